#include <argos3/campaign/statistics/p_value_adjustment.h>

#include <argos3/campaign/statistics/sample_checks.h>

#include <algorithm>
#include <numeric>

namespace argos {

namespace {

std::vector<Real> AdjustByHolm(std::span<const Real> pValues) {
  const size_t n = pValues.size();
  std::vector<size_t> order(n);
  std::iota(order.begin(), order.end(), size_t(0));
  std::ranges::sort(order, {}, [pValues](size_t i) { return pValues[i]; });
  std::vector<Real> adjusted(n);
  Real greatest = 0.0;
  for (size_t i = 0; i < n; ++i) {
    greatest = std::max(greatest, static_cast<Real>(n - i) * pValues[order[i]]);
    adjusted[order[i]] = std::min(1.0, greatest);
  }
  return adjusted;
}

}  // namespace

std::vector<Real> AdjustPValues(std::span<const Real> pValues, EPValueAdjustment adjustment) {
  for (const Real pValue : pValues) {
    RequireProbability(pValue, "p value");
  }
  if (adjustment == EPValueAdjustment::Holm) {
    return AdjustByHolm(pValues);
  }
  std::vector<Real> adjusted(pValues.begin(), pValues.end());
  if (adjustment == EPValueAdjustment::Bonferroni) {
    for (Real& pValue : adjusted) {
      pValue = std::min(1.0, static_cast<Real>(pValues.size()) * pValue);
    }
  }
  return adjusted;
}

}  // namespace argos
