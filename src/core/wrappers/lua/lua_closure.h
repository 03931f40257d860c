#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_CLOSURE_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_CLOSURE_H

#include <argos3/core/wrappers/lua/lua_arguments.h>
#include <argos3/core/wrappers/lua/lua_value.h>

#include <string>
#include <tuple>
#include <type_traits>

struct lua_State;

namespace argos {

/**
 * A Lua function that calls a C++ function on an object.
 *
 * The object's address, the function's name for messages and, unless it is a method, its address
 * are upvalues: a call needs no look-up. Exceptions become Lua errors,
 * "script.lua:7: robot.wheels.set_velocity: argument 2 must be a number, got nil".
 */
class CLuaClosure {
 public:
  /** Type of the functions that Lua calls. */
  using TEntry = int (*)(lua_State*);
  using TAnyFunction = void (*)();

  /** Pushes a closure that calls a method; see CLuaTable::AddMethod(). */
  template <auto METHOD, typename OBJECT>
  static void PushMethod(lua_State* state, const std::string& name, OBJECT& object) {
    using TTraits = SMethod<decltype(METHOD)>;
    typename TTraits::TClass& base = object;
    Push(state, name, &TTraits::template Enter<METHOD>, &base, nullptr);
  }

  /** Pushes a closure that calls function(object, arguments...); see CLuaTable::AddFunction(). */
  template <typename RESULT, typename OBJECT, typename... PARAMETERS>
  static void PushFunction(lua_State* state, const std::string& name,
                           std::remove_reference_t<OBJECT>& object,
                           RESULT (*function)(OBJECT, PARAMETERS...)) {
    static_assert(std::is_lvalue_reference_v<OBJECT>, "the first parameter is the object, DEVICE&");
    Push(state, name, &SFunction<RESULT, OBJECT, PARAMETERS...>::Enter, &object,
         reinterpret_cast<TAnyFunction>(function));
  }

 private:
  template <typename METHOD>
  struct SMethod;

  template <typename RESULT, typename CLASS, typename... PARAMETERS>
  struct SMethod<RESULT (CLASS::*)(PARAMETERS...)> {
    using TClass = CLASS;
    template <auto METHOD>
    static int Enter(lua_State* state) {
      return Protect(state, &Run<METHOD>);
    }
    template <auto METHOD>
    static int Run(lua_State* state) {
      auto& object = *static_cast<CLASS*>(GetObject(state));
      return Call<PARAMETERS...>(
          state, [&](auto&... values) -> RESULT { return (object.*METHOD)(values...); });
    }
  };

  template <typename RESULT, typename CLASS, typename... PARAMETERS>
  struct SMethod<RESULT (CLASS::*)(PARAMETERS...) const>
      : SMethod<RESULT (CLASS::*)(PARAMETERS...)> {};

  template <typename RESULT, typename OBJECT, typename... PARAMETERS>
  struct SFunction {
    static int Enter(lua_State* state) { return Protect(state, &Run); }
    static int Run(lua_State* state) {
      auto& object = *static_cast<std::remove_reference_t<OBJECT>*>(GetObject(state));
      const auto function = reinterpret_cast<RESULT (*)(OBJECT, PARAMETERS...)>(GetFunction(state));
      return Call<PARAMETERS...>(
          state, [&](auto&... values) -> RESULT { return function(object, values...); });
    }
  };

  /** Reads the arguments from left to right, calls, and pushes the result. */
  template <typename... PARAMETERS, typename FUNCTION>
  static int Call(lua_State* state, FUNCTION function) {
    using TResult = decltype(CallWithArguments<PARAMETERS...>(state, function));
    if constexpr (std::is_void_v<TResult>) {
      CallWithArguments<PARAMETERS...>(state, function);
      return 0;
    } else {
      const TResult result = CallWithArguments<PARAMETERS...>(state, function);
      return PushResult(state, result);
    }
  }

  /** Destroys the arguments before it returns: pushing the result may raise a Lua error. */
  template <typename... PARAMETERS, typename FUNCTION>
  static auto CallWithArguments(lua_State* state, FUNCTION function) {
    CLuaArguments arguments(state);
    if constexpr (sizeof...(PARAMETERS) == 1 &&
                  (std::is_same_v<PARAMETERS, CLuaArguments&> && ...)) {
      // the function reads them itself
      if constexpr (std::is_void_v<decltype(function(arguments))>) {
        function(arguments);
        arguments.Finish();
      } else {
        auto result = function(arguments);
        arguments.Finish();
        return result;
      }
    } else {
      std::tuple<std::decay_t<PARAMETERS>...> values{
          arguments.Next<std::decay_t<PARAMETERS> >()...};
      arguments.Finish();
      return std::apply(function, values);
    }
  }

  template <typename RESULT>
  static int PushResult(lua_State* state, const RESULT& result) {
    if constexpr (std::is_same_v<RESULT, SLuaResults>) {
      return result.Count;
    } else {
      if constexpr (std::is_trivially_destructible_v<RESULT>) {
        CLuaValue::Push(state, result);
      } else {
        PushProtected(
            state,
            [](lua_State* inner) {
              CLuaValue::Push(inner, *static_cast<const RESULT*>(GetPushed(inner)));
              return 1;
            },
            &result);
      }
      return 1;
    }
  }

  static void Push(lua_State* state, const std::string& name, TEntry entry, const void* object,
                   TAnyFunction function);
  /** Runs a body that may throw; exceptions become Lua errors. */
  static int Protect(lua_State* state, TEntry body);
  /**
   * Pushes a value whose destructor must run, even if Lua has no memory for the copy.
   * @param push  pushes the value at the address that GetPushed() returns.
   * @throws CARGoSException with the text of the Lua error.
   */
  static void PushProtected(lua_State* state, TEntry push, const void* value);
  static const void* GetPushed(lua_State* state);
  static void* GetObject(lua_State* state);
  static TAnyFunction GetFunction(lua_State* state);
};

}  // namespace argos

#endif
