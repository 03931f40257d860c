#include "lua_tester.h"

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/wrappers/lua/lua_quaternion.h>
#include <argos3/core/wrappers/lua/lua_types.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/core/wrappers/lua/lua_vector2.h>
#include <argos3/core/wrappers/lua/lua_vector3.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace lua_types_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

// tolerance of a few roundings of numbers of about 1
constexpr Real kRounding = 1e-14;

}  // namespace

TEST_CASE(
    "lua types: constructors without, with numbers and with a vector make zero, values and copies",
    "[lua][types]") {
  CLuaTester lua;
  CHECK(lua.Get("vector2()") == "0,0");
  CHECK(lua.Get("vector2(1, -2.5)") == "1,-2.5");
  CHECK(lua.Get("vector3()") == "0,0,0");
  CHECK(lua.Get("vector3(1, 2, 3)") == "1,2,3");
  CHECK(lua.Get("quaternion().w .. quaternion().x .. quaternion().y .. quaternion().z") ==
        "1.00.00.00.0");
  CHECK(lua.Get("quaternion(0.5, 0.25, -1, 2).y") == "-1.0");
  // a copy is a new object
  lua.Do("a = vector2(1, 2); b = vector2(a); b.x = 9");
  CHECK(lua.Get("a") == "1,2");
  CHECK(lua.Get("b") == "9,2");
  lua.Do("a = vector3(1, 2, 3); b = vector3(a); b.z = 9");
  CHECK(lua.Get("a") == "1,2,3");
  CHECK(lua.Get("b") == "1,2,9");
  lua.Do("a = quaternion(1, 2, 3, 4); b = quaternion(a); b.w = 9");
  CHECK(lua.Get("a.w") == "1.0");
  CHECK(lua.Get("b.w") == "9.0");
  // an assignment copies the reference only
  lua.Do("a = vector2(1, 2); b = a; b.x = 9");
  CHECK(lua.Get("a.x") == "9.0");
}

TEST_CASE("lua types: a quaternion of angle and axis ignores the length of the axis",
          "[lua][types]") {
  CLuaTester lua;
  const Real length = GENERATE(1.0, 0.1, 250.0);
  CAPTURE(length);
  lua.Do("q = quaternion(math.pi / 3, vector3(0, " + std::to_string(length) + ", 0))");
  // w = cos(30 degrees), y = sin(30 degrees)
  CHECK_THAT(lua.GetNumber("q.w"), WithinAbs(std::sqrt(3.0) / 2.0, kRounding));
  CHECK_THAT(lua.GetNumber("q.y"), WithinAbs(0.5, kRounding));
  CHECK(lua.GetNumber("q.x") == 0.0);
  CHECK(lua.GetNumber("q.z") == 0.0);
}

TEST_CASE("lua types: wrong arguments of a constructor are errors that list the accepted ones",
          "[lua][types]") {
  CLuaTester lua;
  CHECK(lua.GetError("vector2(1)") ==
        "test:1: vector2 takes nothing, a vector2, or the numbers x, y, got number");
  CHECK_THAT(lua.GetError("vector2(1, 2, 3)"), Contains("got number, number, number"));
  CHECK_THAT(lua.GetError("vector2('1', '2')"), Contains("got string, string"));
  CHECK_THAT(lua.GetError("vector2(vector3())"), Contains("got vector3"));
  CHECK_THAT(lua.GetError("vector3(1, 2)"), Contains("the numbers x, y, z, got number, number"));
  CHECK_THAT(lua.GetError("vector3({1, 2, 3})"), Contains("got table"));
  CHECK_THAT(lua.GetError("vector3(nil)"), Contains("got nil"));
  CHECK_THAT(lua.GetError("quaternion(1, 2, 3)"), Contains("quaternion takes nothing"));
  CHECK_THAT(lua.GetError("quaternion(1, vector2())"), Contains("got number, vector2"));
  CHECK_THAT(lua.GetError("quaternion(1, vector3())"),
             Contains("axis must not be the zero vector"));
  CHECK_THAT(lua.GetError("quaternion(1, vector3(0, 1e308, 1e308))"), Contains("nor infinite"));
  CHECK_THAT(lua.GetError("quaternion(vector3(), vector3(0, 0, 1))"),
             Contains("got vector3, vector3"));
}

