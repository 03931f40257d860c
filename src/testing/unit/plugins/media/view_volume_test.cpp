#include <argos3/plugins/simulator/media/view_volume.h>

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

namespace view_volume_test {

using namespace argos;

namespace {

// far above the rounding errors of coordinates of some metres
constexpr Real kRounding = 1e-9;  // m

CVector3 DrawPoint(CRandomStream& random, Real reach) {
  return CVector3(random.Uniform(-reach, reach), random.Uniform(-reach, reach),
                  random.Uniform(-reach, reach));
}

CVector3 DrawDirection(CRandomStream& random) {
  CVector3 direction;
  do {
    direction = DrawPoint(random, 1.0);
  } while (direction.Length() < 0.1);
  return direction.Normalize();
}

SFrustum DrawFrustum(CRandomStream& random) {
  const CQuaternion view(CRadians(random.Uniform(0.0, 3.0)), DrawDirection(random));
  SFrustum frustum;
  frustum.Eye = DrawPoint(random, 2.0);
  frustum.Right = CVector3(CVector3::X).Rotate(view);
  frustum.Down = CVector3(CVector3::Y).Rotate(view);
  frustum.Ahead = CVector3(CVector3::Z).Rotate(view);
  const Real near = random.Uniform(0.0, 0.5);
  frustum.Depth.Set(near, near + random.Uniform(0.1, 2.0));
  const auto drawSlopes = [&random] {
    const Real first = random.Uniform(-1.5, 1.0);
    return CRange<Real>(first, first + random.Uniform(0.1, 1.5));
  };
  frustum.SlopeRight = drawSlopes();
  frustum.SlopeDown = drawSlopes();
  return frustum;
}

// @return true if a point is in the image
bool Sees(const SFrustum& frustum, const CVector3& point) {
  const CVector3 toPoint = point - frustum.Eye;
  const Real depth = frustum.Ahead.DotProduct(toPoint);
  const auto isIn = [depth](const CRange<Real>& slopes, Real aside) {
    return aside >= slopes.GetMin() * depth && aside <= slopes.GetMax() * depth;
  };
  return depth >= frustum.Depth.GetMin() && depth <= frustum.Depth.GetMax() &&
         isIn(frustum.SlopeRight, frustum.Right.DotProduct(toPoint)) &&
         isIn(frustum.SlopeDown, frustum.Down.DotProduct(toPoint));
}

bool Contains(const SBoundingBox& box, const CVector3& point) {
  return box.MinCorner <= point && point <= box.MaxCorner;
}

struct SPoints {
  std::array<CVector3, CViewVolume::kBlock> Places;

  UInt64 FindInside(const CViewVolume& volume) const {
    Real x[CViewVolume::kBlock], y[CViewVolume::kBlock], z[CViewVolume::kBlock];
    for (size_t i = 0; i < Places.size(); ++i) {
      x[i] = Places[i].GetX();
      y[i] = Places[i].GetY();
      z[i] = Places[i].GetZ();
    }
    return volume.FindInside(x, y, z);
  }
};

}  // namespace

TEST_CASE("view volume: contains what is in the image, and what is near that", "[media]") {
  CRandomStream random(1, "test", "view volume", "frustum");
  int numSeen = 0;
  int numOutside = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const SFrustum frustum = DrawFrustum(random);
    CViewVolume volume(frustum);
    SPoints points;
    UInt64 seen = 0;
    for (size_t i = 0; i < points.Places.size(); ++i) {
      points.Places[i] = frustum.Eye + DrawPoint(random, 2.0);
      if (Sees(frustum, points.Places[i])) {
        seen |= UInt64(1) << i;
        points.Places[i] += (CViewVolume::kMargin - kRounding) * DrawDirection(random);
        CHECK(Contains(volume.GetBox(), points.Places[i]));
      }
    }
    const UInt64 inside = points.FindInside(volume);
    CHECK((seen & ~inside) == 0);
    numSeen += __builtin_popcountll(seen);
    numOutside += 16 - __builtin_popcountll(inside);

    // all is moved together
    const CVector3 way = DrawPoint(random, 5.0);
    volume.Move(way);
    for (CVector3& place : points.Places) {
      place += way;
    }
    CHECK(points.FindInside(volume) == inside);
  }
  // both cases occur often
  CHECK(numSeen > 200);
  CHECK(numOutside > 500);
}

TEST_CASE("view volume: of a box, ends farther out than the box by the margin", "[media]") {
  const CViewVolume volume(SBoundingBox{CVector3(1.0, 2.0, 3.0), CVector3(2.0, 4.0, 6.0)});
  const Real in = CViewVolume::kMargin - kRounding;
  const Real out = CViewVolume::kMargin + kRounding;
  SPoints points;
  points.Places.fill(CVector3(1.5, 3.0, 4.0));
  CHECK(points.FindInside(volume) == 0xffff);
  points.Places[1] = CVector3(1.0 - in, 2.0 - in, 3.0 - in);
  points.Places[2] = CVector3(2.0 + in, 4.0 + in, 6.0 + in);
  points.Places[4] = CVector3(1.0 - out, 3.0, 4.0);
  points.Places[5] = CVector3(2.0 + out, 3.0, 4.0);
  points.Places[8] = CVector3(1.5, 2.0 - out, 4.0);
  points.Places[9] = CVector3(1.5, 4.0 + out, 4.0);
  points.Places[14] = CVector3(1.5, 3.0, 3.0 - out);
  points.Places[15] = CVector3(1.5, 3.0, 6.0 + out);
  points.Places[0] = CVector3(1.5, std::nan(""), 4.0);
  CHECK(points.FindInside(volume) == (0xffff & ~0xc331));
}

}  // namespace view_volume_test
