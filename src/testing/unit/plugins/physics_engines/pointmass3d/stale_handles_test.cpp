// Handles and numbers whose body has left; see ARGOS_CHECK_INVARIANTS.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/drivers.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/flyers.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_body.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_engine.h>
#include <argos3/testing/support/invariants.h>

#include <catch2/catch.hpp>

namespace pointmass3d_stale_handles_test {

using namespace argos;

namespace {

/** A body of which only the address is used. */
struct SOwner {
  CPointMass3DEngine Engine;
  CEmbodiedEntity Entity{nullptr, "body"};
  CPointMass3DBody Body{Engine, Entity, CPointMass3DBody::EKind::Driver, CDriveSource()};
};

// three bodies, of which the first is removed, so that the third gets its number; then a fourth
template <typename BODIES, typename ADD>
void CheckHandles(BODIES& bodies, ADD&& add) {
  const SPointMassHandle first = add();
  const SPointMassHandle second = add();
  const SPointMassHandle third = add();
  REQUIRE(bodies.IsCurrent(first));
  CHECK(bodies.Remove(first) == &bodies.GetOwner(0));
  const SPointMassHandle moved = bodies.GetHandle(0);
  CHECK(bodies.GetNumber(moved) == 0);
  CHECK(bodies.GetNumber(second) == 1);
  const SPointMassHandle fourth = add();
  CHECK(bodies.GetNumber(fourth) == third.Slot);
  for (const SPointMassHandle& stale : {first, third}) {
    CHECK_FALSE(bodies.IsCurrent(stale));
    CheckCaught([&] { static_cast<void>(bodies.GetNumber(stale)); }, "stale handle of a body");
    CheckCaught([&] { bodies.Remove(stale); }, "stale handle of a body");
  }
  CHECK(bodies.Remove(fourth) == nullptr);
  CheckCaught([&] { static_cast<void>(bodies.GetNumber(fourth)); }, "stale handle of a body");
  CheckCaught([&] { static_cast<void>(bodies.GetHandle(2)); }, "no body in slot 2 of 2");
  CheckCaught([&] { static_cast<void>(bodies.GetOwner(2)); }, "body with the number 2");
  CheckCaught([&] { static_cast<void>(bodies.GetPose(2)); }, "body with the number 2");
  bodies.Clear();
  CHECK_FALSE(bodies.IsCurrent(moved));
  add();
  CHECK_FALSE(bodies.IsCurrent(moved));
}

}  // namespace

TEST_CASE("drivers: the handle of a removed body is stale, also after its number is used again",
          "[pointmass3d][invariants]") {
  SOwner owner;
  const Real wheels[2] = {0.0, 0.0};
  CDrivers drivers;
  CheckHandles(drivers, [&] {
    return drivers.Add(owner.Body, CDriveSource(wheels, 0.1), SPlanarPose(), 0.0);
  });
}

TEST_CASE("flyers: the handle of a removed body is stale, also after its number is used again",
          "[pointmass3d][invariants]") {
  SOwner owner;
  SBodyDescription description;
  description.Shapes.push_back(SShapeDescription::Cylinder(0.1, 0.1));
  description.Mass = 1.0;
  description.Propellers = SPropellersDescription();
  CFlyers::SSettings settings;
  settings.Owner = &owner.Body;
  settings.Body = &description;
  CFlyers flyers;
  CheckHandles(flyers, [&] { return flyers.Add(settings, SFlightPose()); });
}

}  // namespace pointmass3d_stale_handles_test
