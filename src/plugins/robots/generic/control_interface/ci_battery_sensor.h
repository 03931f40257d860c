#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_BATTERY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_BATTERY_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>

namespace argos {

/** The charge of the battery of a robot. */
class CCI_BatterySensor : public CTableSensor {
 public:
  struct SReading {
    Real AvailableCharge = 1.0; /**< fraction of the full charge, in [0,1] */
    Real TimeLeft = 0.0; /**< until empty at the rate of the last tick, s; may be infinite */

    SReading() = default;
    SReading(Real availableCharge, Real timeLeft)
        : AvailableCharge(availableCharge), TimeLeft(timeLeft) {}

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "AvailableCharge", reading.AvailableCharge, "TimeLeft",
                          reading.TimeLeft);
    }
  };

  const SReading& GetReading() const { return m_sReading; }

 protected:
  SReading m_sReading;

 private:
  const char* GetLuaName() const override { return "battery"; }
  /** robot.battery.available_charge, .time_left (s) */
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
