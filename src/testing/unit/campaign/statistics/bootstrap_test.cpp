#include "hostile_values.h"

#include <argos3/campaign/statistics/bootstrap.h>
#include <argos3/campaign/statistics/bootstrap_interval.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bootstrap_test {

using Catch::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace argos;

namespace {

// hours between failures of an air conditioner: F. Proschan (1963); A. C. Davison and D. V.
// Hinkley (1997), example 1.1; R: boot::aircondit
const std::vector<Real> kAirConditioner = {3, 5, 7, 18, 43, 85, 91, 98, 100, 130, 230, 487};

std::vector<Real> FortyReplicates() {
  std::vector<Real> replicates = {30,  35,  42,  48,  55,  60,  64,  70,  71,  77,
                                  80,  83,  88,  90,  95,  99,  103, 105, 108, 112,
                                  115, 119, 121, 126, 130, 133, 138, 141, 147, 150,
                                  155, 160, 168, 171, 180, 188, 199, 210, 230, 260};
  for (Real& replicate : replicates) {
    replicate += 0.25;
  }
  return replicates;
}

SBootstrapOptions With(EBootstrapStatistic statistic, size_t numResamples = 9999) {
  SBootstrapOptions options;
  options.Statistic = statistic;
  options.NumResamples = numResamples;
  return options;
}

}  // namespace

TEST_CASE("bootstrap: intervals of given replicates are those of R's boot",
          "[campaign][statistics]") {
  // boot 1.3-28: boot:::perc.ci(t, 0.9)
  const SConfidenceInterval percentile = ComputeReplicatesInterval(FortyReplicates(), 0.9);
  CHECK_THAT(percentile.Lower, WithinRel(35.6593063912373, 1e-13));
  CHECK_THAT(percentile.Upper, WithinRel(229.080553167893, 1e-13));
  // boot:::bca.ci(NULL, level, 1, t0 = mean(hours), t = t, L = mean(j) - j)
  const std::vector<Real> jackknife = ComputeJackknife(kAirConditioner, EBootstrapStatistic::Mean);
  const auto bca = [&](Real level) {
    return ComputeBcaReplicatesInterval(1297.0 / 12.0, FortyReplicates(), jackknife, level);
  };
  CHECK_THAT(bca(0.6).Lower, WithinRel(61.8254546955545, 1e-12));
  CHECK_THAT(bca(0.6).Upper, WithinRel(151.823197868575, 1e-12));
  CHECK_THAT(bca(0.9).Lower, WithinRel(35.687847073765, 1e-12));
  CHECK_THAT(bca(0.9).Upper, WithinRel(229.19144148039, 1e-12));
}

TEST_CASE("bootstrap: intervals of the air conditioner", "[campaign][statistics]") {
  // R 4.2, boot 1.3-28 with 99,999 resamples: percentile (46.8, 191.4), BCa (57.1, 227.3).
  // Quantiles of 9,999 resamples have standard errors of 0.4 below and 2 above, of 99,999 a third
  // of that.
  const SConfidenceInterval percentile =
      ComputePercentileInterval(kAirConditioner, With(EBootstrapStatistic::Mean));
  CHECK_THAT(percentile.Lower, WithinAbs(46.8, 2.0));
  CHECK_THAT(percentile.Upper, WithinAbs(191.4, 7.0));
  const SConfidenceInterval bca =
      ComputeBcaInterval(kAirConditioner, With(EBootstrapStatistic::Mean));
  CHECK_THAT(bca.Lower, WithinAbs(57.1, 2.0));
  CHECK_THAT(bca.Upper, WithinAbs(227.3, 10.0));
  // R: median, percentile (12.5, 115.0); BCa with ties below (11.5, 114.0)
  const SConfidenceInterval median =
      ComputePercentileInterval(kAirConditioner, With(EBootstrapStatistic::Median));
  CHECK(median.Lower == 12.5);
  CHECK(median.Upper == 115.0);
  const SConfidenceInterval bcaMedian =
      ComputeBcaInterval(kAirConditioner, With(EBootstrapStatistic::Median));
  CHECK_THAT(bcaMedian.Lower, WithinAbs(12.5, 1.0));
  CHECK_THAT(bcaMedian.Upper, WithinAbs(115.0, 1.0));
}

