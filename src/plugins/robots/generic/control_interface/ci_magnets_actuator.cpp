#include <argos3/plugins/robots/generic/control_interface/ci_magnets_actuator.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include <cmath>

namespace argos {

CCI_MagnetsActuator::SInterface::SInterface(const std::string& id, Real current)
    : Id(id), Current(current) {}

CCI_MagnetsActuator::SInterface::TVector& CCI_MagnetsActuator::GetInterfaces() {
  return m_vecInterfaces;
}

void CCI_MagnetsActuator::CreateLuaState(lua_State* state) {
  CLuaTable magnets(state, *this, "magnets");
  for (SInterface& interface : m_vecInterfaces) {
    CLuaTable magnet = magnets.GetTable(interface.Id.c_str());
    magnet.AddFunction("set_current", interface, [](SInterface& self, Real current) {
      if (!std::isfinite(current)) {
        THROW_ARGOSEXCEPTION("argument 1 must be a finite number, got " << current);
      }
      self.Current = current;
    });
  }
}

}  // namespace argos
