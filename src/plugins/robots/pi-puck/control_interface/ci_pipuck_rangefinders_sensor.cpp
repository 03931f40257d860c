#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_rangefinders_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/plugins/robots/pi-puck/control_interface/pipuck_transform.h>

namespace argos {

namespace {

constexpr Real kRangefinderElevation = 0.0333;  // m
constexpr Real kRangefinderRange = 0.1;  // m

/**
 * A sensor at (x, y), m, that looks to (toX, toY): z is turned by a right angle about a horizontal
 * axis, to the right for sensors on the right side of the robot.
 */
CCI_PiPuckRangefindersSensor::TConfiguration MakeRangefinder(Real x, Real y, Real toX, Real toY,
                                                             bool isRight) {
  CVector3 axis(-toY, toX, 0.0);
  CRadians turn = CRadians::PI_OVER_TWO;
  if (!isRight) {
    axis = -axis;
    turn = -turn;
  }
  return {"origin", CVector3(x, y, kRangefinderElevation), CQuaternion(turn, axis.Normalize()),
          kRangefinderRange};
}

}  // namespace

const std::map<UInt8, CCI_PiPuckRangefindersSensor::TConfiguration>
    CCI_PiPuckRangefindersSensor::MAP_SENSOR_CONFIG = {
        {0, MakeRangefinder(0.0333, -0.0096, 0.976, -0.218, true)},
        {1, MakeRangefinder(0.0234, -0.0264, 0.683, -0.730, true)},
        {2, MakeRangefinder(0.0, -0.035, 0.0, -1.0, true)},
        {3, MakeRangefinder(-0.028, -0.0212, -0.776, -0.630, true)},
        {4, MakeRangefinder(-0.028, 0.0212, -0.776, 0.630, false)},
        {5, MakeRangefinder(0.0, 0.035, 0.0, 1.0, false)},
        {6, MakeRangefinder(0.0234, 0.0264, 0.683, 0.730, false)},
        {7, MakeRangefinder(0.0333, 0.0096, 0.976, 0.218, false)}};

CCI_PiPuckRangefindersSensor::SInterface::SInterface(const UInt8& label)
    : Label(label), Configuration(MAP_SENSOR_CONFIG.at(label)) {}

void CCI_PiPuckRangefindersSensor::WriteReadings(CLuaTable& table) const {
  VisitInterfaces(*this, [&table](const SInterface& interface) {
    CLuaTable record = table.GetTable(std::size_t{interface.Label} + 1);
    record.Set("proximity", interface.Proximity);
    record.Set("illuminance", interface.Illuminance);
    if (record.IsNew()) {
      WriteTransform(record, std::get<1>(interface.Configuration),
                     std::get<2>(interface.Configuration), std::get<0>(interface.Configuration));
    }
  });
}

std::vector<CCI_Sensor::SColumn> CCI_PiPuckRangefindersSensor::GetReadingColumns() const {
  return MakeNumberedColumns(MAP_SENSOR_CONFIG.size(), "m");
}

void CCI_PiPuckRangefindersSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyInterfaces(*this, &SInterface::Proximity, numbers, count);
}

}  // namespace argos
