#include <argos3/campaign/design/expression.h>

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/wrappers/lua/lua_headers.h>
#include <argos3/core/wrappers/lua/lua_limits.h>
#include <argos3/core/wrappers/lua/lua_state.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace argos {

namespace {

constexpr UInt64 kMaxInstructions = 1000000;
constexpr UInt64 kMaxMemory = UInt64{16} << 20;  // bytes

constexpr const char* kChunkName = "=expression";

SLuaLimits MakeLimits() {
  SLuaLimits limits;
  limits.MaxInstructions = kMaxInstructions;
  limits.MaxMemory = kMaxMemory;
  return limits;
}

// drops "expression:1: " and the traceback
std::string ShortenMessage(const std::string& message) {
  std::string line = message.substr(0, message.find('\n'));
  const std::string prefix = std::string(kChunkName + 1) + ':';
  if (line.compare(0, prefix.size(), prefix) == 0) {
    const size_t end = line.find(": ", prefix.size());
    if (end != std::string::npos) {
      line.erase(0, end + 2);
    }
  }
  return line;
}

std::string FormatNumber(Real number) {
  constexpr Real kExact = 9007199254740992.0;  // 2^53
  if (number == std::floor(number) && std::abs(number) < kExact) {
    return std::to_string(static_cast<SInt64>(number));
  }
  return fmt::format("{:.15g}", number);
}

}  // namespace

struct CExpressions::SValue {
  int Type = LUA_TNIL;
  int Count = 0;  // number of values
  bool IsInteger = false;
  bool Boolean = false;
  SInt64 Integer = 0;
  Real Number = 0.0;
  std::string Text;
};

CExpressions::CExpressions() : m_state(std::make_unique<CLuaState>(MakeLimits())) {}

CExpressions::~CExpressions() = default;

void CExpressions::SetNames(std::vector<std::pair<std::string, std::string>> namesAndValues) {
  m_names = std::move(namesAndValues);
  m_numbers.clear();
}

void CExpressions::AddName(const std::string& name, const std::string& value) {
  m_names.emplace_back(name, value);
}

void CExpressions::AddNumber(const std::string& name, Real value) {
  m_numbers.emplace_back(name, value);
}

// __index of the environment; upvalue 1 is the CExpressions
int CExpressions::HandleUnknownName(lua_State* state) {
  auto* self = static_cast<CExpressions*>(lua_touserdata(state, lua_upvalueindex(1)));
  const char* name = lua_type(state, 2) == LUA_TSTRING ? lua_tostring(state, 2) : "?";
  std::snprintf(self->m_unknownName.data(), self->m_unknownName.size(), "%s", name);
  return luaL_error(state, "unknown name");
}

void CExpressions::PushEnvironment(lua_State* state) {
  lua_newtable(state);
  lua_newtable(state);
  lua_getglobal(state, "math");
  lua_pushnil(state);
  while (lua_next(state, -2) != 0) {
    // environment, copy, math, key, value
    lua_pushvalue(state, -2);
    lua_insert(state, -2);
    lua_rawset(state, -5);
  }
  lua_pop(state, 1);
  for (const char* name : {"random", "randomseed"}) {
    lua_pushnil(state);
    lua_setfield(state, -2, name);
  }
  lua_setfield(state, -2, "math");
  for (const auto& [name, value] : m_numbers) {
    lua_pushnumber(state, value);
    lua_setfield(state, -2, name.c_str());
  }
  for (const auto& [name, value] : m_names) {
    SInt64 integer = 0;
    Real number = 0.0;
    if (ParseNumber(value, integer) == ENumberParsing::Ok) {
      lua_pushinteger(state, integer);
    } else if (ParseNumber(value, number) == ENumberParsing::Ok) {
      lua_pushnumber(state, number);
    } else {
      lua_pushlstring(state, value.data(), value.size());
    }
    lua_setfield(state, -2, name.c_str());
  }
  lua_newtable(state);
  lua_pushlightuserdata(state, this);
  lua_pushcclosure(state, HandleUnknownName, 1);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
}

