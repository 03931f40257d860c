#include <argos3/plugins/robots/generic/simulator/sight_lines.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/physics_engine/ray_queries.h>
#include <argos3/core/simulator/space/space.h>

#include <algorithm>
#include <cmath>

namespace argos {

void CSightLines::Start(const CRayCaster& robot, const CVector3& eye, size_t groupSize) {
  m_robot = &robot;
  m_eye = eye;
  m_groupSize = groupSize;
  m_lines.clear();
  m_groups.Clear();
  m_minZ = eye.GetZ();
  m_maxZ = eye.GetZ();
}

void CSightLines::Reserve(size_t num, size_t groupSize) {
  m_lines.reserve(num * groupSize);
  m_groups.Reserve(num);
}

void CSightLines::SGroups::Clear() {
  for (std::vector<float>* values : {&DX, &DY, &SquareLength, &Spread, &Near}) {
    values->clear();
  }
}

void CSightLines::SGroups::Reserve(size_t num) {
  for (std::vector<float>* values : {&DX, &DY, &SquareLength, &Spread, &Near}) {
    values->reserve(num);
  }
}

void CSightLines::SGroups::Add(Real dx, Real dy) {
  DX.push_back(static_cast<float>(dx));
  DY.push_back(static_cast<float>(dy));
  SquareLength.push_back(static_cast<float>(dx * dx + dy * dy));
  Spread.push_back(0.0F);
  Near.push_back(0.0F);
}

// extends the last group to a point at (dx, dy) from its first
void CSightLines::SGroups::Widen(Real dx, Real dy) {
  Spread.back() = std::max(Spread.back(), static_cast<float>(std::sqrt(dx * dx + dy * dy)));
}

// Near < 0 if a circle, seen from above, is farther from the axis than the spread, beside it or
// behind the eye, by more than the rounding error: then it meets no line of the group, whose
// distance from the axis grows from 0 at the eye to the spread. Otherwise >= 0, or not a number.
void CSightLines::SGroups::ComputeNearness(Real x, Real y, Real radius) {
  constexpr Real kError = 1e-6;  // relative, see SPlanarRays
  const auto circleX = static_cast<float>(x);
  const auto circleY = static_cast<float>(y);
  const auto inflated =
      static_cast<float>(radius * (1.0 + kError) + kError * (std::abs(x) + std::abs(y)));
  const size_t size = GetSize();
  const float* const dx = DX.data();
  const float* const dy = DY.data();
  const float* const squareLength = SquareLength.data();
  const float* const spread = Spread.data();
  float* __restrict near = Near.data();
  for (size_t i = 0; i < size; ++i) {
    const float aside = dx[i] * circleY - dy[i] * circleX;
    const float along = dx[i] * circleX + dy[i] * circleY;
    // the eye is the nearest point to what is behind it: twice min(along, 0) without a branch
    const float behind = along - std::abs(along);
    const float reach = inflated + static_cast<float>(1.0 + kError) * spread[i];
    near[i] = reach * reach * squareLength[i] - aside * aside - 0.25F * (behind * behind);
  }
}

namespace {

// true if a point, world frame, is below the plane of the body's base
bool IsBelowBase(const CEmbodiedEntity& body, CVector3 point) {
  const SAnchor& origin = body.GetOriginAnchor();
  point -= origin.Position;
  point.Rotate(origin.Orientation.Inverse());
  return point.GetZ() < 0.0;
}

}  // namespace

void CSightLines::Add(const CVector3& point, const CEmbodiedEntity* open) {
  const CVector3 toEnd = point - m_eye;
  const Real length = toEnd.Length();
  SLine line;
  line.End = point;
  line.Open = open != nullptr && IsBelowBase(*open, m_eye) ? open : nullptr;
  line.DX = toEnd.GetX();
  line.DY = toEnd.GetY();
  line.SquareLengthXY = line.DX * line.DX + line.DY * line.DY;
  line.Limit = length > kTouch ? 1.0 - kTouch / length : 0.0;
  line.Hit = 1.0;
  m_minZ = std::min(m_minZ, point.GetZ());
  m_maxZ = std::max(m_maxZ, point.GetZ());
  if (m_lines.size() % m_groupSize == 0) {
    m_groups.Add(line.DX, line.DY);
  } else {
    const SLine& first = m_lines[m_lines.size() / m_groupSize * m_groupSize];
    m_groups.Widen(line.DX - first.DX, line.DY - first.DY);
  }
  m_lines.push_back(line);
}

void CSightLines::Trace(bool all) {
  if (m_lines.empty()) {
    return;
  }
  if (m_robot->AreBodiesOutsideIndex()) {
    TraceOneByOne();
    return;
  }
  // encloses the projections of all lines onto the ground
  SPlanarArea area = SPlanarArea::Empty();
  area.Include(m_eye.GetX(), m_eye.GetY());
  for (const SLine& line : m_lines) {
    area.Include(line.End.GetX(), line.End.GetY());
  }
  const CBodyIndex& index = m_robot->GetSpace().GetBodyIndex();
  const UInt32 ownBody = m_robot->GetBody().GetBodyNumber();
  index.ForShapesInArea(area, [&](const SIndexedShape& shape) {
    if (shape.Body != ownBody && shape.ZMax >= m_minZ && shape.ZMin <= m_maxZ) {
      TraceShape(index, shape, all);
    }
  });
}

// the upright bounding cylinder of a solid, relative to the eye
struct CSightLines::SDisc {
  Real X, Y;  // vector from the eye to its axis, m
  Real SquareRadius;  // m^2
  Real ZMin, ZMax;  // m, world frame