TEST_CASE("bootstrap: the jackknife leaves out one value each", "[campaign][statistics]") {
  // R 4.2: sapply(1:n, function(i) median(hours[-i]))
  CHECK(ComputeJackknife(kAirConditioner, EBootstrapStatistic::Median) ==
        std::vector<Real>{91, 91, 91, 91, 91, 91, 85, 85, 85, 85, 85, 85});
  const std::vector<Real> eleven(kAirConditioner.begin(), kAirConditioner.end() - 1);
  CHECK(ComputeJackknife(eleven, EBootstrapStatistic::Median) ==
        std::vector<Real>{88, 88, 88, 88, 88, 67, 64, 64, 64, 64, 64});
  const std::vector<Real> means =
      ComputeJackknife(std::vector<Real>{1.0, 2.0, 6.0}, EBootstrapStatistic::Mean);
  CHECK_THAT(means[0], WithinRel(4.0, 1e-15));
  CHECK_THAT(means[1], WithinRel(3.5, 1e-15));
  CHECK_THAT(means[2], WithinRel(1.5, 1e-15));
  CHECK(ComputeJackknife(std::vector<Real>{1.0, 2.0}, EBootstrapStatistic::Median) ==
        std::vector<Real>{2.0, 1.0});
}

TEST_CASE("bootstrap: the seed and the set of values decide", "[campaign][statistics]") {
  const auto statistic = GENERATE(EBootstrapStatistic::Mean, EBootstrapStatistic::Median);
  const std::vector<Real> replicates = ComputeReplicates(kAirConditioner, statistic, 500, 7);
  std::vector<Real> reversed(kAirConditioner.rbegin(), kAirConditioner.rend());
  CHECK(ComputeReplicates(reversed, statistic, 500, 7) == replicates);
  CHECK(ComputeReplicates(kAirConditioner, statistic, 500, 8) != replicates);
  CHECK(std::is_sorted(replicates.begin(), replicates.end()));
}

TEST_CASE("bootstrap: replicates have the moments of resampling", "[campaign][statistics]") {
  // the mean of two draws from 0 and 1: 0, 1/2, 1 with probabilities 1/4, 1/2, 1/4
  const std::vector<Real> replicates =
      ComputeReplicates(std::vector<Real>{0.0, 1.0}, EBootstrapStatistic::Mean, 40000, 1);
  const auto count = [&](Real value) {
    return static_cast<Real>(std::count(replicates.begin(), replicates.end(), value));
  };
  // five standard deviations
  CHECK_THAT(count(0.0), WithinAbs(10000.0, 5.0 * std::sqrt(7500.0)));
  CHECK_THAT(count(0.5), WithinAbs(20000.0, 5.0 * std::sqrt(10000.0)));
  CHECK_THAT(count(1.0), WithinAbs(10000.0, 5.0 * std::sqrt(7500.0)));
}

TEST_CASE("bootstrap: BCa is equivariant under reflection of the replicates",
          "[campaign][statistics]") {
  const auto mirror = [](std::vector<Real> values) {
    for (Real& value : values) {
      value = -value;
    }
    std::sort(values.begin(), values.end());
    return values;
  };
  const std::vector<Real> jackknife = ComputeJackknife(kAirConditioner, EBootstrapStatistic::Mean);
  const SConfidenceInterval interval =
      ComputeBcaReplicatesInterval(100.0, FortyReplicates(), jackknife, 0.8);
  const SConfidenceInterval mirrored =
      ComputeBcaReplicatesInterval(-100.0, mirror(FortyReplicates()), mirror(jackknife), 0.8);
  CHECK_THAT(mirrored.Lower, WithinRel(-interval.Upper, 1e-12));
  CHECK_THAT(mirrored.Upper, WithinRel(-interval.Lower, 1e-12));
}

