// What parts bodies in Box2D that overlap.

#include "planar_scene.h"

#include <argos3/plugins/simulator/physics_engines/dynamics2d/overlap_solver.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>

#include <box2d/box2d.h>
#include <catch2/catch.hpp>

namespace overlap_solver_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kUnits = 1.0 / CPlanarScene::kRadius;  // for a metre
constexpr Real kTolerance = 1e-3;  // units

/** Bodies of a store, in units of Box2D. */
struct SOverlaps {
  CPlanarScene Scene;
  COverlapSolver Solver;

  b2Body& Add(Real x, const SShapeDescription& shape, Real mass) {
    SBodyDescription description;
    description.Shapes.push_back(shape);
    description.Mass = mass;
    b2Body& body = Scene.Store.CreateBody(
        CPlanarScene::PoseAt(x / kUnits, 0.0),
        mass > 0.0 ? EPlanarKind::Passive : EPlanarKind::Immovable, SPlanarOwner(), false);
    AddFixtures(body, description, kUnits, 0.5);
    if (mass > 0.0) {
      SetMass(body, description, kUnits);
    }
    return body;
  }
  b2Body& AddDisc(Real x, Real mass) {
    return Add(x, SShapeDescription::Cylinder(1.0 / kUnits, 0.1), mass);
  }
  b2Body& AddBox(Real x, Real mass) {
    return Add(x, SShapeDescription::Box(CVector3(2.0 / kUnits, 2.0 / kUnits, 0.1)), mass);
  }
  float Resolve() {
    // finds contacts, moves nothing
    Scene.Store.GetWorld().Step(0.0F, 0, 0);
    return Solver.Resolve(Scene.Store.GetWorld());
  }
};

}  // namespace

TEST_CASE("overlap solver: two bodies are parted in inverse proportion to their masses",
          "[dynamics2d]") {
  const bool areBoxes = GENERATE(true, false);
  const Real mass = GENERATE(1.0, 3.0, 0.0);  // kg, of the second; 0: it does not move
  CAPTURE(areBoxes, mass);
  SOverlaps overlaps;
  b2Body& first = areBoxes ? overlaps.AddBox(0.0, 1.0) : overlaps.AddDisc(0.0, 1.0);
  b2Body& second = areBoxes ? overlaps.AddBox(1.9, mass) : overlaps.AddDisc(1.9, mass);
  CHECK(overlaps.Resolve() <= kTolerance);
  const Real share = mass > 0.0 ? mass / (1.0 + mass) : 1.0;
  CHECK_THAT(first.GetPosition().x, WithinAbs(-0.1 * share, kTolerance));
  CHECK_THAT(second.GetPosition().x, WithinAbs(1.9 + 0.1 * (1.0 - share), kTolerance));
  for (const b2Body* body : {&first, &second}) {
    CHECK_THAT(body->GetPosition().y, WithinAbs(0.0, kTolerance));
    CHECK_THAT(body->GetAngle(), WithinAbs(0.0, kTolerance));
  }
}

TEST_CASE("overlap solver: bodies without an overlap stay where they are", "[dynamics2d]") {
  const bool areBoxes = GENERATE(true, false);
  CAPTURE(areBoxes);
  SOverlaps overlaps;
  b2Body& first = areBoxes ? overlaps.AddBox(0.0, 1.0) : overlaps.AddDisc(0.0, 1.0);
  b2Body& second = areBoxes ? overlaps.AddBox(2.001, 1.0) : overlaps.AddDisc(2.001, 1.0);
  const b2Vec2 before = second.GetPosition();
  CHECK(overlaps.Resolve() == 0.0F);
  CHECK(first.GetPosition() == b2Vec2(0.0F, 0.0F));
  CHECK(second.GetPosition() == before);
}

TEST_CASE("overlap solver: a body that is pushed into one that was not near parts from both",
          "[dynamics2d]") {
  SOverlaps overlaps;
  b2Body& heavy = overlaps.AddDisc(0.0, 100.0);
  b2Body& pushed = overlaps.AddDisc(1.5, 1.0);
  // beyond what Box2D takes for a contact
  b2Body& far = overlaps.AddDisc(3.85, 1.0);
  overlaps.Resolve();
  CHECK(pushed.GetPosition().x - heavy.GetPosition().x >= 2.0 - 2.0 * kTolerance);
  CHECK(far.GetPosition().x - pushed.GetPosition().x >= 2.0 - 2.0 * kTolerance);
}

}  // namespace overlap_solver_test
