#include <argos3/plugins/robots/generic/control_interface/table_bytes.h>

#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void SetBytes(CLuaTable& table, const char* field, const CByteArray& bytes) {
  CLuaTable list = table.MakeTable(field, bytes.Size(), 0);
  for (size_t i = 0; i < bytes.Size(); ++i) {
    list.Set(i + 1, static_cast<Real>(bytes.ToCArray()[i]));
  }
  if (!list.IsNew()) {
    list.Truncate(bytes.Size());
  }
}

}  // namespace argos
