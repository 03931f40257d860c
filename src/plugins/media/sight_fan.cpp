#include <argos3/plugins/simulator/media/sight_fan.h>

#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/utility/math/vectorized.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// relative; much larger than rounding errors
constexpr Real kMore = 1.0 + 1e-6;
constexpr Real kLess = 1.0 - 1e-6;
constexpr Real kMargin = 1e-6;  // m, the same for places along a line
constexpr Real kHeightMargin = 1e-9;  // m, and for heights
constexpr UInt32 kMaxBuckets = 256;
// up to so many lines are all compared with each solid
constexpr size_t kFewLines = 8;

// A number in [0,4] that grows with the angle from the x axis, by 0.5 to 1 for each radian: within
// a quadrant, y / (x + y). Without branches, for loops that are vectorized.
inline Real DirectionOf(Real x, Real y) {
  const Real sum = std::abs(x) + std::abs(y);
  const Real part = y / (sum > 0.0 ? sum : 1.0);
  const Real ahead = part < 0.0 ? 4.0 + part : part;
  return x < 0.0 ? 2.0 - part : ahead;
}

}  // namespace

// the circle around the footprint of a solid, relative to the eye
struct CSightFan::SCircle {
  Real X, Y;  // m
  Real SquareDistance;  // m^2
  Real Outer, Inner;  // m^2, square of the radius with a margin
  Real From, To;  // directions of its tangents, unless the eye is inside; perhaps not in [0,4]

  static SCircle Make(Real x, Real y, Real radius) {
    SCircle circle;
    circle.X = x;
    circle.Y = y;
    circle.SquareDistance = x * x + y * y;
    circle.Outer = radius * radius * kMore;
    circle.Inner = radius * radius * kLess;
    // The tangents are at an angle of asin(sine) from the centre, which is at most this for every
    // sine in [0,1]: the difference is 0 at both ends and has no other sign between them.
    const bool isOutside = circle.SquareDistance > circle.Outer;
    const Real sine = std::sqrt(circle.Outer / (isOutside ? circle.SquareDistance : circle.Outer));
    const Real width = sine * (1.0 + (0.5 * ARGOS_PI - 1.0) * sine * sine) + kMargin;
    const Real middle = DirectionOf(x, y);
    circle.From = middle - width;
    circle.To = middle + width;
    return circle;
  }

  // false if the segment does not meet the circle, with a margin
  bool IsNear(const SLine& line, Real squareCross, Real along) const {
    if (squareCross > Outer * line.SquareLength) {
      return false;
    }
    if (along <= 0.0) {
      return SquareDistance <= Outer;
    }
    const Real toEndX = X - line.DX;
    const Real toEndY = Y - line.DY;
    return along < line.SquareLength || toEndX * toEndX + toEndY * toEndY <= Outer;
  }
};

// the circles of a list of discs, in arrays over which loops are vectorized
struct CSightFan::SCircles {
  static constexpr size_t kCapacity = SDiscList::kCapacity;

  Real X[kCapacity], Y[kCapacity], SquareDistance[kCapacity], Outer[kCapacity], Inner[kCapacity];
  Real From[kCapacity], To[kCapacity];

  static void Compute(const SDiscList& discs, const SEnd& eye, SCircles& circles);
  SCircle Get(size_t i) const {
    return {X[i], Y[i], SquareDistance[i], Outer[i], Inner[i], From[i], To[i]};
  }
};

ARGOS_VECTORIZED
void CSightFan::SCircles::Compute(const SDiscList& __restrict discs, const SEnd& eye,
                                  SCircles& __restrict circles) {
  const Real eyeX = eye.X;
  const Real eyeY = eye.Y;
  const size_t size = discs.Size;
  for (size_t i = 0; i < size; ++i) {
    const SCircle circle = SCircle::Make(discs.X[i] - eyeX, discs.Y[i] - eyeY, discs.Radius[i]);
    circles.X[i] = circle.X;
    circles.Y[i] = circle.Y;
    circles.SquareDistance[i] = circle.SquareDistance;
    circles.Outer[i] = circle.Outer;
    circles.Inner[i] = circle.Inner;
    circles.From[i] = circle.From;
    circles.To[i] = circle.To;
  }
}

Real CSightFan::ComputeReach(const CLineOfSight& sight, const CLineOfSight::SEnd& body, Real x,
                             Real y) {
  return sight.GetIndex().ComputeReach(body.Number, x, y);
}

void CSightFan::Reserve(size_t num) {
  m_added.reserve(num);
  m_lines.reserve(num);
  m_buckets.reserve(num);
  m_isClear.reserve(num);
  m_bucketStart.reserve(kMaxBuckets + 1);
}

void CSightFan::Start(const SEnd& eye) {
  m_eye = &eye;
  m_added.clear();
}

void CSightFan::Add(const SEnd& end, bool toEnd) {
  m_added.push_back({&end, toEnd});
}

// Functions are defined before their callers, and inline: the innermost loops call them.

