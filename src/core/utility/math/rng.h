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
 * A category seeds its generators from its own seed, in the order of their creation. The simulator
 * creates the category "argos" with the experiment's seed. (The simulator's own noise uses
 * CRandomStream, whose seeds do not depend on any order.)
 *
 * A generator that a robot's controller or devices create is destroyed with them: see COwner in
 * rng_owner.h, which also says how those of robots added during a run are seeded.
 *
 * Categories belong to a registry. The static functions act on the current registry of the calling
 * thread: the one set with SetCurrentRegistry(), otherwise the shared one. A registry, its
 * categories and its generators may be used by one thread at a time, except that CreateRNG() may be
 * called by several threads.
 */
class CRandom {
 public:
  class CRNG;
  class CCategory;
  class COwner;
  class CRegistry;

  /** Does nothing and returns false if the category exists. */
  static bool CreateCategory(const std::string& category, UInt32 seed);

  /** @throws CARGoSException if there is no such category. */
  static CCategory& GetCategory(const std::string& category);

  static bool ExistsCategory(const std::string& category);

  /** Also destroys the generators of the category. @throws CARGoSException if there is no such
   * category. */
  static void RemoveCategory(const std::string& category);

  /** Returns a new generator, owned by the category; it is destroyed earlier if its current owner
   * is. @throws CARGoSException if there is no such category. */
  static CRNG* CreateRNG(const std::string& category);

  /** @throws CARGoSException if there is no such category. */
  static UInt32 GetSeedOf(const std::string& category);

  /** See CCategory::SetSeed(). @throws CARGoSException if there is no such category. */
  static void SetSeedOf(const std::string& category, UInt32 seed);

  /** Calls ResetRNGs() on every category, in the order of their ids. */
  static void Reset();

  /**
   * Sets the current registry of the calling thread; null selects the shared one.
   * @return what was set before; null if nothing was.
   */
  static CRegistry* SetCurrentRegistry(CRegistry* registry);

  static CRegistry& GetCurrentRegistry();

  /**
   * Sets the shared registry, that of threads which have set none; null selects that of the
   * process. The simulator sets that of the only experiment.
   */
  static void SetSharedRegistry(CRegistry* registry);

  /** The registry that exists as long as the process. */
  static CRegistry& GetProcessRegistry();
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

  /** Returns to the start of the seed's stream. */
  void Reset();

  /** Returns true with the given probability; one draw. */
  bool Bernoulli(Real probability = 0.5);

  /** Returns min + r (max - min), in [min,max]; one draw. */
  CRadians Uniform(const CRange<CRadians>& range);
  Real Uniform(const CRange<Real>& range);

  /**
   * Returns min + r (max - min) truncated towards zero; one draw.
   *
   * The maximum has a probability of 2^-32 only: a range of non-negative numbers is effectively
   * [min,max).
   */
  SInt32 Uniform(const CRange<SInt32>& range);
  UInt32 Uniform(const CRange<UInt32>& range);

  /**
   * Returns -mean log(r); one draw. A draw of 0 counts as half of the smallest step, so the result
   * is finite.
   */
  Real Exponential(Real mean);

  /**
   * Inverts the cumulative distribution at r; one draw.
   *
   * @throws CARGoSException if the mean is negative, not a number, or above 4e9.
   */
  UInt32 Poisson(Real mean);

  /**
   * The standard deviation is the first argument. Polar Box-Muller method, an even number of draws.
   */
  Real Gaussian(Real standardDeviation, Real mean = 0.0);

  /** Returns sigma sqrt(-2 log(r)) with r strictly inside (0,1). */
  Real Rayleigh(Real sigma);

  /** Returns exp(mu + sigma Gaussian(1,0)). */
  Real Lognormal(Real sigma, Real mu);

  /** Shuffles the elements; one draw for each element except the last. */
  template <typename T>
  void Shuffle(std::vector<T>& elements) {
    const UInt32 count = static_cast<UInt32>(elements.size());
    for (UInt32 i = 0; i + 1 < count; ++i) {
      // the range includes its maximum, though rarely, which would be one too many
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
  /** Destroys the generators. */
  ~CCategory();

  CCategory(const CCategory&) = delete;
  CCategory& operator=(const CCategory&) = delete;

  const std::string& GetId() const { return m_id; }

  /** Changes the result of GetId(), not the name under which the category is found. */
  void SetId(const std::string& id) { m_id = id; }

  UInt32 GetSeed() const { return m_seed; }

  /** Stores the seed; it takes effect at the next ResetRNGs(). */
  void SetSeed(UInt32 seed) { m_seed = seed; }

  /**
   * Returns a new generator with the next seed, uniform in [1, 2^32-1]. It belongs to the category
   * and to the thread's current COwner, if there is one. Safe on several threads at once.
   */
  CRNG* CreateRNG();

  /** Returns to the start: seeds every generator as at the start, and resets it. */
  void ResetRNGs();

  /**
   * Gives every generator its next seed, in the order of creation; it takes effect at the
   * generator's next Reset().
   */
  void ReseedRNGs();

  /** The number of generators that exist. */
  size_t GetNumRNGs() const { return m_generators.size(); }

 private:
  friend class COwner;

  struct SGenerator {
    std::unique_ptr<CRNG> Generator;
    COwner* Owner;  // null: lives as long as the category
    UInt32 Place;  // number of generators of the category that its owner had before
    UInt64 Birth;  // see COwner::CScope
    size_t Ordinal;  // index of its seed, if it has no owner
  };

  UInt32 DrawSeed();
  void Reseed();
  UInt32 ComputeSeed(const SGenerator& generator) const;
  /** The index of the seed of what the owner created while loading; null if there is none. */
  const size_t* FindOrdinal(const COwner& owner, UInt32 place) const;

  std::string m_id;
  UInt32 m_seed;
  CRNG m_seeder;
  std::vector<UInt32> m_seeds;  // drawn from the seeder, for destroyed generators, too
  UInt64 m_round = 0;  // calls of ReseedRNGs() since the start
  UInt64 m_nextSerial = 0;
  std::map<UInt64, SGenerator> m_generators;  // indexed by serial number: in the order of creation
  // generators that owners created while loading, by id and place: the indices of the seeds
  std::map<std::pair<std::string, UInt32>, size_t> m_ordinalsAtStart;
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
  /** Their ids, in ascending order. */
  std::vector<std::string> ListCategories() const;
  void Reset();

 private:
  std::map<std::string, std::unique_ptr<CCategory> > m_categories;
};

}  // namespace argos

#endif
