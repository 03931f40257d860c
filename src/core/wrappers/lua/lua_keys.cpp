#include <argos3/core/wrappers/lua/lua_keys.h>

#include <argos3/core/wrappers/lua/lua_parameters.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string_view>
#include <type_traits>

namespace argos {

namespace {

enum class EKind { NUMBER, STRING, BOOLEAN, OTHER };

struct SKey {
  EKind Kind;
  bool IsInteger;
  lua_Integer Integer;  // value of a number that is an integer; of a boolean, 0 or 1
  lua_Number Number;
  std::string_view Text;  // lives as long as the list that holds the key
  lua_Integer Place;  // place in the list, from 1
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

// an error leaves this function with longjmp(): the keys must not be in memory that a destructor
// releases
static_assert(std::is_trivially_destructible_v<SKey>);

/** Replaces the list on top of the stack by a sorted copy; its entries are @p count keys. */
void SortList(lua_State* state, lua_Integer count) {
  const int list = lua_gettop(state);
  auto* const keys = static_cast<SKey*>(
      lua_newuserdatauv(state, static_cast<std::size_t>(count) * sizeof(SKey), 0));
  for (lua_Integer i = 0; i < count; ++i) {
    lua_rawgeti(state, list, i + 1);
    std::construct_at(keys + i, Describe(state, -1, i + 1));
    lua_pop(state, 1);
  }
  std::sort(keys, keys + count);
  lua_createtable(state, static_cast<int>(count), 0);
  for (lua_Integer i = 0; i < count; ++i) {
    lua_rawgeti(state, list, keys[i].Place);
    lua_rawseti(state, -2, i + 1);
  }
  lua_replace(state, list);
  lua_settop(state, list);
}

}  // namespace

bool PushOrderedKeys(lua_State* state, int index) {
  const int table = lua_absindex(state, index);
  luaL_checkstack(state, kOrderedKeysStack, "too many nested tables");
  CLuaParameters::ReadAll(state, table);
  lua_newtable(state);
  const int list = lua_gettop(state);
  lua_Integer count = 0;
  lua_Integer numAddresses = 0;
  SKey previous{};
  bool isOrdered = true;
  for (lua_pushnil(state); lua_next(state, table) != 0; lua_pop(state, 1)) {
    const SKey key = Describe(state, -2, ++count);
    isOrdered = isOrdered && (count == 1 || previous < key);
    previous = key;
    numAddresses += key.Kind == EKind::OTHER ? 1 : 0;
    lua_pushvalue(state, -2);
    lua_rawseti(state, list, count);
  }
  if (!isOrdered) {
    SortList(state, count);
  }
  return numAddresses <= 1;
}

}  // namespace argos
