#ifndef ARGOS3_TESTING_UNIT_CORE_WRAPPERS_LUA_LUA_TESTER_H
#define ARGOS3_TESTING_UNIT_CORE_WRAPPERS_LUA_LUA_TESTER_H

#include <argos3/core/wrappers/lua/lua_state.h>

#include <string>

namespace argos {

/** A Lua state for tests; code is given as text. */
class CLuaTester : public CLuaState {
 public:
  using CLuaState::CLuaState;
  using CLuaState::Get;

  /** Runs statements; errors name the chunk "test". @throws CLuaError */
  void Do(const std::string& code);
  /** The value of an expression as tostring() gives it. @throws CLuaError */
  std::string Get(const std::string& expression);
  Real GetNumber(const std::string& expression);
  /** The message of the error that statements raise, without the traceback; "" if there is none. */
  std::string GetError(const std::string& code);
};

}  // namespace argos

#endif
