#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_CONTACT_FINDER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_CONTACT_FINDER_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/broad_phase.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_cache.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_contacts.h>
#include <argos3/plugins/simulator/physics_engines/planar/body_forest.h>

#include <vector>

namespace argos {

class CRigidGhosts;
class CRigidGrips;

/**
 * Finds contacts and the islands of connected bodies, and creates contact joints in ODE for those
 * islands that ODE steps.
 *
 * An island is a set of awake movable bodies that are connected by contacts or grips, directly or
 * through each other. Fixed bodies do not connect others.
 */
class CContactFinder {
 public:
  /** A set of connected bodies. */
  struct SIsland {
    UInt32 Rows = 0;  // of the constraints among its bodies
    bool Supported = false;  // true if a fixed body touches it
    bool Quiet = true;  // used by the world
    bool HasJoints = false;  // true if a body has joints that only ODE solves
  };

  /** The contacts are allocated from a pool, which Clear() empties without freeing its memory. */
  CContactFinder(const SRigidSettings& settings, dWorldID world);
  ~CContactFinder();
  CContactFinder(const CContactFinder&) = delete;
  CContactFinder& operator=(const CContactFinder&) = delete;

  /** Allocates for numbers of bodies. */
  void Reserve(size_t movables, size_t fixed);
  /** To be called after bodies were added, removed or placed. */
  void MarkChanged() { m_broadPhase.MarkChanged(); }
  /**
   * Wakes bodies near awake ones, and finds the contacts of the next substep.
   * @param movables  the active ones, by SRigidBody::ActiveNumber. @param fixed  by
   * SRigidBody::Number. @param planes  that bound everything.
   * @param grips    of the world. @param ghosts  of other engines.
   * @param gravity  m/s^2: the direction of friction in contacts that do not slide.
   * @param substep  s: the length of the next substep.
   */
  void Find(const std::vector<SRigidBody*>& movables, const std::vector<SRigidBody*>& fixed,
            const std::vector<SRigidBody*>& planes, const CRigidGrips& grips,
            const CRigidGhosts& ghosts, const CVector3& gravity, Real substep);
  /**
   * Creates the contacts in ODE, of all islands or of those that have joints. They limit friction
   * separately along two directions.
   */
  void CreateInODE(bool ofAll);
  /** Destroys the contacts in ODE. */
  void Clear();
  /** After the bodies that doze have been marked. @param isFirst  of the substeps of a tick. */
  void KeepDozing(bool isFirst) {
    if (isFirst) {
      m_list.ForgetDozing();
      m_cache.ForgetDozing();
    }
    m_list.KeepDozing();
    m_cache.KeepDozing();
  }
  /** The next contacts do not start with the forces of the last ones. */
  void ForgetForces() {
    m_list.Forget();
    m_cache.Clear();
  }

  /** After Find(): the contacts; the world sets their forces. */
  std::vector<SRigidContact>& GetContacts() { return m_list.Get(); }
  /** After Find(): the number of the island of an awake body, below that of active bodies. */
  UInt32 GetIslandNumber(UInt32 activeNumber) { return FindRoot(activeNumber); }
  SIsland& GetIslandByNumber(UInt32 number) { return IslandOf(number); }
  /** After Find(): the island of an awake body. */
  SIsland& GetIsland(const SRigidBody& body) { return IslandOf(FindRoot(body.ActiveNumber)); }
  UInt32 GetNumContacts() const { return static_cast<UInt32>(m_list.Get().size()); }

 private:
  SIsland& IslandOf(UInt32 body) {
    ARGOS_ASSERT(body < m_islands.size(), "there is no movable body with the number " << body);
    return m_islands[body];
  }
  void WakeNeighbours(const std::vector<SRigidPair>& pairs, const CRigidGrips& grips) const;
  bool IsWoken(const SRigidBody& first, const SRigidBody& second) const;
  void Unite(const SRigidBody& first, const SRigidBody& second);
  void Touch(SRigidBody& first, SRigidBody& second);
  void TouchSolids(const SRigidBody& first, const SRigidBody& second);
  void TouchPair(const SRigidBody& first, size_t a, const SRigidBody& second, size_t b, Real reach);
  int FindLeveled(const SRigidBody& first, size_t a, const SRigidBody& second, size_t b, Real reach,
                  dContact* contacts);
  void TouchItself(const SRigidBody& body);
  void Roll(SRigidBody& robot, const SRigidBody& ground);
  bool FindRollerContact(const SRoller& roller, const CVector3& centre, const SRigidBody& ground,
                         dGeomID solid, dContactGeom& contact) const;
  void BearOnce(SRigidBody& robot, size_t wheel);
  void AddRollerContact(dContact& contact, SRigidBody& robot, size_t roller,
                        const SRigidBody& ground, size_t solid);
  void AddSolidContact(dContact& contact, const SRigidBody& first, size_t a,
                       const SRigidBody& second, size_t b);
  Real ComputeReach(const SRigidBody& first, const SRigidBody& second) const;
  SRigidContact& Join(const dContact& contact, const SRigidBody& first, const SRigidBody& second,
                      UInt32 rows, UInt64 solids);
  void SetDirectionInODE(SRigidContact& contact) const;
  void SoftenInODE(SRigidContact& contact) const;
  UInt32 FindRoot(UInt32 body);
  void CountRows(const std::vector<SRigidBody*>& movables);

  const SRigidSettings& m_settings;
  dWorldID m_world;
  dJointGroupID m_contacts;
  dGeomID m_probe;  // a sphere, moved to one roller after the other
  CBroadPhase m_broadPhase;
  CRigidContacts m_list;
  CContactCache m_cache;
  CVector3 m_gravity;
  Real m_substep = 0.0;
  TBodyForest m_parents;  // of a forest of islands, by number of body
  std::vector<SIsland> m_islands;  // by number of body; of roots
};

}  // namespace argos

#endif
