#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_ENCODER_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_ENCODER_SENSOR_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>

namespace argos {

/** The encoders of the wheels of the foot-bot: the distances that they rolled. */
class CCI_FootBotEncoderSensor : public CTableSensor {
 public:
  struct SReading {
    Real CoveredDistanceLeftWheel = 0.0; /**< since the previous step, cm, positive ahead */
    Real CoveredDistanceRightWheel = 0.0; /**< since the previous step, cm, positive ahead */
    Real WheelAxisLength = 0.0; /**< distance between the wheels, cm */

    SReading() = default;
    SReading(Real distanceLeft, Real distanceRight, Real axisLength)
        : CoveredDistanceLeftWheel(distanceLeft),
          CoveredDistanceRightWheel(distanceRight),
          WheelAxisLength(axisLength) {}

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "CoveredDistanceLeftWheel", reading.CoveredDistanceLeftWheel,
                          "CoveredDistanceRightWheel", reading.CoveredDistanceRightWheel,
                          "WheelAxisLength", reading.WheelAxisLength);
    }
  };

  const SReading& GetReading() const { return m_sReading; }

 protected:
  SReading m_sReading;

 private:
  const char* GetLuaName() const override { return "encoder"; }
  /** robot.encoder.distance_left, .distance_right, .axis_length (cm) */
  void WriteConstants(CLuaTable& table) override;
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
