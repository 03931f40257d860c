#include <argos3/campaign/statistics/missing_values.h>

#include <argos3/campaign/statistics/sample_checks.h>

#include <cmath>

namespace argos {

SPresentValues RemoveMissing(std::span<const Real> values) {
  SPresentValues present;
  for (const Real value : values) {
    if (!std::isnan(value)) {
      present.Values.push_back(value);
    }
  }
  present.NumMissing = values.size() - present.Values.size();
  return present;
}

SPresentPairs RemoveMissingPairs(std::span<const Real> x, std::span<const Real> y) {
  RequirePairs(x, y);
  SPresentPairs present;
  for (size_t i = 0; i < x.size(); ++i) {
    if (!std::isnan(x[i]) && !std::isnan(y[i])) {
      present.X.push_back(x[i]);
      present.Y.push_back(y[i]);
    }
  }
  present.NumMissing = x.size() - present.X.size();
  return present;
}

}  // namespace argos
