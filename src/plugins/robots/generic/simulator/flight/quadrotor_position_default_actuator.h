#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_POSITION_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_POSITION_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_position_actuator.h>
#include <argos3/plugins/robots/generic/simulator/quadrotor_control.h>

namespace argos {

/** Gives the propellers of a robot a place to go to; they start to get there in the next tick. */
class CQuadRotorPositionDefaultActuator : public CSimulatedActuator,
                                          public CCI_QuadRotorPositionActuator {
 public:
  /** @throws CARGoSException unless the robot has a "quadrotor" that nobody else controls. */
  void SetRobot(CComposableEntity& robot) override;
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

  void SetAbsolutePosition(const CVector3& position) override;
  void SetRelativePosition(const CVector3& position) override;
  void SetAbsoluteYaw(const CRadians& yaw) override;
  void SetRelativeYaw(const CRadians& yaw) override;

 private:
  void StayHere();
  void Set(const CQuadRotorEntity::SPositionControlData& target);

  CQuadRotorControl m_control;
  CQuadRotorEntity::SPositionControlData m_target;  // with noise
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
