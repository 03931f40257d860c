#ifndef ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_USER_TYPE_H
#define ARGOS3_COMPAT_CORE_WRAPPERS_LUA_LUA_USER_TYPE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/wrappers/lua/lua_headers.h>
#include <argos3/core/wrappers/lua/lua_types.h>

#include <string>
#include <utility>

namespace argos {

/**
 * Base of the Lua types that ARGoS 3 publishes: a userdatum that holds a VALUE. Our own code uses
 * CLuaType. Where C functions take a state, their arguments and results are on the stack.
 */
template <typename VALUE>
class CLuaUserType {
 public:
  /** Creates the metatable and the constructor, a global function named as the type. */
  static void RegisterType(lua_State* state) { CLuaType<VALUE>::Register(state); }
  /** The name of the metatable in the registry, for luaL_checkudata(). */
  static const std::string& GetTypeId() { return CLuaType<VALUE>::GetTypeId(); }

  /** Called by Lua: the constructor, the metamethods and the methods. */
  static int Create(lua_State* state) { return CLuaType<VALUE>::Create(state); }
  static int Index(lua_State* state) { return Call(state, "__index"); }
  static int NewIndex(lua_State* state) { return Call(state, "__newindex"); }
  static int ToString(lua_State* state) { return Call(state, "__tostring"); }
  static int Equal(lua_State* state) { return Call(state, "__eq"); }
  static int Multiply(lua_State* state) { return Call(state, "__mul"); }
  static int Normalize(lua_State* state) { return Call(state, "normalize"); }

 protected:
  template <typename... ARGUMENTS>
  static void Push(lua_State* state, ARGUMENTS&&... arguments) {
    CLuaType<VALUE>::Push(state, VALUE(std::forward<ARGUMENTS>(arguments)...));
  }
  static VALUE& Get(lua_State* state, int index) { return CLuaType<VALUE>::Get(state, index); }
  static int Call(lua_State* state, const char* method) {
    return CLuaType<VALUE>::Call(state, method);
  }
};

/** Base of the Lua types vector2 and vector3. */
template <typename VECTOR>
class CLuaVectorType : public CLuaUserType<VECTOR> {
 public:
  static int Add(lua_State* state) { return TBase::Call(state, "__add"); }
  static int Subtract(lua_State* state) { return TBase::Call(state, "__sub"); }
  static int UnaryMinus(lua_State* state) { return TBase::Call(state, "__unm"); }
  static int Length(lua_State* state) { return TBase::Call(state, "length"); }
  static int DotProduct(lua_State* state) { return TBase::Call(state, "dot"); }
  static int CrossProduct(lua_State* state) { return TBase::Call(state, "cross"); }
  static int Rotate(lua_State* state) { return TBase::Call(state, "rotate"); }

 private:
  using TBase = CLuaUserType<VECTOR>;
};

}  // namespace argos

#endif
