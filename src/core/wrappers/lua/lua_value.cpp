#include <argos3/core/wrappers/lua/lua_value.h>

#include <argos3/core/wrappers/lua/lua_types.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

namespace argos {

namespace {

template <typename VALUE>
bool OverwriteUserdata(lua_State* state, const VALUE& value) {
  VALUE* const old = CLuaType<VALUE>::Test(state, -1);
  if (old != nullptr) {
    *old = value;
  }
  lua_pop(state, 1);
  return old != nullptr;
}

// fields of the table on top of the stack
void SetColor(lua_State* state, const CColor& color) {
  lua_pushnumber(state, color.GetRed());
  lua_setfield(state, -2, "red");
  lua_pushnumber(state, color.GetGreen());
  lua_setfield(state, -2, "green");
  lua_pushnumber(state, color.GetBlue());
  lua_setfield(state, -2, "blue");
}

}  // namespace

void CLuaValue::Push(lua_State* state, bool value) {
  lua_pushboolean(state, value ? 1 : 0);
}

void CLuaValue::Push(lua_State* state, Real value) {
  lua_pushnumber(state, value);
}

void CLuaValue::Push(lua_State* state, SLuaInteger value) {
  lua_pushinteger(state, value.Value);
}

void CLuaValue::Push(lua_State* state, const char* value) {
  lua_pushstring(state, value);
}

void CLuaValue::Push(lua_State* state, const std::string& value) {
  lua_pushlstring(state, value.data(), value.size());
}

void CLuaValue::Push(lua_State* state, const CRadians& value) {
  lua_pushnumber(state, value.GetValue());
}

void CLuaValue::Push(lua_State* state, const CVector2& value) {
  CLuaType<CVector2>::Push(state, value);
}

void CLuaValue::Push(lua_State* state, const CVector3& value) {
  CLuaType<CVector3>::Push(state, value);
}

void CLuaValue::Push(lua_State* state, const CQuaternion& value) {
  CLuaType<CQuaternion>::Push(state, value);
}

void CLuaValue::Push(lua_State* state, const CColor& value) {
  lua_createtable(state, 0, 3);
  SetColor(state, value);
}

bool CLuaValue::Overwrite(lua_State* state, const CVector2& value) {
  return OverwriteUserdata(state, value);
}

bool CLuaValue::Overwrite(lua_State* state, const CVector3& value) {
  return OverwriteUserdata(state, value);
}

bool CLuaValue::Overwrite(lua_State* state, const CQuaternion& value) {
  return OverwriteUserdata(state, value);
}

bool CLuaValue::Overwrite(lua_State* state, const CColor& value) {
  const bool isTable = lua_istable(state, -1);
  if (isTable) {
    SetColor(state, value);
  }
  lua_pop(state, 1);
  return isTable;
}

}  // namespace argos
