#include <argos3/plugins/robots/generic/simulator/sight_lines.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/physics_engine/ray_queries.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/math/vectorized.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace argos {

namespace {

constexpr UInt32 kBits[] = {1U << 0,  1U << 1,  1U << 2,  1U << 3, 1U << 4,  1U << 5,
                            1U << 6,  1U << 7,  1U << 8,  1U << 9, 1U << 10, 1U << 11,
                            1U << 12, 1U << 13, 1U << 14, 1U << 15};

}  // namespace

// Groups, one array for each property, so that the compiler vectorizes loops over them. The axis of
// a group is the line to its first point. Heights are measured from that of the eye.
struct CSightLines::SBlock {
  static constexpr size_t kSize = 16;

  Real X[kSize], Y[kSize];  // vector of the axis, m
  Real Lowest[kSize], Highest[kSize];  // m, of the points
  float Spread[kSize];  // m, of the other points around the first, seen from above
  size_t Size = 0;  // number of groups
  UInt32 Open = 0;  // bit i: group i is to be tested
  // written by Finish()
  float DX[kSize], DY[kSize];  // X and Y
  float Inverse[kSize];  // 1 / square of the length of the axis, 1/m^2
  float Drop[kSize], Rise[kSize];  // inverse of how far the lines go down, and up, at most, 1/m

  void Add(const CVector3& toEnd);
  void Widen(const CVector3& toEnd);
  void Finish();
  // the numbers of the groups that may meet a solid, as bits
  UInt32 FindNear(const SDisc& disc) const;
};

CSightLines::CSightLines() = default;
CSightLines::~CSightLines() = default;

void CSightLines::Start(const CRayCaster& robot, const CVector3& eye, size_t groupSize) {
  m_robot = &robot;
  m_eye = eye;
  m_groupSize = groupSize;
  m_lines.clear();
  m_blocks.clear();
  m_isAnyHit = false;
}

void CSightLines::Reserve(size_t num, size_t groupSize) {
  m_lines.reserve(num * groupSize);
  m_blocks.reserve(num / SBlock::kSize + 1);
  m_occluders.reserve(num);
}

bool CSightLines::FindOccluders(const SBoundingBox& box) {
  m_occluders.clear();
  if (m_robot->AreBodiesOutsideIndex()) {
    return true;
  }
  const CVector3& min = box.MinCorner;
  const CVector3& max = box.MaxCorner;
  const UInt32 ownBody = m_robot->GetBody().GetBodyNumber();
  m_robot->GetSpace().GetBodyIndex().ForShapesInArea(
      {min.GetX(), min.GetY(), max.GetX(), max.GetY()},
      [this, ownBody](const SIndexedShape& shape) {
        if (shape.Body != ownBody) {
          m_occluders.push_back(shape);
        }
      },
      {min.GetZ(), max.GetZ()});
  return !m_occluders.empty();
}

void CSightLines::SBlock::Add(const CVector3& toEnd) {
  X[Size] = toEnd.GetX();
  Y[Size] = toEnd.GetY();
  Lowest[Size] = toEnd.GetZ();
  Highest[Size] = toEnd.GetZ();
  Spread[Size] = 0.0F;
  Open |= UInt32(1) << Size;
  ++Size;
}

// extends the last group
void CSightLines::SBlock::Widen(const CVector3& toEnd) {
  const size_t last = Size - 1;
  const Real dx = toEnd.GetX() - X[last];
  const Real dy = toEnd.GetY() - Y[last];
  Lowest[last] = std::min(Lowest[last], toEnd.GetZ());
  Highest[last] = std::max(Highest[last], toEnd.GetZ());
  Spread[last] = std::max(Spread[last], static_cast<float>(std::sqrt(dx * dx + dy * dy)));
}

