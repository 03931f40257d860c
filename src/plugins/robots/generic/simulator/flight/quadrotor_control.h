#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_CONTROL_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_CONTROL_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>

namespace argos {

class CControllableEntity;
class CEmbodiedEntity;

/** What the actuators of flying robots have in common: the robot's propellers, which one takes. */
class CQuadRotorControl {
 public:
  CQuadRotorControl() = default;
  /** Gives them back. */
  ~CQuadRotorControl();
  CQuadRotorControl(const CQuadRotorControl&) = delete;
  CQuadRotorControl& operator=(const CQuadRotorControl&) = delete;

  /**
   * Takes the robot's propellers.
   * @param device  which actuator does so, for messages.
   * @throws CARGoSException if the robot has none, or if another actuator has taken them.
   */
  void Take(CComposableEntity& robot, CQuadRotorEntity::EControlMethod method,
            const std::string& device);

  CQuadRotorEntity& GetQuadRotor() { return *m_quadrotor; }
  const CEmbodiedEntity& GetBody() const { return *m_body; }
  const CControllableEntity& GetRobot() const { return *m_robot; }
  /** Yaw of the body now. */
  CRadians ComputeYaw() const;

 private:
  CQuadRotorEntity* m_quadrotor = nullptr;  // of the robot; null until taken
  CEmbodiedEntity* m_body = nullptr;  // of the robot
  CControllableEntity* m_robot = nullptr;
};

/** With the noise on a vector: each component takes a draw. @param quantity  number of the noise's.
 */
CVector3 ApplyNoise(CDeviceNoise& noise, size_t quantity, const CVector3& vector);

}  // namespace argos

#endif
