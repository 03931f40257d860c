#include "lua_tester.h"

#include <argos3/core/wrappers/lua/lua_keys.h>
#include <argos3/core/wrappers/lua/lua_registry.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>

namespace lua_utility_test {

using namespace argos;
using Catch::Contains;

namespace {

// written like a plug-in for ARGoS 3
class CUserDevice {
 public:
  void CreateLuaState(lua_State* state) {
    CLuaUtility::OpenRobotStateTable(state, "user");
    CLuaUtility::AddToTable(state, "_instance", this);
    CLuaUtility::AddToTable(state, "set", &Set);
    CLuaUtility::AddToTable(state, "text", std::string("abc"));
    CLuaUtility::AddToTable(state, "number", 2.5);
    CLuaUtility::AddToTable(state, "angle", CRadians(0.5));
    CLuaUtility::AddToTable(state, "v2", CVector2(1.0, 2.0));
    CLuaUtility::AddToTable(state, "v3", CVector3(1.0, 2.0, 3.0));
    CLuaUtility::AddToTable(state, "q", CQuaternion(0.0, 1.0, 0.0, 0.0));
    CLuaUtility::AddToTable(state, "color", CColor(1, 2, 3));
    CLuaUtility::AddToTable(state, 1, std::string("one"));
    CLuaUtility::AddToTable(state, 2, 2.5);
    CLuaUtility::AddToTable(state, 3, CRadians(0.5));
    CLuaUtility::AddToTable(state, 4, CVector2(1.0, 2.0));
    CLuaUtility::AddToTable(state, 5, CVector3(1.0, 2.0, 3.0));
    CLuaUtility::AddToTable(state, 6, CQuaternion());
    CLuaUtility::AddToTable(state, 7, CColor(4, 5, 6));
    CLuaUtility::StartTable(state, "inner");
    CLuaUtility::AddToTable(state, "deep", 1.0);
    CLuaUtility::StartTable(state, 1);
    CLuaUtility::AddToTable(state, "deeper", 2.0);
    CLuaUtility::EndTable(state);
    CLuaUtility::EndTable(state);
    CLuaUtility::CloseRobotStateTable(state);
  }

  static int Set(lua_State* state) {
    auto* const self = CLuaUtility::GetDeviceInstance<CUserDevice>(state, "user");
    if (self == nullptr) {
      return luaL_error(state, "no instance");
    }
    self->Value = luaL_checknumber(state, 1);
    return 0;
  }

  Real Value = 0.0;
};

class CUserTester : public CLuaTester {
 public:
  CUserTester() {
    Run([this](lua_State* state) {
      lua_newtable(state);
      lua_pushvalue(state, -1);
      lua_rawsetp(state, LUA_REGISTRYINDEX, &kLuaRobotKey);
      Device.CreateLuaState(state);
      CHECK(lua_gettop(state) == 1);
      lua_setglobal(state, "robot");
    });
  }

  CUserDevice Device;
};

/** A file removed by the destructor; tests run concurrently, each in its own process. */
class CScriptFile {
 public:
  explicit CScriptFile(const std::string& text) { std::ofstream(Path) << text; }
  ~CScriptFile() { std::remove(Path.c_str()); }
  CScriptFile(const CScriptFile&) = delete;
  CScriptFile& operator=(const CScriptFile&) = delete;

  const std::string Path = InBuildTree("lua_utility_test_" + std::to_string(getpid()) + ".lua");
};

/** The memory of a Lua state, from which nothing is released. */
struct SBuffer {
  alignas(16) std::array<std::byte, 65536> Bytes;
  std::size_t NumUsed = 0;

