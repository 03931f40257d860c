#include <argos3/plugins/robots/generic/control_interface/ci_directional_leds_actuator.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include <algorithm>

namespace argos {

size_t CCI_DirectionalLEDsActuator::GetNumLEDs() const {
  return m_tSettings.size();
}

void CCI_DirectionalLEDsActuator::SetSingleColor(UInt32 led, const CColor& color) {
  CheckLED(led);
  m_tSettings[led] = color;
}

void CCI_DirectionalLEDsActuator::SetAllColors(const CColor& color) {
  std::fill(m_tSettings.begin(), m_tSettings.end(), color);
}

void CCI_DirectionalLEDsActuator::SetAllColors(const std::vector<CColor>& colors) {
  if (colors.size() != m_tSettings.size()) {
    THROW_ARGOSEXCEPTION("directional LEDs actuator: got " << colors.size() << " colors for "
                                                           << m_tSettings.size() << " LEDs");
  }
  m_tSettings = colors;
}

void CCI_DirectionalLEDsActuator::SetSingleIntensity(UInt32 led, UInt8 intensity) {
  CheckLED(led);
  m_tSettings[led].SetAlpha(intensity);
}

void CCI_DirectionalLEDsActuator::SetAllIntensities(UInt8 intensity) {
  for (CColor& color : m_tSettings) {
    color.SetAlpha(intensity);
  }
}

void CCI_DirectionalLEDsActuator::CheckLED(UInt32 led) const {
  if (led >= m_tSettings.size()) {
    THROW_ARGOSEXCEPTION("directional LEDs actuator: there is no LED "
                         << led << "; the robot has " << m_tSettings.size()
                         << " directional LEDs, numbered from 0");
  }
}

void CCI_DirectionalLEDsActuator::CreateLuaState(lua_State* state) {
  CLuaTable leds(state, *this, "directional_leds");
  leds.AddFunction("set_single_color", *this,
                   [](CCI_DirectionalLEDsActuator& self, CLuaArguments& arguments) {
                     const auto led = static_cast<UInt32>(arguments.NextIndex(self.GetNumLEDs()));
                     const auto color = arguments.Next<CColor>();
                     arguments.Finish();
                     self.SetSingleColor(led, color);
                   });
  leds.AddFunction(
      "set_all_colors", *this,
      [](CCI_DirectionalLEDsActuator& self, const CColor& color) { self.SetAllColors(color); });
}

}  // namespace argos
