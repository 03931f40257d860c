#include <argos3/plugins/robots/generic/simulator/disc_entries.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace argos;

namespace {

constexpr size_t kMaxRays = 8;

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

// nearest entry of one ray into any disc, one after the other
Real FindEntry(const SPlanarRays<kMaxRays>& rays, size_t ray,
               const std::vector<SIndexedShape>& discs) {
  Real fraction = kNoHit;
  for (const SIndexedShape& disc : discs) {
    fraction = std::min(fraction, IntersectHorizontalRay(disc, rays.X[ray], rays.Y[ray], 0.5,
                                                         rays.DX[ray], rays.DY[ray]));
  }
  return fraction;
}

size_t CompareWithSingleRays(const SPlanarRays<kMaxRays>& rays, size_t count,
                             const std::vector<SIndexedShape>& discs) {
  Real fractions[kMaxRays];
  std::fill_n(fractions, count, kNoHit);
  CDiscEntries<kMaxRays> entries(rays);
  entries.Start(count);
  for (const SIndexedShape& disc : discs) {
    entries.Enter(disc);
  }
  entries.Take(fractions);
  size_t hits = 0;
  for (size_t i = 0; i < count; ++i) {
    CAPTURE(i);
    CHECK(fractions[i] == FindEntry(rays, i, discs));
    hits += fractions[i] <= 1.0 ? 1 : 0;
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
    SPlanarRays<kMaxRays> rays;
    const size_t count = 1 + static_cast<size_t>(scene) % kMaxRays;
    for (size_t i = 0; i < count; ++i) {
      rays.Set(i, place(random), place(random), place(random), place(random));
    }
    std::vector<SIndexedShape> discs;
    for (int i = 0; i < scene % 12; ++i) {
      discs.push_back(Disc(place(random), place(random), 0.01 + 0.2 * std::abs(place(random))));
    }
    hits += CompareWithSingleRays(rays, count, discs);
    rayCount += count;
  }
  // the scenes have both
  CHECK(hits > rayCount / 4);
  CHECK(hits < rayCount);
}

TEST_CASE("rays among discs: touched borders, ends on borders, and starts on them", "[sensors]") {
  const Real radius = GENERATE(0.035, 0.5, 1.0);
  const Real shift = GENERATE(0.0, 1e-16, -1e-16, 1e-9, -1e-9);  // m
  const Real origin = GENERATE(0.0, 17.3);
  CAPTURE(radius, shift, origin);
  SPlanarRays<kMaxRays> rays;
  const Real border = origin + radius + shift;
  rays.Set(0, border, origin, 0.1, 0.0);  // starts there, leads away
  rays.Set(1, border, origin, -0.1, 0.0);  // starts there, leads inside
  rays.Set(2, border + 0.1, origin, -0.1, 0.0);  // ends there
  rays.Set(3, origin - 2.0, border, 4.0, 0.0);  // touches it
  rays.Set(4, origin, origin, 0.1, 0.1);  // starts at the centre
  rays.Set(5, border, origin - 1.0, 0.0, 1.0);  // ends where it would touch
  rays.Set(6, border, origin, 0.0, 1.0);  // starts where it touches
  CompareWithSingleRays(rays, 7, {Disc(origin, origin, radius)});
  CompareWithSingleRays(
      rays, 7, {Disc(origin, origin, radius), Disc(origin + 2.0 * radius, origin, radius)});
}
