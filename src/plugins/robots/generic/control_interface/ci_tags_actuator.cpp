#include <argos3/plugins/robots/generic/control_interface/ci_tags_actuator.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include <algorithm>

namespace argos {

size_t CCI_TagsActuator::GetNumTags() const {
  return m_tSettings.size();
}

void CCI_TagsActuator::SetSinglePayload(UInt32 tag, const std::string& payload) {
  if (tag >= m_tSettings.size()) {
    THROW_ARGOSEXCEPTION("tags actuator: there is no tag " << tag << "; the robot has "
                                                           << m_tSettings.size()
                                                           << " tags, numbered from 0");
  }
  m_tSettings[tag] = payload;
}

void CCI_TagsActuator::SetAllPayloads(const std::string& payload) {
  std::fill(m_tSettings.begin(), m_tSettings.end(), payload);
}

void CCI_TagsActuator::CreateLuaState(lua_State* state) {
  CLuaTable tags(state, *this, "tags");
  tags.AddFunction("set_single_payload", *this,
                   [](CCI_TagsActuator& self, CLuaArguments& arguments) {
                     const auto tag = static_cast<UInt32>(arguments.NextIndex(self.GetNumTags()));
                     const auto payload = arguments.Next<std::string>();
                     arguments.Finish();
                     self.SetSinglePayload(tag, payload);
                   });
  tags.AddMethod<&CCI_TagsActuator::SetAllPayloads>("set_all_payloads", *this);
}

}  // namespace argos