TEST_CASE("lua types: components can be read and written by name", "[lua][types]") {
  CLuaTester lua;
  lua.Do("a = vector3(1, 2, 3); a.x = 4; a.y = -5; a.z = 0.5");
  CHECK(lua.Get("a") == "4,-5,0.5");
  lua.Do("q = quaternion(); q.w = 1; q.x = 2; q.y = 3; q.z = 4");
  CHECK(lua.Get("q.w + 10 * q.x + 100 * q.y + 1000 * q.z") == "4321.0");
  CHECK(lua.Get("math.type(vector2(1, 2).x)") == "float");

  CHECK(lua.GetError("local _ = vector2().z") ==
        "test:1: a vector2 has no component 'z', only those of \"xy\"");
  CHECK_THAT(lua.GetError("vector3().w = 1"), Contains("a vector3 has no component 'w'"));
  CHECK_THAT(lua.GetError("vector3().x = '1'"),
             Contains("component 'x' of a vector3 must be a number, got string"));
  CHECK_THAT(lua.GetError("quaternion().angle = 1"), Contains("only the components of \"wxyz\""));
  CHECK(lua.Get("vector3().nothing_like_that") == "nil");
  CHECK(lua.Get("vector3()[1]") == "nil");
}

TEST_CASE("lua types: tostring has six significant digits, and degrees for a quaternion",
          "[lua][types]") {
  CLuaTester lua;
  CHECK(lua.Get("vector2(1/3, 1e10)") == "0.333333,1e+10");
  CHECK(lua.Get("vector3(1234567, 0, -2)") == "1.23457e+06,0,-2");
  // a quarter turn about z
  CHECK_THAT(lua.Get("quaternion(math.pi / 2, vector3(0, 0, 1))"), Catch::StartsWith("90,"));
  CHECK(lua.Get("quaternion()") == "0,0,0");
}

TEST_CASE("lua types: vectors add, subtract, negate and scale to new objects", "[lua][types]") {
  CLuaTester lua;
  lua.Do("a, b = vector2(1, 2), vector2(10, 20)");
  CHECK(lua.Get("a + b") == "11,22");
  CHECK(lua.Get("b - a") == "9,18");
  CHECK(lua.Get("-a") == "-1,-2");
  CHECK(lua.Get("a * 3") == "3,6");
  CHECK(lua.Get("3 * a") == "3,6");
  lua.Do("c, d = vector3(1, 2, 3), vector3(10, 20, 30)");
  CHECK(lua.Get("c + d") == "11,22,33");
  CHECK(lua.Get("d - c") == "9,18,27");
  CHECK(lua.Get("-c") == "-1,-2,-3");
  CHECK(lua.Get("c * -0.5") == "-0.5,-1,-1.5");
  CHECK(lua.Get("-0.5 * c") == "-0.5,-1,-1.5");
  // the operands are unchanged
  CHECK(lua.Get("a") == "1,2");
  CHECK(lua.Get("c") == "1,2,3");
}

TEST_CASE("lua types: quaternions multiply by Hamilton's rules", "[lua][types]") {
  CLuaTester lua;
  lua.Do(
      "i, j, k = quaternion(0, 1, 0, 0), quaternion(0, 0, 1, 0), quaternion(0, 0, 0, 1)\n"
      "one = quaternion()");
  CHECK(lua.Get("i * j == k") == "true");
  CHECK(lua.Get("j * k == i") == "true");
  CHECK(lua.Get("k * i == j") == "true");
  CHECK(lua.Get("j * i == quaternion(0, 0, 0, -1)") == "true");
  CHECK(lua.Get("i * i == quaternion(-1, 0, 0, 0)") == "true");
  CHECK(lua.Get("one * k == k") == "true");
}

