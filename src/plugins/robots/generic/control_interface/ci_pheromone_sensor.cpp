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

}  // namespace argos
