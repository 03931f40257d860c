#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RANGE_AND_BEARING_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RANGE_AND_BEARING_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** Sends a message of fixed size in all directions, in every tick, until it is changed. */
class CCI_RangeAndBearingActuator : public CCI_Actuator {
 public:
  /** @return number of bytes of the message. */
  size_t GetSize() const { return m_cData.Size(); }
  /** @throws CARGoSException unless @p data has GetSize() bytes. */
  void SetData(const CByteArray& data);
  /** @param index from 0. @throws CARGoSException if it is not < GetSize(). */
  void SetData(size_t index, UInt8 value);
  /** Sets all bytes to 0. */
  void ClearData();

  /** robot.range_and_bearing.set_data(i, byte), set_data({b1, ...}), clear_data() */
  void CreateLuaState(lua_State* state) override;

 protected:
  CByteArray m_cData;
};

}  // namespace argos

#endif
