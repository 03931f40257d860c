#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RANGE_AND_BEARING_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_RANGE_AND_BEARING_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>
#include <vector>

namespace argos {

/** Receives messages from robots nearby, with range and bearing of the senders. */
class CCI_RangeAndBearingSensor : public CTableSensor {
 public:
  /** A message, with range and bearing of its sender from this robot. */
  struct SPacket {
    Real Range = 0.0; /**< cm */
    CRadians HorizontalBearing; /**< in [-PI,PI], 0 = ahead, counter-clockwise */
    CRadians VerticalBearing; /**< elevation above the robot's xy plane, in [-PI/2,PI/2] */
    CByteArray Data;

    SPacket() = default;

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SPacket& reading) {
      return PrintReading(stream, "Range", reading.Range, "HorizontalBearing",
                          reading.HorizontalBearing, "VerticalBearing", reading.VerticalBearing,
                          "Data", reading.Data);
    }
    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const std::vector<SPacket>& readings) {
      return PrintReadings(stream, readings);
    }
  };
  typedef std::vector<SPacket> TReadings;

  /** @return the last packets, in the order in which the senders were added to the arena. */
  const TReadings& GetReadings() const { return m_tReadings; }

 protected:
  TReadings m_tReadings;

 private:
  const char* GetLuaName() const override { return "range_and_bearing"; }
  /** robot.range_and_bearing[i] = { range, horizontal_bearing, vertical_bearing, data } */
  void WriteReadings(CLuaTable& table) const override;
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/quaternion.h>
#endif

#endif
