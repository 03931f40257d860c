#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_DIRECTIONAL_LEDS_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_DIRECTIONAL_LEDS_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <vector>

namespace argos {

/** The LEDs of a robot that shine in one direction each; black ones are off. */
class CCI_DirectionalLEDsActuator : public CCI_Actuator {
 public:
  size_t GetNumLEDs() const;

  /** @param led from 0. @throws CARGoSException if there is no such LED. */
  virtual void SetSingleColor(UInt32 led, const CColor& color);
  virtual void SetAllColors(const CColor& color);
  /** @throws CARGoSException if the numbers of colours and of LEDs differ. */
  virtual void SetAllColors(const std::vector<CColor>& colors);
  /**
   * @param led        from 0.
   * @param intensity  the alpha channel of the colour, 0 to 255.
   * @throws CARGoSException if there is no such LED.
   */
  virtual void SetSingleIntensity(UInt32 led, UInt8 intensity);
  virtual void SetAllIntensities(UInt8 intensity);

  /** robot.directional_leds.set_single_color(i, color), set_all_colors(color); LEDs count from 1 */
  void CreateLuaState(lua_State* state) override;

 protected:
  std::vector<CColor> m_tSettings;
  std::vector<CColor> m_tInitSettings;  // at the start, and after a reset

 private:
  void CheckLED(UInt32 led) const;
};

}  // namespace argos

#endif
