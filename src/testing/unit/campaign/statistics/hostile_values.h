#ifndef ARGOS3_TESTING_UNIT_CAMPAIGN_STATISTICS_HOSTILE_VALUES_H
#define ARGOS3_TESTING_UNIT_CAMPAIGN_STATISTICS_HOSTILE_VALUES_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

#include <functional>
#include <limits>
#include <vector>

namespace argos {

constexpr Real kNaN = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

/** Checks that a function refuses, in each place, what is no finite number, and names the place. */
inline void CheckRefusesHostileValues(const std::vector<Real>& accepted,
                                      const std::function<void(const std::vector<Real>&)>& call) {
  REQUIRE_NOTHROW(call(accepted));
  for (const Real hostile : {kNaN, kInfinity, -kInfinity, 2e150, -1e300}) {
    for (size_t i = 0; i < accepted.size(); ++i) {
      CAPTURE(hostile, i);
      std::vector<Real> values = accepted;
      values[i] = hostile;
      CHECK_THROWS_WITH(call(values), Catch::Contains("value " + std::to_string(i + 1) + " of"));
    }
  }
}

}  // namespace argos

#endif
