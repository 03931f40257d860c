#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_POSITION_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_FLIGHT_QUADROTOR_POSITION_DEFAULT_ACTUATOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_position_actuator.h>
#include <argos3/plugins/robots/generic/simulator/quadrotor_actuator.h>

namespace argos {

/** Sets the target position and yaw of a flying robot, used from the next tick on. */
class CQuadRotorPositionDefaultActuator
    : public CQuadRotorActuator<CCI_QuadRotorPositionActuator,
                                CQuadRotorEntity::SPositionControlData> {
 public:
  /** @throws CARGoSException if the robot has no "quadrotor", or another actuator controls it. */
  void SetRobot(CComposableEntity& robot) override;
  void Init(TConfigurationNode& tree) override;

  void SetAbsolutePosition(const CVector3& position) override;
  void SetRelativePosition(const CVector3& position) override;
  void SetAbsoluteYaw(const CRadians& yaw) override;
  void SetRelativeYaw(const CRadians& yaw) override;

 private:
  CQuadRotorEntity::SPositionControlData MakeStartTarget() const override;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/entity/composable_entity.h>
#endif

#endif