// Inverse heights are infinite unless the height is positive: then no fraction of a line gets to a
// solid.
ARGOS_VECTORIZED
void CSightLines::SBlock::Finish() {
  ARGOS_VECTOR_LOOP
  for (size_t i = 0; i < kSize; ++i) {
    DX[i] = static_cast<float>(X[i]);
    DY[i] = static_cast<float>(Y[i]);
    Inverse[i] = 1.0F / static_cast<float>(X[i] * X[i] + Y[i] * Y[i]);
    const float drop = 1.0F / static_cast<float>(-Lowest[i]);
    const float rise = 1.0F / static_cast<float>(Highest[i]);
    Drop[i] = Lowest[i] < 0.0 ? drop : HUGE_VALF;
    Rise[i] = Highest[i] > 0.0 ? rise : HUGE_VALF;
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
  const bool isOpen = open != nullptr && IsBelowBase(*open, m_eye);
  if (m_lines.size() % m_groupSize != 0) {
    m_blocks.back().Widen(point - m_eye);
  } else {
    if (m_blocks.empty() || m_blocks.back().Size == SBlock::kSize) {
      m_blocks.emplace_back();
    }
    m_blocks.back().Add(point - m_eye);
  }
  m_lines.push_back({point, isOpen ? open : nullptr, 1.0, true});
}

void CSightLines::Trace(bool all) {
  if (m_robot->AreBodiesOutsideIndex()) {
    TraceOneByOne();
    return;
  }
  for (SBlock& block : m_blocks) {
    block.Finish();
  }
  const CBodyIndex& index = m_robot->GetSpace().GetBodyIndex();
  for (const SIndexedShape& shape : m_occluders) {
    TraceShape(index, shape, all);
  }
}

// the upright bounding cylinder of a solid, relative to the eye
struct CSightLines::SDisc {
  Real X, Y;  // vector from the eye to its axis, m
  Real SquareRadius;  // m^2
  Real ZMin, ZMax;  // m, world frame
  // for SBlock::FindNear():
  float Reach;  // m, the radius with a margin for its rounding errors
  float Below, Above;  // m, how far the cylinder is below the eye, or above it, at least; or 0

  SDisc(const SIndexedShape& shape, const CVector3& eye);

  // true if the line segment from the eye, by a vector, m, may intersect the cylinder
  bool MayIntersect(const CVector3& line, Real eyeZ, Real endZ) const {
    const Real dx = line.GetX();
    const Real dy = line.GetY();
    const Real squareLength = dx * dx + dy * dy;
    if (!IsCircleOnLine(X, Y, dx, dy, SquareRadius, squareLength) || std::min(eyeZ, endZ) > ZMax ||
        std::max(eyeZ, endZ) < ZMin) {
      return false;
    }
    const Real along = X * dx + Y * dy;
    if (along <= 0.0) {
      return X * X + Y * Y <= SquareRadius;
    }
    const Real toEndX = X - dx;
    const Real toEndY = Y - dy;
    return along < squareLength || toEndX * toEndX + toEndY * toEndY <= SquareRadius;
  }
};

CSightLines::SDisc::SDisc(const SIndexedShape& shape, const CVector3& eye)
    : X(shape.X - eye.GetX()),
      Y(shape.Y - eye.GetY()),
      SquareRadius(shape.Radius * shape.Radius),
      ZMin(shape.ZMin),
      ZMax(shape.ZMax) {
  // relative: distances have errors of at most 10 units of 2^-24, this is half as much again
  constexpr Real kError = 1e-6;
  Reach = static_cast<float>(shape.Radius * (1.0 + kError) + kError * (std::abs(X) + std::abs(Y)));
  const auto atLeast = [](Real height) {
    return static_cast<float>(std::max(0.0, height * (1.0 - kError) - kTouch));
  };
  Below = atLeast(eye.GetZ() - ZMax);
  Above = atLeast(ZMin - eye.GetZ());
}

// A line is at the heights of the solid from a fraction on. The point of the axis after that
// fraction that is nearest to the circle is farther from it than the lines of the group are from
// the axis, by more than the rounding error: then none of them meets the solid. Comparisons with
// what is not a number, of axes without a length, are false, so such groups count as near.
ARGOS_VECTORIZED
UInt32 CSightLines::SBlock::FindNear(const SDisc& disc) const {
  const auto x = static_cast<float>(disc.X);
  const auto y = static_cast<float>(disc.Y);
  const float height = disc.Below + disc.Above;
  const float* const inverseHeights = disc.Above > 0.0F ? Rise : Drop;
  UInt32 near = 0;
  ARGOS_VECTOR_LOOP
  for (size_t i = 0; i < kSize; ++i) {
    const float first = height * inverseHeights[i];
    const float along = (DX[i] * x + DY[i] * y) * Inverse[i];
    const float ahead = along < first ? first : along;
    const float nearest = ahead > 1.0F ? 1.0F : ahead;
    const float besideX = x - nearest * DX[i];
    const float besideY = y - nearest * DY[i];
    const float reach = disc.Reach + 1.000001F * Spread[i];
    const float key = reach * reach - besideX * besideX - besideY * besideY;
    const bool isOut = (key < 0.0F) | (first > 1.0F);
    near |= isOut ? 0U : kBits[i];
  }
  return near & Open;
}

void CSightLines::TraceShape(const CBodyIndex& index, const SIndexedShape& shape, bool all) {
  const SDisc disc(shape, m_eye);
  for (size_t block = 0; block < m_blocks.size(); ++block) {
    // few groups are near
    for (UInt32 near = m_blocks[block].FindNear(disc); near != 0; near &= near - 1) {
      const auto place = static_cast<UInt32>(std::countr_zero(near));
      const size_t group = block * SBlock::kSize + place;
      TraceGroup(index, shape, disc, group);
      if (!all && !IsGroupClear(group)) {
        m_blocks[block].Open &= ~(UInt32(1) << place);
      }
    }
  }
}

void CSightLines::TraceGroup(const CBodyIndex& index, const SIndexedShape& shape, const SDisc& disc,
                             size_t group) {
  for (size_t i = group * m_groupSize; i < (group + 1) * m_groupSize; ++i) {
    SLine& line = m_lines[i];
    if (disc.MayIntersect(line.End - m_eye, m_eye.GetZ(), line.End.GetZ()) &&
        (line.Open == nullptr || line.Open->GetBodyNumber() != shape.Body)) {
      Meet(line, index.Intersect(shape, CRay3(m_eye, line.End)));
    }
  }
}

// a body occludes the end unless the line meets it within kTouch of the end
void CSightLines::Meet(SLine& line, Real fraction) {
  if (fraction < line.Hit) {
    const Real length = (line.End - m_eye).Length();
    line.Hit = fraction;
    line.IsClear = length <= kTouch || fraction >= 1.0 - kTouch / length;
    m_isAnyHit = true;
  }
}

bool CSightLines::IsGroupClear(size_t group) const {
  const auto first = m_lines.begin() + static_cast<std::ptrdiff_t>(group * m_groupSize);
  return !m_isAnyHit || std::all_of(first, first + static_cast<std::ptrdiff_t>(m_groupSize),
                                    [](const SLine& line) { return line.IsClear; });
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
      Meet(line, FindHitBesides(*line.Open, ray));
    } else if (GetClosestEmbodiedEntityIntersectedByRay(hit, ray, m_robot->GetBody())) {
      Meet(line, hit.TOnRay);
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
