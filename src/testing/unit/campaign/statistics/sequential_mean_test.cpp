#include "hostile_values.h"
#include "samples.h"

#include <argos3/campaign/statistics/mean_interval.h>
#include <argos3/campaign/statistics/proportion_interval.h>
#include <argos3/campaign/statistics/sequential_mean.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace sequential_mean_test {

using Catch::Contains;
using Catch::Matchers::WithinRel;
using namespace argos;

namespace {

SStoppingRule MakeRule(EMeanPrecision precision, Real halfWidth, size_t minCount = 10,
                       size_t maxPositions = 100000, Real level = 0.95) {
  return {precision, halfWidth, level, minCount, maxPositions};
}

struct SSimulation {
  SConfidenceInterval Coverage;  // of the share of intervals with the mean, at 0.999
  Real MeanCount;  // of values used
};

// repeats an estimate of a mean of a known distribution
SSimulation Simulate(const SStoppingRule& rule, Real trueMean, size_t repetitions,
                     const std::function<Real()>& draw) {
  size_t numCovered = 0;
  size_t numValues = 0;
  for (size_t i = 0; i < repetitions; ++i) {
    CSequentialMean mean(rule);
    for (size_t position = 0; mean.GetDecision() == EStopDecision::Continue; ++position) {
      mean.Insert(position, draw());
    }
    REQUIRE(mean.GetDecision() == EStopDecision::PrecisionReached);
    numCovered += std::abs(mean.GetMean() - trueMean) <= mean.GetTargetHalfWidth() ? 1 : 0;
    numValues += mean.GetCount();
  }
  return {ComputeProportionInterval(numCovered, repetitions, 0.999),
          static_cast<Real>(numValues) / static_cast<Real>(repetitions)};
}

}  // namespace

TEST_CASE("sequential mean: covers the mean of normal values, with the asymptotic number of them",
          "[campaign][statistics]") {
  CRandomStream stream(1, "test", "sequential", "normal");
  const SSimulation result = Simulate(MakeRule(EMeanPrecision::Absolute, 0.2), 5.0, 4000,
                                      [&] { return stream.Gaussian(1.0, 5.0); });
  CAPTURE(result.Coverage.Lower, result.Coverage.Upper, result.MeanCount);
  // nominal 0.95, of which Starr (1966) lets a percent be lost at this size; shown with
  // confidence 0.999
  CHECK(result.Coverage.Lower > 0.92);
  CHECK(result.Coverage.Upper < 0.97);
  // Chow and Robbins: (z s / d)^2 = 96.04
  CHECK_THAT(result.MeanCount, WithinRel(96.04, 0.03));
}

TEST_CASE("sequential mean: covers the mean of skewed values with relative precision",
          "[campaign][statistics]") {
  // exponential: variation 1, so (z (1 + g) / g)^2 = 1.645^2 11^2 = 327 values
  CRandomStream stream(2, "test", "sequential", "exponential");
  const SSimulation result =
      Simulate(MakeRule(EMeanPrecision::Relative, 0.1, 10, 100000, 0.9), 3.0, 1500,
               [&] { return -3.0 * std::log(1.0 - stream.Uniform01()); });
  CAPTURE(result.Coverage.Lower, result.Coverage.Upper, result.MeanCount);
  CHECK(result.Coverage.Lower > 0.85);
  CHECK(result.Coverage.Upper < 0.94);
  CHECK_THAT(result.MeanCount, WithinRel(327.0, 0.05));
}

