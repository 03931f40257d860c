#include "lua_tester.h"

#include <argos3/core/wrappers/lua/lua_registry.h>
#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <stdexcept>
#include <vector>

namespace lua_table_test {

using namespace argos;
using Catch::Contains;

namespace {

/** A device with a function of every kind. */
class CDevice {
 public:
  void SetSpeeds(Real left, Real right) { Speeds = {left, right}; }
  void Turn(const CRadians& angle) { Angle = angle.GetValue(); }
  void Switch(bool on) { IsOn = on; }
  void SetByte(UInt8 byte) { Byte = byte; }
  void SetSigned(SInt32 value) { Signed = value; }
  void SetHuge(UInt64 value) { Huge = value; }
  void Say(const std::string& text) { Text = text; }
  void GoTo(const CVector3& place) { Place = place; }
  void Push(const CVector2& push) { Place.Set(push.GetX(), push.GetY(), 0.0); }
  void Face(const CQuaternion& orientation) { Orientation = orientation; }
  void Paint(const CColor& color) { Color = color; }
  Real GetAngle() const { return Angle; }
  bool IsSwitchedOn() const { return IsOn; }
  const std::string& GetText() const { return Text; }
  CVector3 GetPlace() const { return Place; }
  UInt32 CountNothing() { return 0; }
  void Refuse() { THROW_ARGOSEXCEPTION("the device is out of order"); }
  void Break() { throw std::runtime_error("broken"); }
  void BreakBadly() { throw 7; }

  void CreateLuaState(lua_State* state);
  void ReadingsToLuaState(lua_State* state);

  std::vector<Real> Speeds;
  Real Angle = 0.0;
  bool IsOn = false;
  UInt8 Byte = 0;
  SInt32 Signed = 0;
  UInt64 Huge = 0;
  std::string Text;
  CVector3 Place;
  CQuaternion Orientation;
  CColor Color;

  struct SReading {
    Real Value;
    Real Angle;
  };
  std::vector<SReading> Ring = {{0.0, 1.0}, {0.0, 2.0}, {0.0, 3.0}};
  std::vector<Real> Numbers = {0.0, 0.0};
  std::vector<std::vector<int>> Messages;
};

void CDevice::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, "device");
  table.AddMethod<&CDevice::SetSpeeds>("set_speeds", *this);
  table.AddMethod<&CDevice::Turn>("turn", *this);
  table.AddMethod<&CDevice::Switch>("switch", *this);
  table.AddMethod<&CDevice::SetByte>("set_byte", *this);
  table.AddMethod<&CDevice::SetSigned>("set_signed", *this);
  table.AddMethod<&CDevice::SetHuge>("set_huge", *this);
  table.AddMethod<&CDevice::Say>("say", *this);
  table.AddMethod<&CDevice::GoTo>("go_to", *this);
  table.AddMethod<&CDevice::Push>("push", *this);
  table.AddMethod<&CDevice::Face>("face", *this);
  table.AddMethod<&CDevice::Paint>("paint", *this);
  table.AddMethod<&CDevice::GetAngle>("get_angle", *this);
  table.AddMethod<&CDevice::IsSwitchedOn>("is_switched_on", *this);
  table.AddMethod<&CDevice::GetText>("get_text", *this);
  table.AddMethod<&CDevice::GetPlace>("get_place", *this);
  table.AddMethod<&CDevice::CountNothing>("count_nothing", *this);
  table.AddMethod<&CDevice::Refuse>("refuse", *this);
  table.AddMethod<&CDevice::Break>("break_", *this);
  table.AddMethod<&CDevice::BreakBadly>("break_badly", *this);
  table.AddFunction("set_one", *this, [](CDevice& self, CLuaArguments& arguments) {
    const std::size_t index = arguments.NextIndex(3);
    self.Ring[index].Value = arguments.Next<Real>();
  });
  table.AddFunction("sum", *this, [](CDevice&, Real a, UInt32 b) { return a + b; });
  table.AddFunction("set_bytes", *this, [](CDevice& self, CLuaArguments& arguments) {
    const std::vector<UInt8> bytes = arguments.NextBytes(3);
    self.Byte = bytes[2];
    return static_cast<UInt32>(bytes[0] + bytes[1]);
  });
  CLuaTable ring = table.GetTable("ring");
  ring.SetRecords(Ring, [](CLuaTable& record, const SReading& reading) {
    record.Set("value", reading.Value);
    if (record.IsNew()) {
      record.Set("angle", reading.Angle);
    }
  });
}

