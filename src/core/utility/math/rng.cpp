#include <argos3/core/utility/math/rng.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/normal_quantile.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/math/rng_owner.h>
#include <argos3/core/utility/text/lists.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_rng.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

namespace argos {

namespace {

constexpr Real kMaxDraw = 4294967295.0;  // 2^32 - 1

// up to this mean the terms of a Poisson distribution can be summed from 0 without underflow of
// exp(-mean)
constexpr Real kMaxMeanSummed = 500.0;

// up to this mean GSL's cumulative distribution is accurate; from 1e7 on it reports errors
constexpr Real kMaxMeanBisected = 1e6;

// larger means would exceed UInt32
constexpr Real kMaxPoissonMean = 4e9;

// smallest k with P(X <= k) >= probability, by summation
UInt32 InvertPoissonBySumming(Real probability, Real mean) {
  Real term = std::exp(-mean);
  Real sum = term;
  UInt32 k = 0;
  while (sum < probability) {
    ++k;
    term *= mean / static_cast<Real>(k);
    // a probability of 1 is not reached: stop when the sum no longer grows
    if (static_cast<Real>(k) > mean && sum + term == sum) {
      break;
    }
    sum += term;
  }
  return k;
}

// the same by bisection of the cumulative distribution
UInt32 InvertPoissonByBisection(Real probability, Real mean) {
  UInt32 below = 0;
  // 10 standard deviations are beyond every probability that a 32-bit draw can express
  UInt32 above = static_cast<UInt32>(mean + 10.0 * std::sqrt(mean));
  while (below < above) {
    const UInt32 middle = below + (above - below) / 2;
    if (gsl_cdf_poisson_P(middle, mean) >= probability) {
      above = middle;
    } else {
      below = middle + 1;
    }
  }
  return below;
}

// the same by the Cornish-Fisher expansion of the normal quantile up to 1/mean: the error is below
// 1e-6 standard deviations. Abramowitz and Stegun, Handbook of Mathematical Functions, 26.2.49,
// with the cumulants of the Poisson distribution
UInt32 InvertPoissonByExpansion(Real probability, Real mean) {
  const Real halfStep = 0.5 / kMaxDraw;
  const Real z = ComputeNormalQuantile(std::clamp(probability, halfStep, 1.0 - halfStep) - 0.5);
  const Real deviation = std::sqrt(mean);
  const Real w = z + (z * z - 1.0) / (6.0 * deviation) + (z - z * z * z) / (72.0 * mean);
  return static_cast<UInt32>(std::ceil(mean + deviation * w - 0.5));
}

UInt32 InvertPoisson(Real probability, Real mean) {
  if (mean <= kMaxMeanSummed) {
    return InvertPoissonBySumming(probability, mean);
  }
  return mean <= kMaxMeanBisected ? InvertPoissonByBisection(probability, mean)
                                  : InvertPoissonByExpansion(probability, mean);
}

thread_local CRandom::CRegistry* currentRegistry = nullptr;
std::atomic<CRandom::CRegistry*> sharedRegistry{nullptr};  // null: that of the process

// guards the lists of generators of all categories and owners: robots may create generators in a
// phase of a tick
std::mutex& GetGeneratorsMutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

/** Owns the state of GSL's generator; keeps GSL out of the header. */
class CRandom::CRNG::CGenerator {
 public:
  explicit CGenerator(UInt32 seed) : m_state(gsl_rng_alloc(gsl_rng_mt19937)) { Seed(seed); }

  CGenerator(const CGenerator& other) : m_state(gsl_rng_clone(other.m_state.get())) {}

  CGenerator& operator=(const CGenerator& other) = delete;

  void Seed(UInt32 seed) {
    // GSL replaces the seed 0 by its default, 4357, but uses only the low 32 bits of others: 2^32
    // is the seed 0 of std::mt19937
    static_assert(std::numeric_limits<unsigned long>::digits > 32,
                  "the seed 0 needs a 64-bit unsigned long");
    gsl_rng_set(m_state.get(), seed == 0 ? (1UL << 32) : seed);
  }

