#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_keys.h>
#include <argos3/core/wrappers/lua/lua_types.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <bit>
#include <limits>

// The format: each value is a tag followed by its contents. The contents of a table are pairs of a
// key and a value; the tag END closes them.

namespace argos {

namespace {

constexpr int kDeepestNesting = 32;

// a table that is in several places is written several times: without a limit, a small graph of
// tables could fill the memory
constexpr std::size_t kMaxBytes = std::size_t{16} << 20;

// slots of Lua's stack for each level of nesting: the ordered keys, a key, its value, and those
// that a test for a type needs
constexpr int kStackPerLevel = kOrderedKeysStack + 4;

/**
 * Reserves the stack for the deepest table before any object with a destructor exists: an error
 * leaves with longjmp().
 */
void ReserveStack(lua_State* state) {
  luaL_checkstack(state, (kDeepestNesting + 1) * kStackPerLevel, "too many nested tables");
}

enum ETag : UInt8 {
  END = 0,
  STRING,
  FLOAT,
  INTEGER,
  FALSE,
  TRUE,
  TABLE,
  VECTOR2,
  VECTOR3,
  QUATERNION
};

void AppendNumber(CByteArray& data, Real number) {
  // written as bits: the number format of a byte array has neither infinity nor NaN
  data << std::bit_cast<UInt64>(number);
}

bool IsSerializable(lua_State* state, int index) {
  switch (lua_type(state, index)) {
    case LUA_TSTRING:
    case LUA_TNUMBER:
    case LUA_TBOOLEAN:
    case LUA_TTABLE:
      return true;
    default:
      return CLuaType<CVector2>::Test(state, index) != nullptr ||
             CLuaType<CVector3>::Test(state, index) != nullptr ||
             CLuaType<CQuaternion>::Test(state, index) != nullptr;
  }
}

void AppendTable(lua_State* state, int index, CByteArray& data, int depth);

void AppendUserdata(lua_State* state, int index, CByteArray& data) {
  if (const CVector2* const v2 = CLuaType<CVector2>::Test(state, index)) {
    data << static_cast<UInt8>(VECTOR2);
    AppendNumber(data, v2->GetX());
    AppendNumber(data, v2->GetY());
  } else if (const CVector3* const v3 = CLuaType<CVector3>::Test(state, index)) {
    data << static_cast<UInt8>(VECTOR3);
    AppendNumber(data, v3->GetX());
    AppendNumber(data, v3->GetY());
    AppendNumber(data, v3->GetZ());
  } else if (const CQuaternion* const q = CLuaType<CQuaternion>::Test(state, index)) {
    data << static_cast<UInt8>(QUATERNION);
    AppendNumber(data, q->GetW());
    AppendNumber(data, q->GetX());
    AppendNumber(data, q->GetY());
    AppendNumber(data, q->GetZ());
  }
}

void AppendValue(lua_State* state, int index, CByteArray& data, int depth) {
  switch (lua_type(state, index)) {
    case LUA_TSTRING: {
      std::size_t length = 0;
      const char* const text = lua_tolstring(state, index, &length);
      data << static_cast<UInt8>(STRING) << static_cast<UInt32>(length);
      data.AddBuffer(reinterpret_cast<const UInt8*>(text), length);
      break;
    }
    case LUA_TNUMBER:
      if (lua_isinteger(state, index) != 0) {
        data << static_cast<UInt8>(INTEGER) << static_cast<SInt64>(lua_tointeger(state, index));
      } else {
        data << static_cast<UInt8>(FLOAT);
        AppendNumber(data, lua_tonumber(state, index));
      }
      break;
    case LUA_TBOOLEAN:
      data << static_cast<UInt8>(lua_toboolean(state, index) != 0 ? TRUE : FALSE);
      break;
    case LUA_TTABLE:
      AppendTable(state, index, data, depth + 1);
      break;
    default:
      AppendUserdata(state, index, data);
      break;
  }
}

void AppendTable(lua_State* state, int index, CByteArray& data, int depth) {
  if (depth > kDeepestNesting) {
    THROW_ARGOSEXCEPTION("a table to be sent may be nested " << kDeepestNesting
                                                             << " deep; does it contain itself?");
  }
  const int table = lua_absindex(state, index);
  data << static_cast<UInt8>(TABLE);
  PushOrderedKeys(state, table);
  const int keys = lua_gettop(state);
  const auto count = static_cast<lua_Integer>(lua_rawlen(state, keys));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(state, keys, i);
    lua_pushvalue(state, -1);
    lua_rawget(state, table);
    if (IsSerializable(state, -2) && IsSerializable(state, -1)) {
      AppendValue(state, keys + 1, data, depth);
      AppendValue(state, keys + 2, data, depth);
    }
    if (data.Size() > kMaxBytes) {
      THROW_ARGOSEXCEPTION("a table to be sent may take " << kMaxBytes
                                                          << " bytes; does it share parts?");
    }
    lua_settop(state, keys);
  }
  lua_settop(state, keys - 1);
  data << static_cast<UInt8>(END);
}

Real TakeNumber(CByteArray& data) {
  return std::bit_cast<Real>(data.PopFront<UInt64>());
}

void TakeTable(lua_State* state, CByteArray& data, int depth);

void TakeString(lua_State* state, CByteArray& data) {
  const auto length = data.PopFront<UInt32>();
  if (length > data.Size()) {
    THROW_ARGOSEXCEPTION("a string of " << length << " bytes in " << data.Size());
  }
  luaL_Buffer text;
  data.FetchBuffer(reinterpret_cast<UInt8*>(luaL_buffinitsize(state, &text, length)), length);
  luaL_pushresultsize(&text, length);
}

/** Pushes the value whose tag was read; false for END. */
bool TakeValue(lua_State* state, CByteArray& data, UInt8 tag, int depth) {
  switch (tag) {
    case END:
      return false;
    case STRING:
      TakeString(state, data);
      return true;
    case FLOAT:
      lua_pushnumber(state, TakeNumber(data));
      return true;
    case INTEGER:
      lua_pushinteger(state, data.PopFront<SInt64>());
      return true;
    case FALSE:
    case TRUE:
      lua_pushboolean(state, tag == TRUE ? 1 : 0);
      return true;
    case TABLE:
      TakeTable(state, data, depth + 1);
      return true;
    case VECTOR2: {
      const Real x = TakeNumber(data);
      CLuaType<CVector2>::Push(state, CVector2(x, TakeNumber(data)));
      return true;
    }
    case VECTOR3: {
      const Real x = TakeNumber(data);
      const Real y = TakeNumber(data);
      CLuaType<CVector3>::Push(state, CVector3(x, y, TakeNumber(data)));
      return true;
    }
    case QUATERNION: {
      const Real w = TakeNumber(data);
      const Real x = TakeNumber(data);
      const Real y = TakeNumber(data);
      CLuaType<CQuaternion>::Push(state, CQuaternion(w, x, y, TakeNumber(data)));
      return true;
    }
    default:
      THROW_ARGOSEXCEPTION("no value has the tag " << static_cast<int>(tag));
  }
}

void TakeTable(lua_State* state, CByteArray& data, int depth) {
  if (depth > kDeepestNesting) {
    THROW_ARGOSEXCEPTION("tables nested too deep");
  }
  lua_newtable(state);
  const int table = lua_gettop(state);
  while (TakeValue(state, data, data.PopFront<UInt8>(), depth)) {
    const Real number = lua_tonumber(state, -1);
    if (!TakeValue(state, data, data.PopFront<UInt8>(), depth) || number != number) {
      THROW_ARGOSEXCEPTION("a key without a value, or one that is not a number");
    }
    lua_rawset(state, table);
  }
}

}  // namespace

void CLuaUtility::LuaSerializeTable(CByteArray& data, lua_State* state, SInt32 offset) {
  ReserveStack(state);
  CByteArray bytes;
  AppendTable(state, lua_absindex(state, offset), bytes, 1);
  data.AddBuffer(bytes.ToCArray(), bytes.Size());
}

bool CLuaUtility::LuaDeserializeTable(CByteArray& data, lua_State* state) {
  ReserveStack(state);
  const int top = lua_gettop(state);
  CByteArray rest = data;
  try {
    if (rest.PopFront<UInt8>() == TABLE) {
      TakeTable(state, rest, 1);
      data.Swap(rest);
      return true;
    }
  } catch (const CARGoSException&) {
    // the bytes are not those of a serialized table
  }
  lua_settop(state, top);
  return false;
}

}  // namespace argos
