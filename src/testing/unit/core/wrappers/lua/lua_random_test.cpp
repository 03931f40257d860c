#include "lua_tester.h"

#include <argos3/core/wrappers/lua/lua_random.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace lua_random_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

// Draws of each distribution. Statistics lie within 5 standard errors of their estimates in all but
// one of 1.7 million samples, and the seed is fixed.
constexpr int kDraws = 20000;
constexpr Real kErrors = 5.0;

class CRandomTester : public CLuaTester {
 public:
  explicit CRandomTester(UInt32 seed = 1) : m_random(seed) {
    Run([this](lua_State* state) {
      lua_newtable(state);
      CLuaUtility::StartTable(state, "random");
      m_random.Register(state);
      CLuaUtility::EndTable(state);
      lua_setglobal(state, "robot");
    });
    Do("r = robot.random\n"
       "function sample(draw, n)\n"
       "  sum, squares, min, max = 0, 0, math.huge, -math.huge\n"
       "  for i = 1, n do\n"
       "    local x = draw()\n"
       "    if type(x) == 'boolean' then x = x and 1 or 0 end\n"
       "    sum, squares = sum + x, squares + x * x\n"
       "    min, max = math.min(min, x), math.max(max, x)\n"
       "  end\n"
       "end");
  }

  void Sample(const std::string& draw) {
    Do("sample(function() return r." + draw + " end, " + std::to_string(kDraws) + ")");
  }
  Real GetMean() { return GetNumber("sum") / kDraws; }
  Real GetVariance() { return GetNumber("squares") / kDraws - GetMean() * GetMean(); }

  CLuaRandom m_random;
};

}  // namespace

TEST_CASE("lua random: bernoulli draws with the given probability", "[lua][random]") {
  CRandomTester lua;
  CHECK(lua.Get("type(r.bernoulli())") == "boolean");
  const auto [call, p] = GENERATE(table<std::string, Real>({{"bernoulli()", 0.5},
                                                            {"bernoulli(0.2)", 0.2},
                                                            {"bernoulli(0)", 0.0},
                                                            {"bernoulli(1)", 1.0}}));
  CAPTURE(call);
  lua.Sample(call);
  CHECK_THAT(lua.GetMean(), WithinAbs(p, kErrors * std::sqrt(p * (1.0 - p) / kDraws)));
}

TEST_CASE("lua random: uniform draws have the moments and bounds of the range", "[lua][random]") {
  CRandomTester lua;
  const auto [call, min, max] = GENERATE(table<std::string, Real, Real>(
      {{"uniform()", 0.0, 1.0}, {"uniform(4)", 0.0, 4.0}, {"uniform(-3, 5)", -3.0, 5.0}}));
  CAPTURE(call);
  lua.Sample(call);
  CHECK(lua.GetNumber("min") >= min);
  CHECK(lua.GetNumber("max") <= max);
  // draws approach the bounds: 20,000 of them miss the outer 0.1 % with a probability of 2e-9
  CHECK(lua.GetNumber("min") < min + 0.001 * (max - min));
  CHECK(lua.GetNumber("max") > max - 0.001 * (max - min));
  const Real deviation = (max - min) / std::sqrt(12.0);
  CHECK_THAT(lua.GetMean(),
             WithinAbs((min + max) / 2.0, kErrors * deviation / std::sqrt(Real(kDraws))));
}

TEST_CASE("lua random: uniform_int excludes the upper bound, also below zero", "[lua][random]") {
  CRandomTester lua;
  const auto [call, min, max] =
      GENERATE(table<std::string, Real, Real>({{"uniform_int(6)", 0.0, 5.0},
                                               {"uniform_int(1, 6)", 1.0, 5.0},
                                               {"uniform_int(-3, 3)", -3.0, 2.0}}));
  CAPTURE(call);
  lua.Sample(call);
  CHECK(lua.GetNumber("min") == min);
  CHECK(lua.GetNumber("max") == max);
  // all numbers are equally likely: the variance of a discrete uniform
  // distribution is (n^2 - 1) / 12
  const Real count = max - min + 1.0;
  const Real deviation = std::sqrt((count * count - 1.0) / 12.0);
  CHECK_THAT(lua.GetMean(),
             WithinAbs((min + max) / 2.0, kErrors * deviation / std::sqrt(Real(kDraws))));
  CHECK(lua.Get("math.type(r.uniform_int(3))") == "float");
  CHECK(lua.GetNumber("r.uniform_int(4, 4)") == 4.0);
}

TEST_CASE("lua random: exponential and poisson have their mean", "[lua][random]") {
  CRandomTester lua;
  lua.Sample("exponential(2)");
  CHECK(lua.GetNumber("min") >= 0.0);
  CHECK_THAT(lua.GetMean(), WithinAbs(2.0, kErrors * 2.0 / std::sqrt(Real(kDraws))));
  lua.Sample("poisson(3)");
  CHECK(lua.GetNumber("min") == 0.0);
  CHECK_THAT(lua.GetMean(), WithinAbs(3.0, kErrors * std::sqrt(3.0 / kDraws)));
  CHECK(lua.Get("math.type(r.poisson(3))") == "integer");
}

