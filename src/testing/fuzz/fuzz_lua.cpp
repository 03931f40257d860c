// The input is a Lua script: it is compiled and run, and its step() is called. Files and programs
// are out of its reach.

#include <argos3/testing/fuzz/fuzz_support.h>

#include <argos3/core/wrappers/lua/lua_closure.h>
#include <argos3/core/wrappers/lua/lua_random.h>
#include <argos3/core/wrappers/lua/lua_state.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <string>

using namespace argos;

namespace {

constexpr UInt64 kInstructions = 100000;
constexpr UInt64 kMemory = 8 * SLuaLimits::kMebi;

/** roundtrip(table): what a robot receives if another one sends the table. */
class CMessages {
 public:
  SLuaResults RoundTrip(CLuaArguments& arguments) {
    lua_State* const state = arguments.GetState();
    if (!arguments.IsNextTable()) {
      arguments.ThrowNextMustBe("a table");
    }
    arguments.Skip();
    arguments.Finish();
    CByteArray data;
    CLuaUtility::LuaSerializeTable(data, state);
    CLuaUtility::LuaDeserializeTable(data, state);
    return {1};
  }
};

void RemoveFiles(lua_State* state) {
  for (const char* const name : {"io", "loadfile", "dofile", "require", "package", "print"}) {
    lua_pushnil(state);
    lua_setglobal(state, name);
  }
  lua_getglobal(state, "os");
  for (const char* const name : {"execute", "remove", "rename", "tmpname"}) {
    lua_pushnil(state);
    lua_setfield(state, -2, name);
  }
  lua_pop(state, 1);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return RunFuzzInput([data, size] {
    CLuaRandom random(1);
    CMessages messages;
    SLuaLimits limits;
    limits.MaxInstructions = kInstructions;
    limits.MaxMemory = kMemory;
    CLuaState lua(limits);
    lua.Run([&](lua_State* state) {
      RemoveFiles(state);
      lua_newtable(state);
      CLuaUtility::StartTable(state, "random");
      random.Register(state);
      CLuaUtility::EndTable(state);
      CLuaClosure::PushMethod<&CMessages::RoundTrip>(state, "robot.roundtrip", messages);
      lua_setfield(state, -2, "roundtrip");
      lua_setglobal(state, "robot");
    });
    lua.Run([data, size](lua_State* state) {
      const auto* const text = reinterpret_cast<const char*>(data);
      if (luaL_loadbufferx(state, text, size, "=fuzz", "t") != LUA_OK) {
        lua_error(state);
      }
      lua_call(state, 0, 0);
    });
    lua.Run([](lua_State* state) { CLuaState::CallGlobal(state, "step"); });
  });
}
