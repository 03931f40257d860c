#include <argos3/plugins/robots/generic/simulator/range_and_bearing_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/medium_attribute.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/plugins/simulator/media/rab_medium.h>

namespace argos {

void CRangeAndBearingDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_rab = &robot.GetComponent<CRABEquippedEntity>("rab");
  m_cData = CByteArray(m_rab->GetMsgSize());
}

void CRangeAndBearingDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_RangeAndBearingActuator::Init(tree);
  SelectMedium(tree);
  m_rab->Enable();
}

void CRangeAndBearingDefaultActuator::SelectMedium(TConfigurationNode& tree) {
  if (NodeAttributeExists(tree, "medium")) {
    m_rab->SetMedium(
        ReadMedium<CRABMedium>(tree, m_robot->GetSimulator(), "a range and bearing medium"));
    return;
  }
  // a sensor of the same controller is initialized after this actuator, and selects the medium
  if (HasDeviceBeside(tree, "sensors", "range_and_bearing")) {
    return;
  }
  // the messages reach no robot if there is no medium
  if (CRABMedium* const medium = FindOnlyMedium<CRABMedium>(tree, m_robot->GetSimulator())) {
    m_rab->SetMedium(*medium);
  }
}

void CRangeAndBearingDefaultActuator::Update() {
  m_rab->SetData(m_cData);
}

void CRangeAndBearingDefaultActuator::Reset() {
  ClearData();
}

REGISTER_ACTUATOR(
    CRangeAndBearingDefaultActuator, "range_and_bearing", "default", "the authors of this project",
    "1.0", "Sends short messages to robots nearby.",
    R"(The controller sets the bytes of a message. The robot sends the message in all directions in every tick, from
the next one on, until it is changed; at the start and after a reset all bytes are zero. The attributes rab_data_size and
rab_range of the robot define the number of bytes and the range.
)" + RequiredActuatorXML(R"(<range_and_bearing implementation="default" />)") +
        R"(
with a medium for range and bearing:

  <media>
    <range_and_bearing id="rab" />
  </media>
)" + OptionalXML(R"(<range_and_bearing implementation="default" medium="rab" />)") +
        R"(
  medium  text: the id of a medium for range and bearing. Default: the medium of the robot's sensor
          "range_and_bearing"; without that sensor, the only medium of this kind.
)",
    "Usable")

}  // namespace argos
