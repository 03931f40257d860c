#include <argos3/testing/support/statistics.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/math/rng.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

namespace rng_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using namespace argos;

namespace {

constexpr Real kMaxDraw = 4294967295.0;
const CRange<Real> kUnit(0.0, 1.0);

std::vector<Real> DrawSome(CRandom::CRNG& rng) {
  std::vector<Real> values(10);
  for (Real& value : values) {
    value = rng.Uniform(kUnit);
  }
  return values;
}

template <typename DRAW>
std::vector<Real> Sample(DRAW draw) {
  std::vector<Real> samples(20000);
  std::generate(samples.begin(), samples.end(), draw);
  return samples;
}

// a registry that is current during its lifetime
class CCurrentRegistry {
 public:
  CCurrentRegistry() { CRandom::SetCurrentRegistry(&m_registry); }
  ~CCurrentRegistry() { CRandom::SetCurrentRegistry(nullptr); }

 private:
  CRandom::CRegistry m_registry;
};

}  // namespace

TEST_CASE("random numbers: the stream is that of the standard Mersenne Twister", "[core][math]") {
  const UInt32 seed = GENERATE(0u, 1u, 5489u, 4357u, 123456789u, 4294967295u);
  CAPTURE(seed);
  CRandom::CRNG rng(seed);
  std::mt19937 reference(seed);
  CHECK(rng.GetSeed() == seed);
  for (int i = 0; i < 2000; ++i) {
    // u / (2^32 - 1) is different for every u
    REQUIRE(rng.Uniform(kUnit) == static_cast<Real>(reference()) / kMaxDraw);
  }
}

TEST_CASE("random numbers: the 10000th number of the default seed equals the standard's",
          "[core][math]") {
  // ISO/IEC 14882, [rand.predef]
  CRandom::CRNG rng(5489);
  for (int i = 1; i < 10000; ++i) {
    rng.Uniform(kUnit);
  }
  CHECK(rng.Uniform(kUnit) == 4123659995.0 / kMaxDraw);
}

TEST_CASE("random numbers: copies give the same numbers, a new seed takes effect at the reset",
          "[core][math]") {
  CRandom::CRNG rng(12);
  const std::vector<Real> start = DrawSome(rng);
  CRandom::CRNG copy(rng);
  const std::vector<Real> next = DrawSome(rng);
  CHECK(DrawSome(copy) == next);
  CHECK(copy.GetSeed() == 12u);

  rng.Reset();
  CHECK(DrawSome(rng) == start);
  rng.SetSeed(13);
  CHECK(rng.GetSeed() == 13u);
  CHECK(DrawSome(rng) == next);
  rng.Reset();
  CRandom::CRNG other(13);
  CHECK(DrawSome(rng) == DrawSome(other));
  copy = other;
  CHECK(DrawSome(copy) == DrawSome(other));
  CHECK(copy.GetSeed() == 13u);
  const CRandom::CRNG& same = copy;
  copy = same;
  CHECK(DrawSome(copy) == DrawSome(other));
}

TEST_CASE("random numbers: uniform numbers are min + u / (2^32 - 1) * span", "[core][math]") {
  CRandom::CRNG rng(99);
  std::mt19937 reference(99);
  for (int i = 0; i < 500; ++i) {
    REQUIRE(rng.Uniform(CRange<Real>(-3.0, 5.0)) ==
            -3.0 + static_cast<Real>(reference()) / kMaxDraw * 8.0);
    REQUIRE(rng.Uniform(CRange<CRadians>(CRadians(1.0), CRadians(3.0))).GetValue() ==
            1.0 + static_cast<Real>(reference()) / kMaxDraw * 2.0);
    REQUIRE(rng.Uniform(CRange<UInt32>(10, 20)) ==
            static_cast<UInt32>(10.0 + static_cast<Real>(reference()) / kMaxDraw * 10.0));
    // conversion truncates towards zero
    REQUIRE(rng.Uniform(CRange<SInt32>(-5, 5)) ==
            static_cast<SInt32>(-5.0 + static_cast<Real>(reference()) / kMaxDraw * 10.0));
  }
  const CRange<SInt32> all(std::numeric_limits<SInt32>::min(), std::numeric_limits<SInt32>::max());
  CHECK(rng.Uniform(all) ==
        static_cast<SInt32>(all.GetMin() + static_cast<Real>(reference()) / kMaxDraw * kMaxDraw));
  CHECK(rng.Uniform(CRange<UInt32>(7, 7)) == 7u);
}