TEST_CASE("sequential mean: stops at the first interval that is narrow enough",
          "[campaign][statistics]") {
  const std::vector<Real>& values = kOzone[2];
  CSequentialMean mean(MakeRule(EMeanPrecision::Absolute, 18.0, 5));
  size_t expected = 0;
  for (size_t n = 5; n <= values.size() && expected == 0; ++n) {
    const SConfidenceInterval interval = ComputeMeanInterval(std::span(values).first(n));
    expected = interval.Upper - interval.Lower <= 36.0 ? n : 0;
  }
  REQUIRE(expected > 5);
  for (size_t i = 0; i < values.size(); ++i) {
    CAPTURE(i);
    CHECK((mean.GetDecision() == EStopDecision::Continue) == (i < expected));
    mean.Insert(i, values[i]);
  }
  CHECK(mean.GetDecision() == EStopDecision::PrecisionReached);
  CHECK(mean.GetCount() == expected);
  CHECK(mean.GetNumPositions() == expected);
  const SConfidenceInterval interval = ComputeMeanInterval(std::span(values).first(expected));
  CHECK_THAT(mean.GetMean() - mean.GetHalfWidth(), WithinRel(interval.Lower, 1e-13));
  CHECK_THAT(mean.GetMean() + mean.GetHalfWidth(), WithinRel(interval.Upper, 1e-13));
  CHECK(mean.GetTargetHalfWidth() == 18.0);
  CHECK(mean.EstimateNumPositions() == expected);
}

TEST_CASE("sequential mean: the order in which values arrive does not matter",
          "[campaign][statistics]") {
  CRandomStream stream(3, "test", "sequential", "order");
  std::vector<Real> values;
  std::vector<size_t> order;
  for (size_t i = 0; i < 200; ++i) {
    values.push_back(i % 7 == 3 ? kNaN : stream.Gaussian(1.0, 2.0));
    order.push_back(i);
  }
  const SStoppingRule rule = MakeRule(EMeanPrecision::Relative, 0.15, 10, 200);
  CSequentialMean inOrder(rule);
  for (size_t i = 0; i < 200; ++i) {
    inOrder.Insert(i, values[i]);
  }
  REQUIRE(inOrder.GetDecision() == EStopDecision::PrecisionReached);
  REQUIRE(inOrder.GetNumMissing() > 0);
  REQUIRE(inOrder.GetNumPositions() < 150);
  for (int repetition = 0; repetition < 20; ++repetition) {
    for (size_t i = 0; i < order.size(); ++i) {
      std::swap(order[i], order[i + stream.UniformInteger(UInt64(order.size() - i))]);
    }
    CSequentialMean shuffled(rule);
    for (const size_t position : order) {
      shuffled.Insert(position, values[position]);
    }
    CHECK(shuffled.GetDecision() == EStopDecision::PrecisionReached);
    CHECK(shuffled.GetNumPositions() == inOrder.GetNumPositions());
    CHECK(shuffled.GetNumMissing() == inOrder.GetNumMissing());
    CHECK(shuffled.GetMean() == inOrder.GetMean());
    CHECK(shuffled.GetHalfWidth() == inOrder.GetHalfWidth());
  }
}

TEST_CASE("sequential mean: a gap holds the decision", "[campaign][statistics]") {
  CSequentialMean mean(MakeRule(EMeanPrecision::Absolute, 1.0, 2, 10));
  mean.Insert(1, 5.0);
  mean.Insert(2, 5.1);
  CHECK(mean.GetDecision() == EStopDecision::Continue);
  CHECK(mean.GetCount() == 0);
  CHECK(std::isnan(mean.GetMean()));
  CHECK(std::isnan(mean.GetStandardDeviation()));
  CHECK(mean.GetHalfWidth() == kInfinity);
  mean.Insert(0, 5.05);
  CHECK(mean.GetDecision() == EStopDecision::PrecisionReached);
  CHECK(mean.GetCount() == 2);
  CHECK_THAT(mean.GetMean(), WithinRel(5.025, 1e-15));
}

