#include "lua_tester.h"

#include <argos3/core/wrappers/lua/lua_utility.h>

namespace argos {

void CLuaTester::Do(const std::string& code) {
  Run([&code](lua_State* state) {
    if (luaL_loadbuffer(state, code.data(), code.size(), "=test") != LUA_OK) {
      lua_error(state);
    }
    lua_call(state, 0, 0);
  });
}

std::string CLuaTester::Get(const std::string& expression) {
  std::string value;
  Do("test_result = tostring(" + expression + ")");
  Run([&value](lua_State* state) {
    lua_getglobal(state, "test_result");
    value = lua_tostring(state, -1);
  });
  return value;
}

Real CLuaTester::GetNumber(const std::string& expression) {
  Real value = 0.0;
  Do("test_result = " + expression);
  Run([&value](lua_State* state) {
    lua_getglobal(state, "test_result");
    value = luaL_checknumber(state, -1);
  });
  return value;
}

std::string CLuaTester::GetError(const std::string& code) {
  try {
    Do(code);
  } catch (const CLuaError& error) {
    const std::string& message = error.GetMessage();
    return message.substr(0, message.find("\nstack traceback:"));
  }
  return "";
}

}  // namespace argos
