#include <argos3/core/wrappers/lua/lua_state.h>

#include <argos3/core/utility/text/classic_locale.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/wrappers/lua/lua_missing_names.h>
#include <argos3/core/wrappers/lua/lua_sandbox.h>
#include <argos3/core/wrappers/lua/lua_script.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <string_view>
#include <utility>

namespace argos {

namespace {

// instructions between two checks of the limit
constexpr UInt64 kPeriod = CLuaSandbox::kInstructionsOfCoroutine;

// copying so much memory takes about as long as an instruction
constexpr UInt64 kBytesPerInstruction = 64;

/** Called for an error outside Run(), which none of our code raises. */
int Panic(lua_State* state) {
  const char* const message = lua_tostring(state, -1);
  LOGERR << "[FATAL] uncaught Lua error: " << (message != nullptr ? message : "?") << std::endl;
  LOGERR.Flush();
  return 0;  // Lua aborts
}

constexpr char kTraceback[] = "\nstack traceback:";

/** Where the innermost function in Lua was at the last error; read after the call has ended. */
struct SErrorPlace {
  int Line = 0;  // 0 = unknown
  std::array<char, 1024> File = {};
};

thread_local SErrorPlace g_errorPlace;

/** Finds the innermost function in Lua; false if there is none. */
bool FindLuaFunction(lua_State* state, lua_Debug& activation) {
  for (int level = 0; lua_getstack(state, level, &activation) != 0; ++level) {
    lua_getinfo(state, "Sl", &activation);
    if (activation.currentline > 0) {
      return true;
    }
  }
  return false;
}

/** Turns an error object into a message with its place and a traceback. */
int AddTraceback(lua_State* state) {
  const char* message = lua_tostring(state, 1);
  if (message == nullptr) {
    if (luaL_callmeta(state, 1, "__tostring") != 0 && lua_type(state, -1) == LUA_TSTRING) {
      message = lua_tostring(state, -1);
    } else {
      message = lua_pushfstring(state, "(the error is a %s value)", luaL_typename(state, 1));
    }
  }
  lua_Debug activation;
  if (FindLuaFunction(state, activation)) {
    g_errorPlace.Line = activation.currentline;
    // "@" and the path of a file
    std::snprintf(g_errorPlace.File.data(), g_errorPlace.File.size(), "%s",
                  activation.source[0] == '@' ? activation.source + 1 : "");
    // Lua gives errors of its own inside C functions, such as the iterator of ipairs(), no place
    if (std::string_view(message).rfind("attempt to ", 0) == 0) {
      message = lua_pushfstring(state, "%s:%d: %s", activation.short_src, activation.currentline,
                                message);
    }
  }
  luaL_traceback(state, state, message, 1);
  return 1;
}

// adds which name was misspelt, if one was
std::string Explain(lua_State* state, std::string message) {
  if (g_errorPlace.Line == 0) {
    return message;
  }
  const std::size_t end = std::min(message.find(kTraceback), message.size());
  message.insert(end, ExplainMissingName(state, message.substr(0, end), g_errorPlace.File.data(),
                                         g_errorPlace.Line));
  return message;
}

int FinishXpcall(lua_State* state, int, lua_KContext) {
  return lua_gettop(state);
}

}  // namespace

struct CLuaState::SCall {
  TCall Call;
  const void* Body;
  std::exception_ptr Exception;
};

CLuaState::CLuaState(const SLuaLimits& limits)
    : m_limits(limits), m_memory(static_cast<std::size_t>(limits.MaxMemory)) {
  m_state = lua_newstate(&CLuaState::Reallocate, this);
  if (m_state == nullptr) {
    THROW_ARGOSEXCEPTION("not enough memory for a Lua state");
  }
  lua_atpanic(m_state, Panic);
  lua_setwarnf(m_state, Warn, this);
  // coroutines inherit the extra space and the hook
  *static_cast<CLuaState**>(lua_getextraspace(m_state)) = this;
  SetUsualHook();
  try {
    Run([this](lua_State* state) {
      luaL_openlibs(state);
      CLuaUtility::RegisterLoggerWrapper(state);
      CLuaUtility::RegisterTypes(state);
      lua_getglobal(state, "xpcall");
      lua_pushcclosure(state, Xpcall, 1);
      lua_setglobal(state, "xpcall");
      CLuaSandbox::Install(state, m_limits);
    });
  } catch (...) {
    lua_close(m_state);
    throw;
  }
}

CLuaState::CLuaState(UInt64 maxInstructions)
    : CLuaState(SLuaLimits{.MaxInstructions = maxInstructions}) {}

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

void CLuaState::KeepOrder(bool isOn) {
  m_memory.KeepOrder(isOn);
  lua_gc(m_state, isOn ? LUA_GCSTOP : LUA_GCRESTART);
}

void CLuaState::Execute(const SLuaScript& script) {
  m_variations = script.Variations;
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
    throw CLuaError(FindFaultOfFunction(state, name));
  }
  lua_insert(state, -1 - numArguments);
  lua_call(state, numArguments, numResults);
}

