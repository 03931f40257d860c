#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RFID_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RFID_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>
#include <string>
#include <vector>

namespace argos {

/** Reads the RFID tags near the robot. */
class CCI_RFIDSensor : public CTableSensor {
 public:
  /** The reading of one tag. */
  struct SReading {
    std::string Id; /**< of the tag */
    CByteArray Data; /**< the whole memory of the tag */
    Real Distance = 0.0; /**< from the robot's centre, along the robot's xy plane, cm */
    CRadians Angle; /**< in [-PI,PI], 0 = ahead, counter-clockwise */

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "Id", reading.Id, "Data", reading.Data, "Distance",
                          reading.Distance, "Angle", reading.Angle);
    }
    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const std::vector<SReading>& readings) {
      return PrintReadings(stream, readings);
    }
  };
  typedef std::vector<SReading> TReadings;

  /** @return the readings, in the order in which the tags were added to the arena. */
  const TReadings& GetReadings() const { return m_tReadings; }

 protected:
  TReadings m_tReadings;

 private:
  const char* GetLuaName() const override { return "rfid"; }
  /** robot.rfid[i] = { id, data = { b1, ... }, distance, angle } */
  void WriteReadings(CLuaTable& table) const override;
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
