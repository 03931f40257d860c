#include <argos3/plugins/robots/generic/simulator/leds_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/read_medium.h>
#include <argos3/plugins/simulator/media/led_medium.h>

namespace argos {

void CLEDsDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_robot = &robot;
  m_leds = &robot.GetComponent<CLEDEquippedEntity>("leds");
  m_tSettings.assign(m_leds->GetNumLEDs(), CColor());
}

void CLEDsDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_LEDsActuator::Init(tree);
  CSimulator& simulator = m_robot->GetComponent<CControllableEntity>("controller").GetSimulator();
  m_leds->SetMedium(ReadMedium<CLEDMedium>(tree, simulator, "an LED medium"));
  m_leds->Enable();
}

void CLEDsDefaultActuator::Update() {
  m_leds->SetAllLEDsColors(m_tSettings);
}

void CLEDsDefaultActuator::Reset() {
  SetAllColors(CColor());
}

REGISTER_ACTUATOR(
    CLEDsDefaultActuator, "leds", "default", "the authors of this project", "1.0",
    "The coloured LEDs of a robot.",
    R"(The controller sets the colour of each LED, or of all LEDs. Cameras that use the same medium detect the
LEDs that are not black. All LEDs are black at the start and after a reset.
)" + RequiredActuatorXML(R"(<leds implementation="default" medium="leds" />)") +
        MediumXML(R"(<led id="leds" />)", "an LED medium"),
    "Usable")

}  // namespace argos
