// References to bodies that have left; see ARGOS_CHECK_INVARIANTS.

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_world.h>
#include <argos3/testing/support/invariants.h>

#include <catch2/catch.hpp>

namespace stale_bodies_test {

using namespace argos;

namespace {

/** A world with boxes in a row. */
struct SScene {
  SBodyDescription Description;
  CRigidWorld World{SRigidSettings(), [] {}};

  SScene() {
    Description.Shapes.push_back(SShapeDescription::Box(CVector3(0.1, 0.1, 0.1)));
    Description.Mass = 1.0;
  }
  SRigidBody& Add(Real x, bool movable) {
    SRigidSource source;
    source.Description = &Description;
    source.Movable = movable;
    SRigidPose pose;
    pose.Position.SetX(x);
    return World.Add(source, pose);
  }
};

}  // namespace

TEST_CASE("rigid world: a reference to a removed body is noticed", "[dynamics3d][invariants]") {
  UseODEInThisThread();
  const bool movable = GENERATE(true, false);
  SScene scene;
  SRigidBody& first = scene.Add(0.0, movable);
  SRigidBody& second = scene.Add(1.0, movable);
  CHECK(scene.World.Has(first));
  scene.World.Remove(first);
  CHECK_FALSE(scene.World.Has(first));
  CHECK(scene.World.Has(second));
  CHECK(second.Number == 0);
  CheckCaught([&] { scene.World.Remove(first); }, "removed that is not in the world");
  CheckCaught([&] { scene.World.Place(first, {}, {}); }, "placed that is not in the world");
}

TEST_CASE("rigid world: a body with the number of another one is noticed",
          "[dynamics3d][invariants]") {
  UseODEInThisThread();
  SScene scene;
  scene.Add(0.0, true);
  SRigidBody& second = scene.Add(1.0, true);
  second.Number = 0;
  CheckCaught([&] { scene.World.Remove(second); }, "not the one with its number, 0");
}

TEST_CASE("broad phase: bodies that were removed without notice are noticed",
          "[dynamics3d][invariants]") {
  UseODEInThisThread();
  SScene scene;
  std::vector<SRigidBody*> movables = {&scene.Add(0.0, true), &scene.Add(0.05, true)};
  SRigidBody& other = scene.Add(0.06, true);
  CBroadPhase phase;
  CHECK(phase.FindPairs(movables, {}).size() == 1);
  movables.pop_back();
  CheckCaught([&] { phase.FindPairs(movables, {}); }, "without MarkChanged()");
  // as many as before, but the place of one was used again
  movables.push_back(&other);
  CheckCaught([&] { phase.FindPairs(movables, {}); }, "without MarkChanged()");
  phase.MarkChanged();
  CHECK(phase.FindPairs(movables, {}).size() == 1);
}

}  // namespace stale_bodies_test
