#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_STORE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_STORE_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_bodies.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_settings.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/slot_generations.h>

#include <box2d/box2d.h>

#include <array>
#include <deque>
#include <vector>

namespace argos {

struct SBodyDescription;

/**
 * The bodies of a planar world in dense arrays, one for each kind, and the Box2D world.
 *
 * Lengths are in metres unless a comment says Box2D units. Each Box2D body with a shape carries a
 * number, which is unique among the present ones and dense.
 */
class CPlanarStore {
 public:
  explicit CPlanarStore(const SPlanarSettings& settings);
  CPlanarStore(const CPlanarStore&) = delete;
  CPlanarStore& operator=(const CPlanarStore&) = delete;

  /** Allocates the arrays for so many bodies. */
  void Reserve(size_t immovable, size_t passive, size_t driven);
  /** Allocates what so many Box2D bodies need in addition to the present ones. */
  void ReserveNumbers(size_t additional);

  /** Adds a body that is at rest. */
  void AddImmovable(const SPlanarOwner& owner, const SBodyDescription& description,
                    const SPlanarPose& pose);
  void AddPassive(const SPlanarOwner& owner, const SBodyDescription& description,
                  const SPlanarPose& pose);
  /** Adds a robot without a Box2D body. */
  void AddDriven(const SPlanarOwner& owner, const SBodyDescription& description,
                 const SPlanarPose& pose, const CDriveSource& drive);
  /** Removes a body, which is not active; the last body of its kind gets its slot. */
  void Remove(const SPlanarHandle& handle);

  std::vector<SImmovableBody>& GetImmovable() { return m_immovable; }
  std::vector<SPassiveBody>& GetPassive() { return m_passive; }
  const std::vector<SPassiveBody>& GetPassive() const { return m_passive; }
  std::vector<SDrivenBody>& GetDriven() { return m_driven; }
  const std::vector<SDrivenBody>& GetDriven() const { return m_driven; }
  /** The slots of the robots that are no discs, ascending. */
  const std::vector<UInt32>& GetDrivenSolids() const { return m_drivenSolids; }
  bool HasSolids() const { return !m_passive.empty() || !m_drivenSolids.empty(); }
  /** One body. The handle must be current, and of that kind. */
  SPassiveBody& GetPassive(const SPlanarHandle& handle) {
    return m_passive[SlotOf(handle, EPlanarKind::Passive)];
  }
  const SPassiveBody& GetPassive(const SPlanarHandle& handle) const {
    return m_passive[SlotOf(handle, EPlanarKind::Passive)];
  }
  SDrivenBody& GetDriven(const SPlanarHandle& handle) {
    return m_driven[SlotOf(handle, EPlanarKind::Driven)];
  }
  const SDrivenBody& GetDriven(const SPlanarHandle& handle) const {
    return m_driven[SlotOf(handle, EPlanarKind::Driven)];
  }
  SDrivenBody& GetDriven(UInt32 slot) {
    ARGOS_ASSERT(slot < m_driven.size(), "there is no robot in slot " << slot);
    return m_driven[slot];
  }
  /** @return true if the body of the handle is still in its slot. */
  bool IsCurrent(const SPlanarHandle& handle) const {
    return GenerationsOf(handle.Kind).IsCurrent(handle.Slot, handle.Generation);
  }
  /** Of a passive or driven body: the number of its grips. */
  UInt8& GetNumGrips(const SPlanarHandle& handle);
  /** Of a passive or driven body: around the origin, m. */
  Real GetBoundingRadius(const SPlanarHandle& handle) const;
  /** Of a passive or driven body: half of its narrowest side, m. */
  Real GetNarrowestHalf(const SPlanarHandle& handle) const;
  const SPlanarOwner& GetOwner(const SPlanarHandle& handle) const;