TEST_CASE("lua types: == compares components exactly", "[lua][types]") {
  CLuaTester lua;
  CHECK(lua.Get("vector2(1, 2) == vector2(1, 2)") == "true");
  CHECK(lua.Get("vector2(1, 2) == vector2(1, 2 + 1e-15)") == "false");
  CHECK(lua.Get("vector3(1, 2, 3) == vector3(1, 2, 3)") == "true");
  CHECK(lua.Get("vector3(1, 2, 3) ~= vector3(1, 2, 4)") == "true");
  CHECK(lua.Get("quaternion() == quaternion(1, 0, 0, 0)") == "true");
  CHECK(lua.Get("quaternion() == quaternion(-1, 0, 0, 0)") == "false");
  CHECK(lua.Get("vector2() == vector3()") == "false");
  CHECK(lua.Get("vector2() == 0") == "false");
}

TEST_CASE("lua types: operators that do not exist are errors", "[lua][types]") {
  CLuaTester lua;
  const std::string wrong =
      GENERATE("vector2(1, 2) / 2", "vector2() < vector2()", "#vector2()", "vector2() + 1",
               "vector2() + vector3()", "vector2() * vector2()", "vector3() / 2",
               "vector3() <= vector3()", "#vector3()", "vector3() - vector2()",
               "vector3() * vector3()", "vector3() * '2'", "quaternion() + quaternion()",
               "quaternion() - quaternion()", "-quaternion()", "quaternion() * 2",
               "2 * quaternion()", "quaternion() * vector3()", "quaternion() / 2", "#quaternion()");
  CAPTURE(wrong);
  const std::string error = lua.GetError("local _ = " + wrong);
  CHECK_THAT(error, Contains("vector") || Contains("quaternion") || Contains("userdata"));
}

TEST_CASE("lua types: length and dot give numbers", "[lua][types]") {
  CLuaTester lua;
  CHECK(lua.GetNumber("vector2(3, -4):length()") == 5.0);
  CHECK(lua.GetNumber("vector3(2, 3, 6):length()") == 7.0);
  CHECK(lua.GetNumber("vector2(1, 2):dot(vector2(3, 4))") == 11.0);
  CHECK(lua.GetNumber("vector3(1, 2, 3):dot(vector3(4, 5, 6))") == 32.0);
}

TEST_CASE("lua types: normalize works in place and returns the object", "[lua][types]") {
  CLuaTester lua;
  lua.Do("v = vector2(3, 4); same = v:normalize()");
  CHECK(lua.Get("rawequal(v, same)") == "true");
  CHECK_THAT(lua.GetNumber("v.x"), WithinAbs(0.6, kRounding));
  CHECK_THAT(lua.GetNumber("v.y"), WithinAbs(0.8, kRounding));
  lua.Do("v = vector3(2, 3, 6); same = v:normalize()");
  CHECK(lua.Get("rawequal(v, same)") == "true");
  CHECK_THAT(lua.GetNumber("v.z"), WithinAbs(6.0 / 7.0, kRounding));
  lua.Do("q = quaternion(1, 1, 1, 1); same = q:normalize()");
  CHECK(lua.Get("rawequal(q, same)") == "true");
  CHECK_THAT(lua.GetNumber("q.w"), WithinAbs(0.5, kRounding));
  CHECK_THAT(lua.GetNumber("q.z"), WithinAbs(0.5, kRounding));

  const std::string zero = GENERATE("vector2()", "vector3()", "quaternion(0, 0, 0, 0)",
                                    "vector3(1e308, 1e308, 0)", "vector2(0, 0/0)");
  CHECK_THAT(lua.GetError("local _ = " + zero + ":normalize()"), Contains("has no direction"));
}

