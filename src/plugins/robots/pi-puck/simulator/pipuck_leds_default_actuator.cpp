#include <argos3/plugins/robots/pi-puck/simulator/pipuck_leds_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>

#include <algorithm>

namespace argos {

void CPiPuckLEDsDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_leds = &robot.GetComponent<CDirectionalLEDEquippedEntity>("directional_leds");
  if (m_leds->GetNumLEDs() != NUM_LEDS) {
    THROW_ARGOSEXCEPTION("robot \"" << robot.GetId() << "\" has " << m_leds->GetNumLEDs()
                                    << " directional LEDs, but pipuck_leds needs " << NUM_LEDS);
  }
  m_leds->Enable();
}

void CPiPuckLEDsDefaultActuator::SetRingLEDIndex(UInt32 index, bool on) {
  if (index >= NUM_RING_LEDS) {
    LOGERR << "[ERROR] pipuck_leds: there is no LED " << index
           << " in the ring; they are numbered from 0 to " << NUM_RING_LEDS - 1 << std::endl;
    return;
  }
  m_isOn[index] = on;
}

void CPiPuckLEDsDefaultActuator::SetRingLEDs(bool on) {
  std::fill_n(m_isOn.begin(), NUM_RING_LEDS, on);
}

void CPiPuckLEDsDefaultActuator::Update() {
  for (UInt32 i = 0; i < NUM_LEDS; ++i) {
    m_leds->SetLEDColor(i, m_isOn[i] ? CColor::WHITE : CColor::BLACK);
  }
}

void CPiPuckLEDsDefaultActuator::Reset() {
  m_isOn.fill(false);
}

REGISTER_ACTUATOR(
    CPiPuckLEDsDefaultActuator, "pipuck_leds", "default", "the authors of this project", "1.0",
    "The LEDs of the Pi-Puck.",
    R"(Switches the LEDs of the Pi-Puck: eight in a ring, from the one in front clockwise, one in front, and one in the body. One
that is on is white. Cameras see them if the robot has led_medium.
)" + RequiredActuatorXML(R"(<pipuck_leds implementation="default" />)"),
    "Usable")

}  // namespace argos
