#include <argos3/plugins/robots/generic/control_interface/led_colors.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include <algorithm>

namespace argos {

void CLEDColors::SetSingleColor(UInt32 led, const CColor& color) {
  CheckLED(led);
  m_tSettings[led] = color;
}

void CLEDColors::SetAllColors(const CColor& color) {
  std::fill(m_tSettings.begin(), m_tSettings.end(), color);
}

void CLEDColors::SetAllColors(const TSettings& colors) {
  if (colors.size() != m_tSettings.size()) {
    THROW_ARGOSEXCEPTION("actuator \"" << GetLabel() << "\": got " << colors.size()
                                       << " colors for " << m_tSettings.size() << " LEDs");
  }
  m_tSettings = colors;
}

void CLEDColors::SetSingleIntensity(UInt32 led, UInt8 intensity) {
  CheckLED(led);
  m_tSettings[led].SetAlpha(intensity);
}

void CLEDColors::SetAllIntensities(UInt8 intensity) {
  for (CColor& color : m_tSettings) {
    color.SetAlpha(intensity);
  }
}

void CLEDColors::CheckLED(UInt32 led) const {
  if (led >= m_tSettings.size()) {
    THROW_ARGOSEXCEPTION("actuator \"" << GetLabel() << "\": there is no LED " << led
                                       << "; the robot has " << m_tSettings.size()
                                       << " LEDs, numbered from 0");
  }
}

void CLEDColors::CreateLuaState(lua_State* state) {
  CLuaTable leds(state, *this, GetLabel());
  leds.AddFunction("set_single_color", *this, [](CLEDColors& self, CLuaArguments& arguments) {
    const auto led = static_cast<UInt32>(arguments.NextIndex(self.GetNumLEDs()));
    const auto color = arguments.Next<CColor>();
    arguments.Finish();
    self.SetSingleColor(led, color);
  });
  leds.AddFunction("set_all_colors", *this,
                   [](CLEDColors& self, const CColor& color) { self.SetAllColors(color); });
}

}  // namespace argos
