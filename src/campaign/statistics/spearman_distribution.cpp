#include <argos3/campaign/statistics/spearman_distribution.h>

#include <argos3/campaign/statistics/probability.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace argos {

namespace {

constexpr size_t kEnumeratedUpTo = 9;  // values: 362,880 orders

Real EnumerateUpperTail(Real distance, size_t n) {
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  size_t numOrders = 0;
  size_t numAtLeast = 0;
  do {
    int sum = 0;
    for (size_t i = 0; i < n; ++i) {
      const int difference = order[i] - static_cast<int>(i);
      sum += difference * difference;
    }
    ++numOrders;
    numAtLeast += sum >= distance ? 1 : 0;
  } while (std::next_permutation(order.begin(), order.end()));
  return static_cast<Real>(numAtLeast) / static_cast<Real>(numOrders);
}

// Best and Roberts' series in b = 1 / n and the standardized distance z
Real ComputeSeries(Real distance, Real n) {
  const Real b = 1.0 / n;
  const Real z = (6.0 * (distance - 1.0) / (n * (n * n - 1.0)) - 1.0) * std::sqrt(n - 1.0);
  const Real y = z * z;
  const Real inner =
      0.0879 + 0.0151 * b - y * (0.0072 - 0.0831 * b + y * b * (0.0131 - 4.6e-4 * y));
  const Real middle = -0.0758 + b * (0.1033 + 0.3932 * b) - y * b * inner;
  const Real correction = z * b * (0.2274 + b * (0.2531 + 0.1745 * b) + y * middle);
  return std::clamp(correction * std::exp(-0.5 * y) + ComputeNormalUpperTail(z), 0.0, 1.0);
}

}  // namespace

Real ComputeSpearmanUpperTail(Real distance, size_t n) {
  const auto count = static_cast<Real>(n);
  if (distance <= 0.0) {
    return 1.0;
  }
  if (distance > count * (count * count - 1.0) / 3.0) {
    return 0.0;
  }
  return n <= kEnumeratedUpTo ? EnumerateUpperTail(distance, n) : ComputeSeries(distance, count);
}

}  // namespace argos