  UInt32 Draw() { return static_cast<UInt32>(gsl_rng_get(m_state.get())); }

 private:
  struct SDeleter {
    void operator()(gsl_rng* state) const { gsl_rng_free(state); }
  };

  std::unique_ptr<gsl_rng, SDeleter> m_state;
};

CRandom::CRNG::CRNG(UInt32 seed) : m_seed(seed), m_generator(std::make_unique<CGenerator>(seed)) {}

CRandom::CRNG::CRNG(const CRNG& other)
    : m_seed(other.m_seed), m_generator(std::make_unique<CGenerator>(*other.m_generator)) {}

CRandom::CRNG& CRandom::CRNG::operator=(const CRNG& other) {
  m_seed = other.m_seed;
  m_generator = std::make_unique<CGenerator>(*other.m_generator);
  return *this;
}

CRandom::CRNG::~CRNG() = default;

void CRandom::CRNG::Reset() {
  m_generator->Seed(m_seed);
}

UInt32 CRandom::CRNG::Draw() {
  return m_generator->Draw();
}

Real CRandom::CRNG::DrawUnit() {
  return static_cast<Real>(Draw()) / kMaxDraw;
}

bool CRandom::CRNG::Bernoulli(Real probability) {
  return static_cast<Real>(Draw()) < probability * kMaxDraw;
}

CRadians CRandom::CRNG::Uniform(const CRange<CRadians>& range) {
  return range.GetMin() + DrawUnit() * range.GetSpan();
}

Real CRandom::CRNG::Uniform(const CRange<Real>& range) {
  return range.GetMin() + DrawUnit() * range.GetSpan();
}

SInt32 CRandom::CRNG::Uniform(const CRange<SInt32>& range) {
  // the span is computed in Real, because that of the whole range does not fit SInt32
  const Real min = static_cast<Real>(range.GetMin());
  return static_cast<SInt32>(min + DrawUnit() * (static_cast<Real>(range.GetMax()) - min));
}

UInt32 CRandom::CRNG::Uniform(const CRange<UInt32>& range) {
  return static_cast<UInt32>(static_cast<Real>(range.GetMin()) +
                             DrawUnit() * static_cast<Real>(range.GetSpan()));
}

Real CRandom::CRNG::Exponential(Real mean) {
  const UInt32 draw = Draw();
  return -std::log((draw == 0 ? 0.5 : static_cast<Real>(draw)) / kMaxDraw) * mean;
}

UInt32 CRandom::CRNG::Poisson(Real mean) {
  if (!(mean >= 0.0 && mean <= kMaxPoissonMean)) {
    THROW_ARGOSEXCEPTION("The mean of a Poisson distribution is " << mean << "; it must be in [0,"
                                                                  << kMaxPoissonMean << "].");
  }
  return InvertPoisson(DrawUnit(), mean);
}

Real CRandom::CRNG::Gaussian(Real standardDeviation, Real mean) {
  const CRange<Real> signedUnit(-1.0, 1.0);
  Real x = 0.0;
  Real squareRadius = 0.0;
  do {
    x = Uniform(signedUnit);
    const Real y = Uniform(signedUnit);
    squareRadius = x * x + y * y;
  } while (squareRadius >= 1.0 || squareRadius == 0.0);
  return mean + standardDeviation * x * std::sqrt(-2.0 * std::log(squareRadius) / squareRadius);
}

Real CRandom::CRNG::Rayleigh(Real sigma) {
  Real unit = 0.0;
  do {
    unit = DrawUnit();
  } while (unit <= 0.0 || unit >= 1.0);
  return sigma * std::sqrt(-2.0 * std::log(unit));
}

Real CRandom::CRNG::Lognormal(Real sigma, Real mu) {
  return std::exp(mu + sigma * Gaussian(1.0, 0.0));
}

CRandom::CCategory::CCategory(const std::string& id, UInt32 seed)
    : m_id(id), m_seed(seed), m_seeder(seed) {}

CRandom::CCategory::~CCategory() {
  const std::lock_guard<std::mutex> lock(GetGeneratorsMutex());
  for (const auto& entry : m_generators) {
    if (entry.second.Owner != nullptr) {
      entry.second.Owner->Forget(*this);
    }
  }
}

UInt32 CRandom::CCategory::DrawSeed() {
  m_seeds.push_back(m_seeder.Uniform(CRange<UInt32>(1, std::numeric_limits<UInt32>::max())));
  return m_seeds.back();
}

const size_t* CRandom::CCategory::FindOrdinal(const COwner& owner, UInt32 place) const {
  const auto found = m_ordinalsAtStart.find({owner.GetId(), place});
  return found != m_ordinalsAtStart.end() ? &found->second : nullptr;
}

// seed of a generator of an owner that did not exist at the start
UInt32 CRandom::CCategory::ComputeSeed(const SGenerator& generator) const {
  const std::string purpose = std::to_string(generator.Birth) + ' ' +
                              std::to_string(generator.Place) + ' ' + std::to_string(m_round);
  CRandomStream stream(m_seeder.GetSeed(), m_id, generator.Owner->GetId(), purpose);
  return static_cast<UInt32>(
      stream.UniformInteger(SInt64(1), SInt64(std::numeric_limits<UInt32>::max())));
}

CRandom::CRNG* CRandom::CCategory::CreateRNG() {
  const std::lock_guard<std::mutex> lock(GetGeneratorsMutex());
  const COwner::CScope::SCurrent& current = COwner::CScope::GetCurrent();
  COwner* const owner = current.Owner;
  SGenerator generator{nullptr, owner, 0, current.Birth, m_seeds.size()};
  UInt32 seed = 0;
  if (owner == nullptr) {
    seed = DrawSeed();
  } else {
    generator.Place = owner->CountOf(*this);
    const size_t* const ordinal = FindOrdinal(*owner, generator.Place);
    if (current.Birth == COwner::CScope::kLoading) {
      m_ordinalsAtStart[{owner->GetId(), generator.Place}] = m_seeds.size();
      seed = DrawSeed();
    } else {
      seed = current.Birth == 0 && ordinal != nullptr ? m_seeds[*ordinal] : ComputeSeed(generator);
    }
    owner->m_generators.push_back({this, m_nextSerial});
  }
  generator.Generator = std::make_unique<CRNG>(seed);
  CRNG* const created = generator.Generator.get();
  m_generators.emplace_hint(m_generators.end(), m_nextSerial++, std::move(generator));
  return created;
}

void CRandom::CCategory::ResetRNGs() {
  m_seeder.SetSeed(m_seed);
  m_seeder.Reset();
  m_round = 0;
  Reseed();
  for (const auto& entry : m_generators) {
    entry.second.Generator->Reset();
  }
}

void CRandom::CCategory::ReseedRNGs() {
  ++m_round;
  Reseed();
}

// draws all seeds again, also those of destroyed generators
void CRandom::CCategory::Reseed() {
  const size_t numSeeds = m_seeds.size();
  m_seeds.clear();
  for (size_t i = 0; i < numSeeds; ++i) {
    DrawSeed();
  }
  for (const auto& entry : m_generators) {
    const SGenerator& generator = entry.second;
    const size_t* ordinal = &generator.Ordinal;
    if (generator.Owner != nullptr) {
      ordinal = FindOrdinal(*generator.Owner, generator.Place);
    }
    generator.Generator->SetSeed(ordinal != nullptr ? m_seeds[*ordinal] : ComputeSeed(generator));
  }
}

void CRandom::COwner::DestroyGenerators() {
  if (m_generators.empty()) {
    return;
  }
  const std::lock_guard<std::mutex> lock(GetGeneratorsMutex());
  for (const SReference& reference : m_generators) {
    reference.Category->m_generators.erase(reference.Serial);
  }
  m_generators.clear();
}

UInt32 CRandom::COwner::CountOf(const CCategory& category) const {
  return static_cast<UInt32>(std::ranges::count(m_generators, &category, &SReference::Category));
}

void CRandom::COwner::Forget(const CCategory& category) {
  std::erase_if(m_generators,
                [&](const SReference& reference) { return reference.Category == &category; });
}

CRandom::COwner::CScope::SCurrent& CRandom::COwner::CScope::GetCurrent() {
  thread_local SCurrent current{nullptr, 0};
  return current;
}

CRandom::COwner::CScope::CScope(COwner* owner, UInt64 birth)
    : m_current(GetCurrent()), m_previous(m_current) {
  m_current = {owner, birth};
}

CRandom::COwner::CScope::~CScope() {
  m_current = m_previous;
}

CRandom::CRegistry::CRegistry() = default;

CRandom::CRegistry::~CRegistry() {
  if (currentRegistry == this) {
    currentRegistry = nullptr;
  }
  CRegistry* expected = this;
  sharedRegistry.compare_exchange_strong(expected, nullptr);
}

bool CRandom::CRegistry::CreateCategory(const std::string& category, UInt32 seed) {
  if (ExistsCategory(category)) {
    return false;
  }
  m_categories.emplace(category, std::make_unique<CCategory>(category, seed));
  return true;
}

CRandom::CCategory& CRandom::CRegistry::GetCategory(const std::string& category) {
  const auto found = m_categories.find(category);
  if (found == m_categories.end()) {
    std::string known;
    for (const auto& entry : m_categories) {
      AppendQuoted(known, entry.first);
    }
    THROW_ARGOSEXCEPTION("There is no random number category \""
                         << category << "\"; known categories: " << (known.empty() ? "none" : known)
                         << ". Create it with CRandom::CreateCategory().");
  }
  return *found->second;
}

bool CRandom::CRegistry::ExistsCategory(const std::string& category) const {
  return m_categories.count(category) > 0;
}

void CRandom::CRegistry::RemoveCategory(const std::string& category) {
  GetCategory(category);  // throws on an unknown one
  m_categories.erase(category);
}

std::vector<std::string> CRandom::CRegistry::ListCategories() const {
  std::vector<std::string> ids;
  for (const auto& [id, category] : m_categories) {
    ids.push_back(id);
  }
  return ids;
}

void CRandom::CRegistry::Reset() {
  for (const auto& entry : m_categories) {
    entry.second->ResetRNGs();
  }
}

bool CRandom::CreateCategory(const std::string& category, UInt32 seed) {
  return GetCurrentRegistry().CreateCategory(category, seed);
}

CRandom::CCategory& CRandom::GetCategory(const std::string& category) {
  return GetCurrentRegistry().GetCategory(category);
}

bool CRandom::ExistsCategory(const std::string& category) {
  return GetCurrentRegistry().ExistsCategory(category);
}

void CRandom::RemoveCategory(const std::string& category) {
  GetCurrentRegistry().RemoveCategory(category);
}

CRandom::CRNG* CRandom::CreateRNG(const std::string& category) {
  return GetCategory(category).CreateRNG();
}

UInt32 CRandom::GetSeedOf(const std::string& category) {
  return GetCategory(category).GetSeed();
}

void CRandom::SetSeedOf(const std::string& category, UInt32 seed) {
  GetCategory(category).SetSeed(seed);
}

void CRandom::Reset() {
  GetCurrentRegistry().Reset();
}

CRandom::CRegistry* CRandom::SetCurrentRegistry(CRegistry* registry) {
  return std::exchange(currentRegistry, registry);
}

CRandom::CRegistry& CRandom::GetCurrentRegistry() {
  if (currentRegistry != nullptr) {
    return *currentRegistry;
  }
  CRegistry* const shared = sharedRegistry.load(std::memory_order_acquire);
  return shared != nullptr ? *shared : GetProcessRegistry();
}

void CRandom::SetSharedRegistry(CRegistry* registry) {
  sharedRegistry.store(registry, std::memory_order_release);
}

CRandom::CRegistry& CRandom::GetProcessRegistry() {
  static CRegistry registry;
  return registry;
}

}  // namespace argos
