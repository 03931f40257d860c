#include <argos3/core/wrappers/lua/lua_closure.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <cstdio>
#include <exception>
#include <string_view>

namespace argos {

namespace {

// upvalues of every closure
constexpr int kObject = 1;
constexpr int kName = 2;
constexpr int kFunction = 3;

// bytes; longer messages are cut
constexpr std::size_t kMessageSize = 1024;

constexpr int kFailed = -1;

/** The text of an exception without the prefix of a CARGoSException. */
const char* SkipMark(const char* text) {
  constexpr std::string_view kMark = "[FATAL] ";
  return std::string_view(text).substr(0, kMark.size()) == kMark ? text + kMark.size() : text;
}

/** @return the result of the body, or kFailed with the text of the exception in the buffer. */
int Run(lua_State* state, CLuaClosure::TEntry body, char* message) noexcept {
  try {
    return body(state);
  } catch (const std::exception& error) {
    std::snprintf(message, kMessageSize, "%s", SkipMark(error.what()));
  } catch (...) {
    std::snprintf(message, kMessageSize, "an exception that is not a std::exception");
  }
  return kFailed;
}

}  // namespace

void CLuaClosure::Push(lua_State* state, const std::string& name, TEntry entry, const void* object,
                       TAnyFunction function) {
  lua_pushlightuserdata(state, const_cast<void*>(object));
  lua_pushlstring(state, name.data(), name.size());
  int numUpvalues = 2;
  if (function != nullptr) {
    lua_pushlightuserdata(state, reinterpret_cast<void*>(function));
    numUpvalues = 3;
  }
  lua_pushcclosure(state, entry, numUpvalues);
}

int CLuaClosure::Protect(lua_State* state, TEntry body) {
  // luaL_error() leaves with longjmp(): every object with a destructor is destroyed by now
  char message[kMessageSize];
  const int numResults = Run(state, body, message);
  if (numResults != kFailed) {
    return numResults;
  }
  return luaL_error(state, "%s: %s", lua_tostring(state, lua_upvalueindex(kName)), message);
}

void CLuaClosure::PushProtected(lua_State* state, TEntry push, const void* value) {
  lua_pushcfunction(state, push);
  lua_pushlightuserdata(state, const_cast<void*>(value));
  if (lua_pcall(state, 1, 1, 0) != LUA_OK) {
    THROW_ARGOSEXCEPTION(lua_tostring(state, -1));
  }
}

const void* CLuaClosure::GetPushed(lua_State* state) {
  return lua_touserdata(state, 1);
}

void* CLuaClosure::GetObject(lua_State* state) {
  return lua_touserdata(state, lua_upvalueindex(kObject));
}

CLuaClosure::TAnyFunction CLuaClosure::GetFunction(lua_State* state) {
  return reinterpret_cast<TAnyFunction>(lua_touserdata(state, lua_upvalueindex(kFunction)));
}

}  // namespace argos
