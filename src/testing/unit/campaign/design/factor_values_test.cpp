#include <argos3/campaign/design/expression.h>
#include <argos3/campaign/design/factor_values.h>
#include <argos3/campaign/design/latin_hypercube.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/testing/unit/campaign/campaign_files.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace factor_values_test {

using namespace argos;
using Catch::Matchers::Contains;
typedef std::vector<std::string> TTexts;

TEST_CASE("factor values: lists, with ranges of numbers", "[campaign][design]") {
  CHECK(SplitValues("5, 10 ,20") == TTexts{"5", "10", "20"});
  CHECK(SplitValues("1:4") == TTexts{"1", "2", "3", "4"});
  CHECK(SplitValues("0:0.5:0.1") == TTexts{"0", "0.1", "0.2", "0.3", "0.4", "0.5"});
  CHECK(SplitValues("10:1:-4, x") == TTexts{"10", "6", "2", "x"});
  CHECK(SplitValues("1:4:2") == TTexts{"1", "3"});
  CHECK(SplitValues("a:b, c:1") == TTexts{"a:b", "c:1"});
  CHECK(SplitValues("0,0,1; 1,0,1") == TTexts{"0,0,1", "1,0,1"});
  CHECK(SplitValues("{math.max(1,2)}, {'a;b'}") == TTexts{"{math.max(1,2)}", "{'a;b'}"});
  CHECK(SplitValues("{({5, 6})[1]}, 7") == TTexts{"{({5, 6})[1]}", "7"});
  CHECK(SplitValues("{\"},'\"}, {'},\"'}") == TTexts{"{\"},'\"}", "{'},\"'}"});
  CHECK(SplitValues("{'\\'},'}, {\"\\\"},\"}") == TTexts{"{'\\'},'}", "{\"\\\"},\"}"});
  // a doubled brace is a character
  CHECK(SplitValues("{{1, 2") == TTexts{"{{1", "2"});
}

TEST_CASE("factor values: wrong lists are errors", "[campaign][design]") {
  CHECK_THAT(CatchText([] { SplitValues("1,,2"); }), Contains("a value is empty"));
  CHECK_THAT(CatchText([] { SplitValues("1:5:-1"); }),
             Contains("\"1:5:-1\": steps of -1 do not lead from 1 to 5"));
  CHECK_THAT(CatchText([] { SplitValues("1:5:0"); }), Contains("steps of 0"));
  CHECK_THAT(CatchText([] { SplitValues("0:1:1e-9"); }), Contains("more than 100000 numbers"));
  CHECK_THAT(CatchText([] { SplitValues("{1"); }), Contains("'{' without '}'"));
}

TEST_CASE("factor values: linear and logarithmic steps", "[campaign][design]") {
  SFactorRange range{0.1, 0.5, false, false};
  CHECK(ComputeSteps(range, 5) == TTexts{"0.1", "0.2", "0.3", "0.4", "0.5"});
  range = {1.0, 1000.0, true, false};
  CHECK(ComputeSteps(range, 4) == TTexts{"1", "10", "100", "1000"});
  range = {1.0, 3.0, false, true};
  CHECK(ComputeSteps(range, 6) == TTexts{"1", "2", "3"});
}

TEST_CASE("factor values: random values are in the range and depend on the seed",
          "[campaign][design]") {
  const SFactorRange range{1.0, 100.0, true, false};
  const auto draw = [&range](UInt64 seed) {
    CRandomStream random(seed, "test", "factor", "values");
    return DrawValues(range, 4000, random);
  };
  const TTexts values = draw(1);
  CHECK(values == draw(1));
  CHECK(values != draw(2));
  size_t below = 0;
  for (const std::string& text : values) {
    const Real value = std::stod(text);
    REQUIRE(value >= 1.0);
    REQUIRE(value <= 100.0);
    below += value < 10.0 ? 1 : 0;
  }
  // half of the values below the geometric mean, within 5 standard deviations, sqrt(4000)/2 = 32
  CHECK(below > 2000 - 160);
  CHECK(below < 2000 + 160);
}

TEST_CASE("factor values: whole numbers stay within bounds that are not whole",
          "[campaign][design]") {
  SFactorRange range{1.5, 3.5, false, true};
  CHECK(ComputeSteps(range, 3) == TTexts{"2", "3"});
  range = {-0.4, 2.6, false, true};
  CHECK(ComputeSteps(range, 4) == TTexts{"0", "1", "2"});
}

TEST_CASE("factor values: seeds", "[campaign][design]") {
  CHECK(ParseSeeds("3, 5, 8:10") == std::vector<UInt32>{3, 5, 8, 9, 10});
  CHECK_THAT(CatchText([] { ParseSeeds("3, x"); }), Contains("\"x\" is not a seed"));
  CHECK_THAT(CatchText([] { ParseSeeds("0, 1"); }), Contains("\"0\" is not a seed"));
  CHECK_THAT(CatchText([] { ParseSeeds("3, 1:5"); }), Contains("the seed 3 is given twice"));
}

TEST_CASE("latin hypercube: each stratum has one place", "[campaign][design]") {
  const UInt32 samples = GENERATE(1, 2, 7, 100);
  CAPTURE(samples);
  CRandomStream random(3, "test", "factor", "strata");
  const std::vector<Real> places = DrawPlacesInStrata(samples, random);
  REQUIRE(places.size() == samples);
  for (UInt32 i = 0; i < samples; ++i) {
    CHECK(places[i] >= static_cast<Real>(i) / samples);
    CHECK(places[i] < static_cast<Real>(i + 1) / samples);
  }
}

