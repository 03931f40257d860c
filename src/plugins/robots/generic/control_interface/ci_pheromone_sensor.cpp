#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_sensor.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& pheromone, const CCI_PheromoneSensor::SInterface::TVector& interfaces) {
  for (const CCI_PheromoneSensor::SInterface& interface : interfaces) {
    CLuaTable layer = pheromone.GetTable(interface.Layer.c_str());
    layer.SetRecords(interface.Readings,
                     [](CLuaTable& record, const CCI_PheromoneSensor::SReading& reading) {
                       record.Set("value", reading.Value);
                       if (record.IsNew()) {
                         record.Set("offset", reading.Offset);
                       }
                     });
  }
}

}  // namespace

const CCI_PheromoneSensor::TReadings& CCI_PheromoneSensor::GetReadings(
    const std::string& layer) const {
  std::vector<std::string> known;
  for (const SInterface& interface : m_vecInterfaces) {
    if (interface.Layer == layer) {
      return interface.Readings;
    }
    known.push_back(interface.Layer);
  }
  THROW_ARGOSEXCEPTION("pheromone sensor: there is no layer \"" << layer << "\""
                                                                << DidYouMean(layer, known));
}

void CCI_PheromoneSensor::CreateLuaState(lua_State* state) {
  CLuaTable pheromone(state, *this, "pheromone");
  Write(pheromone, m_vecInterfaces);
}

void CCI_PheromoneSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable pheromone(state, *this);
  Write(pheromone, m_vecInterfaces);
}

}  // namespace argos
