// Pushing, braking, robots of other shapes, and the heights and regions of engines.

#include <argos3/testing/contract/physics_engines/arc_and_push.h>
#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/simulator/entities/box_entity.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

namespace argos::bodies_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

std::string BoxXml(const std::string& id, Real x, Real y, Real yaw, Real mass,
                   const std::string& size = "0.2,0.2,0.1") {
  std::ostringstream xml;
  xml << "<box id='" << id << "' size='" << size << "' movable='true' mass='" << mass
      << "'><body position='" << x << "," << y << ",0' orientation='" << yaw << ",0,0'/></box>";
  return xml.str();
}

}  // namespace

TEST_CASE("push: a robot stronger than friction pushes an object at its own speed",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  // where friction does not depend on weight, the wheels stop slipping for any mass of the object
  const Real mass = GENERATE(0.1, 0.5, 10.0);
  CAPTURE(engine, mass);
  if (IsSkipped(engine, engine.GetHold(mass) < 0.9 * engine.Push, "friction so low for 10 kg")) {
    return;
  }
  CDriveWorld world(engine.ToXml(), DriverXml("foot-bot", "r", 0, 0, 0, 10, 10) +
                                        BoxXml("box", kFootBotRadius + 0.11, 0, 0, mass));
  world.Step(40);
  const CVector3 robot = world.Position("r");
  const CVector3 box = world.Position("box");
  world.Step(20);
  // 2 s at 0.1 m/s; single precision errs by 1e-6 m per tick
  CHECK_THAT(world.Position("r").GetX() - robot.GetX(), WithinAbs(0.2, 2e-5 + engine.Slack));
  CHECK_THAT(world.Position("box").GetX() - box.GetX(), WithinAbs(0.2, 2e-5 + engine.Slack));
  CHECK_THAT(world.Position("box").GetX() - world.Position("r").GetX(),
             WithinAbs(kFootBotRadius + 0.1, 0.02 * kFootBotRadius));
}

TEST_CASE("push: robots of one type that drive head-on stop each other", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("e-puck", "a", -0.2, 0, 0, 10, 10) +
                                        DriverXml("e-puck", "b", 0.2, 0, 180, 10, 10));
  world.Step(100);
  CHECK_THAT(world.Position("a").GetX(), WithinAbs(-kEPuckRadius, 0.02 * kEPuckRadius));
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(kEPuckRadius, 0.02 * kEPuckRadius));
  CHECK_THAT(world.Position("a").GetY(), WithinAbs(0.0, 0.02 * kEPuckRadius));
}

TEST_CASE("push: a mirrored scene has mirrored motions", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  const auto scene = [](Real side) {
    return DriverXml("foot-bot", "r", 0, 0.03 * side, 5 * side, side > 0 ? 10 : 11,
                     side > 0 ? 11 : 10) +
           BoxXml("box", kFootBotRadius + 0.15, -0.02 * side, 20 * side, 0.5);
  };
  CDriveWorld left(engine.ToXml(), scene(1.0));
  CDriveWorld right(engine.ToXml(), scene(-1.0));
  for (int tick = 0; tick < 60; ++tick) {
    left.Step();
    right.Step();
  }
  for (const std::string id : {"r", "box"}) {
    CAPTURE(id);
    // the solver treats the two points of a contact one after the other
    CHECK_THAT(left.Position(id).GetX(), WithinAbs(right.Position(id).GetX(), 1e-3 + engine.Slack));
    CHECK_THAT(left.Position(id).GetY(),
               WithinAbs(-right.Position(id).GetY(), 1e-3 + engine.Slack));
    CHECK_THAT(left.Yaw(id), WithinAbs(-right.Yaw(id), 1e-2 + 10.0 * engine.Slack));
  }
  REQUIRE(left.Position("box").GetX() > kFootBotRadius + 0.2);
}

TEST_CASE("push: a box pushed off its centre rotates", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  CDriveWorld world(engine.ToBrakingXml(1.0, 0.5),
                    DriverXml("foot-bot", "r", 0, 0.08, 0, 10, 10) +
                        BoxXml("box", kFootBotRadius + 0.12, 0, 0, 0.5));
  world.Step(40);
  // the push is ahead, on its left side: it turns clockwise
  CHECK(world.Yaw("box") < -0.1);
  CHECK(world.Position("box").GetX() > kFootBotRadius + 0.12);
  if (IsSkipped(engine, engine.Ground == EGround::Force, "friction against turning by itself")) {
    return;
  }
  // friction holds it with 1.49 N m by default, more than 15 N exert at a lever of 8 cm
  CDriveWorld held(engine.ToXml(), DriverXml("foot-bot", "r", 0, 0.08, 0, 10, 10) +
                                       BoxXml("box", kFootBotRadius + 0.12, 0, 0, 1.0));
  held.Step(40);
  // until the solver has converged it yields
  CHECK_THAT(held.Yaw("box"), WithinAbs(0.0, 0.03));
  CHECK(held.Position("box").GetX() > kFootBotRadius + 0.12);
}

TEST_CASE("brakes: a robot with resting wheels yields only to a force that exceeds its own",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  if (IsSkipped(engine, engine.HasMomentum, "robots that push robots")) {
    return;
  }
  // a foot-bot pushes with up to 15 N, an e-puck brakes with up to 1.5 N
  CDriveWorld world(engine.ToXml(), DriverXml("foot-bot", "strong", 0, 0, 0, 10, 10) +
                                        DriverXml("e-puck", "weak", 0.2, 0, 0, 0, 0));
  world.Step(40);
  const Real before = world.Position("weak").GetX();
  world.Step(10);
  CHECK_THAT(world.Position("weak").GetX() - before, WithinAbs(0.1, 1e-4 + engine.Slack));

  // with exchanged roles the strong robot stays
  CDriveWorld other(engine.ToXml(), DriverXml("e-puck", "weak", 0, 0, 0, 10, 10) +
                                        DriverXml("foot-bot", "strong", 0.2, 0, 0, 0, 0));
  other.Step(100);
  CHECK_THAT(other.Position("strong").GetX(), WithinAbs(0.2, 0.03 * kEPuckRadius + engine.Slack));
}