TEST_CASE("lua types: rotate works in place and returns the object", "[lua][types]") {
  CLuaTester lua;
  lua.Do("v = vector2(2, 0); same = v:rotate(math.pi / 2)");
  CHECK(lua.Get("rawequal(v, same)") == "true");
  CHECK_THAT(lua.GetNumber("v.x"), WithinAbs(0.0, kRounding));
  CHECK_THAT(lua.GetNumber("v.y"), WithinAbs(2.0, kRounding));
  lua.Do(
      "v = vector3(0, 2, 0)\n"
      "same = v:rotate(quaternion(math.pi / 2, vector3(1, 0, 0)))");
  CHECK(lua.Get("rawequal(v, same)") == "true");
  CHECK_THAT(lua.GetNumber("v.y"), WithinAbs(0.0, kRounding));
  CHECK_THAT(lua.GetNumber("v.z"), WithinAbs(2.0, kRounding));
}

TEST_CASE("lua types: cross of vector2 gives a number, of vector3 works in place", "[lua][types]") {
  CLuaTester lua;
  lua.Do("v = vector2(1, 2)");
  CHECK(lua.GetNumber("v:cross(vector2(3, 5))") == -1.0);
  CHECK(lua.Get("v") == "1,2");
  lua.Do("v = vector3(1, 0, 0); same = v:cross(vector3(0, 1, 0))");
  CHECK(lua.Get("rawequal(v, same)") == "true");
  CHECK(lua.Get("v") == "0,0,1");
}

TEST_CASE("lua types: a quaternion has an inverse, angle and axis, and Euler angles",
          "[lua][types]") {
  CLuaTester lua;
  lua.Do("q = quaternion(1, 2, 3, 4); r = q:inverse()");
  CHECK(lua.Get("r == quaternion(1, -2, -3, -4)") == "true");
  CHECK(lua.Get("q == quaternion(1, 2, 3, 4)") == "true");

  lua.Do("angle, axis = quaternion(1.25, vector3(0, 0, 2)):toangleaxis()");
  CHECK_THAT(lua.GetNumber("angle"), WithinAbs(1.25, kRounding));
  CHECK(lua.Get("axis") == "0,0,1");
  lua.Do("angle, axis = quaternion():toangleaxis()");
  CHECK(lua.GetNumber("angle") == 0.0);
  CHECK(lua.Get("axis") == "0,0,1");

  // q = q_x(0.3) q_y(0.2) q_z(0.1), as in an experiment file
  lua.Do(
      "q = quaternion(0.3, vector3(1, 0, 0)) * quaternion(0.2, vector3(0, 1, 0)) *\n"
      "    quaternion(0.1, vector3(0, 0, 1))\n"
      "z, y, x = q:toeulerangles()");
  CHECK_THAT(lua.GetNumber("z"), WithinAbs(0.1, kRounding));
  CHECK_THAT(lua.GetNumber("y"), WithinAbs(0.2, kRounding));
  CHECK_THAT(lua.GetNumber("x"), WithinAbs(0.3, kRounding));
  // near y = 90 degrees x is reported as 0
  lua.Do(
      "z, y, x = (quaternion(0.3, vector3(1, 0, 0)) *\n"
      "           quaternion(math.pi / 2, vector3(0, 1, 0))):toeulerangles()");
  CHECK(lua.GetNumber("x") == 0.0);
  CHECK_THAT(lua.GetNumber("y"), WithinAbs(CRadians::PI_OVER_TWO.GetValue(), kRounding));
}

