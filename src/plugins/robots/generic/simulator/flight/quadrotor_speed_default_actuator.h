#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_SPEED_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_SPEED_DEFAULT_ACTUATOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_speed_actuator.h>
#include <argos3/plugins/robots/generic/simulator/quadrotor_actuator.h>

namespace argos {

/** Sets the target velocity and rotational speed of a flying robot. */
class CQuadRotorSpeedDefaultActuator
    : public CQuadRotorActuator<CCI_QuadRotorSpeedActuator, CQuadRotorEntity::SSpeedControlData> {
 public:
  /** @throws CARGoSException if the robot has no "quadrotor", or another actuator controls it. */
  void SetRobot(CComposableEntity& robot) override;
  void Init(TConfigurationNode& tree) override;

  void SetLinearVelocity(const CVector3& velocity) override;
  void SetRotationalSpeed(const CRadians& speed) override;

 private:
  CQuadRotorEntity::SSpeedControlData MakeStartTarget() const override;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/entity/composable_entity.h>
#endif

#endif