void CDevice::ReadingsToLuaState(lua_State* state) {
  CLuaTable table(state, *this);
  {
    CLuaTable ring = table.GetTable("ring");
    ring.SetRecords(Ring, [](CLuaTable& record, const SReading& reading) {
      record.Set("value", reading.Value);
      if (record.IsNew()) {
        record.Set("angle", reading.Angle);
      }
    });
  }
  {
    CLuaTable numbers = table.GetTable("numbers");
    numbers.SetNumbers(Numbers);
  }
  CLuaTable messages = table.GetTable("messages");
  messages.SetNewRecords(Messages, [](CLuaTable& record, const std::vector<int>& data) {
    CLuaTable list = record.GetTable("data");
    list.SetNumbers(data);
  });
}

/** A state whose robot has such a device. */
class CDeviceTester : public CLuaTester {
 public:
  CDeviceTester() {
    Run([this](lua_State* state) {
      lua_newtable(state);
      Device.CreateLuaState(state);
      CHECK(lua_gettop(state) == 1);
      lua_setglobal(state, "robot");
    });
  }

  void Refresh() {
    Run([this](lua_State* state) {
      Device.ReadingsToLuaState(state);
      CHECK(lua_gettop(state) == 0);
    });
  }

  CDevice Device;
};

/** An allocator of a Lua state that can only release. */
struct SFullMemory {
  lua_Alloc Original = nullptr;
  void* OriginalData = nullptr;

  static void* Reallocate(void* memory, void* block, std::size_t oldSize, std::size_t newSize) {
    const auto& self = *static_cast<const SFullMemory*>(memory);
    const bool grows = block == nullptr ? newSize > 0 : newSize > oldSize;
    return grows ? nullptr : self.Original(self.OriginalData, block, oldSize, newSize);
  }
};

}  // namespace

TEST_CASE("lua table: methods take arguments of every type", "[lua][table]") {
  CDeviceTester lua;
  lua.Do(
      "d = robot.device\n"
      "d.set_speeds(1.5, -2) d.turn(0.25) d.switch(true) d.set_byte(255) d.set_signed(-5)\n"
      "d.set_huge(math.maxinteger) d.say('a\\0b') d.go_to(vector3(1, 2, 3))\n"
      "d.face(quaternion(0, 1, 0, 0)) d.paint('red')");
  CHECK(lua.Device.Speeds == std::vector<Real>{1.5, -2.0});
  CHECK(lua.Device.Angle == 0.25);
  CHECK(lua.Device.IsOn);
  CHECK(lua.Device.Byte == 255);
  CHECK(lua.Device.Signed == -5);
  CHECK(lua.Device.Huge == 9223372036854775807U);
  CHECK(lua.Device.Text == std::string("a\0b", 3));
  CHECK(lua.Device.Place == CVector3(1.0, 2.0, 3.0));
  CHECK(lua.Device.Orientation == CQuaternion(0.0, 1.0, 0.0, 0.0));
  CHECK(lua.Device.Color == CColor::RED);
  lua.Do("d.push(vector2(8, 9)) d.paint(1, 2, 3)");
  CHECK(lua.Device.Place == CVector3(8.0, 9.0, 0.0));
  CHECK(lua.Device.Color == CColor(1, 2, 3));
  lua.Do("d.paint('10,20,30,40') d.set_byte(7.0)");
  CHECK(lua.Device.Color == CColor(10, 20, 30, 40));
  CHECK(lua.Device.Byte == 7);
}

TEST_CASE("lua table: results of methods are returned to the script", "[lua][table]") {
  CDeviceTester lua;
  lua.Do("d = robot.device d.turn(0.5) d.say('hello') d.go_to(vector3(1, 2, 3))");
  CHECK(lua.GetNumber("d.get_angle()") == 0.5);
  CHECK(lua.Get("d.is_switched_on()") == "false");
  CHECK(lua.Get("d.get_text()") == "hello");
  CHECK(lua.Get("d.get_place()") == "1,2,3");
  CHECK(lua.Get("d.count_nothing()") == "0.0");
  CHECK(lua.Get("select('#', d.turn(1))") == "0");
}

