#include <argos3/plugins/robots/generic/simulator/light_occluders.h>

#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/utility/math/vectorized.h>
#include <argos3/plugins/robots/generic/simulator/light_eyes.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace argos {

namespace {

constexpr size_t kInitialCapacity = 64;  // solids
constexpr Real kRoundingError = 1e-9;  // m
constexpr Real kNear = 2.0;  // m, seen from above
// lines that rise more are soon above all bodies, so that nothing is gained by a second query
constexpr Real kSteep = 0.1;

// the fraction of a line at which it leaves the surroundings of the robot; 1 if it does not
Real FindEndOfNear(const CVector3& start, const CVector3& end) {
  const CVector3 way = end - start;
  const Real near = std::max(kNear, std::abs(way.GetZ()) / kSteep);
  return std::min(1.0, near / std::sqrt(way.GetX() * way.GetX() + way.GetY() * way.GetY()));
}

// The exact test of a solid that is not a disc follows for the sensors whose line to the light
// meets a cylinder around it. It is wider by more than the error of that test for starts far away.
SIndexedShape MakeCylinderAround(const SIndexedShape& shape, const CVector3& center) {
  SIndexedShape cylinder = shape;
  const Real distance = std::abs(shape.X - center.GetX()) + std::abs(shape.Y - center.GetY());
  cylinder.HalfX = shape.Radius + 1e-6 * distance + kRoundingError;
  cylinder.ZMin -= kRoundingError;
  cylinder.ZMax += kRoundingError;
  return cylinder;
}

}  // namespace

// The lines from the sensors to a light. Each is, at all fractions of its length, no farther than a
// reach from the axis, the line from the centre of the sensors.
struct CLightOccluders::SBeam {
  Real X, Y, Z;  // start of the axis, m
  Real DX, DY;  // vector of the axis, m
  Real InverseSquare;  // 1 / square of its length seen from above, 1/m^2; 0 if it is upright
  Real InverseRise;  // 1 / difference of heights of its ends, 1/m; infinite if it is level
  Real Across, Vertical;  // reach, m

  explicit SBeam(const SLightEyes& eyes)
      : X(eyes.Center.GetX()),
        Y(eyes.Center.GetY()),
        Z(eyes.Center.GetZ()),
        DX(eyes.Light.GetX() - X),
        DY(eyes.Light.GetY() - Y),
        InverseRise(1.0 / (eyes.Light.GetZ() - Z)),
        Across(eyes.Reach + kRoundingError),
        Vertical(eyes.GetVerticalReach() + kRoundingError) {
    const Real square = DX * DX + DY * DY;
    InverseSquare = square > 0.0 ? 1.0 / square : 0.0;
  }
};

// The axis is at the heights of the solid between two fractions. The point of the axis between
// these that is nearest to the circle of the solid decides.
ARGOS_VECTORIZED
UInt64 CLightOccluders::SBlock::FindNear(const SBeam& beam) const {
  UInt64 near = 0;
  ARGOS_VECTOR_LOOP
  for (size_t i = 0; i < kSize; ++i) {
    const Real x = X[i] - beam.X;
    const Real y = Y[i] - beam.Y;
    const Real atBottom = (ZMin[i] - beam.Vertical - beam.Z) * beam.InverseRise;
    const Real atTop = (ZMax[i] + beam.Vertical - beam.Z) * beam.InverseRise;
    const Real lower = atBottom < atTop ? atBottom : atTop;
    const Real upper = atBottom < atTop ? atTop : atBottom;
    const Real first = lower > 0.0 ? lower : 0.0;
    const Real last = upper < 1.0 ? upper : 1.0;
    const Real along = (x * beam.DX + y * beam.DY) * beam.InverseSquare;
    const Real ahead = along < first ? first : along;
    const Real nearest = ahead > last ? last : ahead;
    const Real besideX = x - nearest * beam.DX;
    const Real besideY = y - nearest * beam.DY;
    const Real reach = Radius[i] + beam.Across;
    const Real key = reach * reach - besideX * besideX - besideY * besideY;
    const bool isOut = (key < 0.0) | (first > last);
    near |= isOut ? 0 : kLaneBits[i];
  }
  return near;
}

CLightOccluders::SSolids::SSolids() {
  Shapes.reserve(kInitialCapacity);
  Blocks.reserve(kInitialCapacity / SBlock::kSize);
}

