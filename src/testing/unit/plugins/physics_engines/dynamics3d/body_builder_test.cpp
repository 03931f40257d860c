// What the builder of rigid bodies corrects in descriptions that no rigid body, or no robot, can
// have.

#include "one_body_world.h"

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_world.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace body_builder_test {

using namespace argos;
using Catch::Matchers::WithinRel;

namespace {

using SScene = SOneBodyWorld;

// kg m^2, about x and z
std::array<Real, 2> MomentsOf(const SRigidBody& body) {
  dMass mass;
  dBodyGetMass(body.Body, &mass);
  return {mass.I[0], mass.I[10]};
}

}  // namespace

TEST_CASE("body builder: moments about the horizontal are at least half of that about the vertical",
          "[dynamics3d]") {
  SScene scene;
  // m (a^2 + b^2) / 12
  const Real own = 0.02 / 12.0;
  scene.Description.PlanarInertia = GENERATE(0.001, 0.0033, 0.1);
  const Real planar = *scene.Description.PlanarInertia;
  CAPTURE(planar);
  const auto [x, z] = MomentsOf(scene.Add());
  CHECK_THAT(z, WithinRel(planar, 1e-12));
  CHECK_THAT(x, WithinRel(planar == 0.1 ? 0.05 : own, 1e-12));
}

TEST_CASE("body builder: wheels leave a tenth of the moment of inertia to the rest",
          "[dynamics3d]") {
  SScene scene;
  scene.Description.Drive = SDifferentialDriveDescription{0.2, 0.02, 10.0, 10.0};
  scene.Description.PlanarInertia = 1e-6;
  CHECK_THAT(MomentsOf(scene.Add())[1], WithinRel(1e-7, 1e-12));
}

TEST_CASE("body builder: the centre of mass of a robot is not above its axles", "[dynamics3d]") {
  SScene scene;
  const Real radius = GENERATE(0.02, 0.08);  // m; the middle of the cube is at 0.05 m
  CAPTURE(radius);
  scene.Description.Drive = SDifferentialDriveDescription{0.05, radius, 10.0, 10.0};
  CHECK_THAT(scene.Add().CentreOfMass.GetZ(), WithinRel(radius == 0.02 ? 0.02 : 0.05, 1e-12));
}

TEST_CASE("body builder: the narrowest side is that of any solid", "[dynamics3d]") {
  SScene scene;
  const auto flat = SShapeDescription::Box(CVector3(0.3, 0.2, 0.04));
  const auto slim = SShapeDescription::Box(CVector3(0.3, 0.03, 0.2));
  const bool swapped = GENERATE(false, true);
  CAPTURE(swapped);
  scene.Description.Shapes = swapped ? std::vector{slim, flat} : std::vector{flat, slim};
  CHECK(scene.Add().Narrowest == 0.03);
  scene.Description.Shapes = {flat};
  CHECK(scene.Add().Narrowest == 0.04);
}

TEST_CASE("body builder: axles have the force of the motors, or what their torque leaves",
          "[dynamics3d]") {
  SScene scene;
  const Real torque = GENERATE(0.5, 10.0);  // N m
  CAPTURE(torque);
  scene.Description.Drive = SDifferentialDriveDescription{0.2, 0.02, 10.0, torque};
  const SRigidBody& body = scene.Add();
  // 0.5 N m at 0.2 m between the wheels: 2.5 N, below half of 10 N
  const Real force = torque == 0.5 ? 2.5 : 5.0;
  for (const dJointID axle : body.Axles) {
    CHECK_THAT(dJointGetHingeParam(axle, dParamFMax), WithinRel(force * 0.02, 1e-12));
  }
}

TEST_CASE("body builder: descriptions that no rigid body can have are refused with the reason",
          "[dynamics3d]") {
  using TChange = std::function<void(SBodyDescription&)>;
  struct SCase {
    TChange Change;
    const char* Reason;
  };
  const Real bad = GENERATE(0.0, -1.0, HUGE_VAL, std::nan(""));
  CAPTURE(bad);
  const auto make = [] {
    SBodyDescription description;
    description.Shapes.push_back(SShapeDescription::Box(CVector3(0.1, 0.1, 0.1)));
    description.Mass = 1.0;
    return description;
  };
  const auto flawOf = [&](const TChange& change) {
    SBodyDescription description = make();
    change(description);
    return FindFlaw(description, true);
  };
  const SDifferentialDriveDescription wheels{0.08, 0.02, 1.0, 1.0};
  const SPlanarDriveDescription planar{1.0, 1.0};
  SPropellersDescription propellers;
  propellers.Position = propellers.Yaw = {1.0, 1.0};
  propellers.Velocity = propellers.YawRate = {1.0, 0.0};
  propellers.MaxForce = propellers.MaxTorque = 1.0;
  CHECK(flawOf([](SBodyDescription&) {}).empty());
  CHECK(flawOf([&](SBodyDescription& d) { d.Drive = wheels; }).empty());
  CHECK(flawOf([&](SBodyDescription& d) { d.PlanarDrive = planar; }).empty());
  CHECK(flawOf([&](SBodyDescription& d) { d.Propellers = propellers; }).empty());
  const SCase cases[] = {
      {[&](SBodyDescription& d) { d.Mass = bad; }, "the mass must be"},
      {[&](SBodyDescription& d) { d.PlanarInertia = bad; }, "the moment of inertia must be"},
      {[&](SBodyDescription& d) { d.Shapes[0].Size.SetZ(bad); }, "the sizes of its solids"},
      {[&](SBodyDescription& d) { d.Shapes[0].Offset.SetX(bad <= 0.0 ? HUGE_VAL : bad); },
       "and their places finite"},
      {[&](SBodyDescription& d) { d.Shapes[0].Orientation = CQuaternion(0.0, 0.0, 0.0, 0.0); },
       "and their places finite"},
      {[&](SBodyDescription& d) { (d.Drive = wheels)->InterwheelDistance = bad; },
       "the distance between the wheels and their radius"},
      {[&](SBodyDescription& d) { (d.Drive = wheels)->WheelRadius = bad; },
       "the distance between the wheels and their radius"},
      {[&](SBodyDescription& d) { (d.Drive = wheels)->MaxForce = bad; }, "of the drive must be"},
      {[&](SBodyDescription& d) { (d.Drive = wheels)->MaxTorque = bad; }, "of the drive must be"},
      {[&](SBodyDescription& d) { (d.PlanarDrive = planar)->MaxForce = bad; },
       "of the drive must be"},
      {[&](SBodyDescription& d) { (d.PlanarDrive = planar)->MaxTorque = bad; },
       "of the drive must be"},
      {[&](SBodyDescription& d) { (d.Propellers = propellers)->Position.Derivative = bad; },
       "the gains on position and yaw"},
      {[&](SBodyDescription& d) { (d.Propellers = propellers)->Yaw.Proportional = bad; },
       "the gains on position and yaw"},
      {[&](SBodyDescription& d) { (d.Propellers = propellers)->Velocity.Proportional = bad; },
       "of the gains on velocity and yaw rate"},
      {[&](SBodyDescription& d) { (d.Propellers = propellers)->MaxForce = bad; },
       "of the propellers must be"},
      {[&](SBodyDescription& d) { (d.Propellers = propellers)->MaxTorque = bad; },
       "of the propellers must be"}};
  for (const SCase& c : cases) {
    CHECK_THAT(flawOf(c.Change), Catch::Contains(c.Reason));
  }
  CHECK_THAT(
      flawOf([&](SBodyDescription& d) { (d.Propellers = propellers)->YawRate.Derivative = -1.0; }),
      Catch::Contains("of the gains on velocity and yaw rate"));
  // casters of a fifth of a wheel's radius or so have no place in a solid that is beside the origin
  CHECK_THAT(flawOf([&](SBodyDescription& d) {
               d.Drive = wheels;
               d.Shapes[0].Offset.SetX(0.05);
             }),
             Catch::Contains("to all four sides, where its casters are"));
  // an immovable body has no mass
  SBodyDescription wall = make();
  wall.Mass = bad;
  CHECK(FindFlaw(wall, false).empty());
}

}  // namespace body_builder_test
