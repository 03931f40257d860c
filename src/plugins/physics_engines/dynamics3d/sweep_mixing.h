#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_SWEEP_MIXING_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_SWEEP_MIXING_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <array>
#include <vector>

namespace argos {

/**
 * Accelerates a fixed-point iteration x = G(x): proposes the next x from the last few results.
 *
 * Anderson's method: of all combinations of the last results, the one for which the changes
 * G(x) - x, if they were linear in x, would be least.
 *
 * Source: H. F. Walker, P. Ni, Anderson acceleration for fixed-point iterations, SIAM Journal on
 * Numerical Analysis 49 (2011).
 */
class CSweepMixing {
 public:
  static constexpr size_t kMemory = 8;

  /** Begins an iteration in a number of variables. */
  void Start(size_t size);
  /** To be filled before each Propose(): G(x), G(x) - x, and how much each variable counts. */
  std::vector<Real>& GetResult() { return m_result; }
  std::vector<Real>& GetChange() { return m_change; }
  std::vector<Real>& GetWeights() { return m_weights; }
  /** @return what is to be added to G(x) for the next x; null: nothing. */
  const std::vector<Real>* Propose();

 private:
  struct SEntry {
    std::vector<Real> Result;  // differences of both from one iteration to the next
    std::vector<Real> Change;
  };
  using TVector = std::array<Real, kMemory>;

  Real Product(const std::vector<Real>& a, const std::vector<Real>& b) const;
  void Grow(size_t size);
  bool FindShares(TVector& shares);

  size_t m_size = 0;
  size_t m_numEntries = 0;
  size_t m_next = 0;
  bool m_hasLast = false;
  Real m_lastSquare = 0.0;
  std::vector<Real> m_result;
  std::vector<Real> m_change;
  std::vector<Real> m_weights;
  std::vector<Real> m_lastResult;
  std::vector<Real> m_lastChange;
  std::vector<Real> m_step;
  std::array<SEntry, kMemory> m_entries;
  std::array<TVector, kMemory> m_products{};  // of the changes of entries
};

}  // namespace argos

#endif