TEST_CASE("lua table: a result for which Lua has no memory is an error", "[lua][table]") {
  // leak checkers would find the text if the error skipped its destructor
  CDeviceTester lua;
  lua.Device.Text = std::string(1000, 'x');
  lua.Run([](lua_State* state) {
    lua_getglobal(state, "robot");
    lua_getfield(state, -1, "device");
    lua_getfield(state, -1, "get_text");
    SFullMemory memory;
    memory.Original = lua_getallocf(state, &memory.OriginalData);
    lua_setallocf(state, &SFullMemory::Reallocate, &memory);
    const int status = lua_pcall(state, 0, 1, 0);
    lua_setallocf(state, memory.Original, memory.OriginalData);
    CHECK(status == LUA_ERRMEM);
    CHECK(std::string(lua_tostring(state, -1)) == "not enough memory");
  });
  CHECK(lua.Get("#robot.device.get_text()") == "1000");
}

TEST_CASE(
    "lua table: the error on a wrong argument gives function, argument, type expected and found",
    "[lua][table]") {
  CDeviceTester lua;
  const auto error = [&](const std::string& call) { return lua.GetError("robot.device." + call); };
  const std::string at = "test:1: robot.device.";
  CHECK(error("set_speeds(1, nil)") == at + "set_speeds: argument 2 must be a number, got nil");
  CHECK(error("set_speeds(1)") == at + "set_speeds: argument 2 must be a number, got nothing");
  CHECK(error("set_speeds()") == at + "set_speeds: argument 1 must be a number, got nothing");
  CHECK(error("set_speeds(1, 2, 3)") == at + "set_speeds: too many arguments: expected 2, got 3");
  CHECK(error("set_speeds('1', 2)") ==
        at + "set_speeds: argument 1 must be a number, got string \"1\"");
  CHECK(error("set_speeds({}, 2)") == at + "set_speeds: argument 1 must be a number, got table");
  // called with a colon instead of a dot
  CHECK(lua.GetError("robot.device:set_speeds(1, 2)") ==
        at + "set_speeds: argument 1 must be a number, got table; call it with a dot, not with "
             "a colon");
  CHECK(error("switch(1)") == at + "switch: argument 1 must be true or false, got 1");
  CHECK(error("switch(nil)") == at + "switch: argument 1 must be true or false, got nil");
  CHECK(error("set_byte(256)") ==
        at + "set_byte: argument 1 must be a whole number from 0 to 255, got 256");
  CHECK(error("set_byte(-1)") ==
        at + "set_byte: argument 1 must be a whole number from 0 to 255, got -1");
  CHECK(error("set_byte(1.5)") == at + "set_byte: argument 1 must be a whole number from 0 to 255 "
                                       "(--lenient truncates others), got 1.5");
  CHECK_THAT(error("set_byte(0/0)"), Contains("whole number from 0 to 255, got"));
  CHECK_THAT(error("set_signed(1e300)"),
             Contains("whole number from -2147483648 to 2147483647, got 1e+300"));
  CHECK(error("say(5)") == at + "say: argument 1 must be a string, got 5");
  CHECK(error("go_to(vector2())") == at + "go_to: argument 1 must be a vector3, got vector2");
  CHECK(error("push(3)") == at + "push: argument 1 must be a vector2, got 3");
  CHECK(error("face(vector3())") == at + "face: argument 1 must be a quaternion, got vector3");
  CHECK_THAT(error("paint('rde')"), Contains(at + "paint: ") && Contains("rde") && Contains("red"));
  CHECK_THAT(error("paint(1, 2)"),
             Contains("argument 3 must be a whole number from 0 to 255, got nothing"));
  CHECK_THAT(error("paint(1, 2, 300)"), Contains("argument 3"));
  CHECK_THAT(error("paint(true)"), Contains("argument 1 must be the name of a color"));
  // none of these calls has reached the device
  CHECK(lua.Device.Speeds.empty());
  CHECK(lua.Device.Byte == 0);
  CHECK(lua.Device.Color == CColor::BLACK);
}

