#include <argos3/plugins/robots/generic/simulator/range_and_bearing_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
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
  ChooseMedium(tree);
  m_rab->Enable();
}

void CRangeAndBearingDefaultActuator::ChooseMedium(TConfigurationNode& tree) {
  if (NodeAttributeExists(tree, "medium")) {
    m_rab->SetMedium(
        ReadMedium<CRABMedium>(tree, m_robot->GetSimulator(), "a range and bearing medium"));
    return;
  }
  // a sensor of the same controller is set up after this, and chooses then
  if (HasDeviceBeside(tree, "sensors", "range_and_bearing")) {
    return;
  }
  // without any medium nobody can hear
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
    R"(The controller sets the bytes of a message. The robot sends it all around in every tick, from the next
one on, until it is changed; it is all zeros at the start and after a reset. How many bytes there are, and
how far they reach, are attributes of the robot: rab_data_size and rab_range.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators>
        <range_and_bearing implementation="default" />
      </actuators>
      <sensors />
      <params />
    </my_controller>
  </controllers>

with a medium for range and bearing:

  <media>
    <range_and_bearing id="rab" />
  </media>

OPTIONAL XML

  <range_and_bearing implementation="default" medium="rab" />

  medium  text: the id of a medium for range and bearing. Not given: that of the robot's sensor
          "range_and_bearing", or without one the only medium there is.
)",
    "Usable")

}  // namespace argos
