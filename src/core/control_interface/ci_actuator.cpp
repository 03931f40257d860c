#include <argos3/core/control_interface/ci_actuator.h>

namespace argos {

CCI_Actuator::~CCI_Actuator() = default;

void CCI_Actuator::Init(TConfigurationNode&) {}

void CCI_Actuator::Reset() {}

void CCI_Actuator::Destroy() {}

void CCI_Actuator::CreateLuaState(lua_State*) {}

}  // namespace argos
