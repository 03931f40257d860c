#include <argos3/core/simulator/geometry/solid_overlap.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/testing/support/polygons.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace solid_overlap_test {

using namespace argos;

namespace {

using EKind = SShapeDescription::EKind;

class CRandomNumbers {
 public:
  explicit CRandomNumbers(unsigned seed) : m_generator(seed) {}
  Real In(Real min, Real max) {
    return std::uniform_real_distribution<Real>(min, max)(m_generator);
  }
  CVector3 Point(Real half) { return CVector3(In(-half, half), In(-half, half), In(-half, half)); }
  CQuaternion Rotation() {
    CQuaternion q(In(-1.0, 1.0), In(-1.0, 1.0), In(-1.0, 1.0), In(-1.0, 1.0));
    return q.Normalize();
  }
  SShapeDescription Solid() {
    const Real kind = In(0.0, 4.0);
    SShapeDescription solid = SShapeDescription::Sphere(In(0.05, 0.3), Point(0.1));
    if (kind < 1.0) {
      solid =
          SShapeDescription::Box(CVector3(In(0.02, 0.5), In(0.02, 0.5), In(0.02, 0.5)), Point(0.1));
    } else if (kind < 2.0) {
      solid = SShapeDescription::Cylinder(In(0.02, 0.3), In(0.02, 0.5), Point(0.1));
    } else if (kind < 3.0) {
      const auto uniform = [this](Real low, Real high) { return In(low, high); };
      solid = SShapeDescription::Prism(RandomPolygon(0.3, uniform), In(0.02, 0.5), Point(0.1));
    }
    solid.Orientation = Rotation();
    return solid;
  }

 private:
  std::mt19937 m_generator;
};

CVector3 Rotated(CVector3 vector, const CQuaternion& rotation) {
  return vector.Rotate(rotation);
}

// transforms a point from the frame of the solid to the world
CVector3 ToWorld(const SPlacedSolid& solid, const CVector3& point) {
  const SShapeDescription& shape = *solid.Shape;
  return solid.Position +
         Rotated(shape.Offset + Rotated(point, shape.Orientation), solid.Orientation);
}

// depth of a point below the surface, m; negative outside, where it bounds the distance
Real DepthOf(const SPlacedSolid& solid, const CVector3& world) {
  const SShapeDescription& shape = *solid.Shape;
  const CVector3 p =
      Rotated(Rotated(world - solid.Position, solid.Orientation.Inverse()) - shape.Offset,
              shape.Orientation.Inverse());
  if (shape.Kind == EKind::Sphere) {
    return shape.Radius - (p - CVector3(0.0, 0.0, shape.Radius)).Length();
  }
  const Real up = 0.5 * shape.Size.GetZ() - std::abs(p.GetZ() - 0.5 * shape.Size.GetZ());
  if (shape.Kind == EKind::Cylinder) {
    return std::min(up, shape.Radius - std::hypot(p.GetX(), p.GetY()));
  }
  if (shape.Kind == EKind::Prism) {
    Real depth = up;
    const auto& base = *shape.Vertices;
    for (size_t i = 0; i < base.size(); ++i) {
      const CVector2 side = base[(i + 1) % base.size()] - base[i];
      const CVector2 offset = CVector2(p.GetX(), p.GetY()) - base[i];
      depth = std::min(depth, side.CrossProduct(offset) / side.Length());
    }
    return depth;
  }
  return std::min({up, 0.5 * shape.Size.GetX() - std::abs(p.GetX()),
                   0.5 * shape.Size.GetY() - std::abs(p.GetY())});
}

// a random point of a solid, in its frame
CVector3 RandomPoint(const SShapeDescription& shape, CRandomNumbers& random) {
  const Real height = random.In(0.0, shape.Size.GetZ());
  const Real angle = random.In(-ARGOS_PI, ARGOS_PI);
  if (shape.Kind == EKind::Box) {
    return CVector3(random.In(-0.5, 0.5) * shape.Size.GetX(),
                    random.In(-0.5, 0.5) * shape.Size.GetY(), height);
  }
  if (shape.Kind == EKind::Prism) {
    // a mean of its corners
    CVector2 sum;
    Real weights = 0.0;
    for (const CVector2& corner : *shape.Vertices) {
      const Real weight = -std::log(random.In(1e-9, 1.0));
      sum += corner * weight;
      weights += weight;
    }
    return CVector3(sum.GetX() / weights, sum.GetY() / weights, height);
  }
  Real radius = shape.Radius;
  if (shape.Kind == EKind::Sphere) {
    radius = std::sqrt(std::max(0.0, radius * radius - (height - radius) * (height - radius)));
  }
  radius *= std::sqrt(random.In(0.0, 1.0));
  return CVector3(radius * std::cos(angle), radius * std::sin(angle), height);
}

// The least and greatest coordinate of a solid along a direction of unit length, m,
// from its corners, rims or poles.
std::pair<Real, Real> ComputeProjection(const SPlacedSolid& solid, const CVector3& direction) {
  const SShapeDescription& shape = *solid.Shape;
  const auto axis = [&](const CVector3& unit) {
    return direction.DotProduct(Rotated(Rotated(unit, shape.Orientation), solid.Orientation));
  };
  const Real x = axis(CVector3::X);
  const Real y = axis(CVector3::Y);
  const Real z = axis(CVector3::Z);
  Real half = shape.Radius;
  if (shape.Kind == EKind::Box) {
    half = 0.5 * (std::abs(x) * shape.Size.GetX() + std::abs(y) * shape.Size.GetY() +
                  std::abs(z) * shape.Size.GetZ());
  } else if (shape.Kind == EKind::Cylinder) {
    half = shape.Radius * std::hypot(x, y) + 0.5 * std::abs(z) * shape.Size.GetZ();
  }
  const Real centre =
      direction.DotProduct(ToWorld(solid, CVector3(0.0, 0.0, 0.5 * shape.Size.GetZ())));
  if (shape.Kind == EKind::Prism) {
    std::pair<Real, Real> projection(HUGE_VAL, -HUGE_VAL);
    for (const CVector2& corner : *shape.Vertices) {
      const Real along = centre + x * corner.GetX() + y * corner.GetY();
      projection.first = std::min(projection.first, along);
      projection.second = std::max(projection.second, along);
    }
    const Real up = 0.5 * std::abs(z) * shape.Size.GetZ();
    return {projection.first - up, projection.second + up};
  }
  return {centre - half, centre + half};
}

}  // namespace

