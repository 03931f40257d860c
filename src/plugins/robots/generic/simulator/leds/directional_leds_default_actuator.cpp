#include <argos3/plugins/robots/generic/simulator/directional_leds_default_actuator.h>

#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>

namespace argos {

void CDirectionalLEDsDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_leds = &robot.GetComponent<CDirectionalLEDEquippedEntity>("directional_leds");
  for (const auto& instance : m_leds->GetInstances()) {
    m_tInitSettings.push_back(instance.Entity.GetInitColor());
  }
  m_tSettings = m_tInitSettings;
  m_leds->Enable();
}

void CDirectionalLEDsDefaultActuator::Update() {
  m_leds->SetAllLEDsColors(m_tSettings);
}

void CDirectionalLEDsDefaultActuator::Reset() {
  m_tSettings = m_tInitSettings;
}

REGISTER_ACTUATOR(
    CDirectionalLEDsDefaultActuator, "directional_leds", "default", "the authors of this project",
    "1.0", "The LEDs of a robot that shine in one direction each.",
    R"(The controller sets the colour of each directional LED, or of all. The algorithm directional_led_detector of
the sensor "cameras" sees those that are not black. At the start and after a reset the LEDs have the colours that the
robot's element gives them.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators>
        <directional_leds implementation="default" />
      </actuators>
      <sensors />
      <params />
    </my_controller>
  </controllers>

on a robot that carries such LEDs:

  <foot-bot id="fb0">
    <body position="0,0,0" />
    <controller config="c1" />
    <directional_leds medium="directional_leds">
      <directional_led position="0.09,0,0.05" orientation="0,90,0" anchor="origin" observable_angle="60" color="red" />
    </directional_leds>
  </foot-bot>

The medium "directional_led" explains these attributes.
)",
    "Usable")

}  // namespace argos
