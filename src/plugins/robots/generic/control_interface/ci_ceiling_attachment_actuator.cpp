#include <argos3/plugins/robots/generic/control_interface/ci_ceiling_attachment_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_CeilingAttachmentActuator::CreateLuaState(lua_State* state) {
  using TDevice = CCI_CeilingAttachmentActuator;
  CLuaTable ceiling(state, *this, "ceiling");
  ceiling.AddFunction("attach", *this, [](TDevice& device) { device.Attach(); });
  ceiling.AddFunction("detach", *this, [](TDevice& device) { device.Detach(); });
  ceiling.AddFunction("is_attached", *this, [](TDevice& device) { return device.IsAttached(); });
}

}  // namespace argos
