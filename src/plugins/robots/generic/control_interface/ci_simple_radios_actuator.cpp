#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

namespace argos {

namespace {

void Send(CCI_SimpleRadiosActuator::SInterface& self, CLuaArguments& arguments) {
  if (!arguments.IsNextTable()) {
    arguments.ThrowNextMustBe("a table");
  }
  arguments.Skip();
  arguments.Finish();
  // the only argument is on top of the stack
  CByteArray message;
  CLuaUtility::LuaSerializeTable(message, arguments.GetState());
  self.Messages.push_back(std::move(message));
}

}  // namespace

void CCI_SimpleRadiosActuator::CreateLuaState(lua_State* state) {
  CLuaTable radios(state, *this, "simple_radios");
  for (SInterface& interface : m_vecInterfaces) {
    CLuaTable radio = radios.GetTable(interface.Id.c_str());
    radio.AddFunction("send", interface, &Send);
  }
}

}  // namespace argos