TEST_CASE("latin hypercube: permutations are complete, levels balanced", "[campaign][design]") {
  CRandomStream random(3, "test", "factor", "levels");
  const std::vector<UInt32> permutation = DrawPermutation(50, random);
  CHECK(std::set<UInt32>(permutation.begin(), permutation.end()).size() == 50);
  CHECK(*std::max_element(permutation.begin(), permutation.end()) == 49);
  CHECK_FALSE(std::is_sorted(permutation.begin(), permutation.end()));
  std::map<UInt32, int> counts;
  for (const UInt32 level : DrawBalancedLevels(20, 3, random)) {
    ++counts[level];
  }
  REQUIRE(counts.size() == 3);
  for (const auto& [level, count] : counts) {
    CHECK(level < 3);
    CHECK((count == 6 || count == 7));
  }
}

TEST_CASE("expressions: numbers, texts and math", "[campaign][design]") {
  CExpressions expressions;
  expressions.SetNames({{"robots", "20"}, {"density", "0.5"}, {"mode", "fast"}});
  CHECK(expressions.Evaluate("robots / 2") == "10");
  CHECK(expressions.Evaluate("40 / density") == "80");
  CHECK(expressions.Evaluate("0.1 * 3") == "0.3");
  // above 2^53 not all whole numbers have a double
  CHECK(expressions.Evaluate("2.0 ^ 53 - 1") == "9007199254740991");
  CHECK(expressions.Evaluate("-(2.0 ^ 53)") == "-9.00719925474099e+15");
  CHECK(expressions.Evaluate("math.floor(robots / 3)") == "6");
  CHECK(expressions.Evaluate("mode .. '!'") == "fast!");
  CHECK(expressions.Evaluate("robots > 10 and mode == 'fast'") == "true");
  CHECK(expressions.IsTrue("robots == 20 and density < 1"));
  CHECK_FALSE(expressions.IsTrue("mode ~= 'fast'"));
  CHECK(expressions.Expand("{robots}, {('x'):rep(3)}, {{1}}") == "20, xxx, {1}");
  CHECK(expressions.Expand("{'}'}") == "}");
}

TEST_CASE("expressions: of what is missing no comparison is true", "[campaign][design]") {
  CExpressions expressions;
  expressions.AddNumber("load", 0.25);
  expressions.AddNumber("missing", std::numeric_limits<Real>::quiet_NaN());
  CHECK(expressions.IsTrue("load > 0.2 and load < 0.3"));
  CHECK_FALSE(expressions.IsTrue("missing > 0.2 or missing <= 0.2"));
  CHECK_THAT(CatchText([&] { expressions.IsTrue("loads > 1"); }),
             Contains("did you mean \"load\"?"));
  expressions.SetNames({});
  CHECK_THAT(CatchText([&] { expressions.IsTrue("load > 1"); }), Contains("\"load\" is not known"));
}

TEST_CASE("expressions: errors name expression and reason", "[campaign][design]") {
  CExpressions expressions;
  expressions.SetNames({{"robots", "20"}, {"mode", "fast"}});
  const auto evaluate = [&](const std::string& text) {
    return CatchText([&] { expressions.Evaluate(text); });
  };
  CHECK_THAT(evaluate("robot + 1"), Contains("the expression \"robot + 1\": \"robot\" is not known "
                                             "here; did you mean \"robots\"?"));
  // without the place in the code, which is always the first line
  CHECK_THAT(evaluate("robots +"),
             Contains("the expression \"robots +\": unexpected symbol near <eof>"));
  CHECK_THAT(evaluate("mode + 1"),
             Contains("the expression \"mode + 1\": attempt to add a 'string' with a 'number'"));
  CHECK_THAT(evaluate(""), Contains("found a value of the type nil"));
  CHECK_THAT(evaluate("math"), Contains("found a value of the type table"));
  CHECK_THAT(evaluate("robots, 2"), Contains("has 2 values"));
  CHECK_THAT(evaluate("1 / 0"), Contains("is not finite"));
  CHECK_THAT(CatchText([&] { expressions.IsTrue("robots"); }),
             Contains("expected a condition") && Contains("number"));
  CHECK_THAT(CatchText([&] { expressions.Expand("{robots"); }), Contains("'{' without '}'"));
  CHECK_THAT(CatchText([&] { expressions.Expand("robots}"); }), Contains("'}' without '{'"));
}

TEST_CASE("expressions: what they may do is limited", "[campaign][design]") {
  CExpressions expressions;
  const auto evaluate = [&](const std::string& text) {
    return CatchText([&] { expressions.Evaluate(text); });
  };
  CHECK_THAT(evaluate("os.time()"), Contains("\"os\" is not known"));
  CHECK_THAT(evaluate("io"), Contains("\"io\" is not known"));
  CHECK_THAT(evaluate("math.random()"), Contains("random"));
  CHECK_THAT(evaluate("(function() while true do end end)()"), Contains("instructions"));
  CHECK_THAT(evaluate("#('x'):rep(1000000000)"), Contains("the expression"));
  // an expression cannot change what later ones see
  CHECK(expressions.Evaluate("(function() math.pi = 3 return 1 end)()") == "1");
  CHECK(expressions.IsTrue("math.pi > 3.14"));
}

}  // namespace factor_values_test
