#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_BORDER_BUNDLES_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_BORDER_BUNDLES_H

#include <argos3/core/simulator/geometry/indexed_shape.h>

#include <vector>

namespace argos {

class CDescribedBodyEngine;
class CEmbodiedEntity;
struct SSimulationContext;

/**
 * Objects near a border, with what may touch them: each such bundle is moved by one engine, so that
 * pushes are passed on across the border as anywhere else.
 *
 * Objects are bodies without a drive or propellers. A bundle is what is connected by pairs that may
 * touch each other in the next tick, one of which is an object, and by grips; two robots are no
 * such pair (they are ghosts for each other), nor are bodies of engines of two types that share
 * space. The bundle is in the engine whose region contains its body of the lowest entity index; if
 * that engine does not accept all of its bodies (grips end where the type of the engine changes,
 * and a leaning body cannot be in a plane), in the first that does. Its other bodies may be outside
 * of that region: they stay in the engine until they leave the bundle. Excepted are those behind a
 * wall of the region.
 */
class CBorderBundles {
 public:
  explicit CBorderBundles(SSimulationContext& context) : m_context(context) {}

  /**
   * Finds the bundles, and moves bodies to the engines of theirs; at the start of a tick, after
   * CPhysicsEngine::CollectGhosts() of all engines, in one thread.
   * @return true if a body has changed its engine: the ghosts have to be collected again.
   */
  bool Update();

 private:
  struct SMember {
    CEmbodiedEntity* Body;
    CDescribedBodyEngine* Engine;
  };

  void ForgetBundles();
  bool FindSeeds();
  bool ReturnStrays();
  bool Find(UInt32 number, SMember& member) const;
  void FindBundle(const SMember& seed);
  void AddNeighbours(const SMember& member);
  void AddGripped(const SMember& member);
  void Include(const SMember& member);
  bool MoveBundle();
  CDescribedBodyEngine& ChooseEngine();
  static CDescribedBodyEngine& FindEngineOfPlace(const SMember& member);
  static bool Meet(const SMember& a, const SMember& b);
  static bool MayBeIn(CDescribedBodyEngine& engine, const SMember& member);
  static bool MayStayIn(CDescribedBodyEngine& engine, const CEmbodiedEntity& body);
  void AddFixedNear(const SMember& member, CDescribedBodyEngine& engine) const;

  SSimulationContext& m_context;
  // scratch of Update()
  Real m_reach = 0.0;  // m; distance in which neighbours are searched
  std::vector<SMember> m_strays;  // strays of the last tick
  std::vector<UInt32> m_seeds;  // numbers of bodies
  std::vector<UInt8> m_isVisited;  // has an entry for each body, by number
  std::vector<UInt32> m_visited;  // numbers of bodies
  std::vector<SMember> m_bundle;
  std::vector<SIndexedShape> m_own, m_near;
  std::vector<CEmbodiedEntity*> m_gripped;
};

}  // namespace argos

#endif
