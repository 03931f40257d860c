#ifndef ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_DIFFERENTIALSTEERING_CONTROL_H
#define ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_DIFFERENTIALSTEERING_CONTROL_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_velocity_control.h>

#include <array>

namespace argos {

/**
 * Moves the body of a user's model like two wheels, with bounded force and torque: it becomes the
 * differential drive of the body's description.
 */
class CDynamics2DDifferentialSteeringControl : public CDynamics2DVelocityControl {
 public:
  /**
   * @param interwheelDistance  m, > 0.
   * @param node                as of the base class, but for the child
   *                            `<dynamics2d><differential_steering>`.
   * Others: see the base class. @throws CARGoSException if the distance is not > 0.
   */
  CDynamics2DDifferentialSteeringControl(CDynamics2DEngine& engine, Real maxForce, Real maxTorque,
                                         Real interwheelDistance,
                                         TConfigurationNode* node = nullptr);

  /** Orders the ground speeds of the wheels, m/s, positive ahead. */
  void SetWheelVelocity(Real left, Real right);
  /** m. */
  Real GetInterwheelDistance() const { return m_interwheelDistance; }
  void Reset() override;

 private:
  void Describe(SBodyDescription& description) const override;
  CDriveSource GetSource() const override {
    return CDriveSource(m_wheels.data(), m_interwheelDistance);
  }
  void UpdateCommand(Real tick) override;

  Real m_interwheelDistance;  // m
  std::array<Real, 2> m_wheels{};  // m/s: left, right
  // the order of the base class that belongs to these speeds
  cpVect m_velocityOfWheels = cpvzero;
  Real m_yawRateOfWheels = 0.0;
};

}  // namespace argos

#endif