TEST_CASE("bootstrap: intervals cover the mean of skewed values as R's boot does",
          "[campaign][statistics]") {
  // exponential values of mean 1, samples of 20; nominal 0.9
  CRandomStream stream(11, "test", "bootstrap", "coverage");
  const int numSamples = 4000;
  size_t byPercentile = 0;
  size_t byBca = 0;
  for (int i = 0; i < numSamples; ++i) {
    std::vector<Real> values;
    for (int j = 0; j < 20; ++j) {
      values.push_back(-std::log(1.0 - stream.Uniform01()));
    }
    SBootstrapOptions options = With(EBootstrapStatistic::Mean, 499);
    options.Level = 0.9;
    options.Seed = static_cast<UInt64>(i);
    const SConfidenceInterval percentile = ComputePercentileInterval(values, options);
    const SConfidenceInterval bca = ComputeBcaInterval(values, options);
    byPercentile += percentile.Lower <= 1.0 && 1.0 <= percentile.Upper ? 1 : 0;
    byBca += bca.Lower <= 1.0 && 1.0 <= bca.Upper ? 1 : 0;
  }
  CAPTURE(byPercentile, byBca);
  // R 4.2, boot 1.3-28, 6,000 other samples: 0.852 and 0.855, with standard errors of 0.0046; those
  // of 4,000 samples are 0.0056. Five of both together.
  CHECK_THAT(static_cast<Real>(byPercentile) / numSamples, WithinAbs(0.852, 0.036));
  CHECK_THAT(static_cast<Real>(byBca) / numSamples, WithinAbs(0.855, 0.036));
  CHECK(byBca > byPercentile);
}

TEST_CASE("bootstrap: half of the replicates that equal the estimate count as below it",
          "[campaign][statistics]") {
  // an acceleration of 0
  const std::vector<Real> symmetric = {-1.0, 0.0, 1.0};
  // 40 replicates, ten of which are the estimate
  const auto makeReplicates = [](int below) {
    std::vector<Real> replicates;
    for (int i = 1; i <= 31; ++i) {
      const size_t count = i == below + 1 ? 10 : 1;
      replicates.insert(replicates.end(), count, static_cast<Real>(i));
    }
    return replicates;
  };
  // 15 below, 15 above: no bias, so that the interval is that of the percentiles
  const std::vector<Real> middle = makeReplicates(15);
  const SConfidenceInterval unbiased = ComputeBcaReplicatesInterval(16.0, middle, symmetric, 0.8);
  const SConfidenceInterval percentile = ComputeReplicatesInterval(middle, 0.8);
  CHECK_THAT(unbiased.Lower, WithinRel(percentile.Lower, 1e-12));
  CHECK_THAT(unbiased.Upper, WithinRel(percentile.Upper, 1e-12));
  CHECK_THAT(percentile.Lower, WithinRel(4.107634851004542, 1e-12));
  // 10 below, 20 above: a share of (10 + 10/2) / 40. By Python's NormalDist: the probabilities are
  // cdf(2 inv_cdf(0.375) -+ inv_cdf(0.9)), interpolated on the normal scale
  const SConfidenceInterval biased =
      ComputeBcaReplicatesInterval(11.0, makeReplicates(10), symmetric, 0.8);
  CHECK_THAT(biased.Lower, WithinRel(1.164721944416579, 1e-12));
  CHECK_THAT(biased.Upper, WithinRel(21.346718295359324, 1e-12));
}

TEST_CASE("bootstrap: an estimate beyond all replicates has a finite bias",
          "[campaign][statistics]") {
  // as if half a replicate were beyond it: a share of 1 - 0.5/40. By Python's NormalDist:
  // cdf(2 inv_cdf(0.9875) - inv_cdf(0.995)), interpolated on the normal scale
  const std::vector<Real> symmetric = {-1.0, 0.0, 1.0};
  const SConfidenceInterval above =
      ComputeBcaReplicatesInterval(1e6, FortyReplicates(), symmetric, 0.99);
  CHECK_THAT(above.Lower, WithinRel(254.17473532654307, 1e-12));
  CHECK(above.Upper == 260.25);
  const SConfidenceInterval below =
      ComputeBcaReplicatesInterval(-1e6, FortyReplicates(), symmetric, 0.99);
  CHECK(below.Lower == 30.25);
  CHECK_THAT(below.Upper, WithinRel(31.26254411224289, 1e-12));
}