inline UInt32 CSightFan::BucketOf(Real direction) const {
  return std::min(static_cast<UInt32>(direction * m_bucketsPerQuadrant), m_numBuckets - 1);
}

void CSightFan::SortLines() {
  const size_t num = m_added.size();
  m_numBuckets = 1;
  while (num > kFewLines && m_numBuckets < num && m_numBuckets < kMaxBuckets) {
    m_numBuckets *= 2;
  }
  m_bucketsPerQuadrant = 0.25 * m_numBuckets;
  m_bucketStart.assign(m_numBuckets + 1, 0);
  m_buckets.resize(num);
  for (size_t i = 0; i < num; ++i) {
    const SEnd& end = *m_added[i].End;
    m_buckets[i] =
        m_numBuckets == 1 ? 0 : BucketOf(DirectionOf(end.X - m_eye->X, end.Y - m_eye->Y));
    ++m_bucketStart[m_buckets[i]];
  }
  UInt32 sum = 0;
  for (UInt32& start : m_bucketStart) {
    sum += start;
    start = sum;
  }
  m_lines.resize(num);
  // backwards, so that each start is that of its bucket in the end
  for (size_t i = num; i-- > 0;) {
    const SEnd& end = *m_added[i].End;
    SLine& line = m_lines[--m_bucketStart[m_buckets[i]]];
    line.DX = end.X - m_eye->X;
    line.DY = end.Y - m_eye->Y;
    line.SquareLength = line.DX * line.DX + line.DY * line.DY;
    const Real length = std::sqrt(line.SquareLength);
    line.First = (m_eye->Reach + kMargin) * length;
    line.Last = line.SquareLength - (end.Reach + kMargin) * length;
    line.DZ = end.Z - m_eye->Z;
    line.Body = end.Body.Number;
    line.Number = static_cast<UInt32>(i);
    line.State = EState::Clear;
  }
}

// Clear if the part of the line between two fractions is above or below the solid; Blocked if the
// line is at a height of the solid at the fraction inside, by more than a rounding.
inline CSightFan::EState CSightFan::CheckHeights(const SIndexedShape& shape, const SLine& line,
                                                 Real first, Real inside, Real last) const {
  const Real z = m_eye->Z;
  // level lines are at one height exactly
  const Real margin = line.DZ == 0.0 ? 0.0 : kHeightMargin;
  const Real atFirst = z + std::max(first, 0.0) * line.DZ;
  const Real atLast = z + std::min(last, 1.0) * line.DZ;
  if (std::max(atFirst, atLast) < shape.ZMin - margin ||
      std::min(atFirst, atLast) > shape.ZMax + margin) {
    return EState::Clear;
  }
  const Real at = z + inside * line.DZ;
  return at >= shape.ZMin + margin && at <= shape.ZMax - margin ? EState::Blocked
                                                                : EState::Doubtful;
}

CSightFan::EState CSightFan::TraceBox(const SIndexedShape& box, const SLine& line) const {
  const auto intersect = [&](Real margin) {
    SIndexedShape other = box;
    other.HalfX += margin;
    other.HalfY += margin;
    return IntersectFootprint(other, m_eye->X, m_eye->Y, line.DX, line.DY);
  };
  SRaySpan outer = intersect(kMargin);
  outer.Clip(0.0, 1.0);
  if (outer.IsEmpty()) {
    return EState::Clear;
  }
  SRaySpan inner = intersect(-kMargin);
  inner.Clip(line.First / line.SquareLength, line.Last / line.SquareLength);
  const bool isInside = line.First < line.Last && inner.First < inner.Last && box.HalfX > kMargin &&
                        box.HalfY > kMargin;
  const EState heights =
      CheckHeights(box, line, outer.First, 0.5 * (inner.First + inner.Last), outer.Last);
  return isInside ? heights : std::min(heights, EState::Doubtful);
}

inline CSightFan::EState CSightFan::TraceLine(const SIndexedShape& shape, const SCircle& circle,
                                              const SLine& line) const {
  const Real cross = circle.X * line.DY - circle.Y * line.DX;
  const Real squareCross = cross * cross;
  const Real along = circle.X * line.DX + circle.Y * line.DY;
  // rejects most solids
  if (!circle.IsNear(line, squareCross, along)) {
    return EState::Clear;
  }
  if (line.SquareLength == 0.0 || shape.Kind == SIndexedShape::EKind::Bounds) {
    return EState::Doubtful;
  }
  if (shape.Kind == SIndexedShape::EKind::Box) {
    return TraceBox(shape, line);
  }
  // the point next to the axis, and a part that contains the chord
  const Real middle = along / line.SquareLength;
  const Real half = std::sqrt(circle.Outer / line.SquareLength);
  const bool isInside =
      squareCross <= circle.Inner * line.SquareLength && along > line.First && along < line.Last;
  const EState heights = CheckHeights(shape, line, middle - half, middle, middle + half);
  return isInside ? heights : std::min(heights, EState::Doubtful);
}

