#include <argos3/core/utility/math/random_stream.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/normal_quantile.h>

#include <cmath>

namespace argos {

namespace {

// Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014, with the
// constants of Vigna's splitmix64.c
constexpr UInt64 kGoldenGamma = 0x9e3779b97f4a7c15ULL;

constexpr UInt64 Mix(UInt64 value) {
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

// FNV-1a (Fowler, Noll, Vo; 64 bits) of the text, mixed into the hash. The length is included, so
// moving a letter from one text to the next changes the result
UInt64 Absorb(UInt64 hash, std::string_view text) {
  UInt64 textHash = 0xcbf29ce484222325ULL;
  for (const char letter : text) {
    textHash = (textHash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  }
  return Mix(Mix(hash + kGoldenGamma * (text.size() + 1)) ^ textHash);
}

}  // namespace

CRandomStream::CRandomStream(UInt64 seed, std::string_view category, std::string_view owner,
                             std::string_view purpose)
    : m_key(Absorb(Absorb(Absorb(Mix(seed + kGoldenGamma), category), owner), purpose)), m_state() {
  Reset();
}

void CRandomStream::Reset() {
  // SplitMix64 never returns four zeros in a row, the one invalid state of xoshiro
  UInt64 counter = m_key;
  for (UInt64& word : m_state) {
    counter += kGoldenGamma;
    word = Mix(counter);
  }
}

UInt64 CRandomStream::UniformInteger(UInt64 count) {
  ARGOS_ASSERT(count > 0, "UniformInteger() needs at least one number to choose from.");
  // D. Lemire, "Fast random integer generation in an interval", ACM TOMACS 29 (2019)
  __extension__ using TWide = unsigned __int128;
  TWide product = static_cast<TWide>(Next()) * count;
  if (static_cast<UInt64>(product) < count) {
    const UInt64 unfair = (0 - count) % count;
    while (static_cast<UInt64>(product) < unfair) {
      product = static_cast<TWide>(Next()) * count;
    }
  }
  return static_cast<UInt64>(product >> 64);
}

Real CRandomStream::Gaussian(Real standardDeviation, Real mean) {
  // the middle of one of 2^53 equal intervals of (-1/2, 1/2): symmetric, and never at a bound
  const SInt64 step = static_cast<SInt64>(Next() >> 11) - (1LL << 52);
  return mean + standardDeviation * ComputeNormalQuantile((static_cast<Real>(step) + 0.5) * kUnit);
}

Real CRandomStream::Rayleigh(Real sigma) {
  // 1 - u is in (0,1], so the logarithm is finite
  return sigma * std::sqrt(-2.0 * std::log(1.0 - Uniform01()));
}

}  // namespace argos
