#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_TAGS_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_TAGS_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <vector>

namespace argos {

/** The payloads of a robot's tags. */
class CCI_TagsActuator : public CCI_Actuator {
 public:
  /** One payload for each tag. */
  typedef std::vector<std::string> TSettings;

  size_t GetNumTags() const;

  /** @param tag from 0. @throws CARGoSException if there is no such tag. */
  virtual void SetSinglePayload(UInt32 tag, const std::string& payload);
  virtual void SetAllPayloads(const std::string& payload);

  /** robot.tags.set_single_payload(i, text), set_all_payloads(text); tags count from 1 */
  void CreateLuaState(lua_State* state) override;

 protected:
  TSettings m_tSettings;
};

}  // namespace argos

#endif