TEST_CASE("random numbers: Bernoulli, exponential and Poisson draw once, Gaussian draws pairs",
          "[core][math]") {
  CRandom::CRNG rng(5);
  std::mt19937 reference(5);
  const auto unit = [&reference] { return static_cast<Real>(reference()) / kMaxDraw; };
  for (int i = 0; i < 200; ++i) {
    REQUIRE(rng.Bernoulli(0.3) == (static_cast<Real>(reference()) < 0.3 * kMaxDraw));
    REQUIRE(rng.Bernoulli() == (static_cast<Real>(reference()) < 0.5 * kMaxDraw));
    REQUIRE(rng.Exponential(2.0) == -std::log(unit()) * 2.0);
    REQUIRE(rng.Rayleigh(3.0) == 3.0 * std::sqrt(-2.0 * std::log(unit())));

    Real x = 0.0;
    Real square = 1.0;
    while (square >= 1.0) {
      x = -1.0 + unit() * 2.0;
      const Real y = -1.0 + unit() * 2.0;
      square = x * x + y * y;
    }
    REQUIRE(rng.Gaussian(1.5, 4.0) == 4.0 + 1.5 * x * std::sqrt(-2.0 * std::log(square) / square));

    // smallest k whose cumulative probability reaches the draw
    const UInt32 poisson = rng.Poisson(2.5);
    const Real probability = unit();
    Real term = std::exp(-2.5);
    Real below = 0.0;
    for (UInt32 k = 0; k < poisson; ++k) {
      below += term;
      term *= 2.5 / static_cast<Real>(k + 1);
    }
    REQUIRE(below < probability);
    REQUIRE(probability <= below + term + 1e-15);
  }
}

TEST_CASE("random numbers: probabilities 0 and 1 give constant results", "[core][math]") {
  CRandom::CRNG rng(1);
  for (int i = 0; i < 1000; ++i) {
    REQUIRE_FALSE(rng.Bernoulli(0.0));
    REQUIRE(rng.Bernoulli(1.0));
    REQUIRE(rng.Poisson(0.0) == 0u);
    REQUIRE(rng.Gaussian(0.0, 3.0) == 3.0);
  }
}

TEST_CASE("random numbers: continuous distributions pass the Kolmogorov test", "[core][math]") {
  CRandom::CRNG rng(GENERATE(1u, 20u, 300u));
  CHECK(KolmogorovSmirnovExcess(Sample([&] { return rng.Uniform(CRange<Real>(-2, 6)); }),
                                [](Real x) { return (x + 2.0) / 8.0; }) < 1.0);
  CHECK(KolmogorovSmirnovExcess(Sample([&] { return rng.Exponential(3.0); }),
                                [](Real x) { return 1.0 - std::exp(-x / 3.0); }) < 1.0);
  CHECK(KolmogorovSmirnovExcess(Sample([&] { return rng.Gaussian(2.0, -1.0); }),
                                [](Real x) { return NormalDistribution(x + 1.0, 2.0); }) < 1.0);
  CHECK(KolmogorovSmirnovExcess(Sample([&] { return rng.Rayleigh(1.5); }),
                                [](Real x) { return 1.0 - std::exp(-x * x / 4.5); }) < 1.0);
  CHECK(KolmogorovSmirnovExcess(Sample([&] { return rng.Lognormal(0.5, 1.0); }), [](Real x) {
          return NormalDistribution(std::log(x) - 1.0, 0.5);
        }) < 1.0);
}

