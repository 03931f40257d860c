#include <argos3/plugins/simulator/physics_engines/kinematics2d/half_planes.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// lines are parallel if the sine of their angle is below this
constexpr Real kParallel = 1e-12;

}  // namespace

void CHalfPlanes::Sort() {
  // insertion sort: there are few planes, and most are in order
  for (size_t i = 1; i < m_size; ++i) {
    const SHalfPlane plane = m_planes[i];
    size_t j = i;
    for (; j > 0 && m_planes[j - 1].Id > plane.Id; --j) {
      m_planes[j] = m_planes[j - 1];
    }
    m_planes[j] = plane;
  }
}

SPlanarVector CHalfPlanes::SumPushes() const {
  SPlanarVector sum = {};
  for (size_t i = 0; i < m_size; ++i) {
    sum = sum - m_planes[i].Push * m_planes[i].Normal;
  }
  return sum;
}

SPlanarVector CHalfPlanes::FindNearest(const SPlanarVector& target) const {
  SPlanarVector step = target;
  for (size_t i = 0; i < m_size; ++i) {
    const SHalfPlane& plane = m_planes[i];
    if (Dot(plane.Normal, step) <= plane.Limit) {
      continue;
    }
    // the nearest step that this plane and the previous ones allow is on the border of this one
    if (!FindOnLine(i, target, step)) {
      // no step is left because of rounding; a step of length 0 is always possible
      return SPlanarVector{};
    }
  }
  return step;
}

// The step on the border of a half plane that is nearest to the target and that the previous planes
// allow.
bool CHalfPlanes::FindOnLine(size_t number, const SPlanarVector& target,
                             SPlanarVector& step) const {
  const SHalfPlane& line = m_planes[number];
  const SPlanarVector direction = {-line.Normal.Y, line.Normal.X};
  Real low = -HUGE_VAL;
  Real high = HUGE_VAL;
  for (size_t i = 0; i < number; ++i) {
    const SHalfPlane& other = m_planes[i];
    const Real slope = Dot(other.Normal, direction);
    const Real room = other.Limit - line.Limit * Dot(other.Normal, line.Normal);
    if (std::abs(slope) < kParallel) {
      // the step satisfies the other plane already, so that it is not the tighter one
      continue;
    }
    if (slope > 0.0) {
      high = std::min(high, room / slope);
    } else {
      low = std::max(low, room / slope);
    }
  }
  if (low > high) {
    return false;
  }
  const Real along = std::clamp(Dot(target, direction), low, high);
  step = line.Limit * line.Normal + along * direction;
  return true;
}

}  // namespace argos
