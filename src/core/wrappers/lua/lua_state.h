#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_STATE_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_STATE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/wrappers/lua/lua_memory.h>

#include <string>

struct lua_Debug;
struct lua_State;

namespace argos {

struct SLuaScript;

/** An error in a script: Lua's message, which begins with file and line, and the traceback. */
class CLuaError : public CARGoSException {
 public:
  explicit CLuaError(const std::string& message) : CARGoSException(message), m_message(message) {}

  const std::string& GetMessage() const { return m_message; }

 private:
  std::string m_message;
};

/**
 * A Lua state with all standard libraries, log(), logerr() and the vector types.
 *
 * So that runs can be repeated, pairs() visits numbers and strings in a fixed order, and the owner
 * of the state seeds math.random() with SeedMath().
 */
class CLuaState {
 public:
  static constexpr UInt64 kDefaultMaxInstructions = 100000000;

  /**
   * @param maxInstructions  instructions of the virtual machine that one Run() may execute before
   * an error interrupts it; 0 = no limit, which makes scripts faster.
   * @throws CARGoSException if there is not enough memory.
   */
  explicit CLuaState(UInt64 maxInstructions = kDefaultMaxInstructions);
  ~CLuaState();
  CLuaState(const CLuaState&) = delete;
  CLuaState& operator=(const CLuaState&) = delete;

  lua_State* Get() const { return m_state; }

  /** Restarts math.random(). */
  void SeedMath(UInt64 seed);

  /** Lets require() search the script's folder first, and runs the script. @throws CLuaError */
  void Execute(const SLuaScript& script);

  /**
   * Calls a global function.
   * @param numArguments  on top of the stack; only inside Run().
   */
  static void CallGlobal(lua_State* state, const char* name, int numArguments = 0,
                         int numResults = 0);

  /**
   * Calls body(lua_State*) on an empty stack and catches Lua errors.
   * @throws CLuaError for a Lua error; exceptions of the body pass through.
   */
  template <typename BODY>
  void Run(const BODY& body) {
    RunBody([](const void* b, lua_State* state) { (*static_cast<const BODY*>(b))(state); }, &body);
  }

  /** Bytes that the state occupies. */
  std::size_t GetMemory() const;

 private:
  using TCall = void (*)(const void* body, lua_State* state);
  struct SCall;

  void RunBody(TCall call, const void* body);
  static int CallBody(lua_State* state);
  /** The object that a Lua state, or a coroutine of it, belongs to. */
  static CLuaState& Of(lua_State* state);
  static void Warn(void* self, const char* message, int toBeContinued);
  static int HandleError(lua_State* state);
  static int Xpcall(lua_State* state);
  static void CountInstructions(lua_State* state, lua_Debug* activation);
  void SetHook(lua_State* state, int period);

  CLuaMemory m_memory;  // of the state
  lua_State* m_state;
  UInt64 m_maxInstructions;
  UInt64 m_instructionsLeft = 0;  // of the current Run()
  bool m_wasInterrupted = false;
  bool m_isWarning = false;  // the script has switched warn() on
  std::string m_warning;  // parts of the current warning so far
};

}  // namespace argos

#endif