TEST_CASE("random numbers: discrete distributions pass the chi-square test", "[core][math]") {
  CRandom::CRNG rng(GENERATE(1u, 20u, 300u));
  std::vector<size_t> uniform(10);
  std::vector<size_t> poisson(10);
  std::vector<Real> poissonProbabilities(10, 0.0);
  Real term = std::exp(-3.0);
  for (UInt32 k = 0; k < 9; ++k) {
    poissonProbabilities[k] = term;
    term *= 3.0 / static_cast<Real>(k + 1);
  }
  poissonProbabilities[9] =
      1.0 - std::accumulate(poissonProbabilities.begin(), poissonProbabilities.end(), 0.0);
  Real successes = 0.0;
  for (int i = 0; i < 20000; ++i) {
    ++uniform[rng.Uniform(CRange<UInt32>(0, 10))];
    ++poisson[std::min(rng.Poisson(3.0), 9u)];
    successes += rng.Bernoulli(0.2) ? 1.0 : 0.0;
  }
  CHECK(ChiSquareExcess(uniform, std::vector<Real>(10, 0.1)) < 1.0);
  CHECK(ChiSquareExcess(poisson, poissonProbabilities) < 1.0);
  // 3.9 standard deviations, probability 1e-4
  CHECK_THAT(successes, WithinAbs(4000.0, 3.9 * std::sqrt(20000 * 0.2 * 0.8)));
}

TEST_CASE("random numbers: Poisson numbers with a large mean are correct and fast",
          "[core][math]") {
  // the method changes at 500 and at 1e6
  const Real mean = GENERATE(499.0, 501.0, 9.9e5, 1.1e6, 4e9);
  CAPTURE(mean);
  CRandom::CRNG rng(8);
  constexpr Real kCount = 4000.0;
  Real sum = 0.0;
  Real sumOfSquares = 0.0;
  for (int i = 0; i < static_cast<int>(kCount); ++i) {
    const Real deviation = (static_cast<Real>(rng.Poisson(mean)) - mean) / std::sqrt(mean);
    sum += deviation;
    sumOfSquares += deviation * deviation;
  }
  // tolerances: 4 standard deviations of the mean of 4000 standardised values and of their squares
  CHECK_THAT(sum / kCount, WithinAbs(0.0, 4.0 / std::sqrt(kCount)));
  CHECK_THAT(sumOfSquares / kCount, WithinAbs(1.0, 4.0 * std::sqrt((2.0 + 1.0 / mean) / kCount)));

  CHECK_THROWS_WITH(rng.Poisson(-1.0), Contains("-1"));
  CHECK_THROWS_AS(rng.Poisson(std::numeric_limits<Real>::quiet_NaN()), CARGoSException);
  CHECK_THROWS_AS(rng.Poisson(1e10), CARGoSException);
}

TEST_CASE("random numbers: the methods for Poisson numbers agree at their limits", "[core][math]") {
  // the adjacent mean is served by another method, with the same draws
  const Real mean = GENERATE(500.0, 1e6);
  CRandom::CRNG rng(9);
  CRandom::CRNG other(9);
  UInt32 different = 0;
  for (int i = 0; i < 5000; ++i) {
    const UInt32 value = rng.Poisson(mean);
    const UInt32 otherValue = other.Poisson(std::nextafter(mean, 1e9));
    REQUIRE(std::max(value, otherValue) - std::min(value, otherValue) <= 1);
    different += value == otherValue ? 0 : 1;
  }
  // The expansion errs by 1e-6 of a standard deviation of 1000: one
  // result in a thousand differs by 1.
  CHECK(different <= 20);
}

