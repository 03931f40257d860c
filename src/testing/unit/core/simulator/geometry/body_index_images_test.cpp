// The body index of a periodic area, compared with one that has copies of all bodies.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <vector>

namespace body_index_images_test {

using namespace argos;
using Catch::WithinAbs;

namespace {

// grazing rays lose half of the digits in a square root
constexpr Real kGrazing = 1e-7;

struct SKind {
  std::shared_ptr<const SBodyDescription> Description;
  bool Movable;
  bool Tilts;
};

// a robot, a box, a stick that lies anywhere, a ball, a large object, or a wall
SKind PickKind(CRandomStream& random) {
  auto description = std::make_shared<SBodyDescription>();
  description->Mass = 1.0;
  const int number = static_cast<int>(random.Uniform(0.0, 6.0));
  switch (number) {
    case 0:
      description->Shapes = {SShapeDescription::Cylinder(0.1, 0.2)};
      break;
    case 1:
      description->Shapes = {SShapeDescription::Box(CVector3(0.3, 0.1, 0.2))};
      break;
    case 2:
      description->Shapes = {SShapeDescription::Cylinder(0.05, 0.5)};
      break;
    case 3:
      description->Shapes = {SShapeDescription::Sphere(0.15)};
      break;
    case 4:
      description->Shapes = {SShapeDescription::Cylinder(0.8, 0.3)};
      break;
    default:
      description->Shapes = {SShapeDescription::Box(CVector3(5.0, 0.1, 0.4))};
      break;
  }
  return {description, number != 5, number == 2};
}

CQuaternion Yaw(CRandomStream& random) {
  return CQuaternion(CRadians(random.Uniform(-4.0, 4.0)), CVector3::Z);
}

CQuaternion Rotation(CRandomStream& random) {
  CQuaternion q(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0),
                random.Uniform(0.1, 1.0));
  return q.Normalize();
}

}  // namespace

TEST_CASE("body index: in a periodic area all images of bodies are found",
          "[core][space][index][torus]") {
  constexpr Real kWidth = 9.0;
  constexpr Real kDepth = 7.0;
  const std::string axes = GENERATE("xy", "x", "y");
  const bool isSorted = GENERATE(false, true);
  CAPTURE(axes, isSorted);
  const int turnsX = axes != "y" ? 3 : 0;
  const int turnsY = axes != "x" ? 3 : 0;
  SPeriodicity period;
  period.X = {1.0, turnsX > 0 ? kWidth : 0.0};
  period.Y = {-2.0, turnsY > 0 ? kDepth : 0.0};
  const CRange<CVector3> area(CVector3(1.0, -2.0, 0.0), CVector3(1.0 + kWidth, -2.0 + kDepth, 1.0));
  CThreadPool pool(0, CreateSchedule("balance_quantity"));
  CBodyIndex torus;
  torus.SetArea(area, period);
  CBodyIndex copies;
  copies.SetArea(area);
  std::vector<std::unique_ptr<CEmbodiedEntity>> bodies;
  const auto add = [&](CBodyIndex& index, const SKind& kind, const CVector3& position,
                       const CQuaternion& orientation) {
    bodies.push_back(
        std::make_unique<CEmbodiedEntity>(nullptr, "body", position, orientation, kind.Movable));
    bodies.back()->SetBodyDescription(kind.Description);
    bodies.back()->EnterIndex(index);
  };
  CRandomStream random(7, "test", "body index", "images");
  for (int i = 0; i < 40; ++i) {
    const SKind kind = PickKind(random);
    const CVector3 place(random.Uniform(1.0, 1.0 + kWidth), random.Uniform(-2.0, -2.0 + kDepth),
                         random.Uniform(-0.2, 0.4));
    const CQuaternion orientation = kind.Tilts ? Rotation(random) : Yaw(random);
    add(torus, kind, place, orientation);
    for (int j = -turnsX; j <= turnsX; ++j) {
      for (int k = -turnsY; k <= turnsY; ++k) {
        add(copies, kind, place + CVector3(j * kWidth, k * kDepth, 0.0), orientation);
      }
    }
  }
  if (isSorted) {
    torus.Rebuild(pool);
    copies.Rebuild(pool);
  }
  int numHits = 0;
  for (int query = 0; query < 200; ++query) {
    // also from outside of the area
    const CVector3 start(random.Uniform(-3.0, 14.0), random.Uniform(-5.0, 8.0),
                         random.Uniform(0.0, 0.3));
    const CRay3 ray(start, start + CVector3(random.Uniform(-2.5, 2.5), random.Uniform(-2.5, 2.5),
                                            random.Uniform(-0.2, 0.2)));
    SEmbodiedEntityIntersectionItem found;
    SEmbodiedEntityIntersectionItem expected;
    REQUIRE(torus.FindClosestHit(found, ray) == copies.FindClosestHit(expected, ray));
    CHECK_THAT(found.TOnRay, WithinAbs(expected.TOnRay, kGrazing));
    numHits += found.IntersectedEntity != nullptr ? 1 : 0;
    const SKind kind = PickKind(random);
    const CQuaternion orientation = kind.Tilts ? Rotation(random) : Yaw(random);
    CHECK((torus.FindOverlap(*kind.Description, start, orientation, CBodyIndex::kNoBody) ==
           CBodyIndex::kNoBody) ==
          (copies.FindOverlap(*kind.Description, start, orientation, CBodyIndex::kNoBody) ==
           CBodyIndex::kNoBody));
    const auto sum = [&](const CBodyIndex& index) {
      Real result = 0.0;
      index.ForShapesNear(start.GetX(), start.GetY(), 1.5, [&](const SIndexedShape& shape) {
        const Real distance = std::hypot(shape.X - start.GetX(), shape.Y - start.GetY());
        // of longer ones, some that only the circle around them brings near may be visited
        const bool isSure = shape.Radius < 1.0 && distance <= 1.5 + shape.Radius;
        result += isSure ? 1.0 + distance * shape.X : 0.0;
      });
      return result;
    };
    CHECK_THAT(sum(torus), WithinAbs(sum(copies), 1e-9));
  }
  CHECK(numHits > 50);
}

}  // namespace body_index_images_test