TEST_CASE("sequential mean: the cap ends what precision does not", "[campaign][statistics]") {
  CSequentialMean mean(MakeRule(EMeanPrecision::Absolute, 1e-6, 2, 4));
  for (size_t i = 0; i < 4; ++i) {
    CHECK(mean.GetDecision() == EStopDecision::Continue);
    CHECK(mean.EstimateNumPositions() >= i + 1);
    CHECK(mean.EstimateNumPositions() <= 4);
    mean.Insert(i, static_cast<Real>(i));
  }
  CHECK(mean.GetDecision() == EStopDecision::CapReached);
  CHECK(mean.GetCount() == 4);
  // 10 values need more positions than there may be, 12, because 5 failed
  CSequentialMean few(MakeRule(EMeanPrecision::Absolute, 1.0, 10, 12));
  for (size_t i = 0; i < 5; ++i) {
    few.Insert(i, kNaN);
  }
  CHECK(few.GetDecision() == EStopDecision::Continue);
  CHECK(few.EstimateNumPositions() == 12);
  // failed runs alone
  CSequentialMean failed(MakeRule(EMeanPrecision::Relative, 0.1, 2, 3));
  for (size_t i = 0; i < 3; ++i) {
    failed.Insert(i, kNaN);
  }
  CHECK(failed.GetDecision() == EStopDecision::CapReached);
  CHECK(failed.GetNumMissing() == 3);
  CHECK(std::isnan(failed.GetMean()));
  CHECK(std::isnan(failed.GetTargetHalfWidth()));
}

TEST_CASE("sequential mean: precision at the cap counts as reached", "[campaign][statistics]") {
  CSequentialMean mean(MakeRule(EMeanPrecision::Absolute, 1e-6, 3, 3));
  for (size_t i = 0; i < 3; ++i) {
    mean.Insert(i, 0.1);
  }
  CHECK(mean.GetDecision() == EStopDecision::PrecisionReached);
  CHECK(mean.GetHalfWidth() == 0.0);
}

TEST_CASE("sequential mean: relative precision of a mean of 0", "[campaign][statistics]") {
  CSequentialMean constant(MakeRule(EMeanPrecision::Relative, 0.1, 5, 50));
  CSequentialMean alternating(MakeRule(EMeanPrecision::Relative, 0.1, 5, 50));
  for (size_t i = 0; i < 50; ++i) {
    constant.Insert(i, 0.0);
    alternating.Insert(i, i % 2 == 0 ? 1.0 : -1.0);
  }
  CHECK(constant.GetDecision() == EStopDecision::PrecisionReached);
  CHECK(constant.GetCount() == 5);
  CHECK(alternating.GetDecision() == EStopDecision::CapReached);
}

TEST_CASE("sequential mean: the planned number approaches the final one",
          "[campaign][statistics]") {
  CRandomStream stream(4, "test", "sequential", "plan");
  CSequentialMean mean(MakeRule(EMeanPrecision::Absolute, 0.1));
  CHECK(mean.EstimateNumPositions() == 10);
  size_t planned = 0;
  for (size_t i = 0; mean.GetDecision() == EStopDecision::Continue; ++i) {
    mean.Insert(i, stream.Gaussian(1.0));
    planned = i == 199 ? mean.EstimateNumPositions() : planned;
  }
  // the variance of 200 values has a standard error of 10 %
  CHECK_THAT(static_cast<Real>(planned), WithinRel(static_cast<Real>(mean.GetCount()), 0.3));
}

