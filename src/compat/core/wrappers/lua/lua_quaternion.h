#ifndef ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_QUATERNION_H
#define ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_QUATERNION_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/wrappers/lua/lua_headers.h>
#include <argos3/core/wrappers/lua/lua_types.h>

#include <string>
#include <utility>

namespace argos {

/** The Lua type quaternion, as published with ARGoS 3; see CLuaVector2. */
class CLuaQuaternion {
 public:
  /** Creates the metatable and the constructor, the global function quaternion(). */
  static void RegisterType(lua_State* state) { CLuaType<CQuaternion>::Register(state); }
  /** The name of the metatable in the registry, for luaL_checkudata(). */
  static const std::string& GetTypeId() { return CLuaType<CQuaternion>::GetTypeId(); }

  /** Pushes CQuaternion(arguments...). */
  template <typename... ARGUMENTS>
  static void PushQuaternion(lua_State* state, ARGUMENTS&&... arguments) {
    CLuaType<CQuaternion>::Push(state, CQuaternion(std::forward<ARGUMENTS>(arguments)...));
  }
  /** The quaternion in the userdatum. Raises an error of Lua if the value has another type. */
  static CQuaternion& ToQuaternion(lua_State* state, int index) {
    return CLuaType<CQuaternion>::Get(state, index);
  }

  /** What Lua calls: the constructor, the metamethods and the methods. */
  static int Create(lua_State* state) { return CLuaType<CQuaternion>::Create(state); }
  static int Index(lua_State* state) { return Call(state, "__index"); }
  static int NewIndex(lua_State* state) { return Call(state, "__newindex"); }
  static int ToString(lua_State* state) { return Call(state, "__tostring"); }
  static int Equal(lua_State* state) { return Call(state, "__eq"); }
  static int Multiply(lua_State* state) { return Call(state, "__mul"); }
  static int Normalize(lua_State* state) { return Call(state, "normalize"); }
  static int Inverse(lua_State* state) { return Call(state, "inverse"); }
  static int ToAngleAxis(lua_State* state) { return Call(state, "toangleaxis"); }
  static int ToEulerAngles(lua_State* state) { return Call(state, "toeulerangles"); }

 private:
  static int Call(lua_State* state, const char* method) {
    return CLuaType<CQuaternion>::Call(state, method);
  }
};

}  // namespace argos

#endif
