#include <argos3/core/utility/math/general.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>

namespace argos {

Real Interpolate(Real x, const std::vector<std::pair<Real, Real> >& points) {
  if (points.size() < 2) {
    THROW_ARGOSEXCEPTION("Cannot interpolate through " << points.size()
                                                       << " point(s): at least 2 are needed.");
  }

  // the segment that contains x, or the first or last one, extended
  const auto last = points.end() - 1;
  const auto upper = std::upper_bound(
      points.begin() + 1, last, x,
      [](Real value, const std::pair<Real, Real>& point) { return value < point.first; });
  const std::pair<Real, Real>& left = *(upper - 1);
  const std::pair<Real, Real>& right = *upper;

  const Real width = right.first - left.first;
  if (!(width > 0.0)) {
    THROW_ARGOSEXCEPTION("Cannot interpolate at "
                         << x << " between the abscissae " << left.first << " and " << right.first
                         << ": points must be sorted by increasing abscissa.");
  }
  return left.second + (x - left.first) / width * (right.second - left.second);
}

}  // namespace argos
