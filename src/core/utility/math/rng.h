#ifndef ARGOS3_CORE_UTILITY_MATH_RNG_H
#define ARGOS3_CORE_UTILITY_MATH_RNG_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/range.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/**
 * Random numbers for user code: Mersenne Twisters grouped in categories.
 *
 * A category seeds its generators from its own seed, in the order in which they are created; so a
 * program that creates them in the same order gets the same numbers. The simulator makes the
 * category "argos" with the experiment's seed. (The program's own noise uses CRandomStream, whose
 * seeds do not depend on any order.)
 *
 * Categories live in a registry. The static functions act on the registry that is current in the
 * calling thread: the one set with SetCurrentRegistry(), or else one that the whole process shares.
 * A registry, its categories and its generators may be used by one thread at a time.
 */
class CRandom {
 public:
  class CRNG;
  class CCategory;
  class CRegistry;

  /** Returns false if the category exists already; then nothing changes. */
  static bool CreateCategory(const std::string& category, UInt32 seed);

  /** @throws CARGoSException if there is no such category. */
  static CCategory& GetCategory(const std::string& category);

  static bool ExistsCategory(const std::string& category);

  /** Also destroys the generators of the category. @throws CARGoSException if there is no such
   * category. */
  static void RemoveCategory(const std::string& category);

  /** Returns a new generator, owned by the category. @throws CARGoSException if there is no such
   * category. */
  static CRNG* CreateRNG(const std::string& category);

  /** @throws CARGoSException if there is no such category. */
  static UInt32 GetSeedOf(const std::string& category);

  /** See CCategory::SetSeed(). @throws CARGoSException if there is no such category. */
  static void SetSeedOf(const std::string& category, UInt32 seed);

  /** Calls ResetRNGs() on every category, in the order of their ids. */
  static void Reset();

  /** Makes a registry current in the calling thread; null stands for the one that the process
   * shares. */
  static void SetCurrentRegistry(CRegistry* registry);

  static CRegistry& GetCurrentRegistry();
};

/**
 * A Mersenne Twister (MT19937) with the stream of std::mt19937, and distributions on it.
 *
 * A draw u is a 32-bit number; r = u / (2^32-1) lies in [0,1], both bounds possible.
 * Generator: GSL's gsl_rng_mt19937, after M. Matsumoto and T. Nishimura, ACM TOMACS 8 (1998), with
 * the initialisation of 2002.
 */
class CRandom::CRNG {
 public:
  CRNG(UInt32 seed);

  /** Duplicates the state. */
  CRNG(const CRNG& other);
  CRNG& operator=(const CRNG& other);

  ~CRNG();

  UInt32 GetSeed() const { return m_seed; }

  /** Takes effect at the next Reset(). */
  void SetSeed(UInt32 seed) { m_seed = seed; }

  /** Goes back to the start of the seed's stream. */
  void Reset();

  /** Returns true with the given probability; one draw. */
  bool Bernoulli(Real probability = 0.5);

  /** Returns min + r (max - min), in [min,max]; one draw. */
  CRadians Uniform(const CRange<CRadians>& range);
  Real Uniform(const CRange<Real>& range);

  /**
   * Returns min + r (max - min) truncated towards zero; one draw.
   *
   * The maximum comes up with a probability of 2^-32 only: a range of non-negative numbers is
   * effectively [min,max).
   */
  SInt32 Uniform(const CRange<SInt32>& range);
  UInt32 Uniform(const CRange<UInt32>& range);

  /** Returns -mean log(r); one draw. A draw of 0 counts as half of the smallest step, so the result
   * is finite. */
  Real Exponential(Real mean);

  /**
   * Inverts the cumulative distribution at r; one draw.
   *
   * @throws CARGoSException if the mean is negative, not a number, or above 4e9.
   */
  UInt32 Poisson(Real mean);

  /** Beware of the order: the standard deviation comes first. Polar Box-Muller method, an even
   * number of draws. */
  Real Gaussian(Real standardDeviation, Real mean = 0.0);

  /** Returns sigma sqrt(-2 log(r)) with r strictly inside (0,1). */
  Real Rayleigh(Real sigma);

  /** Returns exp(mu + sigma Gaussian(1,0)). */
  Real Lognormal(Real sigma, Real mu);

  /** Puts the elements in random order; one draw for each element but the last. */
  template <typename T>
  void Shuffle(std::vector<T>& elements) {
    const UInt32 count = static_cast<UInt32>(elements.size());
    for (UInt32 i = 0; i + 1 < count; ++i) {
      // the maximum of the range, possible though rare, is one too many
      const UInt32 offset = Uniform(CRange<UInt32>(0, count - i));
      using std::swap;
      swap(elements[i], elements[offset < count - i ? i + offset : count - 1]);
    }
  }

 private:
  class CGenerator;

  UInt32 Draw();
  Real DrawUnit();

  UInt32 m_seed;
  std::unique_ptr<CGenerator> m_generator;
};

/** A group of generators that are seeded from one number. */
class CRandom::CCategory {
 public:
  CCategory(const std::string& id, UInt32 seed);

  const std::string& GetId() const { return m_id; }

  /** Changes what GetId() returns, not the name under which the category is found. */
  void SetId(const std::string& id) { m_id = id; }

  UInt32 GetSeed() const { return m_seed; }

  /** Stores the seed; it takes effect at the next ResetRNGs(). */
  void SetSeed(UInt32 seed) { m_seed = seed; }

  /** Returns a new generator, owned by the category, with the next seed, uniform in [1, 2^32-1]. */
  CRNG* CreateRNG();

  /** Goes back to the start: seeds every generator again, in the order of creation, and resets it.
   */
  void ResetRNGs();

  /** Gives every generator the next seed, in the order of creation; each takes it up at its next
   * Reset(). */
  void ReseedRNGs();

 private:
  UInt32 DrawSeed();

  std::string m_id;
  UInt32 m_seed;
  CRNG m_seeder;
  std::vector<std::unique_ptr<CRNG> > m_generators;
};

/** The categories of one simulation; see the functions of CRandom with the same names. */
class CRandom::CRegistry {
 public:
  CRegistry();
  ~CRegistry();

  CRegistry(const CRegistry&) = delete;
  CRegistry& operator=(const CRegistry&) = delete;

  bool CreateCategory(const std::string& category, UInt32 seed);
  CCategory& GetCategory(const std::string& category);
  bool ExistsCategory(const std::string& category) const;
  void RemoveCategory(const std::string& category);
  void Reset();

 private:
  std::map<std::string, std::unique_ptr<CCategory> > m_categories;
};

}  // namespace argos

#endif
