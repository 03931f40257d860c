#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_DIRECTIONAL_LEDS_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_DIRECTIONAL_LEDS_ACTUATOR_H

#include <argos3/plugins/robots/generic/control_interface/led_colors.h>

namespace argos {

/** The directional LEDs of a robot. In Lua: robot.directional_leds, see CLEDColors. */
class CCI_DirectionalLEDsActuator : public CLEDColors {
 protected:
  TSettings m_tInitSettings;  // settings at the start, and after a reset

 private:
  const char* GetLabel() const override { return "directional_leds"; }
};

}  // namespace argos

#endif
