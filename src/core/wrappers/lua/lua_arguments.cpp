#include <argos3/core/wrappers/lua/lua_arguments.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/text/utf8.h>
#include <argos3/core/wrappers/lua/lua_types.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <fmt/format.h>

#include <cmath>

namespace argos {

namespace {

// key in the registry: nil, or the owner of the script, or true after the warning
constexpr const char* kFractions = "argos.fractions";
constexpr Real kMaxFraction = 4503599627370496.0;  // 2^52: larger numbers are whole

constexpr std::size_t kMaxShownLength = 40;

/** Describes a value for a message: 300, string "10", nil. */
std::string Describe(lua_State* state, int index) {
  if (lua_type(state, index) == LUA_TNUMBER) {
    return fmt::format("{}", lua_tonumber(state, index));
  }
  std::string type = GetLuaTypeName(state, index);
  if (lua_type(state, index) == LUA_TSTRING) {
    const std::string text = lua_tostring(state, index);
    type += " \"" + std::string(CutUtf8(text, kMaxShownLength)) +
            (text.size() > kMaxShownLength ? "...\"" : "\"");
  }
  return type;
}

/** True if the table at an index has functions written in C++, as tables of devices have. */
bool IsDeviceTable(lua_State* state, int index) {
  if (!lua_istable(state, index) || lua_checkstack(state, 3) == 0) {
    return false;
  }
  bool hasFunction = false;
  for (lua_pushnil(state); !hasFunction && lua_next(state, index) != 0; lua_pop(state, 1)) {
    hasFunction = lua_iscfunction(state, -1) != 0;
  }
  return hasFunction;
}

/** For the end of a message: robot.wheels:set_velocity() passes the table as the first argument. */
std::string DescribeColon(lua_State* state, int index) {
  return index == 1 && IsDeviceTable(state, index) ? "; call it with a dot, not with a colon" : "";
}

// advice about a number that is not whole
const char* HintOfFraction(lua_State* state, int index) {
  const Real number = lua_type(state, index) == LUA_TNUMBER ? lua_tonumber(state, index) : 0.0;
  return std::isfinite(number) && std::floor(number) != number ? " (--lenient truncates others)"
                                                               : "";
}

}  // namespace

CLuaArguments::CLuaArguments(lua_State* state) : m_state(state), m_count(lua_gettop(state)) {}

bool CLuaArguments::IsNextTable() const {
  return lua_type(m_state, m_next) == LUA_TTABLE;
}

bool CLuaArguments::IsNextString() const {
  return lua_type(m_state, m_next) == LUA_TSTRING;
}

bool CLuaArguments::IsNextNumber() const {
  return lua_type(m_state, m_next) == LUA_TNUMBER;
}

bool CLuaArguments::IsNextNil() const {
  return !HasNext() || lua_isnil(m_state, m_next);
}

Real CLuaArguments::NextNumber() {
  if (!IsNextNumber()) {
    ThrowNextMustBe("a number");
  }
  return lua_tonumber(m_state, m_next++);
}

bool CLuaArguments::NextBoolean() {
  if (lua_type(m_state, m_next) != LUA_TBOOLEAN) {
    ThrowNextMustBe("true or false");
  }
  return lua_toboolean(m_state, m_next++) != 0;
}

std::string_view CLuaArguments::NextText() {
  if (!IsNextString()) {
    ThrowNextMustBe("a string");
  }
  std::size_t length = 0;
  const char* const text = lua_tolstring(m_state, m_next++, &length);
  return {text, length};
}

std::string CLuaArguments::NextString() {
  return std::string(NextText());
}

void CLuaArguments::AcceptFractions(lua_State* state, const std::string& owner) {
  lua_pushlstring(state, owner.data(), owner.size());
  lua_setfield(state, LUA_REGISTRYINDEX, kFractions);
}

bool CLuaArguments::ToWhole(int index, SInt64& value) const {
  if (lua_type(m_state, index) != LUA_TNUMBER) {
    return false;
  }
  int isWhole = 0;
  value = lua_tointegerx(m_state, index, &isWhole);
  if (isWhole != 0) {
    return true;
  }
  const Real number = lua_tonumber(m_state, index);
  const int type = lua_getfield(m_state, LUA_REGISTRYINDEX, kFractions);
  const bool isTruncated = type != LUA_TNIL && std::abs(number) < kMaxFraction;
  if (isTruncated) {
    value = static_cast<SInt64>(number);
    if (type == LUA_TSTRING) {
      LOGERR << "[WARNING] " << lua_tostring(m_state, -1)
             << ": a Lua function takes whole numbers, "
             << "but argument " << m_next << " is " << number
             << ": such numbers are truncated (--lenient)" << std::endl;
      lua_pushboolean(m_state, 1);
      lua_setfield(m_state, LUA_REGISTRYINDEX, kFractions);
    }
  }
  lua_pop(m_state, 1);
  return isTruncated;
}

SInt64 CLuaArguments::NextInteger(SInt64 min, SInt64 max) {
  SInt64 value = 0;
  if (!ToWhole(m_next, value) || value < min || value > max) {
    ThrowNextMustBe(
        fmt::format("a whole number from {} to {}{}", min, max, HintOfFraction(m_state, m_next)));
  }
  ++m_next;
  return value;
}

std::size_t CLuaArguments::NextIndex(std::size_t count) {
  return static_cast<std::size_t>(NextInteger(1, static_cast<SInt64>(count)) - 1);
}

CColor CLuaArguments::NextColor() {
  CColor color;
  if (IsNextString()) {
    color.Set(NextString());
  } else if (IsNextNumber()) {
    color.SetRed(Next<UInt8>());
    color.SetGreen(Next<UInt8>());
    color.SetBlue(Next<UInt8>());
  } else {
    ThrowNextMustBe("the name of a color, \"r,g,b,a\", or three numbers from 0 to 255");
  }
  return color;
}

template <typename T>
T CLuaArguments::NextObject(const char* expected) {
  const T* const value = CLuaType<T>::Test(m_state, m_next);
  if (value == nullptr) {
    ThrowNextMustBe(expected);
  }
  ++m_next;
  return *value;
}

template CVector2 CLuaArguments::NextObject(const char* expected);
template CVector3 CLuaArguments::NextObject(const char* expected);
template CQuaternion CLuaArguments::NextObject(const char* expected);

std::vector<UInt8> CLuaArguments::NextBytes(std::size_t count) {
  const std::string expected = fmt::format("a table of {} whole numbers from 0 to 255", count);
  if (!IsNextTable()) {
    ThrowNextMustBe(expected);
  }
  const std::size_t size = lua_rawlen(m_state, m_next);
  if (size != count) {
    THROW_ARGOSEXCEPTION("argument " << m_next << " must be " << expected << ", got a table of "
                                     << size << DescribeColon(m_state, m_next));
  }
  std::vector<UInt8> bytes(count);
  for (std::size_t i = 0; i < count; ++i) {
    lua_rawgeti(m_state, m_next, static_cast<lua_Integer>(i) + 1);
    SInt64 value = 0;
    if (!ToWhole(lua_gettop(m_state), value) || value < 0 || value > 255) {
      THROW_ARGOSEXCEPTION("argument " << m_next << " must be " << expected
                                       << HintOfFraction(m_state, -1) << ", but entry " << i + 1
                                       << " is " << Describe(m_state, -1));
    }
    bytes[i] = static_cast<UInt8>(value);
    lua_pop(m_state, 1);
  }
  ++m_next;
  return bytes;
}

void CLuaArguments::Finish() const {
  if (m_next <= m_count) {
    THROW_ARGOSEXCEPTION("too many arguments: expected " << m_next - 1 << ", got " << m_count
                                                         << DescribeColon(m_state, 1));
  }
}

void CLuaArguments::ThrowNextMustBe(const std::string& expected) const {
  THROW_ARGOSEXCEPTION("argument " << m_next << " must be " << expected << ", got "
                                   << Describe(m_state, m_next) << DescribeColon(m_state, m_next));
}

}  // namespace argos