  // true if the infinite line intersects the circle, projected onto the ground
  bool IntersectsPlanar(const SLine& line) const {
    return IsCircleOnLine(X, Y, line.DX, line.DY, SquareRadius, line.SquareLengthXY);
  }
  // true if the line segment may intersect the cylinder
  bool Intersects(const SLine& line, Real eyeZ) const {
    const Real endZ = line.End.GetZ();
    if (std::min(eyeZ, endZ) > ZMax || std::max(eyeZ, endZ) < ZMin) {
      return false;
    }
    const Real along = X * line.DX + Y * line.DY;
    if (along <= 0.0) {
      return X * X + Y * Y <= SquareRadius;
    }
    const Real toEndX = X - line.DX;
    const Real toEndY = Y - line.DY;
    return along < line.SquareLengthXY || toEndX * toEndX + toEndY * toEndY <= SquareRadius;
  }
};

void CSightLines::TraceShape(const CBodyIndex& index, const SIndexedShape& shape, bool all) {
  const SDisc disc = {shape.X - m_eye.GetX(), shape.Y - m_eye.GetY(), shape.Radius * shape.Radius,
                      shape.ZMin, shape.ZMax};
  m_groups.ComputeNearness(disc.X, disc.Y, shape.Radius);
  for (size_t group = 0; group < m_groups.GetSize(); ++group) {
    // rejects most groups
    if (!(m_groups.Near[group] < 0.0F) && (all || IsGroupClear(group))) {
      TraceGroup(index, shape, disc, group);
    }
  }
}

void CSightLines::TraceGroup(const CBodyIndex& index, const SIndexedShape& shape, const SDisc& disc,
                             size_t group) {
  for (size_t i = group * m_groupSize; i < (group + 1) * m_groupSize; ++i) {
    SLine& line = m_lines[i];
    if (disc.IntersectsPlanar(line) && disc.Intersects(line, m_eye.GetZ()) &&
        (line.Open == nullptr || line.Open->GetBodyNumber() != shape.Body)) {
      line.Hit = std::min(line.Hit, index.Intersect(shape, CRay3(m_eye, line.End)));
    }
  }
}

bool CSightLines::IsGroupClear(size_t group) const {
  const auto first = m_lines.begin() + static_cast<std::ptrdiff_t>(group * m_groupSize);
  return std::all_of(first, first + static_cast<std::ptrdiff_t>(m_groupSize),
                     [](const SLine& line) { return line.IsClear(); });
}

// the fraction of the ray at which it meets the first body besides the robot's own and another; 1
// if there is none
Real CSightLines::FindHitBesides(const CEmbodiedEntity& open, const CRay3& ray) const {
  TEmbodiedEntityIntersectionData hits;
  GetEmbodiedEntitiesIntersectedByRay(hits, ray);
  Real first = 1.0;
  for (const SEmbodiedEntityIntersectionItem& hit : hits) {
    if (hit.IntersectedEntity != &open && hit.IntersectedEntity != &m_robot->GetBody()) {
      first = std::min(first, hit.TOnRay);
    }
  }
  return first;
}

void CSightLines::TraceOneByOne() {
  SEmbodiedEntityIntersectionItem hit;
  for (SLine& line : m_lines) {
    const CRay3 ray(m_eye, line.End);
    if (line.Open != nullptr) {
      line.Hit = FindHitBesides(*line.Open, ray);
    } else if (GetClosestEmbodiedEntityIntersectedByRay(hit, ray, m_robot->GetBody())) {
      line.Hit = hit.TOnRay;
    }
  }
}

void CSightLines::Show(size_t number) const {
  const CRay3 ray(m_eye, m_lines[number].End);
  const bool clear = IsClear(number);
  m_robot->GetRobot().AddCheckedRay(!clear, ray);
  if (!clear) {
    m_robot->GetRobot().AddIntersectionPoint(ray, m_lines[number].Hit);
  }
}

}  // namespace argos
