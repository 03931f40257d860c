#ifndef ARGOS3_CORE_UTILITY_MATH_RNG_OWNER_H
#define ARGOS3_CORE_UTILITY_MATH_RNG_OWNER_H

#include <argos3/core/utility/math/rng.h>

#include <string>
#include <vector>

namespace argos {

/**
 * Owns the generators that code of a robot creates, and destroys them with itself.
 *
 * While a CScope of an owner exists, generators that its thread creates belong to that owner. Their
 * seeds do not depend on generators that were destroyed:
 * - Those created while an experiment is loaded take the next seed of the category's seeder. The
 *   category keeps the number of that seed with the owner's id. An owner of the same id gets it
 *   back at a reset, or if it is created again at clock 0.
 * - All others are seeded by a hash of the category's seed, the owner's id, the clock at which they
 *   were created, and how many the owner had. So several threads may create some at a time, and a
 *   run that adds and removes robots repeats after a reset.
 */
class CRandom::COwner {
 public:
  class CScope;

  COwner() = default;
  /** Destroys the generators. */
  ~COwner() { DestroyGenerators(); }

  COwner(const COwner&) = delete;
  COwner& operator=(const COwner&) = delete;

  /** Returns the id of an owner, given what SetId() was. */
  typedef std::string (*TGetId)(const void* subject);
  /**
   * Sets where the id comes from, because most owners never need it.
   * @param getId  called with @p subject, as long as this exists: the same id after a reset as
   *               before, and of one owner at a time.
   */
  void SetId(TGetId getId, const void* subject) {
    m_getId = getId;
    m_subject = subject;
  }
  std::string GetId() const { return m_getId != nullptr ? m_getId(m_subject) : std::string(); }

  void DestroyGenerators();
  size_t GetNumRNGs() const { return m_generators.size(); }

 private:
  friend class CCategory;

  struct SReference {
    CCategory* Category;
    UInt64 Serial;
  };

  UInt32 CountOf(const CCategory& category) const;
  void Forget(const CCategory& category);

  TGetId m_getId = nullptr;
  const void* m_subject = nullptr;  // is not owned
  std::vector<SReference> m_generators;
};

/** The current owner of a thread, until the scope ends. */
class CRandom::COwner::CScope {
 public:
  /** The birth of what is created while an experiment is loaded. */
  static constexpr UInt64 kLoading = ~UInt64(0);

  /**
   * @param owner  null for none.
   * @param birth  kLoading, or the simulation's clock.
   */
  CScope(COwner* owner, UInt64 birth);
  ~CScope();

  CScope(const CScope&) = delete;
  CScope& operator=(const CScope&) = delete;

  /** Replaces the owner. */
  void SetOwner(COwner* owner) { m_current.Owner = owner; }

 private:
  friend class CCategory;

  struct SCurrent {
    COwner* Owner;
    UInt64 Birth;
  };
  static SCurrent& GetCurrent();

  SCurrent& m_current;  // owner of this thread
  SCurrent m_previous;
};

}  // namespace argos

#endif