TEST_CASE("random numbers: shuffling follows the documented draws", "[core][math]") {
  CRandom::CRNG rng(77);
  std::mt19937 reference(77);
  std::vector<int> elements(20);
  std::iota(elements.begin(), elements.end(), 0);
  std::vector<int> expected = elements;
  rng.Shuffle(elements);
  for (UInt32 i = 0; i + 1 < expected.size(); ++i) {
    const Real span = static_cast<Real>(expected.size() - i);
    std::swap(expected[i],
              expected[i + static_cast<UInt32>(static_cast<Real>(reference()) / kMaxDraw * span)]);
  }
  CHECK(elements == expected);
  std::sort(elements.begin(), elements.end());
  for (int i = 0; i < 20; ++i) {
    CHECK(elements[static_cast<size_t>(i)] == i);
  }

  std::vector<int> none;
  CHECK_NOTHROW(rng.Shuffle(none));
  std::vector<bool> bits{true, false, false};
  rng.Shuffle(bits);
  CHECK(std::count(bits.begin(), bits.end(), true) == 1);
}

TEST_CASE("random numbers: every order of a shuffle is equally likely", "[core][math]") {
  CRandom::CRNG rng(4);
  std::vector<size_t> counts(6);
  for (int i = 0; i < 12000; ++i) {
    std::vector<int> elements{0, 1, 2};
    rng.Shuffle(elements);
    ++counts[2 * static_cast<size_t>(elements[0]) + (elements[1] > elements[2] ? 1 : 0)];
  }
  CHECK(ChiSquareExcess(counts, std::vector<Real>(6, 1.0 / 6.0)) < 1.0);
}

TEST_CASE("random categories: they are created once, found and removed", "[core][math]") {
  const CCurrentRegistry registry;
  CHECK_FALSE(CRandom::ExistsCategory("ga"));
  CHECK(CRandom::CreateCategory("ga", 7));
  CHECK_FALSE(CRandom::CreateCategory("ga", 8));
  CHECK(CRandom::GetSeedOf("ga") == 7u);
  CHECK(CRandom::GetCategory("ga").GetId() == "ga");
  CHECK(CRandom::GetCategory("ga").GetSeed() == 7u);
  CRandom::GetCategory("ga").SetId("evolution");
  CHECK(CRandom::GetCategory("ga").GetId() == "evolution");
  CRandom::SetSeedOf("ga", 9);
  CHECK(CRandom::GetSeedOf("ga") == 9u);
  CRandom::RemoveCategory("ga");
  CHECK_FALSE(CRandom::ExistsCategory("ga"));
}

TEST_CASE("random categories: an unknown category is an error that names the known ones",
          "[core][math]") {
  const CCurrentRegistry registry;
  CHECK_THROWS_WITH(CRandom::CreateRNG("argos"), Contains("\"argos\"") && Contains("none"));
  CRandom::CreateCategory("argos", 1);
  CRandom::CreateCategory("ga", 1);
  CHECK_THROWS_WITH(CRandom::GetCategory("args"),
                    Contains("\"args\"") && Contains("\"argos\", \"ga\""));
  CHECK_THROWS_AS(CRandom::RemoveCategory("args"), CARGoSException);
  CHECK_THROWS_AS(CRandom::GetSeedOf("args"), CARGoSException);
  CHECK_THROWS_AS(CRandom::SetSeedOf("args", 1), CARGoSException);
}

TEST_CASE("random categories: generators are seeded in the order of creation", "[core][math]") {
  const CCurrentRegistry registry;
  CRandom::CreateCategory("argos", 42);
  CRandom::CRNG* first = CRandom::CreateRNG("argos");
  CRandom::CRNG* second = CRandom::GetCategory("argos").CreateRNG();
  std::mt19937 seeder(42);
  const auto nextSeed = [&seeder] {
    return static_cast<UInt32>(1.0 + static_cast<Real>(seeder()) / kMaxDraw * (kMaxDraw - 1.0));
  };
  CHECK(first->GetSeed() == nextSeed());
  CHECK(second->GetSeed() == nextSeed());
  CRandom::CRNG same(first->GetSeed());
  CHECK(DrawSome(*first) == DrawSome(same));
}