TEST_CASE("shapes: a box-shaped robot follows its arc and pushes with its front",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  constexpr Real kHalfLength = 0.1;  // m
  CDriveWorld world(engine.ToPromptXml(),
                    DriverXml("foot-bot", "free", 3, 3, 30, 9, 10) +
                        DriverXml("foot-bot", "pusher", 0, 0, 0, 10, 10) +
                        "<cylinder id='c' radius='0.05' height='0.1' movable='true' "
                        "mass='0.5'><body position='0.3,0,0'/></cylinder>");
  CheckArcAndPush(world, engine, SShapeDescription::Box(CVector3(2.0 * kHalfLength, 0.15, 0.1)),
                  kHalfLength, 0.0);
}

TEST_CASE("heights: a body must stand on the plane of the engine", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  if (IsSkipped(engine, engine.IsPlane, "plane that bodies must stand on")) {
    return;
  }
  const std::string box =
      "<box id='b' size='1,1,1' movable='false'><body position='0,0,0.5'/></box>";
  CHECK_NOTHROW(CDriveWorld(engine.ToXml("e", "elevation='0.5'"), box));
  CHECK_THROWS_WITH(CDriveWorld(engine.ToPromptXml("ground"), box),
                    Contains("accepts \"b\" (<box>) at (0,0,0.5)") &&
                        Contains("\"ground\" has its plane at z = 0 m") &&
                        Contains("body is at z = 0.5 m") && Contains("elevation=\"0.5\""));
  // each engine accepts the body on its own plane
  CDriveWorld world(engine.ToPromptXml("ground") + engine.ToXml("upstairs", "elevation='0.5'"),
                    box + DriverXml("e-puck", "r", 0, 0, 0, 10, 10));
  CHECK(world.Body("b").GetPhysicsModel(0).GetEngine().GetId() == "upstairs");
  CHECK(world.Body("b").GetPhysicsModelsNum() == 1);
  CHECK(world.Body("r").GetPhysicsModel(0).GetEngine().GetId() == "ground");
  // the box upstairs does not obstruct the robot on the ground
  world.Step(21);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.2, 1e-9));
}

TEST_CASE("heights: for a body that no engine accepts, every engine gives its reason",
          "[contract][engine][errors]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  if (IsSkipped(engine, engine.IsPlane, "plane that bodies must stand on")) {
    return;
  }
  const std::string robot = DriverXml("e-puck", "r", 0, 0, 0, 0, 0);
  const std::string region =
      "<boundaries><sides><vertex point='5,5'/><vertex point='6,5'/><vertex point='6,6'/></sides>"
      "</boundaries>";
  const std::string ground = engine.ToXml("ground");
  const std::string upstairs = engine.ToXml("upstairs", "elevation='2.5'");
  const std::string picky = "<toy_engine id='picky' refuses='box'/>";
  const std::string far = "<toy_engine id='far'>" + region + "</toy_engine>";
  const std::string box =
      "<box id='b' size='1,1,1' movable='true' mass='1'><body position='0,2,1.25'/></box>";
  // the result does not depend on the order of engines
  const std::string engines =
      GENERATE_COPY(ground + upstairs + picky + far, far + picky + upstairs + ground,
                    picky + ground + far + upstairs);
  CHECK_THROWS_WITH(
      CDriveWorld(engines, robot + box),
      Contains("<box>") && Contains("\"b\" (<box>) at (0,2,1.25)") &&
          Contains(
              "\"ground\" has its plane at z = 0 m, but the base of the body is at z = 1.25 m") &&
          Contains("\"upstairs\" has its plane at z = 2.5 m") &&
          Contains("set elevation=\"1.25\" of an engine") &&
          Contains("\"picky\" does not accept a <box>") &&
          Contains("outside the region (<boundaries>) of \"far\""));
  // the same during a run, after which nothing of the box is left
  CDriveWorld world(engines, robot);
  CHECK_THROWS_WITH(
      world.GetSimulator().GetLoopFunctions().AddEntity(
          *std::make_unique<CBoxEntity>("b", CVector3(0, 2, -0.75), CQuaternion(), false,
                                        CVector3(1, 1, 1))
               .release()),
      Contains("\"ground\" has its plane at z = 0 m, but the base of the body is at z = -0.75 m"));
  CHECK_THROWS_WITH(world.GetSpace().GetEntity("b"), Contains("\"b\""));
  world.Step();
}

TEST_CASE("parameters: values out of range are refused", "[contract][engine]") {
  CHECK_THROWS_WITH(CDriveWorld(kDynamics2D.ToXml("e", "gripping_rigidity='-5'"), ""),
                    Contains("\"gripping_rigidity\" must be a number >= 0, found -5"));
  CHECK_NOTHROW(CDriveWorld(
      kDynamics2D.ToXml("e", "", "<spatial_hash><cell_size value='0.1'/></spatial_hash>"), ""));
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  if (IsSkipped(engine, engine.Ground == EGround::Force, "<friction>")) {
    return;
  }
  CHECK_THROWS_WITH(CDriveWorld(engine.ToXml("e", "", "<friction box_linear_friction='-1'/>"), ""),
                    Contains("\"box_linear_friction\" must be a number >= 0, found -1"));
}

}  // namespace argos::bodies_test