void CLuaState::CallOptional(lua_State* state, const char* name) {
  const bool isThere = lua_getglobal(state, name) != LUA_TNIL;
  lua_pop(state, 1);
  if (isThere || !NearestNames(name, ListFunctions(state)).empty()) {
    CallGlobal(state, name);
  }
}

std::string CLuaState::FindFaultOfFunction(lua_State* state, const char* name) {
  const int type = lua_getglobal(state, name);
  lua_pop(state, 1);
  if (type == LUA_TFUNCTION) {
    return "";
  }
  const std::vector<std::string> functions = ListFunctions(state);
  return fmt::format("the script must define a global function \"{}\", found {}{}", name,
                     lua_typename(state, type),
                     NearestNames(name, functions).empty() ? "" : DidYouMean(name, functions));
}

std::vector<std::string> CLuaState::ListFunctions(lua_State* state) {
  std::vector<std::string> names;
  lua_pushglobaltable(state);
  for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) {
    // those of Lua's libraries are C functions
    if (lua_type(state, -2) == LUA_TSTRING && lua_isfunction(state, -1) &&
        lua_iscfunction(state, -1) == 0) {
      names.emplace_back(lua_tostring(state, -2));
    }
  }
  lua_pop(state, 1);
  std::sort(names.begin(), names.end());
  return names;
}

std::size_t CLuaState::GetMemory() const {
  constexpr std::size_t kKibi = 1024;
  return kKibi * static_cast<std::size_t>(lua_gc(m_state, LUA_GCCOUNT)) +
         static_cast<std::size_t>(lua_gc(m_state, LUA_GCCOUNTB));
}

