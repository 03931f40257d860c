#include <argos3/plugins/robots/prototype/simulator/joints_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/prototype/simulator/joint_devices.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

void CJointsDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_joints = &robot.GetComponent<CJointEquippedEntity>("joints");
}

void CJointsDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_JointsActuator::Init(tree);
  ForEachJointOfDevice<SInterface>(tree, *m_joints,
                                   [this](TConfigurationNode& node, size_t joint,
                                          const std::string& id, SInterface::EMode mode) {
                                     Real maxImpulse = 0.0;
                                     GetNodeAttribute(node, "max_impulse", maxImpulse);
                                     RequireNotNegative(maxImpulse, OwnerOf(node),
                                                        "attribute \"max_impulse\"");
                                     m_vecInterfaces.emplace_back(id, mode);
                                     m_motors.push_back({joint, maxImpulse});
                                   });
  Update();
}

void CJointsDefaultActuator::Update() {
  for (size_t i = 0; i < m_motors.size(); ++i) {
    CJointEquippedEntity::SCommand command;
    command.Mode = static_cast<CJointEquippedEntity::EMode>(m_vecInterfaces[i].Mode);
    command.Target = m_vecInterfaces[i].Target;
    command.MaxImpulse = m_motors[i].MaxImpulse;
    m_joints->SetCommand(m_motors[i].Joint, command);
  }
}

void CJointsDefaultActuator::Reset() {
  for (SInterface& interface : m_vecInterfaces) {
    interface.Target = 0.0;
  }
}

REGISTER_ACTUATOR(
    CJointsDefaultActuator, "joints", "default", "the authors of this project", "1.0",
    "The motors of a robot's joints.",
    R"(The controller sets a target for each joint that is listed: a position or a speed, which a motor of limited
strength approaches. Positions are relative to the start: rad of a revolute joint, counter-clockwise about its axis,
and m of a prismatic one. In mode "position" the motor's speed is a fifth of the distance in each substep. Targets
are 0 at the start and after a reset.
)" + RequiredActuatorXML(R"(<joints implementation="default">
          <joint id="hinge" mode="position" max_impulse="0.01" />
        </joints>)") +
        kRobotWithJoint + R"(
  joint@id           text, required: of a revolute or prismatic joint of the robot.
  joint@mode         "position", "velocity" or "disabled", required. A disabled joint moves freely.
  joint@max_impulse  N m s or N s, >= 0, required: the greatest impulse of the motor in a substep of the length that the
                     attribute "iterations" of the engine gives. Divided by that length, it is the greatest torque
                     or force: 0.01 in a substep of 0.01 s is 1 N m or 1 N.
)",
    "Usable")

}  // namespace argos
