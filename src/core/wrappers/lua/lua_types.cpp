#include <argos3/core/wrappers/lua/lua_types.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/wrappers/lua/lua_own_metatable.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <type_traits>

// Lua leaves a C function with longjmp() when it raises an error: no object in this file may need a
// destructor.

namespace argos {

namespace {

template <typename VALUE>
constexpr char kMetatableKey = 0;  // key in the registry, by address

template <typename VALUE>
struct STraits;

template <>
struct STraits<CVector2> {
  static constexpr const char* kTypeId = "argos3.vector2";
  static constexpr const char* kName = "vector2";
  static constexpr const char* kKeys = "xy";
  static Real Get(const CVector2& v, int i) { return i == 0 ? v.GetX() : v.GetY(); }
  static void Set(CVector2& v, int i, Real x) { i == 0 ? v.SetX(x) : v.SetY(x); }
};

template <>
struct STraits<CVector3> {
  static constexpr const char* kTypeId = "argos3.vector3";
  static constexpr const char* kName = "vector3";
  static constexpr const char* kKeys = "xyz";
  static Real Get(const CVector3& v, int i) { return v[i]; }
  static void Set(CVector3& v, int i, Real x) { v[i] = x; }
};

template <>
struct STraits<CQuaternion> {
  static constexpr const char* kTypeId = "argos3.quaternion";
  static constexpr const char* kName = "quaternion";
  static constexpr const char* kKeys = "wxyz";
  static Real Get(const CQuaternion& q, int i) {
    const Real parts[] = {q.GetW(), q.GetX(), q.GetY(), q.GetZ()};
    return parts[i];
  }
  static void Set(CQuaternion& q, int i, Real x) {
    Real parts[] = {q.GetW(), q.GetX(), q.GetY(), q.GetZ()};
    parts[i] = x;
    q.Set(parts[0], parts[1], parts[2], parts[3]);
  }
};

/** Raises "vector2:dot: argument 1 must be a vector2, got nil". */
template <typename VALUE>
[[noreturn]] void RaiseArgument(lua_State* state, const char* function, int index,
                                const char* expected) {
  // with object:method(x), self is not counted as an argument
  luaL_error(state, "%s:%s: argument %d must be %s, got %s", STraits<VALUE>::kName, function,
             index - 1, expected, GetLuaTypeName(state, index));
  std::abort();  // luaL_error() does not return, which its declaration does not say
}

template <typename VALUE>
VALUE& CheckSelf(lua_State* state, const char* function, int numArguments) {
  VALUE* const self = TestOwn<VALUE>(state, 1);
  if (self == nullptr) {
    luaL_error(state, "%s:%s must be called on a %s with a colon, got %s", STraits<VALUE>::kName,
               function, STraits<VALUE>::kName, GetLuaTypeName(state, 1));
  }
  if (lua_gettop(state) > 1 + numArguments) {
    luaL_error(state, "%s:%s takes %d argument%s, got %d", STraits<VALUE>::kName, function,
               numArguments, numArguments == 1 ? "" : "s", lua_gettop(state) - 1);
  }
  return *self;
}

template <typename VALUE>
Real CheckNumber(lua_State* state, const char* function, int index) {
  if (lua_type(state, index) != LUA_TNUMBER) {
    RaiseArgument<VALUE>(state, function, index, "a number");
  }
  return lua_tonumber(state, index);
}

template <typename VALUE, typename OTHER>
const OTHER& CheckValue(lua_State* state, const char* function, int index) {
  const OTHER* other = nullptr;
  if constexpr (std::is_same_v<VALUE, OTHER>) {
    other = TestOwn<OTHER>(state, index);
  } else {
    other = CLuaType<OTHER>::Test(state, index);
  }
  if (other == nullptr) {
    char expected[32];
    std::snprintf(expected, sizeof expected, "a %s", STraits<OTHER>::kName);
    RaiseArgument<VALUE>(state, function, index, expected);
  }
  return *other;
}

// Constructors.

[[noreturn]] void RaiseConstructor(lua_State* state, const char* text) {
  char found[128] = "nothing";
  int length = 0;
  for (int i = 1; i <= lua_gettop(state) && length < static_cast<int>(sizeof found) - 16; ++i) {
    length += std::snprintf(found + length, sizeof found - length, "%s%s", i == 1 ? "" : ", ",
                            GetLuaTypeName(state, i));
  }
  luaL_error(state, "%s, got %s", text, found);
  std::abort();  // is not reached
}

bool AreNumbers(lua_State* state, int count) {
  for (int i = 1; i <= count; ++i) {
    if (lua_type(state, i) != LUA_TNUMBER) {
      return false;
    }
  }
  return lua_gettop(state) == count;
}

/** Copies the argument, or reads one number for each component. */
template <typename VALUE>
bool ConstructFromSame(lua_State* state, VALUE& value) {
  const int count = lua_gettop(state);
  if (count == 0) {
    return true;
  }
  if (const VALUE* other = TestOwn<VALUE>(state, 1); count == 1 && other != nullptr) {
    value = *other;
    return true;
  }
  const int numKeys = static_cast<int>(std::char_traits<char>::length(STraits<VALUE>::kKeys));
  if (!AreNumbers(state, numKeys)) {
    return false;
  }
  for (int i = 0; i < numKeys; ++i) {
    STraits<VALUE>::Set(value, i, lua_tonumber(state, i + 1));
  }
  return true;
}

int Construct2(lua_State* state) {
  CVector2 value;
  if (!ConstructFromSame(state, value)) {
    RaiseConstructor(state, "vector2 takes nothing, a vector2, or the numbers x, y");
  }
  PushOwn(state, value);
  return 1;
}

int Construct3(lua_State* state) {
  CVector3 value;
  if (!ConstructFromSame(state, value)) {
    RaiseConstructor(state, "vector3 takes nothing, a vector3, or the numbers x, y, z");
  }
  PushOwn(state, value);
  return 1;
}

int ConstructQuaternion(lua_State* state) {
  CQuaternion value;
  if (!ConstructFromSame(state, value)) {
    CVector3* const axis = CLuaType<CVector3>::Test(state, 2);
    if (lua_gettop(state) != 2 || lua_type(state, 1) != LUA_TNUMBER || axis == nullptr) {
      RaiseConstructor(
          state,
          "quaternion takes nothing, a quaternion, the numbers w, x, y, z, or an angle "
          "in radians and an axis, a vector3");
    }
    const Real length = axis->Length();
    if (!(length > 0.0) || !std::isfinite(length)) {
      luaL_error(state, "quaternion: the axis must not be the zero vector, nor infinite");
    }
    value.FromAngleAxis(CRadians(lua_tonumber(state, 1)), *axis / length);
  }
  PushOwn(state, value);
  return 1;
}

// Metamethods.

/** The component that the key on the stack names; a wrong letter is an error. */
template <typename VALUE>
int FindComponent(lua_State* state, const char* key) {
  for (int i = 0; STraits<VALUE>::kKeys[i] != '\0'; ++i) {
    if (STraits<VALUE>::kKeys[i] == key[0]) {
      return i;
    }
  }
  return luaL_error(state, "a %s has no component '%s', only those of \"%s\"",
                    STraits<VALUE>::kName, key, STraits<VALUE>::kKeys);
}

bool IsLetter(lua_State* state, const char*& key) {
  if (lua_type(state, 2) != LUA_TSTRING) {
    return false;
  }
  std::size_t length = 0;
  key = lua_tolstring(state, 2, &length);
  return length == 1;
}

template <typename VALUE>
int Index(lua_State* state) {
  const VALUE* const self = TestOwn<VALUE>(state, 1);
  const char* key = nullptr;
  if (self != nullptr && IsLetter(state, key)) {
    lua_pushnumber(state, STraits<VALUE>::Get(*self, FindComponent<VALUE>(state, key)));
    return 1;
  }
  lua_settop(state, 2);
  lua_rawget(state, lua_upvalueindex(kMethods));
  return 1;
}

template <typename VALUE>
int NewIndex(lua_State* state) {
  VALUE* const self = TestOwn<VALUE>(state, 1);
  const char* key = nullptr;
  if (self == nullptr || !IsLetter(state, key)) {
    return luaL_error(state, "a %s has only the components of \"%s\"", STraits<VALUE>::kName,
                      STraits<VALUE>::kKeys);
  }
  const int component = FindComponent<VALUE>(state, key);
  if (lua_type(state, 3) != LUA_TNUMBER) {
    return luaL_error(state, "component '%s' of a %s must be a number, got %s", key,
                      STraits<VALUE>::kName, GetLuaTypeName(state, 3));
  }
  STraits<VALUE>::Set(*self, component, lua_tonumber(state, 3));
  return 0;
}

template <typename VALUE>
int ToString(lua_State* state) {
  const VALUE& v = CheckSelf<VALUE>(state, "__tostring", 1);
  char text[96];
  if constexpr (std::is_same_v<VALUE, CVector2>) {
    std::snprintf(text, sizeof text, "%.6g,%.6g", v.GetX(), v.GetY());
  } else if constexpr (std::is_same_v<VALUE, CVector3>) {
    std::snprintf(text, sizeof text, "%.6g,%.6g,%.6g", v.GetX(), v.GetY(), v.GetZ());
  } else {
    CRadians z;
    CRadians y;
    CRadians x;
    v.ToEulerAngles(z, y, x);
    std::snprintf(text, sizeof text, "%.6g,%.6g,%.6g", ToDegrees(z).GetValue(),
                  ToDegrees(y).GetValue(), ToDegrees(x).GetValue());
  }
  lua_pushstring(state, text);
  return 1;
}

template <typename VALUE>
int Equal(lua_State* state) {
  const VALUE* const a = TestOwn<VALUE>(state, 1);
  const VALUE* const b = TestOwn<VALUE>(state, 2);
  lua_pushboolean(state, a != nullptr && b != nullptr && *a == *b);
  return 1;
}

[[noreturn]] void RaiseOperands(lua_State* state, const char* what) {
  luaL_error(state, "%s, got %s and %s", what, GetLuaTypeName(state, 1), GetLuaTypeName(state, 2));
  std::abort();  // is not reached
}

// what: the error if an operand is another value
template <typename VALUE, typename OPERATION>
int PushResult(lua_State* state, OPERATION operation, const char* what) {
  const VALUE* const a = TestOwn<VALUE>(state, 1);
  const VALUE* const b = TestOwn<VALUE>(state, 2);
  if (a == nullptr || b == nullptr) {
    RaiseOperands(state, what);
  }
  PushOwn(state, operation(*a, *b));
  return 1;
}

template <typename VALUE>
int Add(lua_State* state) {
  return PushResult<VALUE>(state, std::plus<VALUE>(), "a vector can be added to one of its kind");
}

template <typename VALUE>
int Subtract(lua_State* state) {
  return PushResult<VALUE>(state, std::minus<VALUE>(),
                           "a vector can be subtracted from one of its kind");
}

template <typename VALUE>
int Negate(lua_State* state) {
  const VALUE* const vector = TestOwn<VALUE>(state, 1);
  if (vector == nullptr) {
    return luaL_error(state, "%s:__unm takes a %s, got %s", STraits<VALUE>::kName,
                      STraits<VALUE>::kName, GetLuaTypeName(state, 1));
  }
  PushOwn(state, -*vector);
  return 1;
}

template <typename VALUE>
int Scale(lua_State* state) {
  const VALUE* vector = TestOwn<VALUE>(state, 1);
  int factor = 2;
  if (vector == nullptr) {
    vector = TestOwn<VALUE>(state, 2);
    factor = 1;
  }
  if (vector == nullptr || lua_type(state, factor) != LUA_TNUMBER) {
    RaiseOperands(state, "a vector can be multiplied by a number");
  }
  PushOwn(state, *vector * lua_tonumber(state, factor));
  return 1;
}

int MultiplyQuaternions(lua_State* state) {
  return PushResult<CQuaternion>(state, std::multiplies<CQuaternion>(),
                                 "a quaternion can be multiplied by a quaternion");
}

// Methods.

template <typename VALUE>
int Length(lua_State* state) {
  lua_pushnumber(state, CheckSelf<VALUE>(state, "length", 0).Length());
  return 1;
}

template <typename VALUE>
int Dot(lua_State* state) {
  const VALUE& self = CheckSelf<VALUE>(state, "dot", 1);
  lua_pushnumber(state, self.DotProduct(CheckValue<VALUE, VALUE>(state, "dot", 2)));
  return 1;
}

template <typename VALUE>
int Normalize(lua_State* state) {
  VALUE& self = CheckSelf<VALUE>(state, "normalize", 0);
  const Real length = self.Length();
  if (!(length > 0.0) || !std::isfinite(length)) {
    return luaL_error(state, "%s:normalize: a %s of length %f has no direction",
                      STraits<VALUE>::kName, STraits<VALUE>::kName, length);
  }
  self.Normalize();
  lua_settop(state, 1);
  return 1;
}

int Rotate2(lua_State* state) {
  CVector2& self = CheckSelf<CVector2>(state, "rotate", 1);
  self.Rotate(CRadians(CheckNumber<CVector2>(state, "rotate", 2)));
  lua_settop(state, 1);
  return 1;
}

int Rotate3(lua_State* state) {
  CVector3& self = CheckSelf<CVector3>(state, "rotate", 1);
  self.Rotate(CheckValue<CVector3, CQuaternion>(state, "rotate", 2));
  lua_settop(state, 1);
  return 1;
}

int Cross2(lua_State* state) {
  const CVector2& self = CheckSelf<CVector2>(state, "cross", 1);
  lua_pushnumber(state, self.CrossProduct(CheckValue<CVector2, CVector2>(state, "cross", 2)));
  return 1;
}

int Cross3(lua_State* state) {
  CVector3& self = CheckSelf<CVector3>(state, "cross", 1);
  self.CrossProduct(CheckValue<CVector3, CVector3>(state, "cross", 2));
  lua_settop(state, 1);
  return 1;
}

int Inverse(lua_State* state) {
  PushOwn(state, CheckSelf<CQuaternion>(state, "inverse", 0).Inverse());
  return 1;
}

int ToAngleAxis(lua_State* state) {
  const CQuaternion& self = CheckSelf<CQuaternion>(state, "toangleaxis", 0);
  CRadians angle;
  CVector3 axis;
  self.ToAngleAxis(angle, axis);
  lua_pushnumber(state, angle.GetValue());
  CLuaType<CVector3>::Push(state, axis);
  return 2;
}

int ToEulerAngles(lua_State* state) {
  const CQuaternion& self = CheckSelf<CQuaternion>(state, "toeulerangles", 0);
  CRadians z;
  CRadians y;
  CRadians x;
  self.ToEulerAngles(z, y, x);
  lua_pushnumber(state, z.GetValue());
  lua_pushnumber(state, y.GetValue());
  lua_pushnumber(state, x.GetValue());
  return 3;
}

constexpr luaL_Reg kMethods2[] = {
    {"length", Length<CVector2>},       {"dot", Dot<CVector2>}, {"cross", Cross2},
    {"normalize", Normalize<CVector2>}, {"rotate", Rotate2},    {nullptr, nullptr}};

constexpr luaL_Reg kMethods3[] = {
    {"length", Length<CVector3>},       {"dot", Dot<CVector3>}, {"cross", Cross3},
    {"normalize", Normalize<CVector3>}, {"rotate", Rotate3},    {nullptr, nullptr}};

constexpr luaL_Reg kMethodsQuaternion[] = {{"normalize", Normalize<CQuaternion>},
                                           {"inverse", Inverse},
                                           {"toangleaxis", ToAngleAxis},
                                           {"toeulerangles", ToEulerAngles},
                                           {nullptr, nullptr}};

template <typename VALUE>
constexpr luaL_Reg kVectorOperators[] = {{"__add", Add<VALUE>},
                                         {"__sub", Subtract<VALUE>},
                                         {"__unm", Negate<VALUE>},
                                         {"__mul", Scale<VALUE>},
                                         {nullptr, nullptr}};

constexpr luaL_Reg kQuaternionOperators[] = {{"__mul", MultiplyQuaternions}, {nullptr, nullptr}};

/** Sets functions of the type in the table on top of the stack. @param metatable  its index. */
void SetFunctions(lua_State* state, const luaL_Reg* functions, int metatable) {
  lua_pushvalue(state, metatable);
  luaL_setfuncs(state, functions, kMetatable);
}

}  // namespace

template <typename VALUE>
void PushMetatable(lua_State* state) {
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, &kMetatableKey<VALUE>) == LUA_TTABLE) {
    return;
  }
  lua_pop(state, 1);
  lua_createtable(state, 0, 10);
  const int metatable = lua_gettop(state);
  const luaL_Reg* operators = nullptr;
  const luaL_Reg* methods = kMethodsQuaternion;
  if constexpr (std::is_same_v<VALUE, CQuaternion>) {
    operators = kQuaternionOperators;
  } else {
    operators = kVectorOperators<VALUE>;
    methods = std::is_same_v<VALUE, CVector2> ? kMethods2 : kMethods3;
  }
  SetFunctions(state, operators, metatable);
  lua_pushvalue(state, metatable);
  lua_createtable(state, 0, 5);
  SetFunctions(state, methods, metatable);
  lua_pushcclosure(state, Index<VALUE>, kMethods);
  lua_setfield(state, metatable, "__index");
  constexpr luaL_Reg kCommon[] = {{"__newindex", NewIndex<VALUE>},
                                  {"__tostring", ToString<VALUE>},
                                  {"__eq", Equal<VALUE>},
                                  {nullptr, nullptr}};
  SetFunctions(state, kCommon, metatable);
  lua_pushstring(state, STraits<VALUE>::kName);
  lua_setfield(state, -2, "__name");
  // found by address here, and by name in users' code
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &kMetatableKey<VALUE>);
  lua_pushvalue(state, -1);
  lua_setfield(state, LUA_REGISTRYINDEX, STraits<VALUE>::kTypeId);
}

