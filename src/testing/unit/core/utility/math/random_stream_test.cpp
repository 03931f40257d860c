#include <argos3/testing/support/statistics.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/math/normal_quantile.h>
#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace random_stream_test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace argos;

namespace {

static_assert(sizeof(CRandomStream) <= 48);
static_assert(std::is_trivially_copyable_v<CRandomStream>);

CRandomStream MakeStream(UInt64 seed = 1) {
  return CRandomStream(seed, "argos", "fb0", "proximity");
}

// how far 20,000 draws are from a distribution; see KolmogorovSmirnovExcess()
template <typename DRAW>
Real ComputeExcess(DRAW draw, const std::function<Real(Real)>& distribution) {
  std::vector<Real> sample(20000);
  std::generate(sample.begin(), sample.end(), draw);
  return KolmogorovSmirnovExcess(std::move(sample), distribution);
}

}  // namespace

TEST_CASE("random stream: the same name gives the same numbers, whatever other streams exist",
          "[core][math]") {
  CRandomStream one = MakeStream();
  CRandomStream unrelated(7, "x", "y", "z");
  unrelated.Next();
  CRandomStream two = MakeStream();
  std::vector<UInt64> start;
  for (int i = 0; i < 100; ++i) {
    start.push_back(one.Next());
    REQUIRE(two.Next() == start.back());
  }
  one.Reset();
  for (const UInt64 value : start) {
    REQUIRE(one.Next() == value);
  }
}

TEST_CASE("random stream: every part of the name matters", "[core][math]") {
  const CRandomStream streams[] = {
      CRandomStream(1, "argos", "fb0", "noise"), CRandomStream(2, "argos", "fb0", "noise"),
      CRandomStream(1, "argo", "sfb0", "noise"), CRandomStream(1, "argos", "fb0n", "oise"),
      CRandomStream(1, "argos", "fb1", "noise"), CRandomStream(1, "argos", "noise", "fb0"),
      CRandomStream(1, "fb0", "argos", "noise"), CRandomStream(1, "argosfb0noise", "", ""),
      CRandomStream(1, "", "argosfb0noise", ""), CRandomStream(0, "", "", ""),
      CRandomStream(1ULL << 32, "", "", ""),     CRandomStream(1, "argos", "fb0", "")};
  std::set<UInt64> first;
  for (CRandomStream stream : streams) {
    first.insert(stream.Next());
  }
  CHECK(first.size() == std::size(streams));
}

TEST_CASE("random stream: streams of numbered owners are independent", "[core][math]") {
  // the first numbers of neighbouring owners are uniform and uncorrelated
  std::vector<Real> values;
  for (int i = 0; i < 20000; ++i) {
    values.push_back(CRandomStream(1, "argos", "fb" + std::to_string(i), "noise").Uniform01());
  }
  Real correlation = 0.0;
  for (size_t i = 0; i + 1 < values.size(); ++i) {
    correlation += 12.0 * (values[i] - 0.5) * (values[i + 1] - 0.5);
  }
  // tolerance: 4 standard deviations of a sum of products of standardised values
  CHECK_THAT(correlation, WithinAbs(0.0, 4.0 * std::sqrt(20000.0)));
  size_t next = 0;
  CHECK(ComputeExcess([&] { return values[next++]; }, [](Real x) { return x; }) < 1.0);
}

TEST_CASE("random stream: xoshiro256** follows the published recurrence", "[core][math]") {
  // The authors' recurrence runs beside ours from the same state: the key
  // is drawn first, then four words.
  CRandomStream stream = MakeStream();
  UInt64 words[5];
  static_assert(sizeof(words) == sizeof(stream));
  std::copy_n(reinterpret_cast<const unsigned char*>(&stream), sizeof(words),
              reinterpret_cast<unsigned char*>(words));
  UInt64* s = words + 1;
  const auto rotl = [](UInt64 x, int k) { return (x << k) | (x >> (64 - k)); };
  for (int i = 0; i < 100; ++i) {
    const UInt64 result = rotl(s[1] * 5, 7) * 9;
    const UInt64 t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = rotl(s[3], 45);
    REQUIRE(stream.Next() == result);
  }
}

TEST_CASE("random stream: continuous distributions pass the Kolmogorov test", "[core][math]") {
  CRandomStream stream = MakeStream(GENERATE(1, 2, 3));
  CHECK(ComputeExcess([&] { return stream.Uniform01(); }, [](Real x) { return x; }) < 1.0);
  CHECK(ComputeExcess([&] { return stream.Uniform(-3.0, 1.0); },
                      [](Real x) { return (x + 3.0) / 4.0; }) < 1.0);
  CHECK(ComputeExcess([&] { return stream.Gaussian(2.0, 5.0); },
                      [](Real x) { return NormalDistribution(x - 5.0, 2.0); }) < 1.0);
  CHECK(ComputeExcess([&] { return stream.Rayleigh(0.5); },
                      [](Real x) { return 1.0 - std::exp(-2.0 * x * x); }) < 1.0);
}

