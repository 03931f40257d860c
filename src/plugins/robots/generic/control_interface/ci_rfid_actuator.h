#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RFID_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RFID_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/byte_array.h>

#include <string>

namespace argos {

/** Writes to the RFID tag nearest to the robot. */
class CCI_RFIDActuator : public CCI_Actuator {
 public:
  /**
   * Commands to write bytes once, in the next tick, to the tag that is nearest then. Replaces a
   * pending command.
   * @param offset  of the first byte in the tag's memory. If the bytes do not fit, nothing is
   *                written.
   */
  void Write(const CByteArray& data, size_t offset = 0);
  /** Discards a pending command. */
  void Cancel() { m_isOrdered = false; }

  /** @return id of the tag written in this step; empty if no tag was in range or it was too small.
   */
  virtual const std::string& GetWrittenTag() const = 0;

  /** robot.rfid.write({b1, ...} [, first]), first counts from 1; robot.rfid.written() */
  void CreateLuaState(lua_State* state) override;

 protected:
  bool m_isOrdered = false;
  size_t m_offset = 0;
  CByteArray m_data;
};

}  // namespace argos

#endif
