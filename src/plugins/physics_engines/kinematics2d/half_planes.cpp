#include <argos3/plugins/simulator/physics_engines/kinematics2d/half_planes.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// sines of angles below this are of lines that are parallel
constexpr Real kParallel = 1e-12;

}  // namespace

void CHalfPlanes::Sort() {
  // few, and mostly in order
  for (size_t i = 1; i < m_size; ++i) {
    const SHalfPlane plane = m_planes[i];
    size_t j = i;
    for (; j > 0 && m_planes[j - 1].Id > plane.Id; --j) {
      m_planes[j] = m_planes[j - 1];
    }
    m_planes[j] = plane;
  }
}

SStep CHalfPlanes::SumPushes() const {
  SStep sum;
  for (size_t i = 0; i < m_size; ++i) {
    sum.X -= m_planes[i].Push * m_planes[i].NormalX;
    sum.Y -= m_planes[i].Push * m_planes[i].NormalY;
  }
  return sum;
}

SStep CHalfPlanes::FindNearest(const SStep& wanted) const {
  SStep step = wanted;
  for (size_t i = 0; i < m_size; ++i) {
    const SHalfPlane& plane = m_planes[i];
    if (plane.NormalX * step.X + plane.NormalY * step.Y <= plane.Limit) {
      continue;
    }
    // the nearest step that this one and those before it allow is on this one's border
    if (!FindOnLine(i, wanted, step)) {
      // roundings leave nothing; to stay is always possible
      return SStep();
    }
  }
  return step;
}

// The step on the border of a half plane that is nearest to the one wanted and that those before it
// allow.
bool CHalfPlanes::FindOnLine(size_t number, const SStep& wanted, SStep& step) const {
  const SHalfPlane& line = m_planes[number];
  const Real directionX = -line.NormalY;
  const Real directionY = line.NormalX;
  Real low = -HUGE_VAL;
  Real high = HUGE_VAL;
  for (size_t i = 0; i < number; ++i) {
    const SHalfPlane& other = m_planes[i];
    const Real slope = other.NormalX * directionX + other.NormalY * directionY;
    const Real room =
        other.Limit - line.Limit * (other.NormalX * line.NormalX + other.NormalY * line.NormalY);
    if (std::abs(slope) < kParallel) {
      // of two limits in the same direction the smaller one has been found before
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
  const Real along = std::clamp(wanted.X * directionX + wanted.Y * directionY, low, high);
  step.X = line.Limit * line.NormalX + along * directionX;
  step.Y = line.Limit * line.NormalY + along * directionY;
  return true;
}

}  // namespace argos