TEST_CASE("random stream: the Gaussian has the right moments", "[core][math]") {
  CRandomStream stream = MakeStream(GENERATE(1, 2, 3));
  constexpr int kCount = 100000;
  Real sums[4] = {};
  for (int i = 0; i < kCount; ++i) {
    const Real value = stream.Gaussian(1.0);
    Real power = 1.0;
    for (Real& sum : sums) {
      power *= value;
      sum += power;
    }
  }
  // 4 standard deviations: the variances of x, x^2, x^3, x^4 are 1, 2, 15, 96
  const Real root = std::sqrt(static_cast<Real>(kCount));
  CHECK_THAT(sums[0] / kCount, WithinAbs(0.0, 4.0 / root));
  CHECK_THAT(sums[1] / kCount, WithinAbs(1.0, 4.0 * std::sqrt(2.0) / root));
  CHECK_THAT(sums[2] / kCount, WithinAbs(0.0, 4.0 * std::sqrt(15.0) / root));
  CHECK_THAT(sums[3] / kCount, WithinAbs(3.0, 4.0 * std::sqrt(96.0) / root));
}

TEST_CASE("random stream: numbers stay within the bounds", "[core][math]") {
  CRandomStream stream = MakeStream();
  for (int i = 0; i < 10000; ++i) {
    const Real unit = stream.Uniform01();
    REQUIRE(unit >= 0.0);
    REQUIRE(unit < 1.0);
    REQUIRE_FALSE(stream.Bernoulli(0.0));
    REQUIRE(stream.Bernoulli(1.0));
    REQUIRE(stream.Rayleigh(1.0) >= 0.0);
    REQUIRE(stream.UniformInteger(1) == 0u);
    REQUIRE(stream.UniformInteger(UInt64(7)) < 7u);
    const SInt64 number = stream.UniformInteger(-3, 3);
    REQUIRE(number >= -3);
    REQUIRE(number <= 3);
  }
  CHECK(stream.Gaussian(0.0, 2.5) == 2.5);
  CHECK(stream.UniformInteger(5, 5) == 5);
  // the whole range of the type is accepted
  CHECK_NOTHROW(stream.UniformInteger(std::numeric_limits<SInt64>::min(),
                                      std::numeric_limits<SInt64>::max()));
#ifndef NDEBUG
  CHECK_THROWS_AS(stream.UniformInteger(UInt64(0)), CARGoSException);
#endif
}

TEST_CASE("random stream: discrete distributions pass the chi-square test", "[core][math]") {
  CRandomStream stream = MakeStream(GENERATE(1, 2, 3));
  std::vector<size_t> counts(10);
  Real successes = 0.0;
  for (int i = 0; i < 20000; ++i) {
    ++counts[static_cast<size_t>(stream.UniformInteger(1, 10) - 1)];
    successes += stream.Bernoulli(0.2) ? 1.0 : 0.0;
  }
  CHECK(ChiSquareExcess(counts, std::vector<Real>(10, 0.1)) < 1.0);
  CHECK_THAT(successes, WithinAbs(4000.0, 3.9 * std::sqrt(20000 * 0.2 * 0.8)));
  // Two thirds of 2^64: without rejection the lower half would be twice as frequent.
  const UInt64 count = 0xaaaaaaaaaaaaaaaaULL;
  Real low = 0.0;
  for (int i = 0; i < 20000; ++i) {
    low += stream.UniformInteger(count) < count / 2 ? 1.0 : 0.0;
  }
  CHECK_THAT(low, WithinAbs(10000.0, 3.9 * std::sqrt(20000 * 0.25)));
}

TEST_CASE("random stream: each value consumes one number of the stream", "[core][math]") {
  CRandomStream stream = MakeStream();
  CRandomStream counter = stream;
  stream.Uniform01();
  stream.Uniform(1.0, 2.0);
  stream.Bernoulli();
  stream.Gaussian(1.0, 0.0);
  stream.Rayleigh(1.0);
  for (int i = 0; i < 5; ++i) {
    counter.Next();
  }
  CHECK(stream.Next() == counter.Next());
}

TEST_CASE("normal quantile: inverts the error function in the centre and in both tails",
          "[core][math]") {
  CHECK(ComputeNormalQuantile(0.0) == 0.0);
  // 97.5 % and 99.5 % points from tables
  CHECK_THAT(ComputeNormalQuantile(0.475), WithinAbs(1.959963984540054, 1e-15));
  CHECK_THAT(ComputeNormalQuantile(0.495), WithinAbs(2.5758293035489004, 2e-15));

  const int power = GENERATE(range(1, 54));
  const Real probability = std::ldexp(1.0, -power);
  const Real excess = probability - 0.5;  // exact
  const Real quantile = ComputeNormalQuantile(excess);
  CAPTURE(power);
  CHECK(ComputeNormalQuantile(-excess) == -quantile);
  // a relative error of 2^-53 in the quantile x changes the probability by x^2 2^-53, 70 * 1e-16 at
  // most, and the distribution function has roundings of its own
  CHECK_THAT(NormalDistribution(quantile, 1.0), WithinRel(probability, 5e-14));
  // the same algorithm in GSL, with other roundings
  CHECK_THAT(quantile, WithinRel(gsl_cdf_ugaussian_Pinv(probability), 2e-15));
}

}  // namespace random_stream_test
