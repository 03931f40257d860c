#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_PLACED_READINGS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_PLACED_READINGS_H

#include <argos3/core/control_interface/print_readings.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>
#include <vector>

/*
 * Control interfaces whose readings contain the place of their sensors: the direction of each light
 * or proximity sensor, the offset of each ground sensor. An interface derives from CPlacedSensors
 * and defines a table, SSensorPlaces; its source includes placed_readings_impl.h.
 */

namespace argos {

/**
 * The readings of sensors around a robot.
 *
 * @tparam SENSOR  the control interface. Each interface has a type of readings of its own, so that
 *                 functions may be overloaded for them.
 */
template <class SENSOR>
class CAngularReadings {
 public:
  struct SReading {
    Real Value = 0.0; /**< in [0,1]: 0 for no light or no object; larger is brighter, or nearer */
    CRadians Angle; /**< direction of the sensor, in (-PI,PI], counter-clockwise from ahead */

    SReading() = default;
    SReading(Real value, const CRadians& angle) : Value(value), Angle(angle) {}

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "Value", reading.Value, "Angle", reading.Angle);
    }
    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const std::vector<SReading>& readings) {
      return PrintReadings(stream, readings);
    }
  };

  typedef std::vector<SReading> TReadings;

  /** One reading for each sensor. */
  const TReadings& GetReadings() const { return m_tReadings; }

 protected:
  typedef SENSOR TSensor;
  static constexpr const char* kLuaPlace = "angle";

  CAngularReadings() = default;
  ~CAngularReadings() = default;

  static const CRadians& GetPlace(const SReading& reading) { return reading.Angle; }

  TReadings m_tReadings;
};

/** The readings of sensors under a robot; see CAngularReadings. */
template <class SENSOR>
class COffsetReadings {
 public:
  struct SReading {
    Real Value = 0.0; /**< in [0,1]: 0 is black, 1 is white */
    CVector2 Offset; /**< of the sensor from the centre of the robot, in its frame, cm */

    SReading() = default;
    SReading(Real value, const CVector2& offset) : Value(value), Offset(offset) {}

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReading& reading) {
      return PrintReading(stream, "Value", reading.Value, "Offset", reading.Offset);
    }
    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const std::vector<SReading>& readings) {
      return PrintReadings(stream, readings);
    }
  };

  typedef std::vector<SReading> TReadings;

  /** One reading for each sensor. */
  const TReadings& GetReadings() const { return m_tReadings; }

 protected:
  typedef SENSOR TSensor;
  static constexpr const char* kLuaPlace = "offset";

  COffsetReadings() = default;
  ~COffsetReadings() = default;

  static const CVector2& GetPlace(const SReading& reading) { return reading.Offset; }

  TReadings m_tReadings;
};

/** Describes the sensors of one control interface. @tparam PLACE  CRadians or CVector2. */
template <class PLACE>
struct SSensorPlaces {
  const char* Device; /**< label of the sensor in experiment files */
  const char* LuaName; /**< Lua scripts find the readings in robot.<LuaName> */
  UInt32 Num; /**< number of sensors */
  PLACE (*GetPlace)(UInt32 index); /**< of sensor @p index < Num */
};

/**
 * A control interface with one reading for each place in the table SENSOR::kPlaces.
 *
 * @tparam READINGS  CAngularReadings<SENSOR> or COffsetReadings<SENSOR>.
 * @tparam BASE      CTableSensor or CVirtualTableSensor.
 */
template <class READINGS, class BASE = CTableSensor>
class CPlacedSensors : public BASE, public READINGS {
 public:
  std::vector<CCI_Sensor::SColumn> GetReadingColumns() const override;
  void CopyReadings(Real* numbers, std::size_t count) const override;

 protected:
  /** All values are 0. */
  CPlacedSensors();

 private:
  const char* GetLuaName() const override;
  /** A list of tables { value, angle or offset }, in the order of the robot's sensors. */
  void WriteReadings(CLuaTable& table) const override;
};

}  // namespace argos

#endif
