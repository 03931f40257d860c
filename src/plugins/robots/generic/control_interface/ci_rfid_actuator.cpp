#include <argos3/plugins/robots/generic/control_interface/ci_rfid_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <vector>

namespace argos {

namespace {

// write(bytes [, first])
void WriteFromLua(CCI_RFIDActuator& self, CLuaArguments& arguments) {
  const size_t size = arguments.IsNextTable() ? lua_rawlen(arguments.GetState(), 1) : 0;
  const std::vector<UInt8> bytes = arguments.NextBytes(size);
  const UInt32 first = arguments.HasNext() ? arguments.Next<UInt32>() : 1;
  arguments.Finish();
  if (first == 0) {
    THROW_ARGOSEXCEPTION("argument 2 must be a whole number from 1 on, got 0");
  }
  self.Write(CByteArray(bytes.data(), bytes.size()), first - 1);
}

}  // namespace

void CCI_RFIDActuator::Write(const CByteArray& data, size_t offset) {
  m_data = data;
  m_offset = offset;
  m_isOrdered = true;
}

void CCI_RFIDActuator::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, "rfid");
  table.AddFunction("write", *this, &WriteFromLua);
  table.AddFunction("written", *this, [](CCI_RFIDActuator& self) { return self.GetWrittenTag(); });
}

}  // namespace argos
