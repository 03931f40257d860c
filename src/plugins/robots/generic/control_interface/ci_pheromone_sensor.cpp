#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_sensor.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

const CCI_PheromoneSensor::TReadings& CCI_PheromoneSensor::GetReadings(
    const std::string& layer) const {
  std::vector<std::string> known;
  for (const SInterface& interface : m_vecInterfaces) {
    if (interface.Layer == layer) {
      return interface.Readings;
    }
    known.push_back(interface.Layer);
  }
  THROW_ARGOSEXCEPTION("pheromone sensor: unknown layer \"" << layer << "\""
                                                            << DidYouMean(layer, known));
}

void CCI_PheromoneSensor::WriteReadings(CLuaTable& table) const {
  for (const SInterface& interface : m_vecInterfaces) {
    CLuaTable layer = table.GetTable(interface.Layer.c_str());
    layer.SetRecords(interface.Readings, [](CLuaTable& record, const SReading& reading) {
      record.Set("value", reading.Value);
      if (record.IsNew()) {
        record.Set("offset", reading.Offset);
      }
    });
  }
}

std::vector<CCI_Sensor::SColumn> CCI_PheromoneSensor::GetReadingColumns() const {
  std::vector<SColumn> columns;
  for (const SInterface& interface : m_vecInterfaces) {
    for (const SColumn& column : MakeNumberedColumns(interface.Readings.size())) {
      columns.push_back({interface.Layer + '_' + column.Name, "1/m^2"});
    }
  }
  return columns;
}

void CCI_PheromoneSensor::CopyReadings(Real* numbers, std::size_t count) const {
  std::size_t next = 0;
  for (const SInterface& interface : m_vecInterfaces) {
    for (const SReading& reading : interface.Readings) {
      if (next < count) {
        numbers[next++] = reading.Value;
      }
    }
  }
}

}  // namespace argos