void CLuaState::RunBody(TCall call, const void* body) {
  // an embedding program may have set a locale with a decimal comma
  const CClassicLocale locale;
  m_instructionsLeft = m_limits.MaxInstructions;
  m_textLeft = m_memory.GetLimit();
  m_refusal.Size = 0;
  g_errorPlace.Line = 0;
  if (m_wasInterrupted) {
    m_wasInterrupted = false;
    SetUsualHook();
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
  if (status == LUA_ERRMEM) {
    message = DescribeRefusal();
  } else if (m_refusal.Size > 0 && message.find("not enough memory") != std::string::npos) {
    // the script has passed the error on
    message = DescribeRefusal() + '\n' + message;
  }
  if (status != LUA_OK) {
    const bool isExplained = status == LUA_ERRRUN && !m_wasInterrupted;
    throw CLuaError(isExplained ? Explain(m_state, std::move(message)) : message);
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

void* CLuaState::Reallocate(void* self, void* block, std::size_t oldSize, std::size_t newSize) {
  auto& state = *static_cast<CLuaState*>(self);
  void* const result = state.m_memory.Reallocate(block, oldSize, newSize);
  if (result == nullptr && newSize > 0) {
    state.NoteRefusal(newSize);
  }
  return result;
}

// Lua's error for lack of memory is a text without a place: a message would need memory
void CLuaState::NoteRefusal(std::size_t size) {
  m_refusal.Size = size;
  m_refusal.Line = 0;
  lua_Debug activation;
  if (m_state != nullptr && FindLuaFunction(m_state, activation)) {
    m_refusal.Line = activation.currentline;
    std::snprintf(m_refusal.Source.data(), m_refusal.Source.size(), "%s", activation.short_src);
  }
}

std::string CLuaState::DescribeRefusal() const {
  std::string text = m_refusal.Line > 0 ? fmt::format("{}:{}: not enough memory",
                                                      m_refusal.Source.data(), m_refusal.Line)
                                        : std::string("not enough memory");
  if (m_limits.MaxMemory == 0) {
    return text;
  }
  return text +
         fmt::format(
             ": the limit is {} MiB, of which {} bytes are in use, and {} bytes more were needed; "
             "does a table grow for ever? If not, raise \"max_memory\" in <params>",
             m_limits.MaxMemory / SLuaLimits::kMebi, m_memory.GetUsed(), m_refusal.Size);
}

void CLuaState::SetHook(lua_State* state, int period) {
  if (m_limits.MaxInstructions > 0) {
    lua_sethook(state, CountInstructions, LUA_MASKCOUNT, period);
  }
}

void CLuaState::SetUsualHook() {
  SetHook(m_state, static_cast<int>(std::min(kPeriod, m_limits.MaxInstructions)));
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
  self.CountWork(state, kPeriod + self.m_memory.TakeWork() / kBytesPerInstruction);
}

void CLuaState::CountWork(lua_State* state, UInt64 instructions) {
  if (m_limits.MaxInstructions == 0) {
    return;
  }
  if (m_instructionsLeft > instructions) {
    m_instructionsLeft -= instructions;
    return;
  }
  Interrupt(state);
}

void CLuaState::Interrupt(lua_State* state) {
  // a script that catches this error is interrupted again at its next instruction
  m_instructionsLeft = 0;
  m_wasInterrupted = true;
  SetHook(state, 1);
  SetHook(m_state, 1);
  luaL_where(state, 0);
  if (lua_rawlen(state, -1) == 0) {
    // a C function
    lua_pop(state, 1);
    luaL_where(state, 1);
  }
  lua_pushfstring(state,
                  "interrupted after %I instructions; is there an endless loop? If not, raise "
                  "\"max_instructions\" in <params>",
                  static_cast<LUAI_UACINT>(m_limits.MaxInstructions));
  lua_concat(state, 2);
  lua_error(state);
}

void CLuaState::WarnOnce(lua_State* state, ELuaVariation what, const char* text, const char* more) {
  const auto kind = static_cast<UInt32>(what);
  const UInt32 bit = UInt32(1) << kind;
  if (m_variations == nullptr) {
    m_variations = std::make_shared<std::atomic<UInt32>>(0);
  }
  // several threads may run the script; reading alone does not slow them down
  if ((m_variations->load(std::memory_order_relaxed) & bit) != 0) {
    return;
  }
  luaL_where(state, 1);
  if ((m_variations->fetch_or(bit) & bit) == 0) {
    // it precedes the other messages of the phase, whichever robot came first
    const UInt64 place = CARGoSLog::GetSequence();
    CARGoSLog::SetSequence(kind);
    LOGERR << std::string("[WARNING] ") + lua_tostring(state, -1) + text + more << std::endl;
    CARGoSLog::SetSequence(place);
  }
  lua_pop(state, 1);
}

void CLuaState::CountText(lua_State* state, std::size_t bytes) {
  if (bytes > m_textLeft) {
    luaL_error(state,
               "one call has logged more text than the %I MiB of its limit of memory; raise "
               "\"max_memory\" in <params>",
               static_cast<LUAI_UACINT>(m_limits.MaxMemory / SLuaLimits::kMebi));
  }
  m_textLeft -= bytes;
}

}  // namespace argos
