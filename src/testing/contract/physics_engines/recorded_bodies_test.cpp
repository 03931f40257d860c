// What users' models call: the functions that record bodies, and the engine's.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_box_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_cylinder_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_velocity_control.h>
#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::recorded_bodies_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

TEST_CASE("users' models: boxes and cylinders have models to derive from", "[contract][engine]") {
  CDriveWorld world(
      "<dynamics2d id='e'><friction box_linear_friction='2' cylinder_angular_friction='3'/>"
      "</dynamics2d>",
      "<box id='b' size='0.2,0.4,0.3' movable='true' mass='3'><body position='1,0,0'/></box>"
      "<cylinder id='c' radius='0.1' height='0.3' movable='false'><body position='2,0,0'/>"
      "</cylinder>");
  auto& engine = dynamic_cast<CDynamics2DEngine&>(world.Body("b").GetPhysicsModel(0).GetEngine());
  CHECK(engine.GetBoxLinearFriction() == 2.0);
  CHECK(engine.GetCylinderAngularFriction() == 3.0);
  CBodyRecording recording;
  const CBodyRecording::CScope scope(recording);
  CDynamics2DBoxModel box(engine, world.Get<CBoxEntity>("b"));
  CHECK(box.GetBody()->m == 3.0);
  CHECK_THAT(box.GetBody()->i, WithinAbs(3.0 * 0.2 / 12.0, 1e-15));
  REQUIRE(box.GetBody()->Shapes.size() == 1);
  CHECK(box.GetBody()->Shapes[0]->Size.y == 0.4);
  CHECK(&box.GetGrippable()->GetEmbodiedEntity() == &world.Body("b"));
  CHECK_THROWS_WITH(box.SetBody(box.GetBody(), 0.1), Contains("SetBody() is called twice"));
  CDynamics2DCylinderModel cylinder(engine, world.Get<CCylinderEntity>("c"));
  CHECK(cylinder.GetBody()->IsStatic);
  CHECK(cylinder.GetBody()->Shapes[0]->Radius == 0.1);
}

TEST_CASE("users' models: an engine has neither gravity nor damping", "[contract][engine]") {
  CDriveWorld world(kDynamics2D.ToXml(), DriverXml("beetle", "k", 0, 0, 0, 0, 0));
  auto& engine = dynamic_cast<CDynamics2DEngine&>(world.Body("k").GetPhysicsModel(0).GetEngine());
  CHECK(engine.GetDamping() == 1.0);
  CHECK_NOTHROW(engine.SetDamping(1.0));
  CHECK_NOTHROW(engine.SetGravity(CVector2()));
  CHECK_THROWS_WITH(engine.SetDamping(0.9), Contains("it must be 1, found 0.9"));
  CHECK_THROWS_WITH(engine.SetGravity(CVector2(0.0, -9.81)), Contains("is horizontal"));
  CHECK_THROWS_WITH(engine.SetGrippingRigidity(-1.0), Contains(">= 0"));
  cpBody body;
  body.IsDescribed = true;
  CDynamics2DVelocityControl control(engine, 1.0, 1.0);
  CHECK_THROWS_WITH(control.AttachTo(&body), Contains("after the constructor of the model"));
  CHECK_THROWS_WITH(cpBoxShapeNew(&body, 0.1, 0.1), Contains("has its shapes already"));
  body.p = cpv(1.0, 2.0);
  cpBodySetAngle(&body, 0.5);
  CVector3 position;
  CQuaternion orientation;
  engine.PositionPhysicsToSpace(position, CVector3(0, 0, 3), &body);
  engine.OrientationPhysicsToSpace(orientation, &body);
  CHECK(position == CVector3(1, 2, 3));
  CHECK_THAT(orientation.GetZ(), WithinAbs(std::sin(0.25), 1e-15));
  // removes the body, too
  engine.RemovePhysicsModel("k");
  CHECK(world.Body("k").GetPhysicsModelsNum() == 0);
  CHECK_THROWS_WITH(engine.RemovePhysicsModel("k"), Contains("no user's model of \"k\""));
}

TEST_CASE("users' models: bodies are recorded only in constructors, and moments follow formulas",
          "[contract][engine]") {
  CHECK_THROWS_WITH(cpBodyNew(1.0, 1.0), Contains("outside of the constructor of a model"));
  CHECK(cpMomentForCircle(2.0, 0.1, 0.2, cpv(0.3, 0.4)) == 2.0 * (0.5 * 0.05 + 0.25));
  CHECK_THAT(cpMomentForBox(3.0, 0.2, 0.4), WithinAbs(3.0 * 0.2 / 12.0, 1e-15));
  // the same box as a polygon, around its centre and around a corner
  const cpVect corners[] = {cpv(-0.1, -0.2), cpv(-0.1, 0.2), cpv(0.1, 0.2), cpv(0.1, -0.2)};
  CHECK_THAT(cpMomentForPoly(3.0, 4, corners, cpvzero), WithinAbs(3.0 * 0.2 / 12.0, 1e-15));
  CHECK_THAT(cpMomentForPoly(3.0, 4, corners, cpv(0.1, 0.2)),
             WithinAbs(3.0 * (0.2 / 12.0 + 0.05), 1e-15));
}

}  // namespace argos::recorded_bodies_test