template <typename VALUE>
void CLuaType<VALUE>::Register(lua_State* state) {
  PushMetatable<VALUE>(state);
  lua_pushcclosure(state, &CLuaType::Create, kMetatable);
  lua_setglobal(state, STraits<VALUE>::kName);
}

template <typename VALUE>
void CLuaType<VALUE>::Push(lua_State* state, const VALUE& value) {
  PushBare(state, value);
  PushMetatable<VALUE>(state);
  lua_setmetatable(state, -2);
}

template <typename VALUE>
VALUE* CLuaType<VALUE>::Test(lua_State* state, int index) {
  void* const data = lua_touserdata(state, index);
  if (data == nullptr || lua_islightuserdata(state, index) || lua_getmetatable(state, index) == 0) {
    return nullptr;
  }
  lua_rawgetp(state, LUA_REGISTRYINDEX, &kMetatableKey<VALUE>);
  const bool same = lua_rawequal(state, -1, -2) != 0 && !lua_isnil(state, -1);
  lua_pop(state, 2);
  return same ? static_cast<VALUE*>(data) : nullptr;
}

template <typename VALUE>
VALUE& CLuaType<VALUE>::Get(lua_State* state, int index) {
  VALUE* const value = Test(state, index);
  if (value == nullptr) {
    luaL_error(state, "expected a %s, got %s", STraits<VALUE>::kName, GetLuaTypeName(state, index));
  }
  return *value;
}