TEST_CASE("solid overlap: solids with a common point overlap, solids separated by a plane do not",
          "[core][space]") {
  CRandomNumbers random(5);
  int overlapping = 0;
  int apart = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const SShapeDescription first = random.Solid();
    const SShapeDescription second = random.Solid();
    const SPlacedSolid a{&first, random.Point(0.3), random.Rotation()};
    const SPlacedSolid b{&second, random.Point(0.3), random.Rotation()};
    bool share = false;
    for (int i = 0; i < 200 && !share; ++i) {
      share = DepthOf(b, ToWorld(a, RandomPoint(first, random))) > 1e-6 ||
              DepthOf(a, ToWorld(b, RandomPoint(second, random))) > 1e-6;
    }
    bool isBetween = false;
    for (int i = 0; i < 200 && !isBetween; ++i) {
      const CVector3 direction = random.Point(1.0).Normalize();
      isBetween = ComputeProjection(a, direction).second < ComputeProjection(b, direction).first;
    }
    REQUIRE_FALSE((share && isBetween));
    CAPTURE(trial, static_cast<int>(first.Kind), static_cast<int>(second.Kind));
    if (share || isBetween) {
      REQUIRE(SolidsOverlap(a, b) == share);
      REQUIRE(SolidsOverlap(b, a) == share);
    }
    overlapping += share ? 1 : 0;
    apart += isBetween ? 1 : 0;
  }
  // both results occur in a large part of the trials
  CHECK(overlapping > 1000);
  CHECK(apart > 1000);
}

