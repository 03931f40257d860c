#include <argos3/core/simulator/physics_engine/ray_queries.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace embodied_entity_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

// rounding of rotated vectors of the order of 1
constexpr Real kRounding = 1e-15;

const char* const kTwoRobotsAndAWall = R"(
  <toy-robot id='a'> <body position='0,0,0' orientation='90,0,0' /> <controller config='c' /> </toy-robot>
  <toy-robot id='b'> <body position='1,0,0' /> <controller config='c' /> </toy-robot>
  <toy-block id='wall' size='0.2,2,0.5' movable='false'> <body position='2,0,0' /> </toy-block>)";

CTestWorld MakeWorld() {
  return CTestWorld(SExperiment{.Controllers = R"(<toy_controller id='c'>
      <actuators> <toy_drive implementation='default' /> </actuators> </toy_controller>)",
                                .Engines = "<toy_engine id='toy' />",
                                .Arena = kTwoRobotsAndAWall});
}

void CheckNear(const CVector3& a, const CVector3& b) {
  CAPTURE(a, b);
  CHECK_THAT((a - b).Length(), WithinAbs(0.0, kRounding));
}

}  // namespace

TEST_CASE("anchors: the origin is always in use", "[core][entity]") {
  CEmbodiedEntity body(nullptr, "body_0", CVector3(1.0, 2.0, 3.0));
  CHECK(body.GetOriginAnchor().Index == 0);
  CHECK(body.GetOriginAnchor().Id == "origin");
  CHECK(body.GetOriginAnchor().Position == CVector3(1.0, 2.0, 3.0));
  CHECK(body.IsAnchorEnabled("origin"));
  CHECK(&body.GetAnchor("origin") == &body.GetOriginAnchor());
  CHECK_THROWS_WITH(body.DisableAnchor("origin"), Contains("origin") && Contains("body_0"));
  body.EnableAnchor("origin");
  body.DisableAnchor("origin");
  CHECK(body.IsAnchorEnabled("origin"));
}

TEST_CASE("anchors: uses are counted, and anchors in use are listed by index", "[core][entity]") {
  CEmbodiedEntity body(nullptr, "body_0");
  body.AddAnchor("first");
  body.AddAnchor("second");
  CHECK(body.GetAnchors().size() == 3);
  CHECK(body.GetEnabledAnchors().size() == 1);
  body.EnableAnchor("second");
  body.EnableAnchor("second");
  body.EnableAnchor("first");
  REQUIRE(body.GetEnabledAnchors().size() == 3);
  CHECK(body.GetEnabledAnchors()[1]->Id == "first");
  CHECK(body.GetEnabledAnchors()[2]->Id == "second");
  CHECK(body.GetAnchor("second").InUseCount == 2);
  body.DisableAnchor("second");
  CHECK(body.IsAnchorEnabled("second"));
  body.DisableAnchor("second");
  CHECK_FALSE(body.IsAnchorEnabled("second"));
  CHECK(body.GetEnabledAnchors().size() == 2);
  // disabling a disabled anchor is harmless
  body.DisableAnchor("second");
  CHECK(body.GetAnchor("second").InUseCount == 0);
}

TEST_CASE("anchors: unknown and duplicate ids are errors", "[core][entity]") {
  CEmbodiedEntity body(nullptr, "body_0");
  body.AddAnchor("turret");
  CHECK_THROWS_WITH(body.AddAnchor("turret"), Contains("turret"));
  CHECK_THROWS_WITH(body.GetAnchor("turet"), Contains("turet") && Contains("turret"));
  CHECK_THROWS_AS(body.EnableAnchor("turet"), CARGoSException);
  CHECK_THROWS_AS(body.IsAnchorEnabled("turet"), CARGoSException);
}

TEST_CASE("anchors: initial poses are rigidly attached to the body's pose", "[core][entity]") {
  CEmbodiedEntity body(nullptr, "body_0", CVector3(1.0, 0.0, 0.0),
                       CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));
  const SAnchor& anchor = body.AddAnchor("arm", CVector3(0.5, 0.25, 0.1),
                                         CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));
  CheckNear(anchor.Position, CVector3(0.75, 0.5, 0.1));
  CVector3 ahead = CVector3::X;
  ahead.Rotate(anchor.Orientation);
  CheckNear(ahead, CVector3(-1.0, 0.0, 0.0));
}