TEST_CASE("lua table: errors can be caught, and long texts in them are cut", "[lua][table]") {
  CDeviceTester lua;
  lua.Do("ok, message = pcall(robot.device.set_byte, string.rep('x', 100000))");
  CHECK(lua.Get("ok") == "false");
  CHECK(lua.Get("#message < 200") == "true");
}

TEST_CASE("lua table: exceptions of a device become Lua errors", "[lua][table]") {
  CDeviceTester lua;
  CHECK(lua.GetError("robot.device.refuse()") ==
        "test:1: robot.device.refuse: the device is out of order");
  CHECK(lua.GetError("robot.device.break_()") == "test:1: robot.device.break_: broken");
  CHECK_THAT(lua.GetError("robot.device.break_badly()"), Contains("not a std::exception"));
  lua.Do("ok, message = pcall(robot.device.refuse)");
  CHECK(lua.Get("ok") == "false");
  CHECK_THAT(lua.Get("message"), Contains("out of order"));
}

TEST_CASE("lua table: functions without captures take separate arguments", "[lua][table]") {
  CDeviceTester lua;
  lua.Do("robot.device.set_one(1, 0.5) robot.device.set_one(3, 0.25)");
  CHECK(lua.Device.Ring[0].Value == 0.5);
  CHECK(lua.Device.Ring[2].Value == 0.25);
  CHECK(lua.GetError("robot.device.set_one(0, 1)") ==
        "test:1: robot.device.set_one: argument 1 must be a whole number from 1 to 3, got 0");
  CHECK_THAT(lua.GetError("robot.device.set_one(4, 1)"), Contains("from 1 to 3, got 4"));
  CHECK_THAT(lua.GetError("robot.device.set_one(1, 1, 1)"), Contains("expected 2, got 3"));
  CHECK(lua.GetNumber("robot.device.sum(1.5, 2)") == 3.5);
  CHECK_THAT(lua.GetError("robot.device.sum(1.5, -2)"), Contains("robot.device.sum: argument 2"));
}

TEST_CASE("lua table: the length and values of byte lists are checked", "[lua][table]") {
  CDeviceTester lua;
  CHECK(lua.GetNumber("robot.device.set_bytes({200, 50, 9})") == 250.0);
  CHECK(lua.Device.Byte == 9);
  const std::string expected = "argument 1 must be a table of 3 whole numbers from 0 to 255, ";
  CHECK_THAT(lua.GetError("robot.device.set_bytes({1, 2})"),
             Contains(expected + "got a table of 2"));
  CHECK_THAT(lua.GetError("robot.device.set_bytes({1, 2, 256})"),
             Contains(expected + "but entry 3 is 256"));
  CHECK_THAT(lua.GetError("robot.device.set_bytes({1, -1, 255})"),
             Contains(expected + "but entry 2 is -1"));
  CHECK_THAT(lua.GetError("robot.device.set_bytes({1, 'x', 3})"),
             Contains(expected + "but entry 2 is string \"x\""));
  CHECK_THAT(lua.GetError("robot.device.set_bytes(1)"), Contains(expected + "got 1"));
}

TEST_CASE("lua table: fractions are errors that name the option, or truncated with one warning",
          "[lua][table]") {
  CDeviceTester lua;
  CHECK_THAT(lua.GetError("robot.device.set_one(1.9, 5)"),
             Contains("argument 1 must be a whole number from 1 to 3 (--lenient truncates "
                      "others), got 1.9"));
  CHECK_THAT(lua.GetError("robot.device.set_bytes({1, 2, 3.5})"),
             Contains("(--lenient truncates others), but entry 3 is 3.5"));
  lua.Run([](lua_State* state) { CLuaArguments::AcceptFractions(state, "robot \"r\""); });
  TakeLogErr();
  lua.Do("robot.device.set_one(1.9, 5)");
  CHECK(lua.Device.Ring[0].Value == 5.0);
  lua.Do("robot.device.set_bytes({1, 2, 3.5})");
  CHECK(lua.Device.Byte == 3);
  const std::string warnings = TakeLogErr();
  CHECK_THAT(warnings, Contains("[WARNING] robot \"r\"") && Contains("is 1.9"));
  CHECK(warnings.find("3.5") == std::string::npos);
  CHECK_THAT(lua.GetError("robot.device.set_one(3.9 + 1, 5)"),
             Contains("whole number from 1 to 3"));
}

