#include <argos3/campaign/statistics/missing_values.h>

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

}  // namespace argos