// the same for a disc at all heights of the lines
inline CSightFan::EState CSightFan::TraceDisc(const SCircle& circle, const SLine& line) {
  const Real cross = circle.X * line.DY - circle.Y * line.DX;
  const Real squareCross = cross * cross;
  const Real along = circle.X * line.DX + circle.Y * line.DY;
  if (!circle.IsNear(line, squareCross, along)) {
    return EState::Clear;
  }
  const bool isInside =
      squareCross <= circle.Inner * line.SquareLength && along > line.First && along < line.Last;
  return isInside ? EState::Blocked : EState::Doubtful;
}

// test(const SLine&): the EState of a line with a solid of that body
template <typename TEST>
inline void CSightFan::TraceLines(UInt32 first, UInt32 last, UInt32 body, TEST&& test) {
  for (UInt32 i = first; i < last; ++i) {
    SLine& line = m_lines[i];
    if (line.State == EState::Blocked || line.Body == body) {
      continue;
    }
    const EState state = test(line);
    line.State = std::max(line.State, state);
    m_numOpen -= state == EState::Blocked ? 1 : 0;
  }
}

template <typename TEST>
inline void CSightFan::TraceDirections(Real from, Real to, UInt32 body, TEST&& test) {
  TraceLines(m_bucketStart[BucketOf(from)], m_bucketStart[BucketOf(to) + 1], body, test);
}

// tests the lines that may meet a circle
template <typename TEST>
inline void CSightFan::TraceCircle(const SCircle& circle, UInt32 body, TEST&& test) {
  if (m_numBuckets == 1 || circle.SquareDistance <= circle.Outer) {
    TraceLines(0, static_cast<UInt32>(m_lines.size()), body, test);
    return;
  }
  TraceDirections(std::max(0.0, circle.From), std::min(4.0, circle.To), body, test);
  // across the x axis
  if (circle.From < 0.0) {
    TraceDirections(circle.From + 4.0, 4.0, body, test);
  } else if (circle.To > 4.0) {
    TraceDirections(0.0, circle.To - 4.0, body, test);
  }
}

inline void CSightFan::TraceShape(const SIndexedShape& shape) {
  const SCircle circle = SCircle::Make(shape.X - m_eye->X, shape.Y - m_eye->Y, shape.Radius);
  TraceCircle(circle, shape.Body,
              [&](const SLine& line) { return TraceLine(shape, circle, line); });
}

void CSightFan::TraceDiscs(const SDiscList& discs) {
  SCircles circles;
  SCircles::Compute(discs, *m_eye, circles);
  for (size_t i = 0; i < discs.Size && m_numOpen > 0; ++i) {
    const SCircle circle = circles.Get(i);
    TraceCircle(circle, discs.Body[i],
                [&circle](const SLine& line) { return TraceDisc(circle, line); });
  }
}

void CSightFan::TraceIndex(const CBodyIndex& index) {
  Real squareReach = 0.0;
  Real lowest = 0.0;
  Real highest = 0.0;
  for (const SLine& line : m_lines) {
    squareReach = std::max(squareReach, line.SquareLength);
    lowest = std::min(lowest, line.DZ);
    highest = std::max(highest, line.DZ);
  }
  const Real reach = std::sqrt(squareReach) * kMore + kMargin;
  const SDiscQuery query = {m_eye->X,
                            m_eye->Y,
                            reach,
                            m_eye->Z + lowest - 2.0 * kHeightMargin,
                            m_eye->Z + highest + 2.0 * kHeightMargin,
                            m_eye->Body.Number};
  SDiscList discs;
  const auto traceDiscs = [this, &discs] {
    TraceDiscs(discs);
    discs.Size = 0;
  };
  index.ListDiscsNear(query, discs, traceDiscs, [&](const SIndexedShape& shape) {
    const Real dx = shape.X - m_eye->X;
    const Real dy = shape.Y - m_eye->Y;
    const Real far = reach + shape.Radius;
    if (shape.Body != m_eye->Body.Number && m_numOpen > 0 && dx * dx + dy * dy <= far * far) {
      TraceShape(shape);
    }
  });
  traceDiscs();
}

void CSightFan::Trace(const CLineOfSight& sight) {
  SortLines();
  m_isClear.resize(m_lines.size());
  m_numOpen = m_lines.size();
  if (sight.HasBodiesOutsideIndex()) {
    for (SLine& line : m_lines) {
      line.State = EState::Doubtful;
    }
  } else {
    TraceIndex(sight.GetIndex());
  }
  for (const SLine& line : m_lines) {
    const SAdded& added = m_added[line.Number];
    const SEnd& start = added.ToEnd ? *m_eye : *added.End;
    const SEnd& end = added.ToEnd ? *added.End : *m_eye;
    m_isClear[line.Number] =
        line.State == EState::Clear || start.Body.Body == end.Body.Body ||
        (line.State == EState::Doubtful &&
         sight.IsClear(CRay3(CVector3(start.X, start.Y, start.Z), CVector3(end.X, end.Y, end.Z)),
                       start.Body, end.Body));
  }
}

}  // namespace argos