TEST_CASE("bootstrap: beyond the pole of the acceleration lies the last replicate",
          "[campaign][statistics]") {
  // one of m values differs: the acceleration is +-(m - 2) / (6 sqrt(m (m - 1))), 0.1664 for 1000
  std::vector<Real> replicates;
  for (int i = 1; i <= 1000; ++i) {
    replicates.push_back(i);
  }
  std::vector<Real> jackknife(1000, 1.0);
  jackknife.front() = 0.0;
  // bias and quantile are inv_cdf(1 - 0.0005) each, 3.29: 1 - 0.1664 6.58 < 0
  CHECK(ComputeBcaReplicatesInterval(2000.0, replicates, jackknife, 0.999).Upper == 1000.0);
  std::vector<Real> mirrored(1000, 0.0);
  mirrored.back() = 1.0;
  CHECK(ComputeBcaReplicatesInterval(-2000.0, replicates, mirrored, 0.999).Lower == 1.0);
}

TEST_CASE("bootstrap: an influence of no value accelerates nothing", "[campaign][statistics]") {
  const std::vector<Real> equal = {3.0, 3.0, 3.0};
  const std::vector<Real> replicates = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};
  // the estimate is in the middle; quarters of 8 intervals
  const SConfidenceInterval interval = ComputeBcaReplicatesInterval(4.0, replicates, equal, 0.5);
  CHECK_THAT(interval.Lower, WithinRel(2.0, 1e-12));
  CHECK_THAT(interval.Upper, WithinRel(6.0, 1e-12));
}

TEST_CASE("bootstrap: probabilities beyond the replicates give the extremes",
          "[campaign][statistics]") {
  const std::vector<Real> replicates = {1.0, 2.0, 3.0};
  // positions 4 p: exactly those of the extremes, a little beyond them, and far
  for (const Real level : {0.5, 0.525, 0.9}) {
    const SConfidenceInterval interval = ComputeReplicatesInterval(replicates, level);
    CHECK(interval.Lower == 1.0);
    CHECK(interval.Upper == 3.0);
  }
}

TEST_CASE("bootstrap: hostile input", "[campaign][statistics]") {
  const auto statistic = GENERATE(EBootstrapStatistic::Mean, EBootstrapStatistic::Median);
  const SBootstrapOptions options = With(statistic, 99);
  CHECK_THROWS_WITH(ComputePercentileInterval({}, options), Contains("number of values 0"));
  CHECK_THROWS_WITH(ComputeBcaInterval(std::vector<Real>{1.0}, options), Contains("at least 2"));
  CHECK_THROWS_WITH(ComputeReplicates({}, statistic, 10, 1), Contains("number of values 0"));
  CHECK_THROWS_WITH(ComputeJackknife(std::vector<Real>{1.0}, statistic), Contains("at least 2"));
  const std::vector<Real> some = {1.0, 2.0, 4.0};
  CheckRefusesHostileValues(some, [&](const auto& x) { ComputePercentileInterval(x, options); });
  CheckRefusesHostileValues(some, [&](const auto& x) { ComputeBcaInterval(x, options); });
  SBootstrapOptions wrong = options;
  wrong.Level = 1.0;
  CHECK_THROWS_WITH(ComputeBcaInterval(some, wrong), Contains("confidence level 1"));
  // two tails of 1/40
  CHECK_NOTHROW(ComputeBcaInterval(some, With(statistic, 39)));
  CHECK_THROWS_WITH(ComputeBcaInterval(some, With(statistic, 38)), Contains("at least 39"));
  CHECK_THROWS_WITH(ComputePercentileInterval(some, With(statistic, 0)), Contains("at least 39"));
  // equal values; a mean of equal values may be rounded
  const SConfidenceInterval equal = ComputeBcaInterval(std::vector<Real>(7, 0.1), options);
  CHECK(equal.Lower == equal.Upper);
  CHECK_THAT(equal.Lower, WithinRel(0.1, 1e-15));
  // an estimate beyond all replicates
  const SConfidenceInterval beyond =
      ComputeBcaReplicatesInterval(1e6, FortyReplicates(), some, 0.95);
  CHECK(beyond.Upper == 260.25);
  CHECK(std::isfinite(beyond.Lower));
}

}  // namespace bootstrap_test
