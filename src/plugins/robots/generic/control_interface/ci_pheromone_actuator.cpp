#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_actuator.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include <cmath>

namespace argos {

Real CCI_PheromoneActuator::CheckRate(const SInterface& interface, Real rate) {
  if (!std::isfinite(rate) || rate < 0.0) {
    THROW_ARGOSEXCEPTION("pheromone actuator: the rate of the layer \""
                         << interface.Layer << "\" must be a number >= 0 (amount per second), got "
                         << rate);
  }
  return rate;
}

void CCI_PheromoneActuator::SetRate(Real rate) {
  SInterface& interface = m_vecInterfaces.front();
  interface.Rate = CheckRate(interface, rate);
}

void CCI_PheromoneActuator::SetRate(const std::string& layer, Real rate) {
  std::vector<std::string> known;
  for (SInterface& interface : m_vecInterfaces) {
    if (interface.Layer == layer) {
      interface.Rate = CheckRate(interface, rate);
      return;
    }
    known.push_back(interface.Layer);
  }
  THROW_ARGOSEXCEPTION("pheromone actuator: unknown layer \"" << layer << "\""
                                                              << DidYouMean(layer, known));
}

void CCI_PheromoneActuator::CreateLuaState(lua_State* state) {
  CLuaTable pheromone(state, *this, "pheromone");
  for (SInterface& interface : m_vecInterfaces) {
    CLuaTable layer = pheromone.GetTable(interface.Layer.c_str());
    layer.AddFunction("set_rate", interface,
                      [](SInterface& self, Real rate) { self.Rate = CheckRate(self, rate); });
  }
}

}  // namespace argos
