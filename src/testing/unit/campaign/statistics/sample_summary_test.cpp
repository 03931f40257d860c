#include "hostile_values.h"
#include "samples.h"

#include <argos3/campaign/statistics/missing_values.h>
#include <argos3/campaign/statistics/moments.h>
#include <argos3/campaign/statistics/quantile.h>
#include <argos3/campaign/statistics/sample_summary.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace sample_summary_test {

using Catch::Contains;
using Catch::Matchers::WithinRel;
using namespace argos;

TEST_CASE("sample summary: numbers of R for ozone in May", "[campaign][statistics]") {
  const SSampleSummary summary = Summarize(kOzone[0]);
  CHECK(summary.Count == 26);
  CHECK(summary.NumMissing == 0);
  // R 4.2: mean, sd, quantile; printed with 12 digits
  CHECK_THAT(summary.Mean, WithinRel(23.6153846154, 1e-11));
  CHECK_THAT(summary.StandardDeviation, WithinRel(22.2244494610362, 1e-13));
  CHECK(summary.Min == 1.0);
  CHECK(summary.LowerQuartile == 11.0);
  CHECK(summary.Median == 18.0);
  CHECK(summary.UpperQuartile == 31.5);
  CHECK(summary.Max == 115.0);
}

TEST_CASE("sample summary: missing values are counted apart", "[campaign][statistics]") {
  const SSampleSummary summary = Summarize(std::vector<Real>{kNaN, 4.0, kNaN, 2.0, kNaN});
  CHECK(summary.Count == 2);
  CHECK(summary.NumMissing == 3);
  CHECK(summary.Mean == 3.0);
  CHECK_THAT(summary.StandardDeviation, WithinRel(std::sqrt(2.0), 1e-15));
  CHECK(summary.LowerQuartile == 2.5);
}

TEST_CASE("sample summary: too few values leave statistics undefined", "[campaign][statistics]") {
  const SSampleSummary none = Summarize(std::vector<Real>{kNaN});
  CHECK(none.Count == 0);
  CHECK(none.NumMissing == 1);
  for (const Real statistic : {none.Mean, none.StandardDeviation, none.Min, none.LowerQuartile,
                               none.Median, none.UpperQuartile, none.Max}) {
    CHECK(std::isnan(statistic));
  }
  const SSampleSummary one = Summarize(std::vector<Real>{7.0});
  CHECK(one.Mean == 7.0);
  CHECK(std::isnan(one.StandardDeviation));
  CHECK(one.LowerQuartile == 7.0);
  CHECK(one.UpperQuartile == 7.0);
  CHECK(Summarize({}).Count == 0);
}

TEST_CASE("sample summary: infinite values are errors", "[campaign][statistics]") {
  const Real infinite = GENERATE(2e150, kInfinity, -kInfinity);
  CAPTURE(infinite);
  CHECK_THROWS_WITH(Summarize(std::vector<Real>{1.0, infinite}), Contains("value 2 of 2"));
}

TEST_CASE("moments: equal values have a deviation of exactly 0", "[campaign][statistics]") {
  const Real value = GENERATE(0.0, 0.1, -3.3, 1e-300, 1e150);
  const SMoments moments = ComputeMoments(std::vector<Real>(7, value));
  CHECK(moments.Mean == value);
  CHECK(moments.StandardDeviation == 0.0);
}

TEST_CASE("moments: neither offsets nor scales cost digits", "[campaign][statistics]") {
  // 1, 2, 4 have mean 7/3 and variance 7/3
  const Real scale = GENERATE(1.0, 1e-200, 1e-310, 1e149);
  const SMoments scaled = ComputeMoments(std::vector<Real>{1.0 * scale, 2.0 * scale, 4.0 * scale});
  // subnormal numbers have 1e-310 / 5e-324 = 2e13 steps
  CHECK_THAT(scaled.Mean / scale, WithinRel(7.0 / 3.0, 1e-13));
  CHECK_THAT(scaled.StandardDeviation / scale, WithinRel(std::sqrt(7.0 / 3.0), 1e-13));
  const SMoments moved = ComputeMoments(std::vector<Real>{1e9 + 1.0, 1e9 + 2.0, 1e9 + 4.0});
  CHECK_THAT(moved.StandardDeviation, WithinRel(std::sqrt(7.0 / 3.0), 1e-13));
}

TEST_CASE("quantile: definition 7 of Hyndman and Fan", "[campaign][statistics]") {
  const std::vector<Real> sorted = {1.0, 2.0, 4.0, 8.0};
  CHECK(ComputeQuantile(sorted, 0.0) == 1.0);
  CHECK(ComputeQuantile(sorted, 0.25) == 1.75);
  CHECK(ComputeQuantile(sorted, 0.5) == 3.0);
  CHECK(ComputeQuantile(sorted, 0.75) == 5.0);
  CHECK(ComputeQuantile(sorted, 1.0) == 8.0);
  // what follows the sample does not count
  const std::vector<Real> longer = {1.0, 2.0, std::numeric_limits<Real>::quiet_NaN()};
  CHECK(ComputeQuantile(std::span(longer).first(2), 1.0) == 2.0);
  CHECK(ComputeMedian(sorted) == 3.0);
  CHECK(ComputeMedian(std::vector<Real>{1.0, 2.0, 4.0}) == 2.0);
}

TEST_CASE("quantile: no values and probabilities out of range are errors",
          "[campaign][statistics]") {
  CHECK_THROWS_WITH(ComputeQuantile({}, 0.5), Contains("number of values 0, at least 1"));
  CHECK_THROWS_WITH(ComputeMedian({}), Contains("number of values 0, at least 1"));
  CHECK_THROWS_WITH(ComputeMoments({}), Contains("number of values 0, at least 1"));
  const Real probability = GENERATE(-0.1, 1.1, kNaN);
  CHECK_THROWS_WITH(ComputeQuantile(std::vector<Real>{1.0}, probability),
                    Contains("it must be in [0,1]"));
}

TEST_CASE("missing values: they are dropped and counted", "[campaign][statistics]") {
  const SPresentValues present = RemoveMissing(std::vector<Real>{kNaN, 2.0});
  CHECK(present.Values == std::vector<Real>{2.0});
  CHECK(present.NumMissing == 1);
}

}  // namespace sample_summary_test
