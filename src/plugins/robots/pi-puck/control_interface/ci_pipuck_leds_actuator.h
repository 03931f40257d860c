#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_LEDS_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_LEDS_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** The LEDs of the Pi-Puck: eight in a ring, one in front, one in the body. Each is on or off. */
class CCI_PiPuckLEDsActuator : public CCI_Actuator {
 public:
  /** @param index  from 0, in front, clockwise to 7; another one is reported and ignored. */
  virtual void SetRingLEDIndex(UInt32 index, bool on) = 0;
  virtual void SetRingLEDs(bool on) = 0;
  virtual void SetFrontLED(bool on) = 0;
  virtual void SetBodyLED(bool on) = 0;

  /**
   * robot.leds.set_ring_led_index(1 to 8, bool), set_ring_leds(bool), set_front_led(bool),
   * set_body_led(bool)
   */
  void CreateLuaState(lua_State* state) override;

 protected:
  const static UInt32 NUM_LEDS = 10;
  const static UInt32 NUM_RING_LEDS = 8;
  const static UInt32 INDEX_FRONT_LED = 8;
  const static UInt32 INDEX_BODY_LED = 9;
};

}  // namespace argos

#endif
