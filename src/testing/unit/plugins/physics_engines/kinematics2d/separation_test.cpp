// Compares lines that separate discs and rectangles with sampled points of both.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/separation.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace argos {

using Catch::Matchers::WithinAbs;

namespace {

// m; tolerance for roundings of numbers of order 1
constexpr Real kRounding = 1e-12;

SFootprint MakeBox(Real x, Real y, Real yaw, Real halfX, Real halfY) {
  return {x, y, std::cos(yaw), std::sin(yaw), halfX, halfY, 0.0};
}

// distance from a point to a rectangle, m; 0 inside
Real DistanceTo(const SFootprint& box, Real x, Real y) {
  const Real dx = x - box.X;
  const Real dy = y - box.Y;
  const Real outX = std::max(0.0, std::abs(box.Cos * dx + box.Sin * dy) - box.HalfX);
  const Real outY = std::max(0.0, std::abs(box.Cos * dy - box.Sin * dx) - box.HalfY);
  return std::hypot(outX, outY);
}

// least distance during a step of the centre, by sampling
Real LeastDistance(const SFootprint& box, Real x, Real y, const SStep& step) {
  Real least = HUGE_VAL;
  for (int i = 0; i <= 2000; ++i) {
    least = std::min(least, DistanceTo(box, x + i / 2000.0 * step.X, y + i / 2000.0 * step.Y));
  }
  return least;
}

}  // namespace

TEST_CASE("separation: the line between discs that miss each other allows the whole step",
          "[unit][kinematics2d]") {
  CRandomStream random(1, "test", "separation", "discs");
  int missed = 0;
  for (int scene = 0; scene < 3000; ++scene) {
    const SStep offset = {random.Uniform(-1, 1), random.Uniform(-1, 1)};
    const SStep relative = {random.Uniform(-2, 2), random.Uniform(-2, 2)};
    constexpr Real kReach = 0.2;
    if (std::hypot(offset.X, offset.Y) <= kReach) {
      continue;
    }
    CAPTURE(offset.X, offset.Y, relative.X, relative.Y);
    const SSeparation line = SeparateDiscs(offset, relative, kReach);
    REQUIRE_THAT(std::hypot(line.NormalX, line.NormalY), WithinAbs(1.0, kRounding));
    REQUIRE(line.Gap >= -kRounding);
    const Real squared = relative.X * relative.X + relative.Y * relative.Y;
    const Real share =
        std::clamp(-(offset.X * relative.X + offset.Y * relative.Y) / squared, 0.0, 1.0);
    const Real nearest = std::hypot(offset.X + share * relative.X, offset.Y + share * relative.Y);
    const Real closing = -(line.NormalX * relative.X + line.NormalY * relative.Y);
    if (nearest > kReach) {
      ++missed;
      REQUIRE(closing <= line.Gap + kRounding);
    } else {
      REQUIRE(closing >= line.Gap - kRounding);
    }
  }
  CHECK(missed > 1000);
}

TEST_CASE("separation: disc and rectangle are on opposite sides of the line",
          "[unit][kinematics2d]") {
  CRandomStream random(1, "test", "separation", "boxes");
  constexpr Real kRadius = 0.15;
  int missed = 0;
  int met = 0;
  for (int scene = 0; scene < 1500; ++scene) {
    const SFootprint box = MakeBox(random.Uniform(-1, 1), random.Uniform(-1, 1),
                                   random.Uniform(-std::numbers::pi, std::numbers::pi),
                                   random.Uniform(0.01, 0.5), random.Uniform(0.01, 0.5));
    const SStep step = {random.Uniform(-2, 2), random.Uniform(-2, 2)};
    const Real start = DistanceTo(box, 0.0, 0.0);
    if (start <= kRadius) {
      continue;
    }
    const SSeparation line = SeparateFromFootprint(0.0, 0.0, kRadius, step, box);
    CAPTURE(scene, line.NormalX, line.NormalY, line.Gap);
    REQUIRE_THAT(std::hypot(line.NormalX, line.NormalY), WithinAbs(1.0, kRounding));
    REQUIRE(line.Gap >= -kRounding);
    // all corners are beyond the line, whose distance from the disc's centre is radius plus gap
    for (int corner = 0; corner < 4; ++corner) {
      const Real x = corner & 1 ? box.HalfX : -box.HalfX;
      const Real y = corner & 2 ? box.HalfY : -box.HalfY;
      const Real along = line.NormalX * (box.X + box.Cos * x - box.Sin * y) +
                         line.NormalY * (box.Y + box.Sin * x + box.Cos * y);
      REQUIRE(along >= kRadius + line.Gap - kRounding);
    }
    REQUIRE_THAT(DistanceTo(box, line.PointX, line.PointY), WithinAbs(0.0, kRounding));
    const Real closing = line.NormalX * step.X + line.NormalY * step.Y;
    const Real least = LeastDistance(box, 0.0, 0.0, step);
    // sampling finds the least distance to about 1e-6
    if (least > kRadius + 1e-5) {
      ++missed;
      REQUIRE(closing <= line.Gap + kRounding);
    } else if (least < kRadius - 1e-5) {
      ++met;
      REQUIRE(closing >= line.Gap - kRounding);
    }
  }
  CHECK(missed > 300);
  CHECK(met > 200);
}

TEST_CASE("separation: a disc inside a rectangle leaves it by the shortest way",
          "[unit][kinematics2d]") {
  const SFootprint box = MakeBox(0.0, 0.0, 0.0, 1.0, 0.5);
  const SSeparation line = SeparateFromFootprint(0.2, 0.4, 0.1, {}, box);
  // 10 cm from its centre to the upper side plus 10 cm of radius
  CHECK_THAT(line.NormalY, WithinAbs(-1.0, kRounding));
  CHECK_THAT(line.Gap, WithinAbs(-0.2, kRounding));
}

TEST_CASE("separation: boxes face to face touch in two points", "[unit][kinematics2d]") {
  const Real yaw = GENERATE(0.0, 0.3, 2.0);
  CAPTURE(yaw);
  const SFootprint a = MakeBox(0.0, 0.0, yaw, 0.5, 0.5);
  // 0.25 m ahead of a's face and a third as wide as it
  const SFootprint b = MakeBox(0.85 * std::cos(yaw), 0.85 * std::sin(yaw), yaw, 0.1, 0.15);
  SSeparation contacts[2];
  REQUIRE(FindContacts(a, b, contacts) == 2);
  for (const SSeparation& contact : contacts) {
    CHECK_THAT(contact.NormalX, WithinAbs(std::cos(yaw), kRounding));
    CHECK_THAT(contact.NormalY, WithinAbs(std::sin(yaw), kRounding));
    CHECK_THAT(contact.Gap, WithinAbs(0.25, kRounding));
    CHECK_THAT(DistanceTo(b, contact.PointX, contact.PointY), WithinAbs(0.0, kRounding));
  }
  CHECK_THAT(
      std::hypot(contacts[0].PointX - contacts[1].PointX, contacts[0].PointY - contacts[1].PointY),
      WithinAbs(0.3, kRounding));
  CHECK_THAT(ComputeGap(a, b), WithinAbs(0.25, kRounding));
  CHECK_THAT(ComputeGap(b, a), WithinAbs(0.25, kRounding));
}

}  // namespace argos
