#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CLOCK_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_CLOCK_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>

namespace argos {

/** The clock of a robot. */
class CCI_ClockSensor : public CTableSensor {
 public:
  struct SReading {
    UInt32 Tick = 0; /**< control steps since the start, this one included: 1 in the first */
    Real Time = 0.0; /**< since the start of the experiment, s */

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "Tick", reading.Tick, "Time", reading.Time);
    }
  };

  const SReading& GetReading() const { return m_sReading; }

 protected:
  SReading m_sReading;

 private:
  const char* GetLuaName() const override { return "clock"; }
  /** robot.clock.tick, .time (s) */
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