TEST_CASE("lua random: gaussian has the deviation as its first argument", "[lua][random]") {
  CRandomTester lua;
  const auto [call, mean] =
      GENERATE(table<std::string, Real>({{"gaussian(2)", 0.0}, {"gaussian(2, 10)", 10.0}}));
  CAPTURE(call);
  lua.Sample(call);
  CHECK_THAT(lua.GetMean(), WithinAbs(mean, kErrors * 2.0 / std::sqrt(Real(kDraws))));
  // the standard error of a variance is sigma^2 sqrt(2 / n)
  CHECK_THAT(lua.GetVariance(), WithinAbs(4.0, kErrors * 4.0 * std::sqrt(2.0 / kDraws)));
}

TEST_CASE("lua random: equal seeds give equal numbers", "[lua][random]") {
  const auto draw = [](CRandomTester& lua) {
    return lua.Get("r.uniform() .. ' ' .. r.gaussian(1) .. ' ' .. r.poisson(5)");
  };
  CRandomTester a(7);
  CRandomTester b(7);
  CRandomTester c(8);
  const std::string first = draw(a);
  CHECK(draw(b) == first);
  CHECK(draw(c) != first);
  CHECK(draw(a) != first);
  a.m_random.Seed(7);
  CHECK(draw(a) == first);
  c.m_random.Seed(7);
  CHECK(draw(c) == first);
}

TEST_CASE("lua random: wrong arguments are errors", "[lua][random]") {
  CRandomTester lua;
  CHECK(lua.GetError("r.uniform('a')") ==
        "test:1: robot.random.uniform: argument 1 must be a number, got string \"a\"");
  CHECK_THAT(lua.GetError("r.uniform(2, 1)"), Contains("the minimum, 2, is above the maximum, 1"));
  CHECK_THAT(lua.GetError("r.uniform(1, 2, 3)"), Contains("too many arguments"));
  CHECK_THAT(lua.GetError("r.uniform_int()"), Contains("argument 1 must be a whole number"));
  CHECK_THAT(lua.GetError("r.uniform_int(1.5)"), Contains("got 1.5"));
  CHECK_THAT(lua.GetError("r.uniform_int(3, 2)"), Contains("above the maximum"));
  CHECK_THAT(lua.GetError("r.bernoulli(1.5)"),
             Contains("argument 1, a probability, must be in [0,1], got 1.5"));
  CHECK_THAT(lua.GetError("r.exponential()"), Contains("argument 1 must be a number, got nothing"));
  CHECK_THAT(lua.GetError("r.poisson(-1)"), Contains("robot.random.poisson") && Contains("-1"));
  CHECK_THAT(lua.GetError("r.gaussian()"), Contains("argument 1 must be a number"));
}

TEST_CASE("lua random: RegisterRNG draws from the given generator", "[lua][random]") {
  CRandom::CRNG generator(5);
  CRandom::CRNG same(5);
  CLuaTester lua;
  lua.Run([&generator](lua_State* state) {
    lua_newtable(state);
    CLuaUtility::RegisterRNG(state, &generator);
    CHECK(lua_gettop(state) == 1);
    lua_setglobal(state, "robot");
  });
  CHECK(lua.GetNumber("robot.random.uniform()") == same.Uniform(CRange<Real>(0.0, 1.0)));
  CHECK(lua.GetNumber("robot.random.gaussian(2, 3)") == same.Gaussian(2.0, 3.0));
}

TEST_CASE("lua random: parameters that no distribution has are errors", "[lua][random]") {
  CRandomTester lua;
  const auto [call, message] = GENERATE(table<std::string, std::string>(
      {{"uniform(0/0)", "the maximum must be a finite number"},
       {"uniform(-math.huge, 1)", "the minimum must be a finite number, got -inf"},
       {"uniform(-1e308, 1e308)", "the distance from the minimum to the maximum must be"},
       {"uniform_int(math.huge)", "argument 1 must be a whole number"},
       {"uniform_int()", "argument 1 must be a whole number"},
       {"bernoulli(0/0)", "argument 1, a probability, must be in [0,1]"},
       {"exponential(-1)", "argument 1, the mean, must be a finite number, 0 or more, got -1"},
       {"exponential(math.huge)", "argument 1, the mean, must be a finite number"},
       {"poisson(-1)", "The mean of a Poisson distribution is -1"},
       {"poisson(1e300)", "The mean of a Poisson distribution is 1e+300"},
       {"gaussian(-1)", "argument 1, the standard deviation, must be a finite number, 0 or more"},
       {"gaussian(1, 0/0)", "argument 2, the mean, must be a finite number"},
       {"gaussian()", "argument 1 must be a number, got nothing"},
       {"gaussian(1, 2, 3)", "too many arguments"}}));
  CAPTURE(call);
  const std::string name = "robot.random." + call.substr(0, call.find('('));
  CHECK_THAT(lua.GetError("r." + call), Contains("test:1: " + name + ": ") && Contains(message));
}

}  // namespace lua_random_test
