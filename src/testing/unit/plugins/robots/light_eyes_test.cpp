#include <argos3/core/simulator/geometry/indexed_shape.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/simulator/light_eyes.h>

#include <catch2/catch.hpp>

#include <algorithm>

namespace light_eyes_test {

using namespace argos;

namespace {

SIndexedShape MakeDisc(const CVector3& base, Real radius, Real height) {
  SIndexedShape disc{};
  disc.X = base.GetX();
  disc.Y = base.GetY();
  disc.HalfX = disc.HalfY = disc.Radius = radius;
  disc.ZMin = base.GetZ();
  disc.ZMax = base.GetZ() + height;
  disc.Kind = SIndexedShape::EKind::Disc;
  return disc;
}

CVector3 DrawPoint(CRandomStream& random) {
  return CVector3(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(0.0, 1.0));
}

// Sensors that are not turned away from the light, whose lines to it are of all kinds: steep,
// level, upright, inside the disc, along its top or bottom, and of no length.
void PlaceEyes(CRandomStream& random, const SIndexedShape& disc, const CVector3& light,
               SLightEyes& eyes) {
  std::fill_n(eyes.DirectionX, SLightEyes::kCapacity, 0.0);
  std::fill_n(eyes.DirectionY, SLightEyes::kCapacity, 0.0);
  std::fill_n(eyes.DirectionZ, SLightEyes::kCapacity, 0.0);
  for (size_t i = 0; i < SLightEyes::kCapacity; ++i) {
    CVector3 place = DrawPoint(random);
    if (i % 5 == 1) {
      place.SetZ(light.GetZ());
    } else if (i % 5 == 2) {
      place.Set(light.GetX(), light.GetY(), place.GetZ());
    } else if (i % 5 == 3) {
      place.Set(disc.X + random.Uniform(-0.2, 0.2), disc.Y,
                random.Bernoulli(0.5) ? disc.ZMin : 0.3);
    } else if (i == 14) {
      place = light;
    }
    eyes.X[i] = place.GetX();
    eyes.Y[i] = place.GetY();
    eyes.Z[i] = place.GetZ();
  }
}

}  // namespace

TEST_CASE("light eyes: a disc occludes for the sensors whose line to the light meets it",
          "[robots][light]") {
  CRandomStream random(1, "test", "light eyes", "discs");
  size_t numClear = 0;
  size_t numOccluded = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    CAPTURE(trial);
    const SIndexedShape disc =
        MakeDisc(DrawPoint(random), random.Uniform(0.0, 0.4), random.Uniform(0.0, 0.5));
    CVector3 light = DrawPoint(random);
    if (trial % 4 == 1) {
      light.SetZ(disc.ZMin);
    } else if (trial % 4 == 2) {
      light.SetZ(disc.ZMax);
    }
    SLightEyes eyes;
    eyes.Count = trial % 2 == 0 ? SLightEyes::kCapacity : 13;
    PlaceEyes(random, disc, light, eyes);
    REQUIRE(eyes.LookAt(light) == eyes.Count);
    // one that is not clear for another reason stays so
    eyes.IsClear[4] = 0;
    const bool isAnyClear = eyes.FindClear(disc, eyes.IsClear);
    bool isAnyExpected = false;
    for (size_t i = 0; i < eyes.Count; ++i) {
      CAPTURE(i);
      const bool isMet = IntersectRay(disc, CRay3(eyes.GetPosition(i), light)) <= 1.0;
      const bool isClear = i != 4 && !isMet;
      REQUIRE((eyes.IsClear[i] != 0) == isClear);
      isAnyExpected = isAnyExpected || isClear;
      ++(isMet ? numOccluded : numClear);
    }
    REQUIRE(isAnyClear == isAnyExpected);
  }
  // both cases occur often
  CHECK(numOccluded > 5000);
  CHECK(numClear > 5000);
}

}  // namespace light_eyes_test
