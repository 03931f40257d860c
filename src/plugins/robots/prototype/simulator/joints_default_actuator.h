#ifndef ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_SIMULATOR_JOINTS_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_SIMULATOR_JOINTS_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/prototype/control_interface/ci_joints_actuator.h>

#include <vector>

namespace argos {

class CJointEquippedEntity;

/** Commands the motors of a robot's joints; see the manual in the source. */
class CJointsDefaultActuator : public CSimulatedActuator, public CCI_JointsActuator {
 public:
  /** @throws CARGoSException if the robot has no "joints". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads the children `<joint>`. @throws CARGoSException if an id or a value is wrong. */
  void Init(TConfigurationNode& tree) override;
  /** @throws CARGoSException if a target is not finite. */
  void Update() override;
  /** Sets all targets to 0. */
  void Reset() override;

 private:
  struct SMotor {
    size_t Joint;  // number in the component
    Real MaxImpulse;  // N m s or N s
  };

  CJointEquippedEntity* m_joints = nullptr;
  std::vector<SMotor> m_motors;  // (interfaces)
};

}  // namespace argos

#endif
