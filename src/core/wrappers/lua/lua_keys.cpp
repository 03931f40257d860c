#include <argos3/core/wrappers/lua/lua_keys.h>

#include <argos3/core/wrappers/lua/lua_utility.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace argos {

namespace {

enum class EKind { NUMBER, STRING, BOOLEAN, OTHER };

struct SKey {
  EKind Kind;
  bool IsInteger;
  lua_Integer Integer;  // of a number that is an integer; of a boolean, 0 or 1
  lua_Number Number;
  std::string_view Text;  // lives as long as the list that holds the key
  lua_Integer Place;  // in the list, from 1
};

SKey Describe(lua_State* state, int index, lua_Integer place) {
  SKey key{EKind::OTHER, false, 0, 0.0, {}, place};
  switch (lua_type(state, index)) {
    case LUA_TNUMBER:
      key.Kind = EKind::NUMBER;
      key.IsInteger = lua_isinteger(state, index) != 0;
      key.Integer = key.IsInteger ? lua_tointeger(state, index) : 0;
      key.Number = lua_tonumber(state, index);
      break;
    case LUA_TSTRING: {
      key.Kind = EKind::STRING;
      std::size_t length = 0;
      const char* const text = lua_tolstring(state, index, &length);
      key.Text = std::string_view(text, length);
      break;
    }
    case LUA_TBOOLEAN:
      key.Kind = EKind::BOOLEAN;
      key.Integer = lua_toboolean(state, index);
      break;
    default:
      break;
  }
  return key;
}

bool operator<(const SKey& a, const SKey& b) {
  if (a.Kind != b.Kind) {
    return a.Kind < b.Kind;
  }
  switch (a.Kind) {
    case EKind::NUMBER:
      if (a.IsInteger && b.IsInteger) {
        return a.Integer < b.Integer;
      }
      return a.Number != b.Number ? a.Number < b.Number : a.Place < b.Place;
    case EKind::STRING:
      return a.Text < b.Text;
    case EKind::BOOLEAN:
      return a.Integer < b.Integer;
    default:
      return a.Place < b.Place;
  }
}

}  // namespace

void PushOrderedKeys(lua_State* state, int index) {
  const int table = lua_absindex(state, index);
  luaL_checkstack(state, 4, "too many nested tables");
  lua_newtable(state);
  const int list = lua_gettop(state);
  std::vector<SKey> keys;
  bool isOrdered = true;
  for (lua_pushnil(state); lua_next(state, table) != 0; lua_pop(state, 1)) {
    const auto place = static_cast<lua_Integer>(keys.size()) + 1;
    keys.push_back(Describe(state, -2, place));
    isOrdered = isOrdered && (place == 1 || keys[keys.size() - 2] < keys.back());
    lua_pushvalue(state, -2);
    lua_rawseti(state, list, place);
  }
  if (isOrdered) {
    return;
  }
  std::sort(keys.begin(), keys.end());
  lua_createtable(state, static_cast<int>(keys.size()), 0);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    lua_rawgeti(state, list, keys[i].Place);
    lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_remove(state, list);
}

}  // namespace argos