TEST_CASE("random categories: a reset repeats all streams", "[core][math]") {
  const CCurrentRegistry registry;
  CRandom::CreateCategory("argos", 42);
  CRandom::CreateCategory("ga", 43);
  CRandom::CRNG* first = CRandom::CreateRNG("argos");
  CRandom::CRNG* second = CRandom::CreateRNG("argos");
  CRandom::CRNG* other = CRandom::CreateRNG("ga");
  const std::vector<Real> firstStart = DrawSome(*first);
  const std::vector<Real> secondStart = DrawSome(*second);
  const std::vector<Real> otherStart = DrawSome(*other);
  CRandom::Reset();
  CHECK(DrawSome(*second) == secondStart);
  CHECK(DrawSome(*first) == firstStart);
  CHECK(DrawSome(*other) == otherStart);

  SECTION("generators created after a reset equal those created without it") {
    CRandom::CRNG* third = CRandom::CreateRNG("argos");
    CRandom::CRegistry fresh;
    fresh.CreateCategory("argos", 42);
    fresh.GetCategory("argos").CreateRNG();
    fresh.GetCategory("argos").CreateRNG();
    CHECK(DrawSome(*third) == DrawSome(*fresh.GetCategory("argos").CreateRNG()));
  }
  SECTION("a new seed of the category takes effect at its reset") {
    CRandom::SetSeedOf("argos", 44);
    const UInt32 seedBefore = first->GetSeed();
    CHECK(first->GetSeed() == seedBefore);
    CRandom::GetCategory("argos").ResetRNGs();
    CRandom::CCategory fresh("argos", 44);
    CHECK(first->GetSeed() == fresh.CreateRNG()->GetSeed());
    CHECK(second->GetSeed() == fresh.CreateRNG()->GetSeed());
    CHECK(DrawSome(*first) != firstStart);
  }
  SECTION("reseeding assigns new seeds that take effect at the generators' own reset") {
    const UInt32 seedBefore = first->GetSeed();
    const std::vector<Real> next = [&] {
      CRandom::CRNG copy(*first);
      return DrawSome(copy);
    }();
    CRandom::GetCategory("argos").ReseedRNGs();
    CHECK(first->GetSeed() != seedBefore);
    CHECK(DrawSome(*first) == next);
    first->Reset();
    CRandom::CRNG fresh(first->GetSeed());
    CHECK(DrawSome(*first) == DrawSome(fresh));
  }
}

TEST_CASE("random registries: each thread has a current one, and the default is shared",
          "[core][math]") {
  CRandom::CRegistry mine;
  CRandom::CRegistry& shared = CRandom::GetCurrentRegistry();
  CRandom::SetCurrentRegistry(&mine);
  CHECK(&CRandom::GetCurrentRegistry() == &mine);
  CRandom::CreateCategory("argos", 1);
  CHECK(mine.ExistsCategory("argos"));
  CHECK_FALSE(shared.ExistsCategory("argos"));

  bool otherSawShared = false;
  bool otherHasOwn = false;
  std::thread other([&] {
    otherSawShared = &CRandom::GetCurrentRegistry() == &shared;
    CRandom::CRegistry own;
    CRandom::SetCurrentRegistry(&own);
    otherHasOwn = CRandom::CreateCategory("argos", 2) && CRandom::GetSeedOf("argos") == 2;
  });
  other.join();
  CHECK(otherSawShared);
  CHECK(otherHasOwn);
  CHECK(CRandom::GetSeedOf("argos") == 1u);
  mine.RemoveCategory("argos");
  CHECK_FALSE(CRandom::ExistsCategory("argos"));
  CRandom::SetCurrentRegistry(nullptr);
  CHECK(&CRandom::GetCurrentRegistry() == &shared);

  // a registry that is destroyed does not stay current
  {
    CRandom::CRegistry shortLived;
    CRandom::SetCurrentRegistry(&shortLived);
  }
  CHECK(&CRandom::GetCurrentRegistry() == &shared);
}

}  // namespace rng_test
