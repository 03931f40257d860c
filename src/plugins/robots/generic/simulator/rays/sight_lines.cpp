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

  float DX[kSize], DY[kSize];  // vector of the axis, m
  float Inverse[kSize];  // 1 / square of its length, 1/m^2
  float Spread[kSize];  // m, of the other points around the first, seen from above
  float Drop[kSize], Rise[kSize];  // inverse of how far the lines go down, and up, at most, 1/m
  size_t Size = 0;  // number of groups
  UInt32 Open = 0;  // bit i: group i is to be tested

  void Add(const SLine& line);
  void Widen(const SLine& first, const SLine& line);
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
  m_minZ = eye.GetZ();
  m_maxZ = eye.GetZ();
}

void CSightLines::Reserve(size_t num, size_t groupSize) {
  m_lines.reserve(num * groupSize);
  m_blocks.reserve(num / SBlock::kSize + 1);
}

namespace {

// infinite unless the height is positive: then no fraction of a line gets to a solid
float InverseHeight(Real height) {
  return height > 0.0 ? 1.0F / static_cast<float>(height) : HUGE_VALF;
}

}  // namespace

void CSightLines::SBlock::Add(const SLine& line) {
  DX[Size] = static_cast<float>(line.DX);
  DY[Size] = static_cast<float>(line.DY);
  Inverse[Size] = 1.0F / static_cast<float>(line.SquareLengthXY);
  Spread[Size] = 0.0F;
  Drop[Size] = InverseHeight(-line.DZ);
  Rise[Size] = InverseHeight(line.DZ);
  Open |= UInt32(1) << Size;
  ++Size;
}

// extends the last group
void CSightLines::SBlock::Widen(const SLine& first, const SLine& line) {
  const Real dx = line.DX - first.DX;
  const Real dy = line.DY - first.DY;
  const size_t last = Size - 1;
  Spread[last] = std::max(Spread[last], static_cast<float>(std::sqrt(dx * dx + dy * dy)));
  Drop[last] = std::min(Drop[last], InverseHeight(-line.DZ));
  Rise[last] = std::min(Rise[last], InverseHeight(line.DZ));
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
  line.DZ = toEnd.GetZ();
  line.SquareLengthXY = line.DX * line.DX + line.DY * line.DY;
  line.Limit = length > kTouch ? 1.0 - kTouch / length : 0.0;
  line.Hit = 1.0;
  m_minZ = std::min(m_minZ, point.GetZ());
  m_maxZ = std::max(m_maxZ, point.GetZ());
  AddToGroup(line);
  m_lines.push_back(line);
}

void CSightLines::AddToGroup(const SLine& line) {
  const size_t place = m_lines.size() % m_groupSize;
  if (place != 0) {
    m_blocks.back().Widen(m_lines[m_lines.size() - place], line);
    return;
  }
  if (m_blocks.empty() || m_blocks.back().Size == SBlock::kSize) {
    m_blocks.emplace_back();
  }
  m_blocks.back().Add(line);
}

bool CSightLines::MayOcclude(const CRayCaster& robot, Real minZ, Real maxZ) {
  const SHeightRange heights = robot.GetSpace().GetBodyIndex().GetHeights();
  return (heights.Min <= maxZ && heights.Max >= minZ) || robot.AreBodiesOutsideIndex();
}

void CSightLines::Trace(bool all) {
  if (m_lines.empty() || !MayOcclude(*m_robot, m_minZ, m_maxZ)) {
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
  // for SBlock::FindNear():
  float Reach;  // m, the radius with a margin for its rounding errors
  float Below, Above;  // m, how far the cylinder is below the eye, or above it, at least; or 0

  SDisc(const SIndexedShape& shape, const CVector3& eye);

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
