#ifndef ARGOS3_CORE_UTILITY_MATH_RANDOM_STREAM_H
#define ARGOS3_CORE_UTILITY_MATH_RANDOM_STREAM_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <array>
#include <string_view>

namespace argos {

/**
 * A small generator for the simulator's own noise; its distributions do not depend on the standard
 * library.
 *
 * A stream is identified by the experiment's seed, a category, the id of its owner and a purpose.
 * The same four always give the same numbers, independently of other streams, creation order and
 * threads; different ones give unrelated streams. 40 bytes, no heap; one thread at a time.
 *
 * Every distribution takes exactly one 64-bit number per value (UniformInteger rarely more).
 *
 * Generator: xoshiro256**, D. Blackman and S. Vigna, "Scrambled linear pseudorandom number
 * generators", ACM TOMS 47 (2021); period 2^256 - 1. Seeded by SplitMix64 from a hash of the name,
 * as the authors advise.
 */
class CRandomStream {
 public:
  /**
   * @param seed      the experiment's seed.
   * @param category  separates sets of streams, "argos" for the simulator's.
   * @param owner     the id of the robot or object that draws from the stream.
   * @param purpose   use of the numbers, "proximity noise"; separates the streams of one owner.
   */
  CRandomStream(UInt64 seed, std::string_view category, std::string_view owner,
                std::string_view purpose);

  /** Returns to the start of the stream. */
  void Reset();

  /** Returns the next 64 random bits. */
  UInt64 Next() {
    const UInt64 result = RotateLeft(m_state[1] * 5, 7) * 9;
    const UInt64 shifted = m_state[1] << 17;
    m_state[2] ^= m_state[0];
    m_state[3] ^= m_state[1];
    m_state[1] ^= m_state[2];
    m_state[0] ^= m_state[3];
    m_state[2] ^= shifted;
    m_state[3] = RotateLeft(m_state[3], 45);
    return result;
  }

  /** Returns a multiple of 2^-53 in [0,1). */
  Real Uniform01() { return static_cast<Real>(Next() >> 11) * kUnit; }

  /** Returns a number in [min,max); max itself only by rounding. */
  Real Uniform(Real min, Real max) { return min + (max - min) * Uniform01(); }

  /** Returns true with the given probability: never for 0, always for 1. */
  bool Bernoulli(Real probability = 0.5) { return Uniform01() < probability; }

  /**
   * Returns one of the numbers 0, ..., count - 1, with exactly equal probability.
   *
   * @param count  must not be 0.
   */
  UInt64 UniformInteger(UInt64 count);

  /** Returns one of the numbers min, ..., max, both included; min <= max is required. */
  SInt64 UniformInteger(SInt64 min, SInt64 max) {
    const UInt64 count = static_cast<UInt64>(max) - static_cast<UInt64>(min) + 1;
    // a count of 0 means all 2^64 numbers
    return static_cast<SInt64>(static_cast<UInt64>(min) +
                               (count == 0 ? Next() : UniformInteger(count)));
  }

  /** Standard deviation first, as in CRandom::CRNG. The result is within 8.3 standard deviations of
   * the mean. */
  Real Gaussian(Real standardDeviation, Real mean = 0.0);

  /** Returns a value >= 0 with density x / sigma^2 exp(-x^2 / (2 sigma^2)). */
  Real Rayleigh(Real sigma);

 private:
  static constexpr Real kUnit = 1.0 / 9007199254740992.0;  // 2^-53

  static constexpr UInt64 RotateLeft(UInt64 value, int count) {
    return (value << count) | (value >> (64 - count));
  }

  UInt64 m_key;
  std::array<UInt64, 4> m_state;
};

}  // namespace argos

#endif
