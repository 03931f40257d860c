#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_UPRIGHT_CROWD_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_UPRIGHT_CROWD_H

#include <argos3/core/utility/spatial/planar_grid.h>
#include <argos3/plugins/simulator/physics_engines/planar/body_forest.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/upright_solver.h>
#include <argos3/plugins/simulator/physics_engines/planar/cell_lists.h>
#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace argos {

class CThreadPool;
struct SGhostCylinder;

/**
 * The active bodies that stand upright on the floor and touch others only sideways, in a tick: they
 * move in the plane, with contacts, drives and friction by CUprightSolver.
 *
 * Bodies that may meet each other in the tick are a cluster. A cluster is solved here if all its
 * bodies stand upright, and meet nothing but each other and upright walls. If in a substep the
 * floor could not keep one of them upright, the cluster is given back before it moves.
 *
 * While a body is here, its parts in ODE have the place of the start of the tick.
 */
class CUprightCrowd {
 public:
  /** All bodies of a world, at the start of a tick. */
  struct SBodies {
    const std::vector<SRigidBody*>& Active;
    const std::vector<SRigidBody*>& Fixed;
    const std::vector<SGhostCylinder>& Ghosts;
  };

  explicit CUprightCrowd(const SRigidSettings& settings) : m_settings(settings) {}

  /** To be called after fixed bodies were added, removed or placed. */
  void MarkFixedChanged() { m_haveFixedChanged = true; }
  /** Contacts start without forces: a body was placed. */
  void ForgetForces() { m_memory.clear(); }
  /**
   * Finds the bodies that are upright in the tick, and sets SRigidBody::IsUpright.
   * @param ground  unset: none. @param reach  how far a body may move in the tick, m.
   */
  void StartTick(const SBodies& bodies, const std::optional<SRollGround>& ground, Real reach);
  /**
   * Moves the bodies by a substep, except those of clusters in which one would tip or moves too
   * far: their parts in ODE get their state, and they are not upright any more.
   * @param pool  null: in this thread. @return true if there are such.
   */
  bool Step(Real substep, CThreadPool* pool);
  /** Writes the bodies to ODE; those at rest go to sleep. */
  void EndTick();
  bool IsEmpty() const { return m_bodies.empty(); }

 private:
  static constexpr UInt32 kNone = ~UInt32(0);

  // a solid of a body, or of a fixed one, in the world frame
  struct SPart {
    UInt32 Body = 0;  // of those that may be upright, or kNone: of another one
    const SRigidBody* Rigid = nullptr;  // null: of a ghost
    bool IsUpright = false;  // else a rectangle around it
    Real Low = 0.0, High = 0.0;  // m
  };
  struct SPair {
    UInt32 A, B;  // bodies; B is kNone for a fixed one
    UInt32 PartA, PartB;  // of bodies, or of fixed ones
    Real Low, High;  // where their heights overlap, m above the floor
    Real Margin, Friction;
    UInt64 Key;
    std::array<Real, 2> Normals, Tangents;  // N: forces at both points in the last substep
  };
  struct SMemory {
    UInt64 Key = 0;
    std::array<Real, 2> Normals{}, Tangents{};
  };
  struct SIsland {
    UInt32 FirstBody = 0, EndBody = 0, FirstContact = 0, EndContact = 0;
  };
  enum class ETouch { Never, Sideways, Otherwise };

  void ListBodies(const SBodies& bodies);
  void AddBody(SRigidBody& body);
  void AddOther(const SRigidBody& body);
  void AddGhost(const SGhostCylinder& ghost);
  void ListFixed(const std::vector<SRigidBody*>& fixed);
  void PlaceParts(const SUprightBody& body, Real offsetX, Real offsetY);
  void FindPairs();
  void PairWithOthers(UInt32 part);
  void PairWithFixed(UInt32 part);
  ETouch JudgeHeights(const SPart& own, const SPart& other) const;
  void AddPair(UInt32 partA, UInt32 partB, bool isFixed);
  void SelectClusters();
  void Remember();
  void Recall();
  void FindContacts(UInt32 pair, Real substep);
  void AddContact(UInt32 pair, UInt32 point, const SSeparation& separation, Real substep);
  void SortIntoIslands();
  void FillIslands();
  Real MeasureUnequal(std::span<const UInt32> bodies) const;
  void SolveIsland(const SIsland& island, Real substep);
  void Move(SUprightBody& body, Real substep) const;
  bool GiveBack();
  bool RunsAway(const SUprightBody& body, Real substep) const;
  Real GetReachOf(bool isDisc) const { return isDisc ? m_reach : kTurningReach * m_reach; }
  template <typename VISIT>
  static void ForEach(CThreadPool* pool, size_t count, size_t grain, VISIT&& visit);

  const SRigidSettings& m_settings;
  std::optional<SRollGround> m_ground;
  Real m_reach = 0.0;  // m
  bool m_haveFixedChanged = true;

  std::vector<SUprightBody> m_bodies;
  std::vector<SUprightSupport> m_supports;
  std::vector<UInt8> m_isOut;  // by body: its cluster is not, or no more, solved here
  std::vector<UInt8> m_tips;  // by body
  std::vector<SPart> m_parts;
  std::vector<SFootprint> m_footprints;  // by part
  CFramedGrid m_grid;
  CCellLists m_cells;  // of the parts
  std::vector<SPart> m_fixedParts;
  std::vector<SFootprint> m_fixedFootprints;
  CFramedGrid m_fixedGrid;
  CCellLists m_fixedCells;
  std::vector<UInt32> m_found;  // scratch
  std::vector<SPair> m_pairs;
  TBodyForest m_clusters;
  std::vector<SMemory> m_memory;  // hash table of the pairs of the last tick

  std::vector<SUprightContact> m_contacts;  // two for each pair
  std::vector<UInt8> m_numContacts;  // by pair
  TBodyForest m_islandOf;
  std::vector<SIsland> m_islands;
  std::vector<UInt32> m_bodyOrder, m_contactOrder;  // by island
  std::vector<UInt32> m_islandNumber;  // by root
};

}  // namespace argos

#endif