TEST_CASE("solid overlap: touching solids do not overlap, solids a micrometre deep do",
          "[core][space]") {
  // each pair is turned as a whole by random rotations
  CRandomNumbers random(6);
  const SShapeDescription box = SShapeDescription::Box(CVector3(0.2, 0.3, 0.4));
  const SShapeDescription cylinder = SShapeDescription::Cylinder(0.1, 0.5);
  const SShapeDescription sphere = SShapeDescription::Sphere(0.15);
  // the corner of the hexagon is on the x axis; the triangle's base is on it, its tip along y
  const SShapeDescription hexagon = SShapeDescription::Prism(RegularPolygon(6, 0.1), 0.3);
  const SShapeDescription triangle = SShapeDescription::Prism(
      {CVector2(-0.1, 0.0), CVector2(0.1, 0.0), CVector2(0.0, 0.2)}, 0.2, CVector3(0.0, -0.1, 0.0));
  const Real apothem = 0.1 * std::sqrt(0.75);
  struct SPair {
    const SShapeDescription* First;
    const SShapeDescription* Second;
    CVector3 Towards;  // unit vector from the first to the second
    Real Distance;  // m, of their origins when they touch
  };
  const Real diagonal = std::sqrt(0.5);
  for (const SPair& pair :
       {SPair{&box, &box, CVector3::X, 0.2}, SPair{&box, &box, CVector3::Z, 0.4},
        SPair{&box, &cylinder, CVector3::Y, 0.25}, SPair{&box, &cylinder, CVector3::Z, 0.4},
        SPair{&cylinder, &cylinder, CVector3(diagonal, diagonal, 0.0), 0.2},
        SPair{&cylinder, &cylinder, CVector3::Z, 0.5}, SPair{&sphere, &box, CVector3::X, 0.25},
        SPair{&sphere, &sphere, CVector3(0.0, diagonal, diagonal), 0.3},
        SPair{&hexagon, &box, CVector3::X, 0.2}, SPair{&hexagon, &box, CVector3::Y, 0.15 + apothem},
        SPair{&hexagon, &hexagon, CVector3::X, 0.2}, SPair{&hexagon, &hexagon, CVector3::Z, 0.3},
        SPair{&hexagon, &cylinder, CVector3::Y, 0.1 + apothem},
        SPair{&hexagon, &sphere, CVector3::Y, 0.15 + apothem},
        SPair{&triangle, &triangle, CVector3::Y, 0.2}, SPair{&triangle, &hexagon, CVector3::Z, 0.2},
        SPair{&triangle, &cylinder, CVector3::Y, 0.2}, SPair{&cylinder, &sphere, CVector3::Z, 0.5},
        SPair{&sphere, &cylinder, CVector3::Y, 0.25}}) {
    for (int turn = 0; turn < 50; ++turn) {
      const CQuaternion rotation = random.Rotation();
      const CVector3 start = random.Point(5.0);
      const auto at = [&](Real distance) {
        const CVector3 offset = pair.Towards * distance;
        return SolidsOverlap({pair.First, start, rotation},
                             {pair.Second, start + Rotated(offset, rotation), rotation});
      };
      CHECK_FALSE(at(pair.Distance));
      CHECK_FALSE(at(pair.Distance + 1e-6));
      CHECK(at(pair.Distance - 1e-6));
      CHECK(at(0.0));
    }
  }
}

TEST_CASE("solid overlap: a tilted box passes under a table that its bounding sphere would touch",
          "[core][space]") {
  // 0.1 m wide, tilted by 30 degrees: its highest corner is at 0.1 sin 30 + 0.1 cos 30 = 0.1366 m
  const SShapeDescription crate = SShapeDescription::Box(CVector3(0.1, 0.1, 0.1));
  const SShapeDescription table = SShapeDescription::Box(CVector3(1.0, 1.0, 0.05));
  const CQuaternion lean(CRadians(ARGOS_PI / 6.0), CVector3::Y);
  // the centre of the base is half a side from the lowest edge, which is on the ground
  const CVector3 place(0.0, 0.0, 0.05 * std::sin(ARGOS_PI / 6.0));
  const Real top = 0.1 * (std::sin(ARGOS_PI / 6.0) + std::cos(ARGOS_PI / 6.0));
  const auto fits = [&](Real height) {
    return !SolidsOverlap({&crate, place, lean},
                          {&table, CVector3(0.0, 0.0, height), CQuaternion()});
  };
  CHECK(fits(top + 1e-6));
  CHECK_FALSE(fits(top - 1e-6));
}

}  // namespace solid_overlap_test
