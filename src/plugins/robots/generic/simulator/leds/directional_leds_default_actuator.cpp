#include <argos3/plugins/robots/generic/simulator/directional_leds_default_actuator.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>

namespace argos {

void CDirectionalLEDsDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_leds = &robot.GetComponent<CDirectionalLEDEquippedEntity>("directional_leds");
  for (const auto& instance : m_leds->GetInstances()) {
    m_tInitSettings.push_back(instance.LED.GetInitColor());
  }
  m_tSettings = m_tInitSettings;
  m_leds->Enable();
}

void CDirectionalLEDsDefaultActuator::Update() {
  m_leds->SetLEDColors(m_tSettings);
}

void CDirectionalLEDsDefaultActuator::Reset() {
  m_tSettings = m_tInitSettings;
}

REGISTER_ACTUATOR(
    CDirectionalLEDsDefaultActuator, "directional_leds", "default", "the authors of this project",
    "1.0", "The directional LEDs of a robot.",
    R"(The controller sets the colour of each directional LED, or of all LEDs. The algorithm directional_led_detector of
the sensor "cameras" detects LEDs that are not black. At the start and after a reset the LEDs have the colours given in
the robot's element.
)" + RequiredActuatorXML(R"(<directional_leds implementation="default" />)") +
        CarriedPartsManual("such LEDs", "directional_led",
                           R"(<directional_leds medium="directional_leds">
      <directional_led position="0.09,0,0.05" orientation="0,90,0" anchor="origin" observable_angle="60" color="red" />
    </directional_leds>)"),
    "Usable")

}  // namespace argos
