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
 * A Lua function that calls C++ on an object.
 *
 * The object's address, the function's name for messages and, unless it is a method, its address
 * are upvalues: nothing is looked up when it is called. Exceptions become Lua errors,
 * "script.lua:7: robot.wheels.set_velocity: argument 2 must be a number, got nil".
 */
class CLuaClosure {
 public:
  /** What Lua calls. */
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
    CLuaArguments arguments(state);
    if constexpr (sizeof...(PARAMETERS) == 1 &&
                  (std::is_same_v<PARAMETERS, CLuaArguments&> && ...)) {
      return PushResult(
          state, [&] { return function(arguments); }, &arguments);
    } else {
      std::tuple<std::decay_t<PARAMETERS>...> values{
          arguments.Next<std::decay_t<PARAMETERS> >()...};
      arguments.Finish();
      return PushResult(
          state, [&] { return std::apply(function, values); }, nullptr);
    }
  }

  /** @param arguments  those that the function reads itself; null if it does not. */
  template <typename FUNCTION>
  static int PushResult(lua_State* state, FUNCTION function, const CLuaArguments* arguments) {
    const auto finish = [arguments] {
      if (arguments != nullptr) {
        arguments->Finish();
      }
    };
    using TResult = decltype(function());
    if constexpr (std::is_void_v<TResult>) {
      function();
      finish();
      return 0;
    } else {
      const std::decay_t<TResult> result = function();
      finish();
      if constexpr (std::is_same_v<TResult, SLuaResults>) {
        return result.Count;
      } else {
        CLuaValue::Push(state, result);
        return 1;
      }
    }
  }

  static void Push(lua_State* state, const std::string& name, TEntry entry, const void* object,
                   TAnyFunction function);
  /** Runs what may throw; exceptions become Lua errors. */
  static int Protect(lua_State* state, TEntry body);
  static void* GetObject(lua_State* state);
  static TAnyFunction GetFunction(lua_State* state);
};

}  // namespace argos

#endif
