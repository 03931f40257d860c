#include <argos3/plugins/robots/pi-puck/control_interface/pipuck_transform.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void WriteTransform(CLuaTable& record, const CVector3& position, const CQuaternion& orientation,
                    const std::string& anchor) {
  CLuaTable transform = record.GetTable("transform");
  transform.Set("position", position);
  transform.Set("orientation", orientation);
  transform.Set("anchor", anchor);
}

}  // namespace argos