template <typename VALUE>
int CLuaType<VALUE>::Create(lua_State* state) {
  if constexpr (std::is_same_v<VALUE, CVector2>) {
    return Construct2(state);
  } else if constexpr (std::is_same_v<VALUE, CVector3>) {
    return Construct3(state);
  } else {
    return ConstructQuaternion(state);
  }
}

template <typename VALUE>
int CLuaType<VALUE>::Call(lua_State* state, const char* method) {
  const int numArguments = lua_gettop(state);
  PushMetatable<VALUE>(state);
  if (method[0] != '_') {
    // __index is a closure with the methods
    lua_getfield(state, -1, "__index");
    lua_getupvalue(state, -1, kMethods);
    lua_replace(state, -3);
    lua_pop(state, 1);
  }
  lua_getfield(state, -1, method);
  lua_insert(state, 1);
  lua_pop(state, 1);
  lua_call(state, numArguments, LUA_MULTRET);
  return lua_gettop(state);
}

template <typename VALUE>
const std::string& CLuaType<VALUE>::GetTypeId() {
  static const std::string id = STraits<VALUE>::kTypeId;
  return id;
}

template class CLuaType<CVector2>;
template class CLuaType<CVector3>;
template class CLuaType<CQuaternion>;

const char* GetLuaTypeName(lua_State* state, int index) {
  if (CLuaType<CVector2>::Test(state, index) != nullptr) {
    return STraits<CVector2>::kName;
  }
  if (CLuaType<CVector3>::Test(state, index) != nullptr) {
    return STraits<CVector3>::kName;
  }
  if (CLuaType<CQuaternion>::Test(state, index) != nullptr) {
    return STraits<CQuaternion>::kName;
  }
  return lua_isnone(state, index) ? "nothing" : luaL_typename(state, index);
}

}  // namespace argos
