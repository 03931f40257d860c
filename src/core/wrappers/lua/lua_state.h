#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_STATE_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_STATE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/wrappers/lua/lua_limits.h>
#include <argos3/core/wrappers/lua/lua_memory.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

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

/** What makes a run differ from another one of the same experiment. */
enum class ELuaVariation { KeyOrder, Next, Address, Seed, Time, Clock, Date };

/**
 * A Lua state with the standard libraries, log(), logerr() and the vector types.
 *
 * So that runs can be repeated, pairs() visits numbers and strings in a fixed order, and the owner
 * of the state seeds math.random() with SeedMath(). lua_sandbox.h lists what scripts cannot do.
 */
class CLuaState : private CNonCopyable {
 public:
  /**
   * A script that exceeds a limit is interrupted with an error; MaxInstructions are those of one
   * Run().
   * @throws CARGoSException if there is not enough memory.
   */
  explicit CLuaState(const SLuaLimits& limits = {});
  /** With the usual limits, but for that of instructions. */
  explicit CLuaState(UInt64 maxInstructions);
  ~CLuaState();

  lua_State* Get() const { return m_state; }

  /** Restarts math.random(). */
  void SeedMath(UInt64 seed);

  /**
   * While this is on, what is created is in memory in its order, and no garbage is collected: for
   * the tables that are written in each tick.
   */
  void KeepOrder(bool isOn);
  /** Prefetches what was created while KeepOrder() was on. */
  void LoadAhead() const { m_memory.LoadAheadInOrder(); }

  /** Lets require() search the script's folder first, and runs the script. @throws CLuaError */
  void Execute(const SLuaScript& script);

  /**
   * Calls a global function.
   * @param numArguments  on top of the stack; only inside Run().
   * @throws CLuaError if there is no such function, with the nearest names of those that are there.
   */
  static void CallGlobal(lua_State* state, const char* name, int numArguments = 0,
                         int numResults = 0);
  /**
   * Calls a global function of the script, without arguments, if it is there; only inside Run().
   * @throws CLuaError if there is none, but a function of a similar name.
   */
  static void CallOptional(lua_State* state, const char* name);

  // Only inside Run(), outside of functions that scripts call.

  /** @return empty if there is a global function of that name; else a message. */
  static std::string FindFaultOfFunction(lua_State* state, const char* name);
  /** Names of the global functions of the script, sorted. */
  static std::vector<std::string> ListFunctions(lua_State* state);

  /**
   * Calls body(lua_State*) on an empty stack and catches Lua errors.
   * @throws CLuaError for a Lua error; exceptions of the body pass through.
   */
  template <typename BODY>
  void Run(const BODY& body) {
    RunBody([](const void* b, lua_State* state) { (*static_cast<const BODY*>(b))(state); }, &body);
  }

  /** Bytes of the objects of the state, without those that are free for reuse. */
  std::size_t GetMemory() const;

  /** The object that a Lua state, or a coroutine of it, belongs to. */
  static CLuaState& Of(lua_State* state);
  /** Bytes that the limit of memory allows; the largest number if there is none. */
  std::size_t GetLargestBlock() const { return m_memory.GetLimit(); }

  // For library functions; the first two raise Lua errors.

  /** Counts work that no instruction stands for. */
  void CountWork(lua_State* state, UInt64 instructions);
  /** Counts bytes that a call writes into the log, which occupy memory until the tick ends. */
  void CountText(lua_State* state, std::size_t bytes);
  /**
   * Logs a warning with the place in the script, unless one of the kind was logged for its file.
   * May raise an error for lack of memory.
   */
  void WarnOnce(lua_State* state, ELuaVariation what, const char* text, const char* more = "");
  bool IsUnsafe() const { return m_limits.IsUnsafe; }
  /** True if the limit of instructions has interrupted this Run(). */
  bool WasInterrupted() const { return m_wasInterrupted; }

 private:
  using TCall = void (*)(const void* body, lua_State* state);
  struct SCall;

  void RunBody(TCall call, const void* body);
  static int CallBody(lua_State* state);
  static void* Reallocate(void* self, void* block, std::size_t oldSize, std::size_t newSize);
  static void Warn(void* self, const char* message, int toBeContinued);
  static int HandleError(lua_State* state);
  static int Xpcall(lua_State* state);
  static void CountInstructions(lua_State* state, lua_Debug* activation);
  void SetHook(lua_State* state, int period);
  void SetUsualHook();
  /** Raises the error of the limit of instructions. */
  void Interrupt(lua_State* state);
  void NoteRefusal(std::size_t size);
  std::string DescribeRefusal() const;

  /** The last block that was refused in the current Run(). */
  struct SRefusal {
    std::size_t Size = 0;  // bytes; 0 = none
    int Line = 0;
    std::array<char, 64> Source = {};  // file of that line
  };

  SLuaLimits m_limits;
  CLuaMemory m_memory;  // memory of the state
  lua_State* m_state = nullptr;
  UInt64 m_instructionsLeft = 0;  // rest of the current Run()
  std::size_t m_textLeft = 0;  // the same, bytes
  SRefusal m_refusal;
  bool m_wasInterrupted = false;
  bool m_isWarning = false;  // the script has switched warn() on
  std::shared_ptr<std::atomic<UInt32>> m_variations;  // of the script; null before Execute()
  std::string m_warning;  // parts of the current warning so far
};

}  // namespace argos

#endif