CExpressions::SValue CExpressions::Compute(std::string_view expression) {
  const std::string code = "return " + std::string(expression);
  SValue value;
  m_unknownName[0] = '\0';
  try {
    m_state->Run([&](lua_State* state) {
      if (luaL_loadbufferx(state, code.data(), code.size(), kChunkName, "t") != LUA_OK) {
        lua_error(state);
      }
      PushEnvironment(state);
      lua_setupvalue(state, -2, 1);
      lua_call(state, 0, LUA_MULTRET);
      value.Count = lua_gettop(state);
      lua_settop(state, 1);
      value.Type = lua_type(state, 1);
      value.Boolean = lua_toboolean(state, 1) != 0;
      value.IsInteger = lua_isinteger(state, 1) != 0;
      if (value.Type == LUA_TNUMBER) {
        value.Integer = value.IsInteger ? lua_tointeger(state, 1) : 0;
        value.Number = lua_tonumber(state, 1);
      } else if (value.Type == LUA_TSTRING) {
        size_t length = 0;
        const char* text = lua_tolstring(state, 1, &length);
        value.Text.assign(text, length);
      }
    });
  } catch (const CLuaError& error) {
    std::string reason = ShortenMessage(error.GetMessage());
    if (m_unknownName[0] != '\0') {
      std::vector<std::string> known = {"math"};
      for (const auto& name : m_names) {
        known.push_back(name.first);
      }
      for (const auto& name : m_numbers) {
        known.push_back(name.first);
      }
      const std::string unknown = m_unknownName.data();
      reason = '"' + unknown + "\" is not known here" + DidYouMean(unknown, known);
    }
    THROW_ARGOSEXCEPTION("the expression \"" << expression << "\": " << reason);
  }
  if (value.Count > 1) {
    THROW_ARGOSEXCEPTION("the expression \"" << expression << "\" has " << value.Count
                                             << " values, expected one");
  }
  return value;
}

std::string CExpressions::Evaluate(std::string_view expression) {
  const SValue value = Compute(expression);
  switch (value.Type) {
    case LUA_TSTRING:
      return value.Text;
    case LUA_TBOOLEAN:
      return value.Boolean ? "true" : "false";
    case LUA_TNUMBER:
      if (value.IsInteger) {
        return std::to_string(value.Integer);
      }
      if (std::isfinite(value.Number)) {
        return FormatNumber(value.Number);
      }
      THROW_ARGOSEXCEPTION("the expression \"" << expression << "\" is not finite");
    default:
      THROW_ARGOSEXCEPTION("the expression \"" << expression
                                               << "\": expected a number or a text, found a value "
                                                  "of the type "
                                               << lua_typename(m_state->Get(), value.Type));
  }
}

bool CExpressions::IsTrue(std::string_view expression) {
  const SValue value = Compute(expression);
  if (value.Type != LUA_TBOOLEAN) {
    THROW_ARGOSEXCEPTION("the expression \""
                         << expression
                         << "\": expected a condition, such as \"robots == 20\", found a value of "
                            "the type "
                         << lua_typename(m_state->Get(), value.Type));
  }
  return value.Boolean;
}

std::string CExpressions::Expand(std::string_view text) {
  std::string result;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool isDoubled = i + 1 < text.size() && text[i + 1] == text[i];
    if (text[i] == '}' && !isDoubled) {
      THROW_ARGOSEXCEPTION("\"" << text << "\": '}' without '{'; write \"}}\" for the character");
    }
    if ((text[i] == '{' || text[i] == '}') && isDoubled) {
      result += text[i];
      ++i;
    } else if (text[i] == '{') {
      const size_t end = FindEndOfExpression(text, i);
      if (end == std::string_view::npos) {
        THROW_ARGOSEXCEPTION("\"" << text << "\": '{' without '}'; write \"{{\" for the character");
      }
      result += Evaluate(text.substr(i + 1, end - i - 1));
      i = end;
    } else {
      result += text[i];
    }
  }
  return result;
}

bool HasExpression(std::string_view text) {
  return text.find_first_of("{}") != std::string_view::npos;
}

size_t FindEndOfExpression(std::string_view text, size_t start) {
  int depth = 0;
  char quote = '\0';
  for (size_t i = start; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') {
      if (c == '\\') {
        ++i;
      } else if (c == quote) {
        quote = '\0';
      }
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return i;
    }
  }
  return std::string_view::npos;
}

}  // namespace argos
