#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RFID_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RFID_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/math/angles.h>

#include <string>
#include <vector>

namespace argos {

/** Reads the RFID tags near the robot. */
class CCI_RFIDSensor : public CCI_Sensor {
 public:
  /** A tag. */
  struct SReading {
    std::string Id; /**< of the tag */
    CByteArray Data; /**< its whole memory */
    Real Distance = 0.0; /**< from the robot's centre, along the robot's xy plane, cm */
    CRadians Angle; /**< in [-PI,PI], 0 = ahead, counter-clockwise */
  };
  typedef std::vector<SReading> TReadings;

  /** In the order in which the tags were put into the arena. */
  const TReadings& GetReadings() const { return m_tReadings; }

  /** robot.rfid[i] = { id, data = { b1, ... }, distance, angle } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  TReadings m_tReadings;
};

}  // namespace argos

#endif
