#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_CONTROL_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_CONTROL_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>

namespace argos {

class CControllableEntity;
class CEmbodiedEntity;

/** Base of the quadrotor actuators: gives one actuator exclusive control of the propellers. */
class CQuadRotorControl {
 public:
  CQuadRotorControl() = default;
  /** Releases the propellers. */
  ~CQuadRotorControl();
  CQuadRotorControl(const CQuadRotorControl&) = delete;
  CQuadRotorControl& operator=(const CQuadRotorControl&) = delete;

  /**
   * Acquires control of the robot's propellers.
   * @param device  label of the actuator, for messages.
   * @throws CARGoSException if the robot has no propellers, or another actuator controls them.
   */
  void Acquire(CComposableEntity& robot, CQuadRotorEntity::EControlMethod method,
               const std::string& device);

  CQuadRotorEntity& GetQuadRotor() { return *m_quadrotor; }
  /** Sets the target that the robot follows. */
  void Command(const CQuadRotorEntity::SPositionControlData& target) {
    m_quadrotor->SetPositionControlData(target);
  }
  void Command(const CQuadRotorEntity::SSpeedControlData& target) {
    m_quadrotor->SetSpeedControlData(target);
  }
  const CEmbodiedEntity& GetBody() const { return *m_body; }
  const CControllableEntity& GetRobot() const { return *m_robot; }
  /** @return the current yaw of the body. */
  CRadians ComputeYaw() const;

 private:
  CQuadRotorEntity* m_quadrotor = nullptr;  // null until Acquire()
  CEmbodiedEntity* m_body = nullptr;
  CControllableEntity* m_robot = nullptr;
};

/** Adds a separate draw of the noise on @p quantity to each component. */
CVector3 ApplyNoise(CDeviceNoise& noise, size_t quantity, const CVector3& vector);

}  // namespace argos

#endif