TEST_CASE("anchors: those in use follow the body, the others keep their poses", "[core][entity]") {
  CTestWorld world = MakeWorld();
  auto& robot = world.Get<CToyRobotEntity>("a");
  CEmbodiedEntity& body = robot.GetEmbodiedEntity();
  SAnchor& idle = body.AddAnchor("idle", CVector3(0.1, 0.0, 0.0));
  SAnchor& used = body.AddAnchor("used", CVector3(0.1, 0.0, 0.02),
                                 CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));
  used.Enable();
  const CVector3 idleBefore = idle.Position;
  robot.GetMotor().Velocity = CVector3(0.0, 0.3, 0.0);
  dynamic_cast<CToyController&>(robot.GetControllableEntity().GetController()).Velocity =
      CVector3(0.0, 0.3, 0.0);
  world.Step(11);
  // commands act from the second tick on: 10 ticks of 0.1 s; x of the body points along world y
  CheckNear(body.GetOriginAnchor().Position, CVector3(0.0, 0.3, 0.0));
  CheckNear(used.Position, CVector3(0.0, 0.4, 0.02));
  CVector3 ahead = CVector3::X;
  ahead.Rotate(used.Orientation);
  CheckNear(ahead, CVector3(-1.0, 0.0, 0.0));
  CHECK(idle.Position == idleBefore);
}

TEST_CASE("embodied entity: without an engine it has neither bounding box nor models",
          "[core][entity]") {
  CEmbodiedEntity body(nullptr, "body_0");
  CHECK(body.GetPhysicsModelsNum() == 0);
  CHECK_THROWS_WITH(body.GetBoundingBox(), Contains("body_0"));
  CHECK_THROWS_WITH(body.GetPhysicsModel(size_t(0)), Contains("0"));
  CHECK_THROWS_WITH(body.GetPhysicsModel("dyn"), Contains("dyn"));
  CHECK_THROWS_WITH(body.RemovePhysicsModel("dyn"), Contains("dyn"));
  CHECK_FALSE(body.IsCollidingWithSomething());
  body.CalculateBoundingBox();
  CHECK_THROWS_AS(body.GetBoundingBox(), CARGoSException);
}

TEST_CASE("embodied entity: reports its engine and its bounding box", "[core][entity]") {
  CTestWorld world = MakeWorld();
  CEmbodiedEntity& body = world.Get<CToyRobotEntity>("b").GetEmbodiedEntity();
  REQUIRE(body.GetPhysicsModelsNum() == 1);
  CHECK(&body.GetPhysicsModel(0).GetEngine() == &world.GetSimulator().GetPhysicsEngine("toy"));
  CHECK(&body.GetPhysicsModel("toy") == &body.GetPhysicsModel(0));
  CheckNear(body.GetBoundingBox().MinCorner, CVector3(0.95, -0.05, 0.0));
  CheckNear(body.GetBoundingBox().MaxCorner, CVector3(1.05, 0.05, 0.1));
  CHECK(body.IsMovable());
  CHECK_THROWS_WITH(body.AddPhysicsModel("other", body.GetPhysicsModel(0)),
                    Contains("toy") && Contains("other"));
}

TEST_CASE("bounding boxes: those that share a face intersect, distant ones do not",
          "[core][entity]") {
  const SBoundingBox box{CVector3(0.0, 0.0, 0.0), CVector3(1.0, 1.0, 1.0)};
  CHECK(box.Intersects({CVector3(0.5, 0.5, 0.5), CVector3(2.0, 2.0, 2.0)}));
  CHECK(box.Intersects({CVector3(1.0, 0.0, 0.0), CVector3(2.0, 1.0, 1.0)}));
  CHECK(box.Intersects({CVector3(0.4, 0.4, 0.4), CVector3(0.6, 0.6, 0.6)}));
  CHECK_FALSE(box.Intersects({CVector3(1.001, 0.0, 0.0), CVector3(2.0, 1.0, 1.0)}));
  CHECK_FALSE(box.Intersects({CVector3(0.0, 0.0, -2.0), CVector3(1.0, 1.0, -0.001)}));
}

TEST_CASE("MoveTo: moves a body to a free place", "[core][entity][move]") {
  CTestWorld world = MakeWorld();
  CEmbodiedEntity& body = world.Get<CToyRobotEntity>("a").GetEmbodiedEntity();
  body.EnableAnchor("top");
  CHECK(body.MoveTo(CVector3(-1.0, 0.5, 0.0), CQuaternion()));
  CHECK(body.GetOriginAnchor().Position == CVector3(-1.0, 0.5, 0.0));
  CheckNear(body.GetAnchor("top").Position, CVector3(-1.0, 0.5, 0.1));
  CheckNear(body.GetBoundingBox().MinCorner, CVector3(-1.05, 0.45, 0.0));
}

