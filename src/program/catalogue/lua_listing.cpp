#include <argos3/program/catalogue/lua_listing.h>

#include <argos3/core/wrappers/lua/lua_controller.h>
#include <argos3/core/wrappers/lua/lua_headers.h>

#include <algorithm>
#include <map>
#include <set>

namespace argos {

namespace {

constexpr int kDeepest = 5;

// names the type of the value on top of the stack
std::string TypeOf(lua_State* state) {
  if (luaL_getmetafield(state, -1, "__name") == LUA_TSTRING) {
    std::string name = lua_tostring(state, -1);
    lua_pop(state, 1);
    return name;
  }
  return luaL_typename(state, -1);
}

// adds the fields of the table on top of the stack; elements of lists once
void ListTable(lua_State* state, const std::string& path, int depth,
               std::map<std::string, std::string>& entries) {
  if (depth > kDeepest || lua_checkstack(state, 4) == 0) {
    return;
  }
  bool isEmpty = true;
  lua_pushnil(state);
  while (lua_next(state, -2) != 0) {
    isEmpty = false;
    std::string key;
    if (lua_type(state, -2) == LUA_TSTRING) {
      key = lua_tostring(state, -2);
    }
    const bool isItem = lua_type(state, -2) == LUA_TNUMBER;
    if (isItem || (!key.empty() && key[0] != '_')) {
      const std::string entry = isItem ? path + "[i]" : path + '.' + key;
      if (lua_type(state, -1) == LUA_TTABLE) {
        ListTable(state, entry, depth + 1, entries);
      } else {
        entries.emplace(entry, TypeOf(state));
      }
    }
    lua_pop(state, 1);
  }
  if (isEmpty) {
    entries.emplace(path, "list");
  }
}

}  // namespace

std::vector<SLuaEntry> ListLuaDevices(CCI_Controller& controller) {
  auto* const lua = dynamic_cast<CLuaController*>(&controller);
  lua_State* const state = lua == nullptr ? nullptr : lua->GetLuaState();
  if (state == nullptr) {
    return {};
  }
  const int top = lua_gettop(state);
  std::map<std::string, std::string> entries;
  if (lua_getglobal(state, "robot") == LUA_TTABLE) {
    static const std::set<std::string> kCommon = {"id", "params", "random"};
    lua_pushnil(state);
    while (lua_next(state, -2) != 0) {
      const std::string key = lua_type(state, -2) == LUA_TSTRING ? lua_tostring(state, -2) : "";
      if (lua_type(state, -1) == LUA_TTABLE && kCommon.count(key) == 0 && !key.empty()) {
        ListTable(state, "robot." + key, 1, entries);
      }
      lua_pop(state, 1);
    }
  }
  lua_settop(state, top);
  std::vector<SLuaEntry> list;
  for (const auto& [path, type] : entries) {
    list.push_back({path, type});
  }
  std::stable_partition(list.begin(), list.end(),
                        [](const SLuaEntry& entry) { return entry.Type == "function"; });
  return list;
}

}  // namespace argos
