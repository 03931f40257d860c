#include <argos3/core/utility/datatypes/digest.h>

#include <catch2/catch.hpp>

#include <bitset>
#include <set>
#include <vector>

namespace digest_test {

using namespace argos;

namespace {

template <typename... VALUES>
UInt64 DigestOf(const VALUES&... values) {
  CDigest digest;
  (digest.Add(values), ...);
  return digest.GetValue();
}

}  // namespace

TEST_CASE("digest: it is that of the documented mixing step on every machine", "[core][digest]") {
  // computed outside this program: a text is its length and its bytes
  CHECK(DigestOf(1, 2.5, std::string("fb0"), true) == 0xf8c2becc35cb7dc3ULL);
}

TEST_CASE("digest: order, value and number of values change it", "[core][digest]") {
  const std::set<UInt64> digests = {DigestOf(),        DigestOf(0),      DigestOf(0, 0),
                                    DigestOf(1, 2),    DigestOf(2, 1),   DigestOf(1),
                                    DigestOf(0, 1, 2), DigestOf(1, 2, 0)};
  CHECK(digests.size() == 8);
}

TEST_CASE("digest: texts with equal concatenation have different digests", "[core][digest]") {
  const std::string a = "a";
  const std::string ab = "ab";
  const std::string b = "b";
  const std::string bc = "bc";
  const std::string c = "c";
  CHECK(DigestOf(ab, c) != DigestOf(a, bc));
  CHECK(DigestOf(std::string(), a) != DigestOf(a, std::string()));
  CHECK(DigestOf(a, b) != DigestOf(ab));
}

TEST_CASE("digest: every single bit of a number changes it", "[core][digest]") {
  // Step i of the mixing is a bijection of the state, so two inputs that differ in one word cannot
  // collide until another word is added.
  std::set<UInt64> digests = {DigestOf(UInt64(0))};
  for (int bit = 0; bit < 64; ++bit) {
    digests.insert(DigestOf(UInt64(1) << bit));
  }
  CHECK(digests.size() == 65);
}

TEST_CASE("digest: numbers are hashed by their bits", "[core][digest]") {
  CHECK(DigestOf(0.0) != DigestOf(-0.0));
  CHECK(DigestOf(1.0) != DigestOf(1.0 + 2.220446049250313e-16));
}

TEST_CASE("digest: one changed bit changes about half of the digest's bits", "[core][digest]") {
  // 64 independent fair bits have mean 32 and standard deviation 4; the mean of 6400 such flips is
  // within 4 standard deviations of the mean, 4 * 4 / sqrt(6400) = 0.2, with 99.99 % probability
  double flipped = 0.0;
  int pairs = 0;
  for (UInt64 value = 0; value < 100; ++value) {
    for (int bit = 0; bit < 64; ++bit) {
      const UInt64 difference =
          DigestOf(value, UInt64(7)) ^ DigestOf(value ^ (UInt64(1) << bit), UInt64(7));
      flipped += static_cast<double>(std::bitset<64>(difference).count());
      ++pairs;
    }
  }
  CHECK_THAT(flipped / pairs, Catch::WithinAbs(32.0, 0.2));
}

}  // namespace digest_test
