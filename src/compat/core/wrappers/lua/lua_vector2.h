#ifndef ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_VECTOR2_H
#define ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_VECTOR2_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/wrappers/lua/lua_headers.h>
#include <argos3/core/wrappers/lua/lua_types.h>

#include <string>
#include <utility>

namespace argos {

/**
 * The Lua type vector2, as published with ARGoS 3: a userdatum that holds a CVector2. Our own code
 * uses CLuaType. Where C functions take a state, their arguments and results are on the stack.
 */
class CLuaVector2 {
 public:
  /** Creates the metatable and the constructor, the global function vector2(). */
  static void RegisterType(lua_State* state) { CLuaType<CVector2>::Register(state); }
  /** The name of the metatable in the registry, for luaL_checkudata(). */
  static const std::string& GetTypeId() { return CLuaType<CVector2>::GetTypeId(); }

  /** Pushes CVector2(arguments...). */
  template <typename... ARGUMENTS>
  static void PushVector2(lua_State* state, ARGUMENTS&&... arguments) {
    CLuaType<CVector2>::Push(state, CVector2(std::forward<ARGUMENTS>(arguments)...));
  }
  /** The vector in the userdatum. Raises an error of Lua if the value has another type. */
  static CVector2& ToVector2(lua_State* state, int index) {
    return CLuaType<CVector2>::Get(state, index);
  }

  /** What Lua calls: the constructor, the metamethods and the methods. */
  static int Create(lua_State* state) { return CLuaType<CVector2>::Create(state); }
  static int Index(lua_State* state) { return Call(state, "__index"); }
  static int NewIndex(lua_State* state) { return Call(state, "__newindex"); }
  static int ToString(lua_State* state) { return Call(state, "__tostring"); }
  static int Equal(lua_State* state) { return Call(state, "__eq"); }
  static int Add(lua_State* state) { return Call(state, "__add"); }
  static int Multiply(lua_State* state) { return Call(state, "__mul"); }
  static int Subtract(lua_State* state) { return Call(state, "__sub"); }
  static int UnaryMinus(lua_State* state) { return Call(state, "__unm"); }
  static int Normalize(lua_State* state) { return Call(state, "normalize"); }
  static int Length(lua_State* state) { return Call(state, "length"); }
  static int DotProduct(lua_State* state) { return Call(state, "dot"); }
  static int CrossProduct(lua_State* state) { return Call(state, "cross"); }
  static int Rotate(lua_State* state) { return Call(state, "rotate"); }

 private:
  static int Call(lua_State* state, const char* method) {
    return CLuaType<CVector2>::Call(state, method);
  }
};

}  // namespace argos

#endif
