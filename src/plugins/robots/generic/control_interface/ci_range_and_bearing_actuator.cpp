#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include <algorithm>

namespace argos {

void CCI_RangeAndBearingActuator::SetData(const CByteArray& data) {
  if (data.Size() != m_cData.Size()) {
    THROW_ARGOSEXCEPTION("range and bearing actuator: messages have "
                         << m_cData.Size() << " bytes, got " << data.Size());
  }
  m_cData = data;
}

void CCI_RangeAndBearingActuator::SetData(size_t index, UInt8 value) {
  if (index >= m_cData.Size()) {
    THROW_ARGOSEXCEPTION("range and bearing actuator: there is no byte "
                         << index << "; messages have " << m_cData.Size()
                         << " bytes, numbered from 0");
  }
  m_cData[index] = value;
}

void CCI_RangeAndBearingActuator::ClearData() {
  m_cData.Zero();
}

void CCI_RangeAndBearingActuator::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, "range_and_bearing");
  table.AddFunction("set_data", *this,
                    [](CCI_RangeAndBearingActuator& self, CLuaArguments& arguments) {
                      if (arguments.IsNextTable()) {
                        const std::vector<UInt8> bytes = arguments.NextBytes(self.GetSize());
                        arguments.Finish();
                        std::copy(bytes.begin(), bytes.end(), self.m_cData.ToCArray());
                        return;
                      }
                      const size_t index = arguments.NextIndex(self.GetSize());
                      const auto value = arguments.Next<UInt8>();
                      arguments.Finish();
                      self.SetData(index, value);
                    });
  table.AddMethod<&CCI_RangeAndBearingActuator::ClearData>("clear_data", *this);
}

}  // namespace argos
