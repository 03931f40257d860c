#ifndef ARGOS3_PLUGINS_ENTITIES_WHEELED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_WHEELED_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/core/utility/memory/object_slabs.h>

#include <memory>
#include <vector>

namespace argos {

/**
 * The wheels of a robot and their commanded speeds.
 *
 * The speed over the ground, which engines use, may differ from the ordered one, which the
 * encoders of the motors read: then the robot drifts, and its sensors do not show it.
 */
class CWheeledEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  /** @param numWheels > 0. @throws CARGoSException if it is 0. */
  CWheeledEntity(CComposableEntity* parent, size_t numWheels);
  CWheeledEntity(CComposableEntity* parent, const std::string& id, size_t numWheels);

  /** Sets all speeds to 0. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "wheels"; }

  size_t GetNumWheels() const { return m_radiiAndVelocities.size() / 2; }
  /**
   * Sets the place of a wheel.
   * @param position  of its centre in the frame of the body's origin, m. @param radius m, > 0.
   * @throws CARGoSException if the index is out of range, or the radius is not > 0.
   */
  void SetWheel(UInt32 index, const CVector3& position, Real radius);

  /** These throw CARGoSException if the index is out of range. */
  const CVector3& GetWheelPosition(size_t index) const;
  Real GetWheelRadius(size_t index) const;
  /** Speed of the wheel's rim over the ground, m/s, positive forward. */
  Real GetWheelVelocity(size_t index) const;

  /** Arrays of GetNumWheels() elements; the pointers stay valid as long as the entity. */
  const CVector3* GetWheelPositions() const { return m_positions.data(); }
  const Real* GetWheelRadia() const { return m_radiiAndVelocities.data(); }
  const Real* GetWheelVelocities() const { return m_radiiAndVelocities.data() + GetNumWheels(); }
  /** The speeds that the encoders of the motors read: without drift those over the ground, m/s. */
  const Real* GetOrderedVelocities() const {
    return m_ordered != nullptr ? m_ordered.get() : GetWheelVelocities();
  }
  /** @return true if SetDriftingVelocities() may be called. */
  bool CanDrift() const { return m_ordered != nullptr; }
  /** Allocates what SetDriftingVelocities() needs. */
  void EnableDrift();

  /**
   * Sets the speeds of all wheels, for the next physics phase.
   * @param velocities  GetNumWheels() speeds of the rims, m/s.
   * @throws CARGoSException if a speed is not finite; all speeds are then unchanged.
   */
  void SetVelocities(const Real* velocities);
  /**
   * The same for wheels that roll at other speeds than their motors turn them, which the encoders
   * of the motors do not show. Needs EnableDrift().
   * @param ordered     GetNumWheels() speeds that the encoders read, m/s.
   * @param velocities  GetNumWheels() speeds over the ground, m/s.
   */
  void SetDriftingVelocities(const Real* ordered, const Real* velocities);

  void UpdateDigest(CDigest& digest) const override;

 private:
  Real* GetVelocities() { return m_radiiAndVelocities.data() + GetNumWheels(); }
  void CheckIndex(size_t index) const;
  void RequireFinite(const Real* velocities) const;

  // frame of the origin anchor, m, (wheels)
  std::vector<CVector3, CSlabAllocator<CVector3>> m_positions;
  // radii, m, (wheels), then speeds, m/s, (wheels), which engines read in every tick
  std::vector<Real, CSlabAllocator<Real>> m_radiiAndVelocities;
  std::unique_ptr<Real[]> m_ordered;  // m/s, (wheels); null: those over the ground
};

}  // namespace argos

#endif
