#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_LED_COLORS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_LED_COLORS_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/color.h>

#include <cstddef>
#include <vector>

namespace argos {

/** Base of the control interfaces for LEDs; black LEDs are off. */
class CLEDColors : public CCI_Actuator {
 public:
  /** One colour for each LED. */
  typedef std::vector<CColor> TSettings;

  size_t GetNumLEDs() const { return m_tSettings.size(); }
  /** @param led from 0. @throws CARGoSException if it is not < GetNumLEDs(). */
  virtual void SetSingleColor(UInt32 led, const CColor& color);
  virtual void SetAllColors(const CColor& color);
  /** @throws CARGoSException if the number of colours is not the number of LEDs. */
  virtual void SetAllColors(const TSettings& colors);
  /**
   * @param led        from 0.
   * @param intensity  the alpha channel of the colour, 0 to 255.
   * @throws CARGoSException if @p led is not < GetNumLEDs().
   */
  virtual void SetSingleIntensity(UInt32 led, UInt8 intensity);
  virtual void SetAllIntensities(UInt8 intensity);

  /** set_single_color(i, color), set_all_colors(color); LEDs count from 1. */
  void CreateLuaState(lua_State* state) override;

 protected:
  TSettings m_tSettings;

 private:
  /** Label of the actuator, also the name of its table in Lua. */
  virtual const char* GetLabel() const = 0;
  void CheckLED(UInt32 led) const;
};

}  // namespace argos

#endif