TEST_CASE("sequential mean: the planned number is that of the present deviation",
          "[campaign][statistics]") {
  // 0 and 2: the half width is t(1) sqrt(2) / sqrt(2) = tan(0.95 pi / 2) = 12.7062, and halves with
  // four times the values
  const Real halfWidth = std::tan(0.95 * std::acos(-1.0) / 2.0);
  const auto plan = [](const SStoppingRule& rule, const std::vector<Real>& values) {
    CSequentialMean mean(rule);
    for (size_t i = 0; i < values.size(); ++i) {
      mean.Insert(i, values[i]);
    }
    REQUIRE(mean.GetDecision() == EStopDecision::Continue);
    return mean.EstimateNumPositions();
  };
  const SStoppingRule rule = MakeRule(EMeanPrecision::Absolute, 1.0, 2, 1000);
  CHECK(plan(rule, {0.0, 2.0}) ==
        static_cast<size_t>(std::ceil(2.0 * halfWidth * halfWidth)));  // 323
  // runs go on failing at the same rate
  CHECK(plan(rule, {0.0, kNaN, 2.0}) ==
        static_cast<size_t>(std::ceil(3.0 * halfWidth * halfWidth)));  // 485
  // never beyond the cap; without a deviation, the least number, and as many as are missing
  CHECK(plan(MakeRule(EMeanPrecision::Absolute, 1.0, 2, 100), {0.0, 2.0}) == 100);
  CHECK(plan(MakeRule(EMeanPrecision::Absolute, 1.0, 5, 100), {0.0, 2.0}) == 5);
  CHECK(plan(MakeRule(EMeanPrecision::Absolute, 1.0, 5, 100), {0.0, kNaN, kNaN, 2.0}) == 7);
  CHECK(plan(MakeRule(EMeanPrecision::Absolute, 1.0, 5, 6), {0.0, kNaN, kNaN, 2.0}) == 6);
  // a mean of 0 never reaches a relative precision
  CHECK(plan(MakeRule(EMeanPrecision::Relative, 0.1, 2, 100), {-1.0, 1.0}) == 100);
}

TEST_CASE("sequential mean: wrong rules", "[campaign][statistics]") {
  const Real wrong = GENERATE(0.0, -1.0, kNaN, kInfinity);
  CHECK_THROWS_WITH(CSequentialMean(MakeRule(EMeanPrecision::Absolute, wrong)),
                    Contains("half width"));
  CHECK_THROWS_WITH(CSequentialMean(MakeRule(EMeanPrecision::Relative, wrong)),
                    Contains("half width"));
  CHECK_THROWS_WITH(CSequentialMean(MakeRule(EMeanPrecision::Relative, 1.0)),
                    Contains("below 1 as a share of the mean"));
  CHECK_THROWS_WITH(CSequentialMean(MakeRule(EMeanPrecision::Absolute, 1.0, 1)),
                    Contains("at least 2 are needed"));
  CHECK_THROWS_WITH(CSequentialMean(MakeRule(EMeanPrecision::Absolute, 1.0, 10, 9)),
                    Contains("9 is below the least, 10"));
  CHECK_THROWS_WITH(CSequentialMean(MakeRule(EMeanPrecision::Absolute, 1.0, 10, 20, 1.0)),
                    Contains("confidence level 1"));
}

TEST_CASE("sequential mean: wrong values", "[campaign][statistics]") {
  CSequentialMean mean(MakeRule(EMeanPrecision::Absolute, 1e-3, 2, 5));
  mean.Insert(0, 1.0);
  mean.Insert(2, 1.0);
  CHECK_THROWS_WITH(mean.Insert(0, 1.0), Contains("position 0 has a value already"));
  CHECK_THROWS_WITH(mean.Insert(2, 1.0), Contains("position 2 has a value already"));
  CHECK_THROWS_WITH(mean.Insert(5, 1.0), Contains("beyond the cap of 5"));
  CHECK_THROWS_WITH(mean.Insert(1, kInfinity), Contains("is inf"));
  CHECK_THROWS_WITH(mean.Insert(1, -2e150), Contains("finite values"));
  // the refused value left no trace
  CHECK(mean.GetCount() == 1);
  mean.Insert(1, 1.0);
  CHECK(mean.GetDecision() == EStopDecision::PrecisionReached);
  // of runs that were under way
  CHECK_NOTHROW(mean.Insert(4, 9.0));
  CHECK(mean.GetCount() == 2);
  CHECK_THROWS_WITH(mean.Insert(1, 1.0), Contains("position 1 has a value already"));
}

}  // namespace sequential_mean_test