TEST_CASE("lua types: errors on wrong arguments of methods can be caught by pcall",
          "[lua][types]") {
  CLuaTester lua;
  CHECK(lua.GetError("vector2():dot(1)") ==
        "test:1: vector2:dot: argument 1 must be a vector2, got number");
  CHECK_THAT(lua.GetError("vector3():dot(vector2())"),
             Contains("vector3:dot: argument 1 must be a vector3, got vector2"));
  CHECK_THAT(lua.GetError("vector2():rotate()"),
             Contains("vector2:rotate: argument 1 must be a number, got nothing"));
  CHECK_THAT(lua.GetError("vector3():rotate(1)"), Contains("must be a quaternion, got number"));
  CHECK_THAT(lua.GetError("vector2():length(1)"), Contains("takes 0 arguments, got 1"));
  CHECK_THAT(lua.GetError("vector2().length()"),
             Contains("vector2:length must be called on a vector2 with a colon, got nothing"));
  CHECK_THAT(lua.GetError("vector2().length(vector3())"), Contains("got vector3"));
  lua.Do("ok, message = pcall(function() return vector3():cross(nil) end)");
  CHECK(lua.Get("ok") == "false");
  CHECK_THAT(lua.Get("message"), Contains("vector3:cross: argument 1 must be a vector3, got nil"));
}

TEST_CASE("lua types: userdata of another library is not accepted as a vector", "[lua][types]") {
  CLuaTester lua;
  CHECK_THAT(lua.GetError("vector2(io.stdout)"), Contains("got userdata"));
  lua.Run([](lua_State* state) {
    lua_pushlightuserdata(state, state);
    CHECK(CLuaType<CVector2>::Test(state, -1) == nullptr);
    CLuaType<CVector3>::Push(state, CVector3(1.0, 2.0, 3.0));
    CHECK(CLuaType<CVector2>::Test(state, -1) == nullptr);
    REQUIRE(CLuaType<CVector3>::Test(state, -1) != nullptr);
    CHECK(CLuaType<CVector3>::Test(state, -1)->GetZ() == 3.0);
  });
}

// the classes that users' C++ code for ARGoS 3 uses
TEST_CASE("lua types: C functions of users read and push values", "[lua][types]") {
  CLuaTester lua;
  lua_State* const state = lua.Get();
  CLuaVector2::RegisterType(state);
  CLuaVector3::PushVector3(state, 1.0, 2.0, 3.0);
  CHECK(luaL_checkudata(state, -1, CLuaVector3::GetTypeId().c_str()) != nullptr);
  CHECK(CLuaVector3::GetTypeId() == "argos3.vector3");
  CLuaVector3::ToVector3(state, -1).SetX(9.0);
  lua_setglobal(state, "pushed");
  CHECK(lua.Get("pushed") == "9,2,3");
  CLuaQuaternion::PushQuaternion(state, CRadians::PI, CVector3::Z);
  CHECK_THAT(CLuaQuaternion::ToQuaternion(state, -1).GetZ(), WithinAbs(1.0, kRounding));
  lua_pop(state, 1);

  lua_register(state, "mirror", [](lua_State* inner) {
    const CVector2& vector = CLuaVector2::ToVector2(inner, 1);
    CLuaVector2::PushVector2(inner, vector.GetY(), vector.GetX());
    return 1;
  });
  CHECK(lua.Get("mirror(vector2(1, 2))") == "2,1");
  CHECK_THAT(lua.GetError("mirror(7)"), Contains("expected a vector2, got number"));
  // metamethods and methods have the form of C functions
  lua_register(state, "sum", &CLuaVector2::Add);
  lua_register(state, "length", &CLuaVector3::Length);
  lua_register(state, "text", &CLuaVector2::ToString);
  lua_register(state, "component", &CLuaVector2::Index);
  lua_register(state, "make", &CLuaVector2::Create);
  lua_register(state, "inverse", &CLuaQuaternion::Inverse);
  CHECK(lua.Get("sum(vector2(1, 2), vector2(3, 4))") == "4,6");
  CHECK(lua.Get("length(vector3(2, 3, 6))") == "7.0");
  CHECK(lua.Get("text(make(5, 6))") == "5,6");
  CHECK(lua.Get("component(vector2(5, 6), 'y')") == "6.0");
  CHECK(lua.Get("inverse(quaternion(1, 2, 3, 4)).x") == "-2.0");
}

}  // namespace lua_types_test
