#include <argos3/campaign/statistics/rank_distribution.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace argos {

namespace {

constexpr size_t kMaxSignedRanks = 1000;
constexpr size_t kMaxRankSum = 100;

void RequireSize(size_t n, size_t max) {
  if (n < 1 || n > max) {
    THROW_ARGOSEXCEPTION("exact distribution of ranks: number of values " << n << ", 1 to " << max
                                                                          << " allowed");
  }
}

}  // namespace

CRankDistribution CRankDistribution::SignedRank(size_t n) {
  RequireSize(n, kMaxSignedRanks);
  // multiplied by 2^-n: exact up to n = 53, and never too great for a Real
  std::vector<Real> shares(n * (n + 1) / 2 + 1, 0.0);
  shares[0] = 1.0;
  size_t greatest = 0;
  for (size_t rank = 1; rank <= n; ++rank) {
    greatest += rank;
    for (size_t sum = greatest; sum >= rank; --sum) {
      shares[sum] = 0.5 * (shares[sum] + shares[sum - rank]);
    }
    for (size_t sum = 0; sum < rank; ++sum) {
      shares[sum] *= 0.5;
    }
  }
  return CRankDistribution(shares);
}

CRankDistribution CRankDistribution::RankSum(size_t m, size_t n) {
  RequireSize(m, kMaxRankSum);
  RequireSize(n, kMaxRankSum);
  // by the owner of the greatest value: counts(i, j)[u] = counts(i - 1, j)[u - j] + counts(i, j -
  // 1)[u]
  std::vector<std::vector<Real>> countsOf(n + 1, {1.0});  // [j], for the current i
  for (size_t i = 1; i <= m; ++i) {
    for (size_t j = 1; j <= n; ++j) {
      std::vector<Real> counts(i * j + 1, 0.0);
      std::copy(countsOf[j].begin(), countsOf[j].end(), counts.begin() + static_cast<long>(j));
      for (size_t u = 0; u < countsOf[j - 1].size(); ++u) {
        counts[u] += countsOf[j - 1][u];
      }
      countsOf[j] = std::move(counts);
    }
  }
  return CRankDistribution(countsOf[n]);
}

CRankDistribution::CRankDistribution(const std::vector<Real>& counts) {
  m_lowerTails.reserve(counts.size());
  Real sum = 0.0;
  for (const Real count : counts) {
    sum += count;
    m_lowerTails.push_back(sum);
  }
  for (Real& tail : m_lowerTails) {
    tail /= sum;
  }
}

Real CRankDistribution::ComputeLowerTail(size_t value) const {
  return m_lowerTails[std::min(value, GetMax())];
}

Real CRankDistribution::ComputeUpperTail(size_t value) const {
  return value > GetMax() ? 0.0 : m_lowerTails[GetMax() - value];
}

size_t CRankDistribution::ComputeQuantile(Real probability) const {
  const Real least = probability - 10.0 * std::numeric_limits<Real>::epsilon();
  const auto found = std::lower_bound(m_lowerTails.begin(), m_lowerTails.end(), least);
  return std::min(static_cast<size_t>(found - m_lowerTails.begin()), GetMax());
}

}  // namespace argos
