#include <argos3/core/wrappers/lua/lua_table.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_registry.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <utility>

namespace argos {

namespace {

constexpr int kStackNeeded = 8;  // slots, by one open table and what is written into it
constexpr int kMinTableSize = 2;  // fields

}  // namespace

CLuaTable::CLuaTable(lua_State* state) : m_state(state) {
  luaL_checkstack(state, kStackNeeded, "too many nested tables");
  m_isReused = lua_rawgetp(state, LUA_REGISTRYINDEX, &kLuaReusedKey) == LUA_TTABLE;
  lua_pop(state, 1);
}

CLuaTable::CLuaTable(lua_State* state, bool isNew, bool isReused, std::string path)
    : m_state(state),
      m_index(lua_gettop(state)),
      m_isNew(isNew),
      m_isReused(isReused),
      m_path(std::move(path)) {
  luaL_checkstack(state, kStackNeeded, "too many nested tables");
}

CLuaTable::~CLuaTable() {
  lua_settop(m_state, m_index - 1);
}

void CLuaTable::OpenRobotTable(const void* device, const char* name) {
  ARGOS_ASSERT(lua_istable(m_state, -1), "the table of the robot is not on the stack");
  lua_getfield(m_state, -1, name);
  m_isNew = !lua_istable(m_state, -1);
  lua_pop(m_state, 1);
  CLuaUtility::OpenRobotStateTable(m_state, name);
  lua_pushvalue(m_state, -1);
  lua_rawsetp(m_state, LUA_REGISTRYINDEX, device);
  CLuaUtility::CloseRobotStateTable(m_state);
  lua_rawgetp(m_state, LUA_REGISTRYINDEX, device);
  m_index = lua_gettop(m_state);
  m_path = "robot." + std::string(name);
}

void CLuaTable::FindRobotTable(const void* device) {
  if (lua_rawgetp(m_state, LUA_REGISTRYINDEX, device) != LUA_TTABLE) {
    lua_pop(m_state, 1);
    THROW_ARGOSEXCEPTION("this device has made no Lua table in CreateLuaState()");
  }
  m_index = lua_gettop(m_state);
}

CLuaTable CLuaTable::GetTable(const char* key) {
  ARGOS_ASSERT(lua_istable(m_state, m_index), "the table of a device is not at " << m_index);
  std::string path = m_path.empty() ? std::string() : GetFunctionName(key);
  const bool isNew = lua_getfield(m_state, m_index, key) != LUA_TTABLE;
  if (isNew) {
    lua_pop(m_state, 1);
    lua_createtable(m_state, 0, kMinTableSize);
    lua_pushvalue(m_state, -1);
    SetField(key);
  }
  return CLuaTable(m_state, isNew, m_isReused, std::move(path));
}

CLuaTable CLuaTable::GetTable(std::size_t index) {
  ARGOS_ASSERT(lua_istable(m_state, m_index) && index > 0, "the table of a device is not at "
                                                               << m_index << ", or " << index
                                                               << " is no index of Lua");
  if (lua_rawgeti(m_state, m_index, static_cast<lua_Integer>(index)) == LUA_TTABLE) {
    return CLuaTable(m_state, false, m_isReused, std::string());
  }
  lua_pop(m_state, 1);
  return MakeTable(index, kMinTableSize);
}

CLuaTable CLuaTable::MakeTable(const char* key, std::size_t numItems, std::size_t numFields) {
  if (m_isReused) {
    if (lua_getfield(m_state, m_index, key) == LUA_TTABLE) {
      return CLuaTable(m_state, false, true, std::string());
    }
    lua_pop(m_state, 1);
  }
  lua_createtable(m_state, static_cast<int>(numItems), static_cast<int>(numFields));
  lua_pushvalue(m_state, -1);
  SetField(key);
  return CLuaTable(m_state, true, m_isReused, std::string());
}

CLuaTable CLuaTable::MakeTable(std::size_t index, int sizeHint) {
  lua_createtable(m_state, 0, sizeHint);
  lua_pushvalue(m_state, -1);
  SetIndex(index);
  return CLuaTable(m_state, true, m_isReused, std::string());
}

void CLuaTable::ReuseReadings(lua_State* state) {
  lua_newtable(state);
  // a list that the script has dropped does not keep its entries
  lua_createtable(state, 0, 1);
  lua_pushliteral(state, "k");
  lua_setfield(state, -2, "__mode");
  lua_setmetatable(state, -2);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &kLuaReusedKey);
}

// the tables of all entries that the list has ever had, from 1 on
CLuaTable CLuaTable::FindSpares() const {
  lua_rawgetp(m_state, LUA_REGISTRYINDEX, &kLuaReusedKey);
  lua_pushvalue(m_state, m_index);
  if (lua_rawget(m_state, -2) != LUA_TTABLE) {
    lua_pop(m_state, 1);
    lua_newtable(m_state);
    lua_pushvalue(m_state, m_index);
    lua_pushvalue(m_state, -2);
    lua_rawset(m_state, -4);
  }
  lua_remove(m_state, -2);
  return CLuaTable(m_state, false, true, std::string());
}

// makes a spare table the entry of that number, whatever the script has put there
CLuaTable CLuaTable::UseSpare(const CLuaTable& spares, std::size_t index) {
  const auto number = static_cast<lua_Integer>(index);
  const bool isNew = lua_rawgeti(m_state, spares.m_index, number) != LUA_TTABLE;
  if (isNew) {
    lua_pop(m_state, 1);
    lua_createtable(m_state, 0, kRecordSizeHint);
    lua_pushvalue(m_state, -1);
    lua_rawseti(m_state, spares.m_index, number);
  }
  lua_pushvalue(m_state, -1);
  SetIndex(index);
  return CLuaTable(m_state, isNew, true, std::string());
}

void CLuaTable::PushField(const char* key) const {
  lua_getfield(m_state, m_index, key);
}

void CLuaTable::PushIndex(std::size_t index) const {
  lua_rawgeti(m_state, m_index, static_cast<lua_Integer>(index));
}

void CLuaTable::Truncate(std::size_t count) {
  for (std::size_t i = lua_rawlen(m_state, m_index); i > count; --i) {
    lua_pushnil(m_state);
    SetIndex(i);
  }
}

std::string CLuaTable::GetFunctionName(const char* name) const {
  return m_path + "." + name;
}

void CLuaTable::SetField(const char* key) {
  lua_setfield(m_state, m_index, key);
}

void CLuaTable::SetIndex(std::size_t index) {
  lua_rawseti(m_state, m_index, static_cast<lua_Integer>(index));
}

void CLuaTable::PushKey(const char* key) {
  lua_pushstring(m_state, key);
}

void CLuaTable::PopKey() {
  lua_pop(m_state, 1);
}

bool CLuaTable::SetInRecord(std::size_t index, Real number) {
  const bool isTable = lua_rawgeti(m_state, m_index, static_cast<lua_Integer>(index)) == LUA_TTABLE;
  if (isTable) {
    lua_pushvalue(m_state, -2);
    lua_pushnumber(m_state, number);
    lua_settable(m_state, -3);
  }
  lua_pop(m_state, 1);
  return isTable;
}

}  // namespace argos
