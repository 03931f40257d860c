// What the builder of rigid bodies corrects in descriptions that no rigid body, or no robot, can
// have.

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_world.h>

#include <catch2/catch.hpp>

#include <array>

namespace body_builder_test {

using namespace argos;
using Catch::Matchers::WithinRel;

namespace {

/** A movable body of 1 kg: a cube of 0.1 m. */
struct SScene {
  SBodyDescription Description;
  std::array<Real, 2> Wheels{};  // m/s
  CRigidWorld World{SRigidSettings(), [] {}};

  SScene() {
    UseODEInThisThread();
    Description.Shapes.push_back(SShapeDescription::Box(CVector3(0.1, 0.1, 0.1)));
    Description.Mass = 1.0;
  }
  SRigidBody& Add() {
    SRigidSource source;
    source.Description = &Description;
    if (Description.Drive) {
      source.Drive = CDriveSource(Wheels.data(), Description.Drive->InterwheelDistance);
    }
    return World.Add(source, SRigidPose());
  }
};

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

}  // namespace body_builder_test
