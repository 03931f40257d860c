#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/simulator/planar_rays.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace planar_rays_test {

using namespace argos;

namespace {

constexpr size_t kRays = 24;

// m, from the centre of a solid's footprint to the half-line on which ray i is
Real DistanceFromHalfLine(const SPlanarRays<kRays>& rays, size_t i, const SIndexedShape& shape) {
  const Real x = shape.X - rays.X[i];
  const Real y = shape.Y - rays.Y[i];
  const Real length = std::hypot(rays.DX[i], rays.DY[i]);
  const Real along = (rays.DX[i] * x + rays.DY[i] * y) / length;
  return along < 0.0 ? std::hypot(x, y) : std::abs(rays.DX[i] * y - rays.DY[i] * x) / length;
}

}  // namespace

TEST_CASE("planar rays: the cheap test rejects no solid that a ray meets, and nearly all others",
          "[robots][rays]") {
  // m: from a table to the widest arenas; places away from the origin cost no precision
  const Real size = GENERATE(1.0, 100.0, 100000.0);
  const Real origin = GENERATE(0.0, 1e6);
  CAPTURE(size, origin);
  CRandomStream random(1, "test", "planar rays", "places");
  size_t numMissed = 0;
  size_t numRejected = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    SPlanarRays<kRays> rays;
    rays.SetCenter(origin, -origin);
    for (size_t i = 0; i < kRays; ++i) {
      const Real angle = random.Uniform(-M_PI, M_PI);
      const Real length = size * std::exp(random.Uniform(-10.0, 1.0));
      rays.Set(i, origin + random.Uniform(-0.2, 0.2), -origin + random.Uniform(-0.2, 0.2),
               length * std::cos(angle), length * std::sin(angle));
    }
    SIndexedShape shape{};
    shape.X = origin + random.Uniform(-size, size);
    shape.Y = -origin + random.Uniform(-size, size);
    shape.Radius = random.Uniform(0.0, 0.1 * size);
    float near[kRays];
    rays.ComputeNearness(shape, kRays, near);
    for (size_t i = 0; i < kRays; ++i) {
      const Real distance = DistanceFromHalfLine(rays, i, shape);
      if (distance <= shape.Radius) {
        CAPTURE(trial, i, distance, shape.Radius);
        REQUIRE(!(near[i] < 0.0F));
      } else {
        ++numMissed;
        numRejected += near[i] < 0.0F ? 1 : 0;
      }
    }
  }
  REQUIRE(numMissed > 10000);
  // a band of some millionths of the distance around the solid is not
  CHECK(static_cast<Real>(numRejected) > 0.999 * static_cast<Real>(numMissed));
}

}  // namespace planar_rays_test