  static void* Reallocate(void* buffer, void* block, std::size_t oldSize, std::size_t newSize) {
    auto& self = *static_cast<SBuffer*>(buffer);
    if (block != nullptr && newSize <= oldSize) {
      return newSize > 0 ? block : nullptr;
    }
    if (newSize == 0 || newSize > self.Bytes.size() - self.NumUsed) {
      return nullptr;
    }
    void* const moved = self.Bytes.data() + self.NumUsed;
    self.NumUsed += (newSize + 15) / 16 * 16;
    if (block != nullptr) {
      std::memcpy(moved, block, oldSize);
    }
    return moved;
  }
};

}  // namespace

TEST_CASE("lua utility: a device that uses the API of ARGoS 3 has all values in its table",
          "[lua][utility]") {
  CUserTester lua;
  CHECK(lua.Get("robot.user.text") == "abc");
  CHECK(lua.Get("robot.user.number") == "2.5");
  CHECK(lua.Get("robot.user.angle") == "0.5");
  CHECK(lua.Get("robot.user.v2") == "1,2");
  CHECK(lua.Get("robot.user.v3") == "1,2,3");
  CHECK(lua.Get("robot.user.q.x") == "1.0");
  CHECK(lua.Get("robot.user.color.red .. robot.user.color.green .. robot.user.color.blue") ==
        "1.02.03.0");
  CHECK(lua.Get("#robot.user") == "7");
  CHECK(lua.Get("robot.user[1]") == "one");
  CHECK(lua.Get("robot.user[2] + robot.user[3]") == "3.0");
  CHECK(lua.Get("robot.user[4]") == "1,2");
  CHECK(lua.Get("robot.user[5]") == "1,2,3");
  CHECK(lua.Get("robot.user[6].w") == "1.0");
  CHECK(lua.Get("robot.user[7].green") == "5.0");
  CHECK(lua.Get("robot.user.inner.deep") == "1.0");
  CHECK(lua.Get("robot.user.inner[1].deeper") == "2.0");
}

TEST_CASE("lua utility: an existing table is opened again", "[lua][utility]") {
  CUserTester lua;
  lua.Run([](lua_State* state) {
    lua_getglobal(state, "robot");
    CLuaUtility::OpenRobotStateTable(state, "user");
    CLuaUtility::AddToTable(state, "more", 1.0);
    CLuaUtility::CloseRobotStateTable(state);
    CHECK(lua_gettop(state) == 1);
  });
  CHECK(lua.Get("robot.user.more") == "1.0");
  CHECK(lua.Get("robot.user.text") == "abc");
}

TEST_CASE("lua utility: functions find the instance even if the script overwrites robot",
          "[lua][utility]") {
  CUserTester lua;
  lua.Do("robot.user.set(4)");
  CHECK(lua.Device.Value == 4.0);
  lua.Do("set = robot.user.set robot = nil set(5)");
  CHECK(lua.Device.Value == 5.0);
}

TEST_CASE("lua utility: a missing instance is null", "[lua][utility]") {
  CUserTester lua;
  lua.Run([](lua_State* state) {
    CHECK(CLuaUtility::GetDeviceInstance<CUserDevice>(state, "nothing") == nullptr);
    CHECK(CLuaUtility::GetDeviceInstance<CUserDevice>(state, "user.inner") == nullptr);
    CHECK(CLuaUtility::GetDeviceInstance<CUserDevice>(state, "user.text.more") == nullptr);
    CHECK(CLuaUtility::GetDeviceInstance<CUserDevice>(state, "user") != nullptr);
    CHECK(lua_gettop(state) == 0);
  });
}

TEST_CASE("lua utility: LoadScript runs a file", "[lua][utility]") {
  CLuaTester lua;
  const CScriptFile script("answer = 42\nfunction init() ready = true end\n");
  REQUIRE(CLuaUtility::LoadScript(lua.Get(), script.Path));
  CHECK(lua.Get("answer") == "42");
  REQUIRE(CLuaUtility::CallLuaFunction(lua.Get(), "init"));
  CHECK(lua.Get("ready") == "true");
  CHECK(lua_gettop(lua.Get()) == 0);
}

TEST_CASE("lua utility: a failure leaves Lua's message on the stack", "[lua][utility]") {
  CLuaTester lua;
  const auto message = [&lua] {
    const std::string text = lua_tostring(lua.Get(), -1);
    lua_settop(lua.Get(), 0);
    return text;
  };
  const CScriptFile script("x = 1\nfunction broken() error('no good') end\nx = = 2\n");
  CHECK_FALSE(CLuaUtility::LoadScript(lua.Get(), script.Path));
  CHECK_THAT(message(), Contains(".lua:3:"));
  CHECK_FALSE(CLuaUtility::LoadScript(lua.Get(), "no_such_file.lua"));
  CHECK_THAT(message(), Contains("no_such_file.lua"));
  CHECK_FALSE(CLuaUtility::CallLuaFunction(lua.Get(), "nothing"));
  CHECK_THAT(message(), Contains("\"nothing\" must be a function, got nil"));
  lua.Do("function broken() error('no good') end");
  CHECK_FALSE(CLuaUtility::CallLuaFunction(lua.Get(), "broken"));
  CHECK_THAT(message(), Contains("no good"));
}

TEST_CASE("lua utility: globals and the stack can be printed", "[lua][utility]") {
  CLuaTester lua;
  lua.Do("zebra = { b = 2, a = 'text' } apple = 1");
  lua.Run([](lua_State* state) {
    CLuaUtility::PrintGlobals(LOG, state);
    CHECK(lua_gettop(state) == 0);
  });
  const std::string text = TakeLog();
  CHECK_THAT(text, Contains("apple = 1\n") && Contains("  a = \"text\"\n  b = 2\n"));
  CHECK(text.find("apple = 1") < text.find("zebra = table"));
  // eight levels of tables are printed, and no more
  lua.Do("deep = {} local t = deep for level = 1, 20 do t.next = { mark = level } t = t.next end");
  lua.Run([](lua_State* state) { CLuaUtility::PrintGlobals(LOG, state); });
  const std::string deep = TakeLog();
  CHECK_THAT(deep, Contains("mark = 7\n") && !Contains("mark = 9\n"));
  lua.Run([](lua_State* state) {
    lua_pushinteger(state, 5);
    lua_pushstring(state, "top");
    CLuaUtility::PrintStack(LOG, state);
    CHECK(lua_gettop(state) == 2);
  });
  CHECK(TakeLog() == "#1 number 5\n#2 string \"top\"\n");
}

TEST_CASE("lua utility: a script's error while something is printed is an error of the call",
          "[lua][utility]") {
  CLuaTester lua;
  // leak checkers would find the text of the long key if the error skipped a destructor
  lua.Do(
      "fail = setmetatable({}, { __tostring = function() error('no text', 0) end })\n"
      "_G[string.rep('a', 100)] = fail");
  CHECK_THROWS_WITH(lua.Run([](lua_State* state) { CLuaUtility::PrintGlobals(LOG, state); }),
                    Contains("no text"));
  CHECK_THROWS_WITH(lua.Run([](lua_State* state) {
    lua_getglobal(state, "fail");
    CLuaUtility::PrintStack(LOG, state);
  }),
                    Contains("no text"));
  TakeLog();
}

TEST_CASE("lua utility: keys are ordered in memory of the state alone", "[lua][utility]") {
  // an error may leave the function without calling destructors
  SBuffer buffer;
  lua_State* const state = lua_newstate(&SBuffer::Reallocate, &buffer);
  REQUIRE(state != nullptr);
  lua_gc(state, LUA_GCSTOP);
  lua_newtable(state);
  for (const char* const key : {"wheels", "id", "proximity", "leds", "params", "random"}) {
    lua_pushboolean(state, 1);
    lua_setfield(state, -2, key);
  }
  CheckAllocatesNothing([state] { PushOrderedKeys(state, 1); });
  REQUIRE(lua_gettop(state) == 2);
  std::string keys;
  for (int i = 1; lua_rawgeti(state, 2, i) == LUA_TSTRING; ++i) {
    keys += lua_tostring(state, -1) + std::string(" ");
  }
  CHECK(keys == "id leds params proximity random wheels ");
  lua_close(state);
}

TEST_CASE("lua utility: a metatable is assigned by its name", "[lua][utility]") {
  CLuaTester lua;
  lua.Run([](lua_State* state) {
    luaL_newmetatable(state, "of_test");
    lua_pushstring(state, "from the metatable");
    lua_setfield(state, -2, "__name");
    lua_newtable(state);
    CLuaUtility::SetMetatable(state, "of_test");
    lua_setglobal(state, "t");
  });
  CHECK(lua.Get("getmetatable(t).__name") == "from the metatable");
}

TEST_CASE("lua utility: tables are restored from their bytes", "[lua][utility]") {
  CLuaTester lua;
  lua.Do(
      "t = { 1, 2.5, 'text', true, false, huge = math.huge, min = math.mininteger, [-1] = "
      "'minus',\n"
      "      [2.5] = 'half', [true] = 'yes', inner = { deep = { 'deepest' } }, empty = {},\n"
      "      zero = 'a\\0b', v2 = vector2(1, 2), v3 = vector3(1, 2, 3),\n"
      "      q = quaternion(1, 2, 3, 4), f = print, [print] = 1 }");
  CByteArray data;
  data << UInt8(7);
  lua.Run([&data](lua_State* state) {
    lua_getglobal(state, "t");
    CLuaUtility::LuaSerializeTable(data, state);
    CHECK(lua_gettop(state) == 1);
  });
  data << UInt8(9);
  CHECK(data.PopFront<UInt8>() == 7);
  lua.Run([&data](lua_State* state) {
    REQUIRE(CLuaUtility::LuaDeserializeTable(data, state));
    CHECK(lua_gettop(state) == 1);
    lua_setglobal(state, "u");
  });
  // only the bytes of the table were taken
  CHECK(data.Size() == 1);
  CHECK(data.PopFront<UInt8>() == 9);
  CHECK(lua.Get("u[1] .. u[2] .. u[3]") == "12.5text");
  CHECK(lua.Get("math.type(u[1]) .. math.type(u[2])") == "integerfloat");
  CHECK(lua.Get("u[4]") == "true");
  CHECK(lua.Get("u[5]") == "false");
  CHECK(lua.Get("u.huge") == "inf");
  CHECK(lua.Get("u.min == math.mininteger") == "true");
  CHECK(lua.Get("u[-1] .. u[2.5] .. u[true]") == "minushalfyes");
  CHECK(lua.Get("u.inner.deep[1]") == "deepest");
  CHECK(lua.Get("next(u.empty)") == "nil");
  CHECK(lua.Get("#u.zero") == "3");
  CHECK(lua.Get("u.v2") == "1,2");
  CHECK(lua.Get("u.v3") == "1,2,3");
  CHECK(lua.Get("u.q == t.q") == "true");
  CHECK(lua.Get("u.f") == "nil");
}

TEST_CASE("lua utility: equal tables give equal bytes in any state", "[lua][utility]") {
  const auto serialize = [] {
    CLuaTester lua;
    lua.Do("t = {} for i = 1, 50 do t['key' .. i] = i end");
    CByteArray data;
    lua.Run([&data](lua_State* state) {
      lua_getglobal(state, "t");
      CLuaUtility::LuaSerializeTable(data, state);
    });
    return data;
  };
  const CByteArray first = serialize();
  for (int i = 0; i < 5; ++i) {
    CHECK(serialize() == first);
  }
}

TEST_CASE("lua utility: a table that contains itself cannot be serialised", "[lua][utility]") {
  CLuaTester lua;
  lua.Do("t = {} t.me = t");
  CByteArray data;
  CHECK_THROWS_WITH(lua.Run([&data](lua_State* state) {
    lua_getglobal(state, "t");
    CLuaUtility::LuaSerializeTable(data, state);
  }),
                    Contains("does it contain itself?"));
  CHECK(data.Empty());
}

TEST_CASE("lua utility: malformed bytes give no table", "[lua][utility]") {
  CLuaTester lua;
  lua.Do("t = { 1, 'text', { vector3(1, 2, 3) } }");
  CByteArray good;
  lua.Run([&good](lua_State* state) {
    lua_getglobal(state, "t");
    CLuaUtility::LuaSerializeTable(good, state);
  });
  // every truncation of valid bytes is too short
  for (std::size_t size = 0; size < good.Size(); ++size) {
    CByteArray data(good.ToCArray(), size);
    lua.Run([&](lua_State* state) {
      CHECK_FALSE(CLuaUtility::LuaDeserializeTable(data, state));
      CHECK(lua_gettop(state) == 0);
    });
    CHECK(data.Size() == size);
  }
  // any changed byte is harmless
  for (std::size_t i = 0; i < good.Size(); ++i) {
    for (const int byte : {0, 1, 6, 10, 255}) {
      CByteArray data = good;
      data[i] = static_cast<UInt8>(byte);
      lua.Run([&](lua_State* state) {
        const bool worked = CLuaUtility::LuaDeserializeTable(data, state);
        CHECK(lua_gettop(state) == (worked ? 1 : 0));
      });
    }
  }
}

TEST_CASE("lua utility: bytes of tables that are nested too deep, or have NaN as a key, give none",
          "[lua][utility]") {
  // tags: end 0, float 2, integer 3, table 6
  const auto nested = [](int levels) {
    CByteArray data;
    data << UInt8(6);
    for (int level = 1; level < levels; ++level) {
      data << UInt8(3) << SInt64(1) << UInt8(6);
    }
    for (int level = 0; level < levels; ++level) {
      data << UInt8(0);
    }
    return data;
  };
  const auto keyed = [](Real key) {
    CByteArray data;
    data << UInt8(6) << UInt8(2) << std::bit_cast<UInt64>(key) << UInt8(3) << SInt64(1) << UInt8(0);
    return data;
  };
  const auto isTable = [](CByteArray data) {
    bool worked = false;
    CLuaTester lua;
    lua.Run([&](lua_State* state) {
      worked = CLuaUtility::LuaDeserializeTable(data, state);
      CHECK(lua_gettop(state) == (worked ? 1 : 0));
    });
    return worked;
  };
  CHECK(isTable(nested(10)));
  CHECK_FALSE(isTable(nested(100000)));
  CHECK(isTable(keyed(2.5)));
  CHECK_FALSE(isTable(keyed(std::nan(""))));
}

}  // namespace lua_utility_test