TEST_CASE("lua table: functions do not depend on the global robot", "[lua][table]") {
  CDeviceTester lua;
  lua.Do("set = robot.device.set_speeds robot = nil set(3, 4)");
  CHECK(lua.Device.Speeds == std::vector<Real>{3.0, 4.0});
  lua.Refresh();
}

TEST_CASE("lua table: readings of fixed number are updated in place", "[lua][table]") {
  CDeviceTester lua;
  CHECK(lua.Get("#robot.device.ring") == "3");
  lua.Do("second = robot.device.ring[2]");
  lua.Device.Ring[1].Value = 0.75;
  CHECK(lua.GetNumber("second.value") == 0.0);
  lua.Refresh();
  CHECK(lua.GetNumber("second.value") == 0.75);
  CHECK(lua.GetNumber("second.angle") == 2.0);
  // entries that a script has removed or replaced are restored
  lua.Do("robot.device.ring[2] = nil robot.device.ring[3] = 'mine'");
  lua.Refresh();
  CHECK(lua.GetNumber("robot.device.ring[2].value") == 0.75);
  CHECK(lua.GetNumber("robot.device.ring[2].angle") == 2.0);
  CHECK(lua.GetNumber("robot.device.ring[3].angle") == 3.0);
  lua.Do("robot.device = nil");
  lua.Refresh();
}

TEST_CASE("lua table: lists of numbers and records have the length of the last reading",
          "[lua][table]") {
  CDeviceTester lua;
  lua.Device.Numbers = {1.0, 2.5, 3.0};
  lua.Device.Messages = {{1, 2}, {3}, {4, 5, 6}};
  lua.Refresh();
  CHECK(lua.Get("table.concat(robot.device.numbers, ' ')") == "1.0 2.5 3.0");
  CHECK(lua.Get("#robot.device.messages") == "3");
  CHECK(lua.Get("table.concat(robot.device.messages[3].data, ' ')") == "4.0 5.0 6.0");
  // a script may keep a message of an earlier reading
  lua.Do("kept = robot.device.messages[1]");
  lua.Device.Numbers = {7.0};
  lua.Device.Messages = {{9}};
  lua.Refresh();
  CHECK(lua.Get("table.concat(robot.device.numbers, ' ')") == "7.0");
  CHECK(lua.Get("#robot.device.messages") == "1");
  CHECK(lua.Get("robot.device.messages[2]") == "nil");
  CHECK(lua.Get("table.concat(robot.device.messages[1].data, ' ')") == "9.0");
  CHECK(lua.Get("table.concat(kept.data, ' ')") == "1.0 2.0");
  lua.Device.Messages.clear();
  lua.Refresh();
  CHECK(lua.Get("#robot.device.messages") == "0");
}

TEST_CASE("lua table: repeated updates do not enlarge the state", "[lua][table]") {
  CDeviceTester lua;
  const auto memory = [&lua] {
    lua.Do("collectgarbage()");
    return lua.GetMemory();
  };
  lua.Device.Messages = {{1, 2}, {3}};
  lua.Refresh();
  const std::size_t before = memory();
  for (int i = 0; i < 1000; ++i) {
    lua.Refresh();
  }
  // less than a byte per update
  CHECK(memory() < before + 1000);
}

TEST_CASE("lua table: an actuator and a sensor share a table, two sensors do not", "[lua][table]") {
  CLuaTester lua;
  CDevice a;
  CDevice b;
  CDevice c;
  const auto add = [](lua_State* state, const char* kind, const std::string& label,
                      CDevice& device) {
    const SLuaDevice current{kind, label};
    lua_pushlightuserdata(state, const_cast<SLuaDevice*>(&current));
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kLuaDeviceKey);
    device.CreateLuaState(state);
  };
  CHECK_THROWS_WITH(
      lua.Run([&](lua_State* state) {
        lua_newtable(state);
        add(state, "actuator", "wheels_a", a);
        add(state, "sensor", "wheels_s", b);
        // the same actuator again
        add(state, "actuator", "wheels_a", a);
        add(state, "sensor", "other_wheels", c);
      }),
      Contains("the sensors <wheels_s> and <other_wheels> would both write into the Lua table "
               "robot.device"));
}

}  // namespace lua_table_test
