#include <argos3/core/wrappers/lua/lua_utility.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/wrappers/lua/lua_keys.h>
#include <argos3/core/wrappers/lua/lua_random.h>
#include <argos3/core/wrappers/lua/lua_registry.h>
#include <argos3/core/wrappers/lua/lua_types.h>
#include <argos3/core/wrappers/lua/lua_value.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>

namespace argos {

namespace {

constexpr int kDeepestPrinted = 8;  // nested tables

constexpr char kOwnRandomKey = 0;  // key in the registry of the userdata that RegisterRNG() made

/** Appends what log() writes for a value. */
void AppendForLog(lua_State* state, luaL_Buffer& buffer, int index) {
  switch (lua_type(state, index)) {
    case LUA_TSTRING:
      lua_pushvalue(state, index);
      luaL_addvalue(&buffer);
      break;
    case LUA_TNUMBER: {
      // prints a number as a C++ stream does
      char text[32];
      const auto end = fmt::format_to_n(text, sizeof text, "{:.6g}", lua_tonumber(state, index));
      luaL_addlstring(&buffer, text, end.size);
      break;
    }
    case LUA_TBOOLEAN:
      luaL_addchar(&buffer, lua_toboolean(state, index) != 0 ? '1' : '0');
      break;
    default:
      luaL_addstring(&buffer, luaL_typename(state, index));
  }
}

/** The function log or logerr; its upvalue is the log. */
int Log(lua_State* state) {
  const int count = lua_gettop(state);
  luaL_Buffer buffer;
  luaL_buffinit(state, &buffer);
  for (int i = 1; i <= count; ++i) {
    AppendForLog(state, buffer, i);
  }
  luaL_addchar(&buffer, '\n');
  luaL_pushresult(&buffer);
  std::size_t length = 0;
  const char* const text = lua_tolstring(state, -1, &length);
  auto& log = *static_cast<CARGoSLog*>(lua_touserdata(state, lua_upvalueindex(1)));
  log << std::string_view(text, length);
  return 0;
}

void RegisterLog(lua_State* state, const char* name, CARGoSLog& log) {
  lua_pushlightuserdata(state, &log);
  lua_pushcclosure(state, Log, 1);
  lua_setglobal(state, name);
}

int CollectRandom(lua_State* state) {
  static_cast<CLuaRandom*>(lua_touserdata(state, 1))->~CLuaRandom();
  return 0;
}

// The functions that print make their texts on Lua's stack: a script's __tostring may raise an
// error, which would skip the destructor of a std::string.

/** Pushes "wander" or 3.5 or table: ... */
void PushFormatted(lua_State* state, int index) {
  const bool isText = lua_type(state, index) == LUA_TSTRING;
  luaL_tolstring(state, index, nullptr);
  if (isText) {
    lua_pushliteral(state, "\"");
    lua_insert(state, -2);
    lua_pushliteral(state, "\"");
    lua_concat(state, 3);
  }
}

/** The string at an index; valid while it is on the stack. */
std::string_view ViewString(lua_State* state, int index) {
  std::size_t length = 0;
  const char* const text = lua_tolstring(state, index, &length);
  return std::string_view(text, length);
}

/** Writes the entries of the table on top of the stack. */
void PrintTable(CARGoSLog& log, lua_State* state, int depth) {
  luaL_checkstack(state, LUA_MINSTACK, "too many nested tables");
  const int table = lua_gettop(state);
  PushOrderedKeys(state, table);
  const int keys = table + 1;
  const auto count = static_cast<lua_Integer>(lua_rawlen(state, keys));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(state, keys, i);
    luaL_tolstring(state, -1, nullptr);
    lua_insert(state, -2);
    lua_rawget(state, table);
    PushFormatted(state, -1);
    const std::string_view key = ViewString(state, keys + 1);
    log << std::string(2 * static_cast<std::size_t>(depth), ' ').append(key) + " = " +
               std::string(ViewString(state, keys + 3)) + "\n";
    lua_settop(state, keys + 2);
    if (lua_istable(state, -1) && key != "_G" && key != "package" && depth < kDeepestPrinted) {
      PrintTable(log, state, depth + 1);
    }
    lua_settop(state, keys);
  }
  lua_settop(state, table);
}

void CheckClaim(lua_State* state, const std::string& name) {
  lua_rawgetp(state, LUA_REGISTRYINDEX, &kLuaDeviceKey);
  const auto* const device = static_cast<const SLuaDevice*>(lua_touserdata(state, -1));
  lua_pop(state, 1);
  if (device == nullptr) {
    return;
  }
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, &kLuaClaimsKey) != LUA_TTABLE) {
    lua_pop(state, 1);
    lua_newtable(state);
    lua_pushvalue(state, -1);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kLuaClaimsKey);
  }
  const std::string claim = std::string(device->Kind) + " " + name;
  lua_getfield(state, -1, claim.c_str());
  const char* const owner = lua_tostring(state, -1);
  if (owner != nullptr && owner != device->Label) {
    THROW_ARGOSEXCEPTION("the " << device->Kind << "s <" << owner << "> and <" << device->Label
                                << "> would both write into the Lua table robot." << name
                                << "; use one of them");
  }
  lua_pop(state, 1);
  CLuaValue::Push(state, device->Label);
  lua_setfield(state, -2, claim.c_str());
  lua_pop(state, 1);
}

}  // namespace

bool CLuaUtility::LoadScript(lua_State* state, const std::string& filename) {
  const std::string problem = FindInputProblem(filename);
  if (!problem.empty()) {
    lua_pushfstring(state, "cannot read the Lua script \"%s\": %s", filename.c_str(),
                    problem.c_str());
    return false;
  }
  return luaL_loadfile(state, filename.c_str()) == LUA_OK && lua_pcall(state, 0, 0, 0) == LUA_OK;
}

