#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RANGE_AND_BEARING_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RANGE_AND_BEARING_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>

#include <vector>

namespace argos {

/** Hears the messages of robots nearby, and where they come from. */
class CCI_RangeAndBearingSensor : public CCI_Sensor {
 public:
  /** A message, and where its sender is, seen from this robot. */
  struct SPacket {
    Real Range = 0.0; /**< cm */
    CRadians HorizontalBearing; /**< in [-PI,PI], 0 = ahead, counter-clockwise */
    CRadians VerticalBearing; /**< elevation above the robot's xy plane, in [-PI/2,PI/2] */
    CByteArray Data;

    SPacket() = default;
  };
  typedef std::vector<SPacket> TReadings;

  /** What was heard last, senders in the order in which they were put into the arena. */
  const TReadings& GetReadings() const { return m_tReadings; }

  /** robot.range_and_bearing[i] = { range, horizontal_bearing, vertical_bearing, data } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  TReadings m_tReadings;
};

}  // namespace argos

#endif
