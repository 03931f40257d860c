#include <argos3/core/control_interface/ci_sensor.h>

namespace argos {

CCI_Sensor::~CCI_Sensor() = default;

void CCI_Sensor::Init(TConfigurationNode&) {}

void CCI_Sensor::Reset() {}

void CCI_Sensor::Destroy() {}

void CCI_Sensor::Enable() {
  m_enabled = true;
}

void CCI_Sensor::Disable() {
  m_enabled = false;
}

void CCI_Sensor::ReturnToStart() {
  if (m_enabled != m_enabledAtStart) {
    m_enabledAtStart ? Enable() : Disable();
  }
}

void CCI_Sensor::CreateLuaState(lua_State*) {}

void CCI_Sensor::ReadingsToLuaState(lua_State*) {}

}  // namespace argos
