#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_LEDS_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_LEDS_ACTUATOR_H

#include <argos3/plugins/robots/generic/control_interface/led_colors.h>

namespace argos {

/** The coloured LEDs of a robot. In Lua: robot.leds, see CLEDColors. */
class CCI_LEDsActuator : public CLEDColors {
 private:
  const char* GetLabel() const override { return "leds"; }
};

}  // namespace argos

#endif
