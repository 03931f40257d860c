#include <argos3/core/wrappers/lua/lua_arguments.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_types.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <fmt/format.h>

namespace argos {

namespace {

constexpr std::size_t kLongestTextShown = 40;

/** Describes a value for a message: 300, string "10", nil. */
std::string Describe(lua_State* state, int index) {
  if (lua_type(state, index) == LUA_TNUMBER) {
    return fmt::format("{}", lua_tonumber(state, index));
  }
  std::string type = GetLuaTypeName(state, index);
  if (lua_type(state, index) == LUA_TSTRING) {
    const std::string text = lua_tostring(state, index);
    type += " \"" + text.substr(0, kLongestTextShown) +
            (text.size() > kLongestTextShown ? "...\"" : "\"");
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

SInt64 CLuaArguments::NextInteger(SInt64 min, SInt64 max) {
  int isWhole = 0;
  const lua_Integer value =
      IsNextNumber() ? lua_tointegerx(m_state, m_next, &isWhole) : lua_Integer{0};
  if (isWhole == 0 || value < min || value > max) {
    ThrowNextMustBe(fmt::format("a whole number from {} to {}", min, max));
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

CVector2 CLuaArguments::NextVector2() {
  const CVector2* const value = CLuaType<CVector2>::Test(m_state, m_next);
  if (value == nullptr) {
    ThrowNextMustBe("a vector2");
  }
  ++m_next;
  return *value;
}

CVector3 CLuaArguments::NextVector3() {
  const CVector3* const value = CLuaType<CVector3>::Test(m_state, m_next);
  if (value == nullptr) {
    ThrowNextMustBe("a vector3");
  }
  ++m_next;
  return *value;
}

CQuaternion CLuaArguments::NextQuaternion() {
  const CQuaternion* const value = CLuaType<CQuaternion>::Test(m_state, m_next);
  if (value == nullptr) {
    ThrowNextMustBe("a quaternion");
  }
  ++m_next;
  return *value;
}

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
    int isWhole = 0;
    const bool isNumber = lua_type(m_state, -1) == LUA_TNUMBER;
    const lua_Integer value = isNumber ? lua_tointegerx(m_state, -1, &isWhole) : lua_Integer{0};
    if (isWhole == 0 || value < 0 || value > 255) {
      THROW_ARGOSEXCEPTION("argument " << m_next << " must be " << expected << ", but entry "
                                       << i + 1 << " is " << Describe(m_state, -1));
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
