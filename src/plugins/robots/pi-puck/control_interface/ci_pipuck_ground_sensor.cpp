#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_ground_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/plugins/robots/pi-puck/control_interface/pipuck_transform.h>

namespace argos {

namespace {

constexpr Real kGroundRange = 0.005;  // m

// y: m, to the left; it looks down
CCI_PiPuckGroundSensor::TConfiguration MakeGroundSensor(Real y) {
  return {"origin", CVector3(0.03, y, 0.002), CQuaternion(CRadians::PI, CVector3::Y), kGroundRange};
}

}  // namespace

const std::map<UInt8, CCI_PiPuckGroundSensor::TConfiguration>
    CCI_PiPuckGroundSensor::MAP_SENSOR_CONFIG = {
        {0, MakeGroundSensor(0.01)}, {1, MakeGroundSensor(0.0)}, {2, MakeGroundSensor(-0.01)}};

CCI_PiPuckGroundSensor::SInterface::SInterface(UInt8 label)
    : Label(label), Configuration(MAP_SENSOR_CONFIG.at(label)) {}

void CCI_PiPuckGroundSensor::WriteReadings(CLuaTable& table) const {
  VisitInterfaces(*this, [&table](const SInterface& interface) {
    CLuaTable record = table.GetTable(std::size_t{interface.Label} + 1);
    record.Set("reflected", interface.Reflected);
    record.Set("background", interface.Background);
    if (record.IsNew()) {
      WriteTransform(record, std::get<1>(interface.Configuration),
                     std::get<2>(interface.Configuration), std::get<0>(interface.Configuration));
    }
  });
}

std::vector<CCI_Sensor::SColumn> CCI_PiPuckGroundSensor::GetReadingColumns() const {
  return MakeNumberedColumns(MAP_SENSOR_CONFIG.size());
}

void CCI_PiPuckGroundSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyInterfaces(*this, &SInterface::Reflected, numbers, count);
}

}  // namespace argos
