#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_STORE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_STORE_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_bodies.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_settings.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/slot_generations.h>

#include <array>
#include <deque>
#include <vector>

namespace argos {

struct SBodyDescription;

/**
 * The bodies of a planar world in dense arrays, one for each kind.
 */
class CPlanarStore : private CNonCopyable {
 public:
  explicit CPlanarStore(const SPlanarSettings& settings);

  /** Allocates the arrays for so many bodies. */
  void Reserve(size_t immovable, size_t passive, size_t driven);

  /** Adds a body that is at rest. */
  void AddImmovable(const SPlanarOwner& owner, const SBodyDescription& description,
                    const SPlanarPose& pose);
  void AddPassive(const SPlanarOwner& owner, const SBodyDescription& description,
                  const SPlanarPose& pose);
  /** Adds a robot. */
  void AddDriven(const SPlanarOwner& owner, const SBodyDescription& description,
                 const SPlanarPose& pose, const CDriveSource& drive);
  /** Removes a body; the last body of its kind gets its slot. */
  void Remove(const SPlanarHandle& handle);

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
  /** Sets the velocity of a movable body. */
  void SetVelocity(const SPlanarHandle& handle, const SPlanarVelocity& velocity);
  bool IsGrippable(const SPlanarHandle& handle) const;
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

  const SPlanarSettings& GetSettings() const { return m_settings; }

 private:
  const SDrivenKind& GetOrAddKind(const SDrivenKind& kind);

  const CSlotGenerations& GenerationsOf(EPlanarKind kind) const {
    return m_generations[static_cast<size_t>(kind)];
  }
  UInt32 SlotOf(const SPlanarHandle& handle, [[maybe_unused]] EPlanarKind kind) const {
    ARGOS_ASSERT(handle.Kind == kind, "handle of a body of another kind, in slot " << handle.Slot);
    GenerationsOf(handle.Kind).Check(handle);
    return handle.Slot;
  }
  SPlanarHandle MakeHandle(EPlanarKind kind, size_t slot);
  void ForgetDrivenSolid(UInt32 slot);
  template <typename BODY>
  void FillSlot(std::vector<BODY>& bodies, EPlanarKind kind, UInt32 slot);

  SPlanarSettings m_settings;
  std::vector<SImmovableBody> m_immovable;
  std::vector<SPassiveBody> m_passive;
  std::vector<SDrivenBody> m_driven;
  std::vector<UInt32> m_drivenSolids;  // slots
  std::deque<SDrivenKind> m_drivenKinds;  // to which robots refer; all different
  std::array<CSlotGenerations, 3> m_generations;  // by kind
  bool m_obstaclesChanged = false;
  Real m_widestMovable = 0.0;  // m
};

}  // namespace argos

#endif
