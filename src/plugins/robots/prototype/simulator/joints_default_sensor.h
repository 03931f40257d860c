#ifndef ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_SIMULATOR_JOINTS_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PROTOTYPE_SIMULATOR_JOINTS_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/prototype/control_interface/ci_joints_sensor.h>

#include <vector>

namespace argos {

class CJointEquippedEntity;

/** Reads the encoders of a robot's joints; see the manual in the source. */
class CJointsDefaultSensor : public CSimulatedSensor, public CCI_JointsSensor {
 public:
  /** @throws CARGoSException if the robot has no "joints". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads the children `<joint>`. @throws CARGoSException if an id or a mode is wrong. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Sets all readings to 0. */
  void Reset() override;

 private:
  CJointEquippedEntity* m_joints = nullptr;
  std::vector<size_t> m_numbers;  // numbers of the joints, (interfaces)
};

}  // namespace argos

#endif
