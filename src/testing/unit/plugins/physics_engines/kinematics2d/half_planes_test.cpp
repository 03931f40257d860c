// Compares the nearest allowed step with a search over all geometric candidates.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/half_planes.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace argos::half_planes_test {

using Catch::Matchers::WithinAbs;

namespace {

bool Allows(const std::vector<SHalfPlane>& planes, const SPlanarVector& step, Real slack) {
  for (const SHalfPlane& plane : planes) {
    if (Dot(plane.Normal, step) > plane.Limit + slack) {
      return false;
    }
  }
  return true;
}

// nearest candidate: the wanted step, its projections on borders, or a corner
SPlanarVector SearchNearest(const std::vector<SHalfPlane>& planes, const SPlanarVector& wanted) {
  std::vector<SPlanarVector> candidates = {wanted};
  for (const SHalfPlane& a : planes) {
    const Real excess = Dot(a.Normal, wanted) - a.Limit;
    candidates.push_back(wanted - excess * a.Normal);
    for (const SHalfPlane& b : planes) {
      const Real cross = Cross(a.Normal, b.Normal);
      if (std::abs(cross) > 1e-6) {
        candidates.push_back({(a.Limit * b.Normal.Y - b.Limit * a.Normal.Y) / cross,
                              (b.Limit * a.Normal.X - a.Limit * b.Normal.X) / cross});
      }
    }
  }
  SPlanarVector best = {};
  Real least = HUGE_VAL;
  for (const SPlanarVector& step : candidates) {
    const Real distance = std::hypot(step.X - wanted.X, step.Y - wanted.Y);
    if (distance < least && Allows(planes, step, 1e-12)) {
      least = distance;
      best = step;
    }
  }
  return best;
}

}  // namespace

TEST_CASE("half planes: the step found is the nearest one that all planes allow",
          "[unit][kinematics2d]") {
  CRandomStream random(1, "test", "half planes", "planes");
  for (int scene = 0; scene < 2000; ++scene) {
    std::vector<SHalfPlane> planes;
    CHalfPlanes solver;
    const int count = scene % 9;
    for (int i = 0; i < count; ++i) {
      const Real angle = random.Uniform(-std::numbers::pi, std::numbers::pi);
      // in a third of the scenes the bodies touch already
      const Real limit = scene % 3 == 0 ? 0.0 : random.Uniform(0.0, 1.0);
      planes.push_back({{std::cos(angle), std::sin(angle)}, limit, static_cast<UInt32>(i), 0.0});
      REQUIRE(solver.Add(planes.back()));
    }
    const SPlanarVector wanted = {random.Uniform(-2, 2), random.Uniform(-2, 2)};
    const SPlanarVector found = solver.FindNearest(wanted);
    const SPlanarVector best = SearchNearest(planes, wanted);
    CAPTURE(scene, wanted.X, wanted.Y);
    // corners of planes 1e-6 rad apart are found to 1e-16 / 1e-6
    REQUIRE_THAT(found.X, WithinAbs(best.X, 1e-9));
    REQUIRE_THAT(found.Y, WithinAbs(best.Y, 1e-9));
    REQUIRE(Allows(planes, found, 1e-12));
  }
}

TEST_CASE("half planes: after sorting, the result does not depend on the order of addition",
          "[unit][kinematics2d]") {
  const std::vector<SHalfPlane> planes = {
      {{0.6, 0.8}, 0.1, 7, 0.0}, {{-0.6, 0.8}, 0.2, 3, 0.0}, {{1.0, 0.0}, 0.05, 5, 0.0}};
  CHalfPlanes forwards;
  CHalfPlanes backwards;
  for (size_t i = 0; i < planes.size(); ++i) {
    forwards.Add(planes[i]);
    backwards.Add(planes[planes.size() - 1 - i]);
  }
  forwards.Sort();
  backwards.Sort();
  const SPlanarVector a = forwards.FindNearest({1.0, 1.0});
  const SPlanarVector b = backwards.FindNearest({1.0, 1.0});
  CHECK(a.X == b.X);
  CHECK(a.Y == b.Y);
}

TEST_CASE("half planes: of parallel ones the tighter one counts", "[unit][kinematics2d]") {
  const bool isTighterFirst = GENERATE(false, true);
  CAPTURE(isTighterFirst);
  CHalfPlanes planes;
  planes.Add({{1.0, 0.0}, isTighterFirst ? 0.25 : 0.5, 0, 0.0});
  planes.Add({{1.0, 0.0}, isTighterFirst ? 0.5 : 0.25, 1, 0.0});
  // the opposite side, which is open
  planes.Add({{-1.0, 0.0}, 0.125, 2, 0.0});
  const SPlanarVector ahead = planes.FindNearest({1.0, 0.75});
  CHECK(ahead.X == 0.25);
  CHECK(ahead.Y == 0.75);
  const SPlanarVector back = planes.FindNearest({-1.0, 0.75});
  CHECK(back.X == -0.125);
  CHECK(back.Y == 0.75);
}

TEST_CASE("half planes: in a corridor without any room a step goes along it as far as it is open",
          "[unit][kinematics2d]") {
  CHalfPlanes planes;
  planes.Add({{0.0, 1.0}, 0.0, 0, 0.0});
  planes.Add({{0.0, -1.0}, 0.0, 1, 0.0});
  planes.Add({{1.0, 0.0}, 0.5, 2, 0.0});
  const SPlanarVector step = planes.FindNearest({1.0, 0.0});
  CHECK(step.X == 0.5);
  CHECK(step.Y == 0.0);
}

TEST_CASE("half planes: where no step is allowed there is none", "[unit][kinematics2d]") {
  // each side of a triangle is outside of the two others
  CHalfPlanes planes;
  const Real sine = std::sqrt(0.75);
  planes.Add({{1.0, 0.0}, -0.01, 0, 0.0});
  planes.Add({{-0.5, sine}, -0.01, 1, 0.0});
  planes.Add({{-0.5, -sine}, -0.01, 2, 0.0});
  const SPlanarVector step = planes.FindNearest({1.0, 0.25});
  CHECK(step.X == 0.0);
  CHECK(step.Y == 0.0);
}

TEST_CASE("half planes: pushes are opposite to the normals, and add up", "[unit][kinematics2d]") {
  CHalfPlanes planes;
  planes.Add({{1.0, 0.0}, 0.0, 0, 0.25});
  planes.Add({{0.6, 0.8}, 0.0, 1, 0.5});
  planes.Add({{0.0, 1.0}, 0.0, 2, 0.0});
  const SPlanarVector sum = planes.SumPushes();
  CHECK_THAT(sum.X, WithinAbs(-0.55, 1e-15));
  CHECK_THAT(sum.Y, WithinAbs(-0.4, 1e-15));
}

TEST_CASE("half planes: the capacity is 64", "[unit][kinematics2d]") {
  CHalfPlanes planes;
  for (UInt32 i = 0; i < 64; ++i) {
    REQUIRE(planes.Add({{1.0, 0.0}, 1.0, i, 0.0}));
  }
  CHECK_FALSE(planes.Add({{1.0, 0.0}, 1.0, 64, 0.0}));
  planes.Clear();
  CHECK(planes.IsEmpty());
}

}  // namespace argos::half_planes_test
