#include <argos3/plugins/robots/prototype/simulator/joints_default_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/prototype/simulator/joint_devices.h>

namespace argos {

void CJointsDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_joints = &robot.GetComponent<CJointEquippedEntity>("joints");
}

void CJointsDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_JointsSensor::Init(tree);
  ForEachJointOfDevice<SInterface>(
      tree, *m_joints,
      [this](TConfigurationNode&, size_t joint, const std::string& id, SInterface::EMode mode) {
        m_vecInterfaces.emplace_back(id, mode);
        m_numbers.push_back(joint);
      });
}

void CJointsDefaultSensor::Update() {
  for (size_t i = 0; i < m_numbers.size(); ++i) {
    const CJointEquippedEntity::SJoint& joint = m_joints->GetJoint(m_numbers[i]);
    switch (m_vecInterfaces[i].Mode) {
      case SInterface::EMode::POSITION:
        m_vecInterfaces[i].Value = joint.Position;
        break;
      case SInterface::EMode::VELOCITY:
        m_vecInterfaces[i].Value = joint.Velocity;
        break;
      case SInterface::EMode::DISABLED:
        break;
    }
  }
}

void CJointsDefaultSensor::Reset() {
  for (SInterface& interface : m_vecInterfaces) {
    interface.Value = 0.0;
  }
}

REGISTER_SENSOR(
    CJointsDefaultSensor, "joints", "default", "the authors of this project", "1.0",
    "The encoders of a robot's joints.",
    R"(For each joint that is listed, its position or its speed: relative to the start, rad (not wrapped) and rad/s of a
revolute joint, counter-clockwise about its axis, and m and m/s of a prismatic one.
)" + RequiredSensorXML(R"(<joints implementation="default">
          <joint id="hinge" mode="position" />
        </joints>)") +
        kRobotWithJoint + R"(
  joint@id    text, required: of a revolute or prismatic joint of the robot.
  joint@mode  "position", "velocity" or "disabled", required. The reading of a disabled encoder is 0.
)",
    "Usable")

}  // namespace argos
