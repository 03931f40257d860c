#include <argos3/campaign/statistics/sample_checks.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <cmath>
#include <string>

namespace argos {

void RequireSample(std::span<const Real> values, size_t minCount, std::string_view name) {
  if (values.size() < minCount) {
    THROW_ARGOSEXCEPTION(name << ": number of values " << values.size() << ", at least " << minCount
                              << " needed");
  }
  for (size_t i = 0; i < values.size(); ++i) {
    const Real value = values[i];
    if (std::isnan(value)) {
      THROW_ARGOSEXCEPTION(name << ": value " << i + 1 << " of " << values.size()
                                << " is not a number; remove missing values first");
    }
    if (std::abs(value) > kMaxValue) {
      THROW_ARGOSEXCEPTION(name << ": value " << i + 1 << " of " << values.size() << " is " << value
                                << "; finite values up to " << kMaxValue << " are allowed");
    }
  }
}

void RequireGroups(std::span<const std::vector<Real>> groups, size_t minGroups, size_t minCount) {
  if (groups.size() < minGroups) {
    THROW_ARGOSEXCEPTION("number of groups " << groups.size() << ", at least " << minGroups
                                             << " needed");
  }
  for (size_t i = 0; i < groups.size(); ++i) {
    RequireSample(groups[i], minCount, "group " + std::to_string(i + 1));
  }
}

void RequirePairs(std::span<const Real> x, std::span<const Real> y) {
  if (x.size() != y.size()) {
    THROW_ARGOSEXCEPTION("pairs need equally many values of both: x has " << x.size() << ", y has "
                                                                          << y.size());
  }
}

void RequireLevel(Real level) {
  // the condition is false for NaN, too
  if (!(level > 0.0 && level < 1.0)) {
    THROW_ARGOSEXCEPTION("confidence level " << level << "; it must be above 0 and below 1");
  }
}

void RequireProbability(Real probability, std::string_view name) {
  if (!(probability >= 0.0 && probability <= 1.0)) {
    THROW_ARGOSEXCEPTION(name << " " << probability << "; it must be in [0,1]");
  }
}

}  // namespace argos
