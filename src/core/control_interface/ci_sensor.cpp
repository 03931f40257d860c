#include <argos3/core/control_interface/ci_sensor.h>

namespace argos {

CCI_Sensor::~CCI_Sensor() = default;

void CCI_Sensor::Init(TConfigurationNode&) {}

void CCI_Sensor::Reset() {}

void CCI_Sensor::Destroy() {}

void CCI_Sensor::Enable() {
  m_bEnabled = true;
  m_switchedOff = false;
}

void CCI_Sensor::Disable() {
  m_bEnabled = false;
  m_switchedOff = true;
}

void CCI_Sensor::MarkStart() {
  m_enabledAtStart = m_bEnabled;
  m_switchedOffAtStart = m_switchedOff;
}

// A derived class may do more in Enable() and Disable().
void CCI_Sensor::ReturnToStart() {
  if (m_bEnabled != m_enabledAtStart) {
    m_enabledAtStart ? Enable() : Disable();
  }
  m_bEnabled = m_enabledAtStart;
  m_switchedOff = m_switchedOffAtStart;
}

void CCI_Sensor::CreateLuaState(lua_State*) {}

void CCI_Sensor::ReadingsToLuaState(lua_State*) {}

}  // namespace argos
