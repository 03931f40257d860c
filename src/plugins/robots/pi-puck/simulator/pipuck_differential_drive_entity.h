#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_DIFFERENTIAL_DRIVE_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_DIFFERENTIAL_DRIVE_ENTITY_H

#include <argos3/plugins/simulator/entities/body_motion.h>
#include <argos3/plugins/simulator/entities/tick_watch.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

#include <string>

namespace argos {

/** The drive of a Pi-Puck: speeds of its wheels over the ground, m/s. Wheel 0 is the left one. */
class CPiPuckDifferentialDriveEntity : public CWheeledEntity {
 public:
  ENABLE_VTABLE();

  /** @param parent  has a "body". */
  explicit CPiPuckDifferentialDriveEntity(CComposableEntity* parent);
  CPiPuckDifferentialDriveEntity(CComposableEntity* parent, const std::string& id);

  /** Sets all speeds to 0. */
  void Reset() override;
  /** Measures the speeds, once a tick. */
  void Update() override;
  std::string GetTypeDescription() const override { return "differential_drive"; }

  /** Ordered speeds, which engines use in the next tick. @throws CARGoSException if not finite. */
  void SetTargetVelocityLeft(Real velocity) { SetTarget(LEFT, velocity); }
  void SetTargetVelocityRight(Real velocity) { SetTarget(RIGHT, velocity); }
  Real GetTargetVelocityLeft() const { return GetWheelVelocities()[LEFT]; }
  Real GetTargetVelocityRight() const { return GetWheelVelocities()[RIGHT]; }

  /** Speeds in the last tick, from the motion of the body. Update() sets them. */
  void SetVelocityLeft(Real velocity) { m_velocities[LEFT] = velocity; }
  void SetVelocityRight(Real velocity) { m_velocities[RIGHT] = velocity; }
  Real GetVelocityLeft() const { return m_velocities[LEFT]; }
  Real GetVelocityRight() const { return m_velocities[RIGHT]; }

 private:
  enum EWheel : UInt8 { LEFT, RIGHT, NUM_WHEELS };

  void SetTarget(EWheel wheel, Real velocity);

  CBodyMotion m_motion;  // motion since the end of the previous tick
  CTickWatch m_tick;
  Real m_velocities[NUM_WHEELS] = {};  // m/s
};

}  // namespace argos

#endif