bool CLuaUtility::CallLuaFunction(lua_State* state, const std::string& function) {
  if (lua_getglobal(state, function.c_str()) != LUA_TFUNCTION) {
    const char* const found = luaL_typename(state, -1);
    lua_pop(state, 1);
    lua_pushfstring(state, "the global \"%s\" must be a function, got %s", function.c_str(), found);
    return false;
  }
  return lua_pcall(state, 0, 0, 0) == LUA_OK;
}

void CLuaUtility::PrintGlobals(CARGoSLog& log, lua_State* state) {
  lua_pushglobaltable(state);
  PrintTable(log, state, 0);
  lua_pop(state, 1);
}

void CLuaUtility::PrintStack(CARGoSLog& log, lua_State* state) {
  const int top = lua_gettop(state);
  for (int i = 1; i <= top; ++i) {
    PushFormatted(state, i);
    std::string line("#");
    line += std::to_string(i) + " " + luaL_typename(state, i) + " ";
    line += ViewString(state, -1);
    log << line + "\n";
    lua_pop(state, 1);
  }
}

void CLuaUtility::RegisterLoggerWrapper(lua_State* state) {
  RegisterLog(state, "log", LOG);
  RegisterLog(state, "logerr", LOGERR);
}

void CLuaUtility::RegisterRNG(lua_State* state, CRandom::CRNG* rng) {
  auto* const random = std::construct_at(
      static_cast<CLuaRandom*>(lua_newuserdatauv(state, sizeof(CLuaRandom), 0)), *rng);
  lua_createtable(state, 0, 1);
  lua_pushcfunction(state, CollectRandom);
  lua_setfield(state, -2, "__gc");
  lua_setmetatable(state, -2);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &kOwnRandomKey);
  StartTable(state, "random");
  random->Register(state);
  EndTable(state);
}

void CLuaUtility::RegisterTypes(lua_State* state) {
  CLuaType<CVector2>::Register(state);
  CLuaType<CVector3>::Register(state);
  CLuaType<CQuaternion>::Register(state);
}

void CLuaUtility::OpenRobotStateTable(lua_State* state, const std::string& name) {
  CheckClaim(state, name);
  CLuaValue::Push(state, name);
  lua_pushvalue(state, -1);
  if (lua_rawget(state, -3) != LUA_TTABLE) {
    lua_pop(state, 1);
    lua_newtable(state);
  }
}

void CLuaUtility::CloseRobotStateTable(lua_State* state) {
  lua_rawset(state, -3);
}

void CLuaUtility::StartTable(lua_State* state, const std::string& key) {
  CLuaValue::Push(state, key);
  lua_newtable(state);
}

void CLuaUtility::StartTable(lua_State* state, int key) {
  lua_pushinteger(state, key);
  lua_newtable(state);
}

void CLuaUtility::EndTable(lua_State* state) {
  lua_rawset(state, -3);
}

void CLuaUtility::SetMetatable(lua_State* state, const std::string& name) {
  luaL_setmetatable(state, name.c_str());
}

void* CLuaUtility::GetInstance(lua_State* state, const std::string& key) {
  const int top = lua_gettop(state);
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, &kLuaRobotKey) != LUA_TTABLE) {
    lua_getglobal(state, "robot");
  }
  for (std::size_t start = 0; start <= key.size() && lua_istable(state, -1);) {
    const std::size_t end = std::min(key.find('.', start), key.size());
    lua_pushlstring(state, key.data() + start, end - start);
    lua_rawget(state, -2);
    start = end + 1;
  }
  void* instance = nullptr;
  if (lua_istable(state, -1)) {
    lua_pushstring(state, "_instance");
    lua_rawget(state, -2);
    instance = lua_touserdata(state, -1);
  }
  lua_settop(state, top);
  return instance;
}

// The overloads of AddToTable: each pushes the value, then stores it.

void CLuaUtility::AddToTable(lua_State* state, const std::string& key, void* value) {
  lua_pushlightuserdata(state, value);
  lua_setfield(state, -2, key.c_str());
}

void CLuaUtility::AddToTable(lua_State* state, const std::string& key, lua_CFunction value) {
  lua_pushcfunction(state, value);
  lua_setfield(state, -2, key.c_str());
}

namespace {

template <typename T>
void AddByName(lua_State* state, const std::string& key, const T& value) {
  CLuaValue::Push(state, value);
  lua_setfield(state, -2, key.c_str());
}

template <typename T>
void AddByNumber(lua_State* state, int key, const T& value) {
  CLuaValue::Push(state, value);
  lua_rawseti(state, -2, key);
}

}  // namespace

void CLuaUtility::AddToTable(lua_State* state, const std::string& key, const std::string& value) {
  AddByName(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, int key, const std::string& value) {
  AddByNumber(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, const std::string& key, Real value) {
  AddByName(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, int key, Real value) {
  AddByNumber(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, const std::string& key, const CRadians& value) {
  AddByName(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, int key, const CRadians& value) {
  AddByNumber(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, const std::string& key, const CVector2& value) {
  AddByName(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, int key, const CVector2& value) {
  AddByNumber(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, const std::string& key, const CVector3& value) {
  AddByName(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, int key, const CVector3& value) {
  AddByNumber(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, const std::string& key, const CQuaternion& value) {
  AddByName(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, int key, const CQuaternion& value) {
  AddByNumber(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, const std::string& key, const CColor& value) {
  AddByName(state, key, value);
}

void CLuaUtility::AddToTable(lua_State* state, int key, const CColor& value) {
  AddByNumber(state, key, value);
}

}  // namespace argos