TEST_CASE("MoveTo: restores the old pose if the place is occupied", "[core][entity][move]") {
  CTestWorld world = MakeWorld();
  CEmbodiedEntity& body = world.Get<CToyRobotEntity>("a").GetEmbodiedEntity();
  const CQuaternion before = body.GetOriginAnchor().Orientation;
  CHECK_FALSE(body.MoveTo(CVector3(1.05, 0.0, 0.0), CQuaternion()));
  CHECK(body.GetOriginAnchor().Position == CVector3());
  CHECK(body.GetOriginAnchor().Orientation.GetZ() == before.GetZ());
  CheckNear(body.GetBoundingBox().MinCorner, CVector3(-0.05, -0.05, 0.0));
  CHECK_FALSE(body.IsCollidingWithSomething());
}

TEST_CASE("MoveTo: with the check-only flag the body never moves", "[core][entity][move]") {
  CTestWorld world = MakeWorld();
  CEmbodiedEntity& body = world.Get<CToyRobotEntity>("a").GetEmbodiedEntity();
  CHECK(body.MoveTo(CVector3(-1.0, 0.5, 0.0), CQuaternion(), true));
  CHECK(body.GetOriginAnchor().Position == CVector3());
  CHECK_FALSE(body.MoveTo(CVector3(1.9, 0.0, 0.0), CQuaternion(), true));
  CHECK(body.MoveTo(CVector3(1.9, 0.0, 0.0), CQuaternion(), true, true));
  CHECK(body.GetOriginAnchor().Position == CVector3());
}

TEST_CASE("MoveTo: when ignoring collisions the body moves, and the call succeeds",
          "[core][entity][move]") {
  CTestWorld world = MakeWorld();
  CEmbodiedEntity& body = world.Get<CToyRobotEntity>("a").GetEmbodiedEntity();
  CHECK(body.MoveTo(CVector3(1.05, 0.0, 0.0), CQuaternion(), false, true));
  CHECK(body.GetOriginAnchor().Position == CVector3(1.05, 0.0, 0.0));
  CHECK(body.IsCollidingWithSomething());
}

TEST_CASE("MoveTo: rays find the body in its new place at once", "[core][entity][move]") {
  CTestWorld world = MakeWorld();
  const CSimulator::CScope scope(world.GetSimulator());
  CEmbodiedEntity& body = world.Get<CToyRobotEntity>("a").GetEmbodiedEntity();
  REQUIRE(body.MoveTo(CVector3(-2.0, 3.0, 0.0), CQuaternion()));
  const CRay3 ray(CVector3(-3.0, 3.0, 0.05), CVector3(-1.0, 3.0, 0.05));
  const CRay3 old(CVector3(-0.5, 0.0, 0.05), CVector3(0.5, 0.0, 0.05));
  SEmbodiedEntityIntersectionItem item;
  REQUIRE(GetClosestEmbodiedEntityIntersectedByRay(item, ray));
  CHECK(item.IntersectedEntity == &body);
  // 0.95 m of 2 m
  CHECK_THAT(item.TOnRay, WithinAbs(0.475, kRounding));
  CHECK_FALSE(GetClosestEmbodiedEntityIntersectedByRay(item, old));
  CHECK_FALSE(GetClosestEmbodiedEntityIntersectedByRay(item, ray, body));
  TEmbodiedEntityIntersectionData all;
  REQUIRE(GetEmbodiedEntitiesIntersectedByRay(
      all, CRay3(CVector3(0.5, 0.0, 0.05), CVector3(2.5, 0.0, 0.05))));
  std::sort(all.begin(), all.end());
  REQUIRE(all.size() == 2);
  CHECK(all[0].IntersectedEntity == &world.Get<CToyRobotEntity>("b").GetEmbodiedEntity());
  CHECK_THAT(all[0].TOnRay, WithinAbs(0.225, kRounding));
  CHECK(all[1].IntersectedEntity == &world.Get<CToyBlockEntity>("wall").GetEmbodiedEntity());
  CHECK_THAT(all[1].TOnRay, WithinAbs(0.7, kRounding));
}

TEST_CASE("MoveTo: a moved wall returns to its place on reset, for rays too",
          "[core][entity][move]") {
  CTestWorld world = MakeWorld();
  const CSimulator::CScope scope(world.GetSimulator());
  CEmbodiedEntity& wall = world.Get<CToyBlockEntity>("wall").GetEmbodiedEntity();
  REQUIRE(wall.MoveTo(CVector3(3.0, 0.0, 0.0), CQuaternion()));
  world.Step();
  world.GetSimulator().Reset();
  CHECK(wall.GetOriginAnchor().Position == CVector3(2.0, 0.0, 0.0));
  SEmbodiedEntityIntersectionItem item;
  REQUIRE(GetClosestEmbodiedEntityIntersectedByRay(
      item, CRay3(CVector3(1.5, 0.0, 0.2), CVector3(3.5, 0.0, 0.2))));
  CHECK_THAT(item.TOnRay, WithinAbs(0.2, kRounding));
}

}  // namespace embodied_entity_test
