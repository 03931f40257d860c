#include <argos3/core/simulator/geometry/indexed_shape.h>
#include <argos3/plugins/robots/generic/simulator/disc_entries.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace disc_entries_test {

using namespace argos;

namespace {

constexpr size_t kMaxRays = SRayBlock::kSize;

SIndexedShape Disc(Real x, Real y, Real radius) {
  SIndexedShape shape{};
  shape.X = x;
  shape.Y = y;
  shape.Cos = 1.0;
  shape.HalfX = shape.HalfY = shape.Radius = radius;
  shape.ZMax = 1.0;
  shape.Kind = SIndexedShape::EKind::Disc;
  return shape;
}

// rays in the frame of an anchor, and the anchor's pose
struct SRays {
  std::vector<SSensorRay> Rays;
  SUprightPose Pose{0.0, 0.0, 1.0, 0.0};

  void Add(Real x, Real y, Real dx, Real dy) {
    SSensorRay ray;
    ray.Offset = CVector3(x, y, 0.0);
    ray.Direction = CVector3(dx, dy, 0.0);
    Rays.push_back(ray);
  }
  // nearest entry of one ray into any disc, one after the other
  Real FindEntry(size_t ray, const std::vector<SIndexedShape>& discs) const {
    const CVector3& offset = Rays[ray].Offset;
    const CVector3& direction = Rays[ray].Direction;
    const Real x = Pose.X + Pose.Cos * offset.GetX() - Pose.Sin * offset.GetY();
    const Real y = Pose.Y + Pose.Sin * offset.GetX() + Pose.Cos * offset.GetY();
    const Real dx = Pose.Cos * direction.GetX() - Pose.Sin * direction.GetY();
    const Real dy = Pose.Sin * direction.GetX() + Pose.Cos * direction.GetY();
    Real fraction = kNoHit;
    for (const SIndexedShape& disc : discs) {
      fraction = std::min(fraction, IntersectHorizontalRay(disc, x, y, 0.5, dx, dy));
    }
    return fraction;
  }
};

// @return number of rays that hit a disc
size_t CompareWithSingleRays(const SRays& rays, const std::vector<SIndexedShape>& discs) {
  Real fractions[kMaxRays];
  std::fill_n(fractions, kMaxRays, kNoHit);
  SRayBlock block;
  FillBlocks(rays.Rays.data(), rays.Rays.size(), &block);
  SDiscList list;
  for (const SIndexedShape& disc : discs) {
    list.X[list.Size] = disc.X;
    list.Y[list.Size] = disc.Y;
    list.Radius[list.Size++] = disc.Radius;
  }
  EnterDiscs(block, rays.Pose, list, fractions);
  size_t hits = 0;
  for (size_t i = 0; i < kMaxRays; ++i) {
    CAPTURE(i);
    // the last ray fills the block
    CHECK(fractions[i] == rays.FindEntry(std::min(i, rays.Rays.size() - 1), discs));
    hits += i < rays.Rays.size() && fractions[i] <= 1.0 ? 1 : 0;
  }
  return hits;
}

}  // namespace

TEST_CASE("rays among discs: entries equal those of each ray into each disc", "[sensors]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<Real> place(-0.2, 0.2);
  size_t hits = 0;
  size_t rayCount = 0;
  for (int scene = 0; scene < 2000; ++scene) {
    CAPTURE(scene);
    SRays rays;
    const Real yaw = 20.0 * place(random);
    rays.Pose = {0.2 * place(random), 0.2 * place(random), std::cos(yaw), std::sin(yaw)};
    const size_t count = 1 + static_cast<size_t>(scene) % kMaxRays;
    for (size_t i = 0; i < count; ++i) {
      rays.Add(place(random), place(random), place(random), place(random));
    }
    std::vector<SIndexedShape> discs;
    for (int i = 0; i < scene % 12; ++i) {
      discs.push_back(Disc(place(random), place(random), 0.01 + 0.2 * std::abs(place(random))));
    }
    hits += CompareWithSingleRays(rays, discs);
    rayCount += count;
  }
  // the scenes have both
  CHECK(hits > rayCount / 5);
  CHECK(hits < rayCount);
}

TEST_CASE("rays among discs: touched borders, ends on borders, and starts on them", "[sensors]") {
  const Real radius = GENERATE(0.035, 0.5, 1.0);
  const Real shift = GENERATE(0.0, 1e-16, -1e-16, 1e-9, -1e-9);  // m
  const Real origin = GENERATE(0.0, 17.3);
  CAPTURE(radius, shift, origin);
  SRays rays;
  const Real border = origin + radius + shift;
  rays.Add(border, origin, 0.1, 0.0);  // starts there, leads away
  rays.Add(border, origin, -0.1, 0.0);  // starts there, leads inside
  rays.Add(border + 0.1, origin, -0.1, 0.0);  // ends there
  rays.Add(origin - 2.0, border, 4.0, 0.0);  // touches it
  rays.Add(origin, origin, 0.1, 0.1);  // starts at the centre
  rays.Add(border, origin - 1.0, 0.0, 1.0);  // ends where it would touch
  rays.Add(border, origin, 0.0, 1.0);  // starts where it touches
  CompareWithSingleRays(rays, {Disc(origin, origin, radius)});
  CompareWithSingleRays(
      rays, {Disc(origin, origin, radius), Disc(origin + 2.0 * radius, origin, radius)});
}

}  // namespace disc_entries_test
