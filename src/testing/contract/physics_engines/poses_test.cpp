// Poses from users' code: what is not a pose is an error in every engine.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/bounding_box.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace argos::poses_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kNaN = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

struct SWrongPose {
  CVector3 Position;
  CQuaternion Orientation;
  std::string Text;  // of the error
};

const std::vector<SWrongPose> kWrongPoses = {
    {CVector3(), CQuaternion(0, 0, 0, 0), "a quaternion of length 1"},
    {CVector3(), CQuaternion(2, 0, 0, 0), "a quaternion of length 1"},
    {CVector3(), CQuaternion(0.5, 0, 0, 0.5), "a quaternion of length 1"},
    {CVector3(), CQuaternion(kNaN, 0, 0, 0), "a quaternion of length 1"},
    {CVector3(), CQuaternion(1, 0, 0, kInfinity), "a quaternion of length 1"},
    {CVector3(kNaN, 0, 0), CQuaternion(), "the position must be"},
    {CVector3(0, -kInfinity, 0), CQuaternion(), "the position must be"},
    {CVector3(0, 0, 1e300), CQuaternion(), "the position must be"}};

// it contains the solids of the description, at the pose of the body, and nothing else
void CheckBoundingBox(const CEmbodiedEntity& body) {
  const SAnchor& origin = body.GetOriginAnchor();
  const SBoundingBox expected =
      body.GetBodyDescription()->ComputeBoundingBox(origin.Position, origin.Orientation);
  CHECK_THAT(Distance(body.GetBoundingBox().MinCorner, expected.MinCorner), WithinAbs(0.0, 1e-9));
  CHECK_THAT(Distance(body.GetBoundingBox().MaxCorner, expected.MaxCorner), WithinAbs(0.0, 1e-9));
}

}  // namespace

TEST_CASE("poses: moving a body to what is not a pose is an error, and leaves it where it is",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("e-puck", "a", 1, 2, 0, 10, 10));
  world.Step(2);
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  const CVector3 before = world.Position("a");
  for (const SWrongPose& wrong : kWrongPoses) {
    CAPTURE(wrong.Position, wrong.Orientation.GetW());
    CHECK_THROWS_WITH(world.Body("a").MoveTo(wrong.Position, wrong.Orientation),
                      Contains("\"a.body_0\"") && Contains(wrong.Text));
    CHECK_THROWS_WITH(
        functions.MoveEntity(world.Body("a"), wrong.Position, wrong.Orientation, true),
        Contains(wrong.Text));
    CHECK(world.Position("a") == before);
  }
  // of users' own code that moves models
  CPhysicsModel& model = world.Body("a").GetPhysicsModel(size_t(0));
  CHECK_THROWS_WITH(model.MoveTo(CVector3(1, kNaN, 0), CQuaternion()),
                    Contains("\"a\" cannot be moved to") && Contains("must be finite"));
  CHECK_THROWS_WITH(model.MoveTo(CVector3(1, 2, 0), CQuaternion(1, 0, kNaN, 0)),
                    Contains("\"a\" cannot be moved to") && Contains("must be finite"));
  CHECK(world.Position("a") == before);
  world.Step(2);
  CHECK(std::isfinite(world.Position("a").Length()));
}

TEST_CASE("poses: enabled anchors move with the body", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("foot-bot", "a", 1, 2, 30, 10, 5));
  CEmbodiedEntity& body = world.Body("a");
  body.EnableAnchor("turret");
  const SAnchor& anchor = body.GetAnchor("turret");
  const CVector3 start = world.Position("a");
  for (int tick = 0; tick < 5; ++tick) {
    world.Step();
    const SAnchor& origin = body.GetOriginAnchor();
    CVector3 offset = anchor.OffsetPosition;
    offset.Rotate(origin.Orientation);
    CHECK_THAT(Distance(anchor.Position, origin.Position + offset), WithinAbs(0.0, 1e-12));
    // the turret has not turned
    CVector3 ahead = CVector3::X;
    CVector3 expected = CVector3::X;
    ahead.Rotate(anchor.Orientation);
    expected.Rotate(origin.Orientation * anchor.OffsetOrientation);
    CHECK_THAT(Distance(ahead, expected), WithinAbs(0.0, 1e-12));
  }
  CHECK(Distance(world.Position("a"), start) > 0.01);
}