void CLightOccluders::SSolids::Clear() {
  Shapes.clear();
  Blocks.clear();
}

void CLightOccluders::SSolids::Add(const SIndexedShape& shape) {
  const size_t place = Shapes.size() % SBlock::kSize;
  if (place == 0) {
    Blocks.emplace_back();
  }
  SBlock& block = Blocks.back();
  block.X[place] = shape.X;
  block.Y[place] = shape.Y;
  block.Radius[place] = shape.Radius;
  block.ZMin[place] = shape.ZMin;
  block.ZMax[place] = shape.ZMax;
  Shapes.push_back(shape);
}

CLightOccluders::CLightOccluders() = default;

void CLightOccluders::Find(const CBodyIndex& index, UInt32 ownBody, const SLightEyes& eyes,
                           const std::vector<CRay3>& lines) {
  m_index = &index;
  m_ownBody = ownBody;
  m_nearLines.clear();
  for (const CRay3& line : lines) {
    const CVector3& start = line.GetStart();
    const Real end = FindEndOfNear(start, line.GetEnd());
    m_nearLines.emplace_back(start, start + end * (line.GetEnd() - start));
  }
  m_near.Clear();
  const auto add = [this](const SIndexedShape& shape) {
    if (shape.Body != m_ownBody) {
      m_near.Add(shape);
    }
  };
  index.ForShapesAlongRays(m_nearLines, {eyes.Reach, eyes.GetVerticalReach()}, add,
                           [] { return false; });
}

void CLightOccluders::Occlude(SLightEyes& eyes) {
  const SBeam beam(eyes);
  if (OccludeBehind(m_near, beam, eyes)) {
    const Real end = FindEndOfNear(eyes.Center, eyes.Light);
    if (end < 1.0) {
      OccludeBeyond(CRay3(eyes.Center + end * (eyes.Light - eyes.Center), eyes.Light), beam, eyes);
    }
  }
}

// the solids found are tested before the next row of cells if they are many
void CLightOccluders::OccludeBeyond(const CRay3& line, const SBeam& beam, SLightEyes& eyes) {
  m_beyond.Clear();
  bool isAnyClear = true;
  const auto test = [&] {
    isAnyClear = OccludeBehind(m_beyond, beam, eyes);
    m_beyond.Clear();
  };
  m_index->ForShapesAlongRays(
      std::array{line}, {eyes.Reach, eyes.GetVerticalReach()},
      [this](const SIndexedShape& shape) {
        if (shape.Body != m_ownBody) {
          m_beyond.Add(shape);
        }
      },
      [&] {
        if (m_beyond.Shapes.size() >= SBlock::kSize) {
          test();
        }
        return !isAnyClear;
      });
  if (isAnyClear && !m_beyond.Shapes.empty()) {
    test();
  }
}

// returns false if no sensor is clear any more
bool CLightOccluders::OccludeBehind(const SSolids& solids, const SBeam& beam,
                                    SLightEyes& eyes) const {
  const size_t size = solids.Shapes.size();
  for (size_t first = 0; first < size; first += SBlock::kSize) {
    UInt64 near = solids.Blocks[first / SBlock::kSize].FindNear(beam);
    if (size - first < SBlock::kSize) {
      near &= (UInt64(1) << (size - first)) - 1;
    }
    for (; near != 0; near &= near - 1) {
      const auto place = first + static_cast<size_t>(std::countr_zero(near));
      if (!OccludeBehind(solids.Shapes[place], eyes)) {
        return false;
      }
    }
  }
  return true;
}

// the same for one solid
bool CLightOccluders::OccludeBehind(const SIndexedShape& shape, SLightEyes& eyes) const {
  if (shape.Kind == SIndexedShape::EKind::Disc) {
    return eyes.FindClear(shape, eyes.IsClear);
  }
  UInt64 clear[SLightEyes::kCapacity];
  bool isAnyClear = eyes.FindClear(MakeCylinderAround(shape, eyes.Center), clear);
  for (size_t i = 0; i < eyes.Count; ++i) {
    if (eyes.IsClear[i] != clear[i]) {
      eyes.IsClear[i] = m_index->Intersect(shape, CRay3(eyes.GetPosition(i), eyes.Light)) > 1.0;
      isAnyClear = isAnyClear || eyes.IsClear[i] != 0;
    }
  }
  return isAnyClear;
}

}  // namespace argos
