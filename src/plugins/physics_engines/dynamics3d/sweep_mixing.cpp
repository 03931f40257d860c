#include <argos3/plugins/simulator/physics_engines/dynamics3d/sweep_mixing.h>

#include <cmath>
#include <utility>

namespace argos {

namespace {

// variables for which there is memory, in those of the largest island so far
constexpr size_t kRoom = 2;
// share of a diagonal element that is left of it in the decomposition of dependent entries
constexpr Real kDependent = 1e-10;
// greatest share of an entry: others are rounding errors
constexpr Real kMaxShare = 1e5;
// it starts again where the squares of changes grow by this factor
constexpr Real kTooMuch = 10.0;

}  // namespace

void CSweepMixing::Start(size_t size) {
  m_size = size;
  m_numEntries = m_next = 0;
  m_hasLast = false;
  if (size > m_result.size()) {
    Grow(kRoom * size);
  }
}

// All at once, and by more than is needed: islands change their size.
void CSweepMixing::Grow(size_t size) {
  for (std::vector<Real>* vector :
       {&m_result, &m_change, &m_weights, &m_lastResult, &m_lastChange, &m_step}) {
    vector->resize(size);
  }
  for (SEntry& entry : m_entries) {
    entry.Result.resize(size);
    entry.Change.resize(size);
  }
}

Real CSweepMixing::Product(const std::vector<Real>& a, const std::vector<Real>& b) const {
  Real sum = 0.0;
  for (size_t i = 0; i < m_size; ++i) {
    sum += m_weights[i] * a[i] * b[i];
  }
  return sum;
}

const std::vector<Real>* CSweepMixing::Propose() {
  const Real square = Product(m_change, m_change);
  if (m_hasLast && square > kTooMuch * m_lastSquare) {
    m_numEntries = m_next = 0;
    m_hasLast = false;
  }
  if (m_hasLast) {
    SEntry& entry = m_entries[m_next];
    for (size_t i = 0; i < m_size; ++i) {
      entry.Result[i] = m_result[i] - m_lastResult[i];
      entry.Change[i] = m_change[i] - m_lastChange[i];
    }
    m_numEntries = m_numEntries < kMemory ? m_numEntries + 1 : kMemory;
    for (size_t i = 0; i < m_numEntries; ++i) {
      m_products[i][m_next] = m_products[m_next][i] = Product(m_entries[i].Change, entry.Change);
    }
    m_next = (m_next + 1) % kMemory;
  }
  std::swap(m_result, m_lastResult);
  std::swap(m_change, m_lastChange);
  m_lastSquare = square;
  m_hasLast = true;
  TVector shares{};
  if (m_numEntries == 0 || !FindShares(shares)) {
    return nullptr;
  }
  for (size_t i = 0; i < m_size; ++i) {
    m_step[i] = 0.0;
    for (size_t j = 0; j < m_numEntries; ++j) {
      m_step[i] -= shares[j] * m_entries[j].Result[i];
    }
  }
  return &m_step;
}

// Least squares by the normal equations, with Cholesky's decomposition.
bool CSweepMixing::FindShares(TVector& shares) {
  std::array<TVector, kMemory> lower{};
  TVector y{};
  for (size_t i = 0; i < m_numEntries; ++i) {
    y[i] = Product(m_entries[i].Change, m_lastChange);
    for (size_t j = 0; j <= i; ++j) {
      Real sum = m_products[i][j];
      for (size_t k = 0; k < j; ++k) {
        sum -= lower[i][k] * lower[j][k];
      }
      if (j < i) {
        lower[i][j] = sum / lower[j][j];
      } else {
        sum = sum > kDependent * m_products[i][i] ? sum : m_products[i][i];
        lower[i][i] = std::sqrt(sum);
      }
    }
    if (!(lower[i][i] > 0.0)) {
      return false;
    }
  }
  for (size_t i = 0; i < m_numEntries; ++i) {
    for (size_t k = 0; k < i; ++k) {
      y[i] -= lower[i][k] * y[k];
    }
    y[i] /= lower[i][i];
  }
  for (size_t i = m_numEntries; i-- > 0;) {
    shares[i] = y[i];
    for (size_t k = i + 1; k < m_numEntries; ++k) {
      shares[i] -= lower[k][i] * shares[k];
    }
    shares[i] /= lower[i][i];
    if (!(std::abs(shares[i]) < kMaxShare)) {
      return false;
    }
  }
  return true;
}

}  // namespace argos