TEST_CASE("poses: enabled anchors and the bounding box move with an object that is pushed",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("foot-bot", "a", 1, 2, 0, 10, 10) +
                                        BoxXml("box", 1.22, 2.03, 20.0, "0.2,0.2,0.1"));
  CEmbodiedEntity& body = world.Body("box");
  body.AddAnchor("mast", CVector3(0.05, 0.02, 0.3), CQuaternion(CRadians(1.0), CVector3::Z));
  body.EnableAnchor("mast");
  const SAnchor& anchor = body.GetAnchor("mast");
  for (int tick = 0; tick < 15; ++tick) {
    world.Step();
    const SAnchor& origin = body.GetOriginAnchor();
    CVector3 offset(0.05, 0.02, 0.3);
    offset.Rotate(origin.Orientation);
    REQUIRE_THAT(Distance(anchor.Position, origin.Position + offset), WithinAbs(0.0, 1e-12));
    CheckBoundingBox(body);
  }
  CHECK(world.Position("box").GetX() > 1.23);
}

TEST_CASE("poses: the bounding box contains solids away from the origin", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), BoxXml("a", 1, 2, 30, "0.2,0.1,0.1"));
  CEmbodiedEntity& body = world.Body("a");
  auto description = std::make_shared<SBodyDescription>(*body.GetBodyDescription());
  description->Shapes = {SShapeDescription::Box(CVector3(0.2, 0.1, 0.1), CVector3(0.3, 0.1, 0)),
                         SShapeDescription::Cylinder(0.05, 0.1, CVector3(-0.1, 0.2, 0))};
  world.GetSpace().RemoveEntityFromPhysicsEngines(body);
  body.SetBodyDescription(description);
  world.GetSpace().AddEntityToPhysicsEngine(body);
  REQUIRE(body.MoveTo(CVector3(1.5, 2.5, 0), CQuaternion(CRadians(2.0), CVector3::Z)));
  CheckBoundingBox(body);
}

TEST_CASE("poses: a body that is made with what is not a pose is an error", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("e-puck", "a", 1, 2, 0, 10, 10));
  const CSimulator::CScope scope(world.GetSimulator());
  for (const SWrongPose& wrong : kWrongPoses) {
    CHECK_THROWS_WITH(CEPuckEntity("b", "driver", wrong.Position, wrong.Orientation),
                      Contains(wrong.Text));
  }
  CHECK(world.GetSpace().GetRootEntityVector().size() == 1);
}

TEST_CASE("poses: an orientation of few digits is scaled to length 1", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("e-puck", "a", 1, 2, 0, 0, 0));
  REQUIRE(world.Body("a").MoveTo(CVector3(2, 2, 0), CQuaternion(0.7, 0, 0, 0.7)));
  // bodies of some engines have an angle of single precision
  CHECK_THAT(world.Body("a").GetOriginAnchor().Orientation.Length(), WithinAbs(1.0, 1e-7));
}

TEST_CASE("poses: a place without a body must be a pose, too", "[contract][engine]") {
  CTestWorld world(SExperiment{
      .Engines = kDynamics2D.ToXml(),
      .Media = "<led id='leds'/>",
      .Arena = "<light id='l' position='0,0,1' color='red' intensity='1' medium='leds'/>"});
  auto& light = world.Get<CLightEntity>("l");
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  for (const SWrongPose& wrong : kWrongPoses) {
    CHECK_THROWS_WITH(functions.MoveEntity(light, wrong.Position, wrong.Orientation),
                      Contains("\"l\"") && Contains(wrong.Text));
  }
  CHECK(light.GetPosition() == CVector3(0, 0, 1));
}

}  // namespace argos::poses_test
