#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CEILING_ATTACHMENT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CEILING_ATTACHMENT_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>

namespace argos {

/** The magnet by which a flying robot holds on to the ceiling, and so stays put without flying. */
class CCI_CeilingAttachmentActuator : public CCI_Actuator {
 public:
  /** The robot attaches as soon as its top is in reach of the ceiling, at the earliest in the next
   * tick. */
  virtual void Attach() = 0;
  /** The robot flies from the next tick on. So it does at the start. */
  virtual void Detach() = 0;
  /** @return true if it holds on to the ceiling now. */
  virtual bool IsAttached() const = 0;

  /** robot.ceiling.attach(), .detach(), .is_attached() */
  void CreateLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