  /** At the end of the last tick; 0 for an immovable body. */
  SPlanarVelocity GetVelocity(const SPlanarHandle& handle) const;
  /**
   * @return true if the body ended the last tick at that pose (within 1e-12); false for immovable
   * bodies.
   * @param pose    world frame.
   * @param origin  of the frame of this world, m, world frame: positions are compared as they were
   * written.
   */
  bool IsAt(const SPlanarHandle& handle, const SPlanarPose& pose,
            const CVector3& origin = CVector3()) const;
  /** Greatest bounding radius of all movable bodies that ever were in this world, m. */
  Real GetWidestMovable() const { return m_widestMovable; }

  /** @return true if immovable bodies were added or removed since the last ListObstacles(). */
  bool HaveObstaclesChanged() const { return m_obstaclesChanged; }
  std::vector<SFootprint> ListObstacles();

  /** Creates a Box2D body without a shape. @param grippable  can grippers hold it? */
  b2Body& CreateBody(const SPlanarPose& pose, EPlanarKind kind, const SPlanarOwner& owner,
                     bool grippable);
  void DestroyBody(b2Body& body);
  /** Owners of Box2D bodies, by number; empty for bodies that cannot be gripped. */
  const std::vector<SPlanarOwner>& GetGrippable() const { return m_grippable; }
  /** @return true if the Box2D body with that number is a robot's. */
  bool IsDriven(UInt32 number) const {
    CheckNumber(number);
    return m_users[number] == EUser::Robot;
  }

  b2World& GetWorld() { return m_world; }
  /** The static body to which motors and ground friction are attached. */
  b2Body& GetGround() { return *m_ground; }

  const SPlanarSettings& GetSettings() const { return m_settings; }
  Real GetMetresPerUnit() const { return m_metresPerUnit; }
  float ToUnits(Real metres) const { return static_cast<float>(metres * m_settings.UnitsPerMetre); }
  Real ToMetres(float units) const { return static_cast<Real>(units) * m_metresPerUnit; }

 private:
  const SDrivenKind& GetOrAddKind(const SDrivenKind& kind);
  /** What has the number of a Box2D body. */
  enum class EUser : UInt8 { None, Robot, Other };

  const CSlotGenerations& GenerationsOf(EPlanarKind kind) const {
    return m_generations[static_cast<size_t>(kind)];
  }
  UInt32 SlotOf(const SPlanarHandle& handle, [[maybe_unused]] EPlanarKind kind) const {
    ARGOS_ASSERT(handle.Kind == kind, "handle of a body of another kind, in slot " << handle.Slot);
    GenerationsOf(handle.Kind).Check(handle);
    return handle.Slot;
  }
  void CheckNumber([[maybe_unused]] UInt32 number) const {
    ARGOS_ASSERT(number < m_numNumbers && m_users[number] != EUser::None,
                 "no Box2D body has the number " << number);
  }
  SPlanarHandle MakeHandle(EPlanarKind kind, size_t slot);
  void AddGroundFriction(b2Body& body, const SGroundFriction& friction);
  void ForgetDrivenSolid(UInt32 slot);
  template <typename BODY>
  void FillSlot(std::vector<BODY>& bodies, EPlanarKind kind, UInt32 slot);

  SPlanarSettings m_settings;
  Real m_metresPerUnit;
  b2World m_world;
  b2Body* m_ground;
  std::vector<SImmovableBody> m_immovable;
  std::vector<SPassiveBody> m_passive;
  std::vector<SDrivenBody> m_driven;
  std::vector<UInt32> m_drivenSolids;  // slots
  std::deque<SDrivenKind> m_drivenKinds;  // to which robots refer; all different
  std::array<CSlotGenerations, 3> m_generations;  // by kind
  bool m_obstaclesChanged = false;
  Real m_widestMovable = 0.0;  // m
  // numbers of Box2D bodies: all below m_numNumbers are in use, except those in m_freeNumbers
  UInt32 m_numNumbers = 0;
  std::vector<UInt32> m_freeNumbers;
  std::vector<SPlanarOwner> m_grippable;  // by number
  std::vector<EUser> m_users;  // by number
};

}  // namespace argos

#endif
