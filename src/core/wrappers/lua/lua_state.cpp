#include <argos3/core/wrappers/lua/lua_state.h>

#include <argos3/core/wrappers/lua/lua_keys.h>
#include <argos3/core/wrappers/lua/lua_script.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <algorithm>
#include <exception>
#include <string_view>

namespace argos {

namespace {

// instructions between two checks of the limit
constexpr UInt64 kPeriod = 1000;

/** Called for an error outside Run(), which none of our code raises. */
int Panic(lua_State* state) {
  const char* const message = lua_tostring(state, -1);
  LOGERR << "[FATAL] uncaught Lua error: " << (message != nullptr ? message : "?") << std::endl;
  LOGERR.Flush();
  return 0;  // Lua aborts
}

/** Turns an error object into a message with a traceback. */
int AddTraceback(lua_State* state) {
  const char* message = lua_tostring(state, 1);
  if (message == nullptr) {
    if (luaL_callmeta(state, 1, "__tostring") != 0 && lua_type(state, -1) == LUA_TSTRING) {
      message = lua_tostring(state, -1);
    } else {
      message = lua_pushfstring(state, "(the error is a %s value)", luaL_typename(state, 1));
    }
  }
  luaL_traceback(state, state, message, 1);
  return 1;
}

bool HasOnlyNumbers(lua_State* state, int table) {
  for (lua_pushnil(state); lua_next(state, table) != 0; lua_pop(state, 1)) {
    if (lua_type(state, -2) != LUA_TNUMBER) {
      lua_pop(state, 2);
      return false;
    }
  }
  return true;
}

/** The iterator that pairs() returns: the next key of a list, and its value in the table. */
int NextOrdered(lua_State* state) {
  // upvalues: the keys, and the number of those returned so far
  auto place = lua_tointeger(state, lua_upvalueindex(2));
  lua_settop(state, 1);
  while (true) {
    lua_settop(state, 1);
    if (lua_rawgeti(state, lua_upvalueindex(1), ++place) == LUA_TNIL) {
      return 1;
    }
    lua_pushvalue(state, -1);
    // skip keys that the loop itself has removed
    if (lua_rawget(state, 1) != LUA_TNIL) {
      lua_pushinteger(state, place);
      lua_replace(state, lua_upvalueindex(2));
      return 2;
    }
  }
}

/** pairs(); its upvalue is next(). */
int Pairs(lua_State* state) {
  luaL_checkany(state, 1);
  if (luaL_getmetafield(state, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(state, 1);
    lua_call(state, 1, 3);
    return 3;
  }
  lua_settop(state, 1);
  // for numbers, Lua's own order depends only on the history of the table
  if (!lua_istable(state, 1) || HasOnlyNumbers(state, 1)) {
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_pushvalue(state, 1);
    return 2;
  }
  PushOrderedKeys(state, 1);
  lua_pushinteger(state, 0);
  lua_pushcclosure(state, NextOrdered, 2);
  lua_pushvalue(state, 1);
  return 2;
}

int FinishXpcall(lua_State* state, int, lua_KContext) {
  return lua_gettop(state);
}

/** Replaces a global function; the original becomes an upvalue of the replacement. */
void Wrap(lua_State* state, const char* name, const char* original, lua_CFunction wrapper) {
  lua_getglobal(state, original);
  lua_pushcclosure(state, wrapper, 1);
  lua_setglobal(state, name);
}

void SetUp(lua_State* state, lua_CFunction xpcall) {
  luaL_openlibs(state);
  Wrap(state, "pairs", "next", Pairs);
  Wrap(state, "xpcall", "xpcall", xpcall);
  CLuaUtility::RegisterLoggerWrapper(state);
  CLuaUtility::RegisterTypes(state);
}

}  // namespace

struct CLuaState::SCall {
  TCall Call;
  const void* Body;
  std::exception_ptr Exception;
};

CLuaState::CLuaState(UInt64 maxInstructions)
    : m_state(lua_newstate(&CLuaMemory::Reallocate, &m_memory)),
      m_maxInstructions(maxInstructions) {
  if (m_state == nullptr) {
    THROW_ARGOSEXCEPTION("not enough memory for a Lua state");
  }
  lua_atpanic(m_state, Panic);
  lua_setwarnf(m_state, Warn, this);
  // coroutines inherit the extra space and the hook
  *static_cast<CLuaState**>(lua_getextraspace(m_state)) = this;
  SetHook(m_state, static_cast<int>(std::min(kPeriod, m_maxInstructions)));
  try {
    Run([](lua_State* state) { SetUp(state, Xpcall); });
  } catch (...) {
    lua_close(m_state);
    throw;
  }
}

CLuaState::~CLuaState() {
  lua_close(m_state);
}

void CLuaState::SeedMath(UInt64 seed) {
  Run([seed](lua_State* state) {
    lua_getglobal(state, "math");
    lua_getfield(state, -1, "randomseed");
    lua_pushinteger(state, static_cast<lua_Integer>(seed));
    lua_call(state, 1, 0);
  });
}

void CLuaState::Execute(const SLuaScript& script) {
  Run([&script](lua_State* state) {
    lua_getglobal(state, "package");
    lua_getfield(state, -1, "path");
    const char* const folder = script.Folder.c_str();
    lua_pushfstring(state, "%s/?.lua;%s/?/init.lua;%s", folder, folder, lua_tostring(state, -1));
    lua_setfield(state, -3, "path");
    lua_settop(state, 0);
    const std::string& code = script.Bytecode;
    if (luaL_loadbufferx(state, code.data(), code.size(), script.Path.c_str(), "b") != LUA_OK) {
      lua_error(state);
    }
    lua_call(state, 0, 0);
  });
}

void CLuaState::CallGlobal(lua_State* state, const char* name, int numArguments, int numResults) {
  if (lua_getglobal(state, name) != LUA_TFUNCTION) {
    luaL_error(state, "the script must define a global function \"%s\", found %s", name,
               luaL_typename(state, -1));
  }
  lua_insert(state, -1 - numArguments);
  lua_call(state, numArguments, numResults);
}

std::size_t CLuaState::GetMemory() const {
  constexpr std::size_t kKibi = 1024;
  return kKibi * static_cast<std::size_t>(lua_gc(m_state, LUA_GCCOUNT)) +
         static_cast<std::size_t>(lua_gc(m_state, LUA_GCCOUNTB));
}

void CLuaState::RunBody(TCall call, const void* body) {
  m_instructionsLeft = m_maxInstructions;
  if (m_wasInterrupted) {
    m_wasInterrupted = false;
    SetHook(m_state, static_cast<int>(std::min(kPeriod, m_maxInstructions)));
  }
  SCall callAndBody{call, body, nullptr};
  lua_settop(m_state, 0);
  lua_pushcfunction(m_state, AddTraceback);
  lua_pushcfunction(m_state, CallBody);
  lua_pushlightuserdata(m_state, &callAndBody);
  const int status = lua_pcall(m_state, 1, 0, 1);
  std::string message;
  if (status != LUA_OK) {
    const char* const text = lua_tostring(m_state, -1);
    message = text != nullptr ? text : "(an error without a message)";
  }
  lua_settop(m_state, 0);
  if (callAndBody.Exception != nullptr) {
    std::rethrow_exception(callAndBody.Exception);
  }
  if (status != LUA_OK) {
    throw CLuaError(message);
  }
}

// exceptions must not pass through Lua, which is C code
int CLuaState::CallBody(lua_State* state) {
  auto& call = *static_cast<SCall*>(lua_touserdata(state, 1));
  lua_settop(state, 0);
  try {
    call.Call(call.Body, state);
  } catch (...) {
    call.Exception = std::current_exception();
  }
  return 0;
}

void CLuaState::SetHook(lua_State* state, int period) {
  if (m_maxInstructions > 0) {
    lua_sethook(state, CountInstructions, LUA_MASKCOUNT, period);
  }
}

CLuaState& CLuaState::Of(lua_State* state) {
  return **static_cast<CLuaState**>(lua_getextraspace(state));
}

// warn(), as in the program lua: off until warn("@on")
void CLuaState::Warn(void* self, const char* message, int toBeContinued) {
  auto& state = *static_cast<CLuaState*>(self);
  if (state.m_warning.empty() && toBeContinued == 0 && message[0] == '@') {
    const std::string_view control = message;
    state.m_isWarning = control == "@on" || (control != "@off" && state.m_isWarning);
    return;
  }
  state.m_warning += message;
  if (toBeContinued == 0) {
    if (state.m_isWarning) {
      LOGERR << "Lua warning: " + state.m_warning + "\n";
    }
    state.m_warning.clear();
  }
}

// Lua counts no instructions in a handler that an interruption calls: a loop there might never end
int CLuaState::HandleError(lua_State* state) {
  lua_settop(state, 1);
  if (Of(state).m_wasInterrupted) {
    return 1;
  }
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, 1, 1);
  return 1;
}

/** xpcall(); its upvalue is Lua's own. */
int CLuaState::Xpcall(lua_State* state) {
  luaL_checktype(state, 2, LUA_TFUNCTION);
  lua_pushvalue(state, 2);
  lua_pushcclosure(state, HandleError, 1);
  lua_replace(state, 2);
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  // the called function may yield
  lua_callk(state, lua_gettop(state) - 1, LUA_MULTRET, 0, FinishXpcall);
  return FinishXpcall(state, LUA_OK, 0);
}

void CLuaState::CountInstructions(lua_State* state, lua_Debug*) {
  CLuaState& self = Of(state);
  if (self.m_instructionsLeft > kPeriod) {
    self.m_instructionsLeft -= kPeriod;
    return;
  }
  // a script that catches this error is interrupted again at its next instruction
  self.m_instructionsLeft = 0;
  self.m_wasInterrupted = true;
  self.SetHook(state, 1);
  luaL_where(state, 0);
  lua_pushfstring(state,
                  "interrupted after %I instructions; is there an endless loop? If not, raise "
                  "\"max_instructions\" in <params>",
                  static_cast<LUAI_UACINT>(self.m_maxInstructions));
  lua_concat(state, 2);
  lua_error(state);
}

}  // namespace argos
