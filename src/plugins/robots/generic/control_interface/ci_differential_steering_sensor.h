#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_DIFFERENTIAL_STEERING_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_DIFFERENTIAL_STEERING_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>

namespace argos {

/** The encoders of two wheels on one axis. */
class CCI_DifferentialSteeringSensor : public CTableSensor {
 public:
  struct SReading {
    Real VelocityLeftWheel = 0.0; /**< cm/s, positive ahead */
    Real VelocityRightWheel = 0.0; /**< cm/s, positive ahead */
    Real CoveredDistanceLeftWheel = 0.0; /**< since the previous step, cm */
    Real CoveredDistanceRightWheel = 0.0; /**< since the previous step, cm */
    Real WheelAxisLength = 0.0; /**< distance between the wheels, cm */

    SReading() = default;
    SReading(Real velocityLeft, Real velocityRight, Real distanceLeft, Real distanceRight,
             Real axisLength)
        : VelocityLeftWheel(velocityLeft),
          VelocityRightWheel(velocityRight),
          CoveredDistanceLeftWheel(distanceLeft),
          CoveredDistanceRightWheel(distanceRight),
          WheelAxisLength(axisLength) {}

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "VelocityLeftWheel", reading.VelocityLeftWheel,
                          "VelocityRightWheel", reading.VelocityRightWheel,
                          "CoveredDistanceLeftWheel", reading.CoveredDistanceLeftWheel,
                          "CoveredDistanceRightWheel", reading.CoveredDistanceRightWheel,
                          "WheelAxisLength", reading.WheelAxisLength);
    }
  };

  const SReading& GetReading() const { return m_sReading; }

 protected:
  SReading m_sReading;

 private:
  const char* GetLuaName() const override { return "wheels"; }
  /** robot.wheels.velocity_left, velocity_right, distance_left, distance_right, axis_length */
  void WriteConstants(CLuaTable& table) override;
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
