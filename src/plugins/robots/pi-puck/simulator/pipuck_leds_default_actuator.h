#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_LEDS_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_LEDS_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_leds_actuator.h>

#include <array>

namespace argos {

class CDirectionalLEDEquippedEntity;

/** Switches the LEDs of a Pi-Puck: white is on, black is off. */
class CPiPuckLEDsDefaultActuator : public CSimulatedActuator, public CCI_PiPuckLEDsActuator {
 public:
  /** @throws CARGoSException if the robot has no "directional_leds", or other than 10 LEDs. */
  void SetRobot(CComposableEntity& robot) override;
  void SetRingLEDIndex(UInt32 index, bool on) override;
  void SetRingLEDs(bool on) override;
  void SetFrontLED(bool on) override { m_isOn[INDEX_FRONT_LED] = on; }
  void SetBodyLED(bool on) override { m_isOn[INDEX_BODY_LED] = on; }
  void Update() override;
  /** Switches all LEDs off. */
  void Reset() override;

 private:
  CDirectionalLEDEquippedEntity* m_leds = nullptr;
  std::array<bool, NUM_LEDS> m_isOn{};
};

}  // namespace argos

#endif
