#include <argos3/plugins/robots/generic/control_interface/colored_blobs.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CSwitchedTableSensor::WriteConstants(CLuaTable& table) {
  table.AddMethod<&CSwitchedTableSensor::Enable>("enable", *this);
  table.AddMethod<&CSwitchedTableSensor::Disable>("disable", *this);
}

}  // namespace argos
