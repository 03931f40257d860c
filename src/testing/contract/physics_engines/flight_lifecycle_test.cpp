// Adding, moving, removing, resetting and transferring flying robots during a run.

#include <argos3/testing/contract/physics_engines/flight_world.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/no_allocation.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace argos::flight_lifecycle_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using testing::ComputeStepResponse;
using testing::ComputeWayToSpeed;

namespace {

constexpr Real kSubstep = 0.01;  // s
constexpr UInt32 kSubsteps = 10;
constexpr Real kRounding = 1e-12;
constexpr UInt32 kRobots = 19;  // two full blocks and a part of one

std::string Id(UInt32 number) {
  return "r" + std::to_string(number);
}

SFlightExperiment Fleet(const std::string& actuator) {
  SFlightExperiment experiment;
  experiment.Actuator = actuator;
  for (UInt32 i = 0; i < kRobots; ++i) {
    experiment.Arena += EyeBotXml(Id(i), CVector3(0.0, i - 9.0, 2.0), 10.0 * i);
  }
  return experiment;
}

// distinct orders for each robot and tick
void OrderSomething(CFlightWorld& world, UInt32 robot, UInt32 tick) {
  const Real phase = 0.3 * tick + robot;
  world.Places(Id(robot)).SetAbsolutePosition(
      CVector3(3.0 * std::sin(phase), robot - 9.0 + 0.1 * std::cos(phase), 2.0 + std::sin(phase)));
  world.Places(Id(robot)).SetAbsoluteYaw(CRadians(phase));
}

}  // namespace

TEST_CASE("flight: robots of a fleet fly bit by bit as each would alone", "[contract][flight]") {
  // independent of the number of robots and of removals
  CFlightWorld fleet(Fleet("quadrotor_position"));
  CLoopFunctions& functions = fleet.GetSimulator().GetLoopFunctions();
  SFlightExperiment alone;
  const UInt32 observed = 13;
  alone.Arena = EyeBotXml(Id(observed), CVector3(0.0, observed - 9.0, 2.0), 10.0 * observed);
  CFlightWorld world(alone);
  std::vector<UInt32> left = {0, 18, 7, 8, 12, 14, 16, 1};
  for (UInt32 tick = 0; tick < 60; ++tick) {
    if (tick % 5 == 3 && !left.empty()) {
      functions.RemoveEntity(Id(left.back()));
      left.pop_back();
    }
    for (UInt32 robot = 0; robot < kRobots; ++robot) {
      if (fleet.GetSpace().GetEntityMapPerId().count(Id(robot)) > 0) {
        OrderSomething(fleet, robot, tick);
      }
    }
    OrderSomething(world, observed, tick);
    fleet.Step();
    world.Step();
    REQUIRE(fleet.Position(Id(observed)) == world.Position(Id(observed)));
    REQUIRE(fleet.Body(Id(observed)).GetOriginAnchor().Orientation ==
            world.Body(Id(observed)).GetOriginAnchor().Orientation);
  }
  CHECK(fleet.GetSimulator().GetPhysicsEngines().front()->GetNumPhysicsModels() == kRobots - 8);
}

TEST_CASE("flight: a robot added during a run flies, and is gone after its removal",
          "[contract][flight]") {
  CFlightWorld world(Fleet("quadrotor_speed"));
  world.Step(3);
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  functions.AddEntity(
      *std::make_unique<CEyeBotEntity>("new", "pilot", CVector3(5, 0, 1)).release());
  world.Speeds("new").SetLinearVelocity(CVector3(0, 0, 1));
  world.Step(10);
  const Real way = kSubstep * ComputeWayToSpeed(0.2, 10 * kSubsteps);
  CHECK_THAT(Distance(world.Position("new"), CVector3(5, 0, 1 + way)), WithinAbs(0.0, kRounding));
  functions.RemoveEntity("new");
  CHECK(world.GetSimulator().GetPhysicsEngines().front()->GetNumPhysicsModels() == kRobots);
  world.Step();
}

TEST_CASE("flight: a moved robot starts from rest at its new pose", "[contract][flight]") {
  SFlightExperiment experiment;
  experiment.Actuator = "quadrotor_speed";
  experiment.Arena = EyeBotXml("r", CVector3()) + EyeBotXml("other", CVector3(5, 5, 5));
  CFlightWorld world(experiment);
  world.Speeds().SetLinearVelocity(CVector3(1, 0, 0));
  world.Speeds().SetRotationalSpeed(CRadians(1.0));
  world.Step(20);
  const CQuaternion turned(CRadians::PI_OVER_TWO, CVector3::Z);
  // a place inside another robot is refused
  CHECK_FALSE(world.Body().MoveTo(CVector3(5, 5.3, 5), turned));
  CHECK(world.Body().MoveTo(CVector3(5, 5, 5.6), turned));
  CHECK(world.Position() == CVector3(5, 5, 5.6));
  CHECK(world.Body().GetOriginAnchor().Orientation == turned);
  world.Step(10);
  const Real way = kSubstep * ComputeWayToSpeed(0.2, 10 * kSubsteps);
  CHECK_THAT(Distance(world.Position(), CVector3(5 + way, 5, 5.6)), WithinAbs(0.0, kRounding));
  const Real turn = kSubstep * ComputeWayToSpeed(0.5 * kSubstep / 0.11, 10 * kSubsteps);
  CHECK_THAT(world.Yaw(), WithinAbs(0.5 * std::numbers::pi + turn, kRounding));
}

TEST_CASE("flight: a motion that is set is that of the robot", "[contract][flight]") {
  SFlightExperiment experiment;
  experiment.Actuator = "quadrotor_speed";
  experiment.Arena = EyeBotXml("r", CVector3(1, 1, 1), 90.0);
  CFlightWorld world(experiment);
  world.Step();
  CPhysicsEngine& engine = world.Body().GetPhysicsModel(0).GetEngine();
  SBodyMotion motion;
  motion.Velocity = CVector3(0.5, -0.25, 0.125);
  motion.Rotation = CVector3(0.0, 0.0, 0.75);
  engine.SetMotion(world.Body(), motion);
  SBodyMotion found;
  REQUIRE(engine.GetMotion(world.Body(), found));
  CHECK(found.Velocity == motion.Velocity);
  CHECK(found.Rotation == motion.Rotation);
  // the loops brake it
  const CVector3 start = world.Position();
  world.Step();
  const CVector3 way = world.Position() - start;
  CHECK(way.GetX() > 0.0);
  CHECK(way.GetY() == Approx(-0.5 * way.GetX()));
  CHECK(way.GetZ() == Approx(0.25 * way.GetX()));
}

TEST_CASE("flight: a moved robot flies back to its target", "[contract][flight]") {
  SFlightExperiment experiment;
  experiment.Arena = EyeBotXml("r", CVector3(1, 1, 1));
  CFlightWorld world(experiment);
  world.Step(5);
  REQUIRE(world.Body().MoveTo(CVector3(1.4, 1, 1), CQuaternion()));
  for (UInt32 tick = 1; tick <= 30; ++tick) {
    world.Step();
    // the response equals that to a step of the target by the same distance
    const Real share =
        ComputeStepResponse(20.0 * kSubstep * kSubstep, 10.0 * kSubstep, tick * kSubsteps);
    CHECK_THAT(world.Position().GetX(), WithinAbs(1.4 - 0.4 * share, kRounding));
  }
}

TEST_CASE("flight: after a reset the run repeats bit by bit", "[contract][flight]") {
  CFlightWorld world(Fleet("quadrotor_position"));
  std::vector<UInt64> first;
  const auto run = [&](const std::function<void(UInt32)>& check) {
    for (UInt32 tick = 0; tick < 60; ++tick) {
      for (UInt32 robot = 0; robot < kRobots; ++robot) {
        OrderSomething(world, robot, tick);
      }
      world.Step();
      check(tick);
    }
  };
  run([&](UInt32) { first.push_back(world.ComputeDigest()); });
  // changes during the run do not matter
  REQUIRE(world.Body("r3").MoveTo(CVector3(8, 8, 8), CQuaternion()));
  world.GetSimulator().Reset();
  CHECK(world.Position("r3") == CVector3(0.0, -6.0, 2.0));
  run([&](UInt32 tick) { REQUIRE(world.ComputeDigest() == first[tick]); });
}

TEST_CASE("flight: at the start and after a reset the target is the robot's own pose",
          "[contract][flight]") {
  SFlightExperiment experiment;
  experiment.Arena = EyeBotXml("r", CVector3(1, 2, 3), -100.0);
  CFlightWorld world(experiment);
  world.Places().SetAbsolutePosition(CVector3(5, 5, 5));
  world.Places().SetAbsoluteYaw(CRadians(1.0));
  world.Step(30);
  world.GetSimulator().Reset();
  world.Step(30);
  CHECK(world.Position() == CVector3(1, 2, 3));
  CHECK_THAT(world.Yaw(), WithinAbs(-100.0 / 180.0 * std::numbers::pi, 1e-15));
}

TEST_CASE("flight: borders between engines do not affect a robot", "[contract][flight]") {
  SFlightExperiment whole;
  whole.Arena = EyeBotXml("r", CVector3(-1, 0, 1));
  SFlightExperiment split = whole;
  split.Engines = kPointMass3D.ToTwoXml(0.0);
  CFlightWorld alone(whole);
  CFlightWorld world(split);
  for (CFlightWorld* each : {&alone, &world}) {
    each->Places().SetAbsolutePosition(CVector3(1.5, 0.5, 2));
    each->Places().SetAbsoluteYaw(CRadians(2.0));
  }
  std::string engine = "west";
  for (int tick = 0; tick < 40; ++tick) {
    alone.Step();
    world.Step();
    REQUIRE(world.Position() == alone.Position());
    REQUIRE(world.Yaw() == alone.Yaw());
    REQUIRE(world.Body().GetPhysicsModelsNum() == 1);
    engine = world.Position().GetX() < 0.0 ? "west" : "east";
    REQUIRE(world.Body().GetPhysicsModel(0).GetEngine().GetId() == engine);
  }
  REQUIRE(engine == "east");
  // after a reset it starts in the west again
  std::vector<UInt64> digests;
  for (int run = 0; run < 2; ++run) {
    world.GetSimulator().Reset();
    CHECK(world.Body().GetPhysicsModel(0).GetEngine().GetId() == "west");
    world.Places().SetAbsolutePosition(CVector3(1.5, 0.5, 2));
    world.Step(25);
    CHECK(world.Body().GetPhysicsModel(0).GetEngine().GetId() == "east");
    digests.push_back(world.ComputeDigest());
  }
  CHECK(digests[0] == digests[1]);
}

TEST_CASE("flight: a robot in a region with a floor and a ceiling changes engines in the air",
          "[contract][flight]") {
  SFlightExperiment experiment;
  experiment.Engines =
      "<pointmass3d id='low'><boundaries><bottom height='0'/><top height='2'/></boundaries>"
      "</pointmass3d><pointmass3d id='high'><boundaries><bottom height='2'/></boundaries>"
      "</pointmass3d>";
  experiment.Arena = EyeBotXml("r", CVector3(0, 0, 1));
  CFlightWorld world(experiment);
  world.Places().SetAbsolutePosition(CVector3(0, 0, 3));
  world.Step(50);
  CHECK(world.Body().GetPhysicsModel(0).GetEngine().GetId() == "high");
  CHECK_THAT(world.Position().GetZ(), WithinAbs(3.0, 1e-4));
  // a place outside all regions is an error
  world.Places().SetAbsolutePosition(CVector3(0, 0, -1));
  CHECK_THROWS_WITH(world.Step(50), Contains("\"r\""));
}

TEST_CASE("flight: walls of a region stop a robot, and gates transfer it", "[contract][flight]") {
  SFlightExperiment experiment;
  const std::string sides =
      "<sides><vertex point='-2,-2' wall='true'/><vertex point='2,-2' wall='true'/>"
      "<vertex point='2,2' wall='true'/><vertex point='-2,2' wall='true'/></sides></boundaries>"
      "</pointmass3d>";
  experiment.Engines =
      "<pointmass3d id='low'><boundaries><bottom height='0' wall='true'/>"
      "<top height='2' gate='high'/>" +
      sides +
      "<pointmass3d id='high'><boundaries><bottom height='2' gate='low'/>"
      "<top height='4' wall='true'/>" +
      sides;
  experiment.Arena = EyeBotXml("r", CVector3(0, 0, 1));
  CFlightWorld world(experiment);
  world.Places().SetAbsolutePosition(CVector3(0.5, 9, 9));
  for (int tick = 0; tick < 150; ++tick) {
    world.Step();
    const SBoundingBox& box = world.Body().GetBoundingBox();
    REQUIRE(box.MaxCorner.GetY() <= 2.0 + 1e-9);
    REQUIRE(box.MaxCorner.GetZ() <= 4.0 + 1e-9);
  }
  CHECK(world.Body().GetPhysicsModel(0).GetEngine().GetId() == "high");
  // it presses against the walls and reaches its target along x
  CHECK_THAT(world.Body().GetBoundingBox().MaxCorner.GetY(), WithinAbs(2.0, 1e-9));
  CHECK_THAT(world.Body().GetBoundingBox().MaxCorner.GetZ(), WithinAbs(4.0, 1e-9));
  CHECK_THAT(world.Position().GetX(), WithinAbs(0.5, 1e-3));
  // back down
  world.Places().SetAbsolutePosition(CVector3(0.5, 0, -3));
  world.Step(150);
  CHECK(world.Body().GetPhysicsModel(0).GetEngine().GetId() == "low");
  CHECK_THAT(world.Position().GetZ(), WithinAbs(0.0, 1e-9));
  CHECK_THAT(world.Position().GetY(), WithinAbs(0.0, 1e-3));
}

TEST_CASE("flight: flying robots and wheeled robots are assigned to engines that accept them",
          "[contract][flight]") {
  const bool planeFirst = GENERATE(true, false);
  CAPTURE(planeFirst);
  const std::string plane = "<dynamics2d id='plane'/>";
  const std::string space = "<pointmass3d id='space'/>";
  SFlightExperiment experiment;
  experiment.Actuator = "";
  experiment.Engines = planeFirst ? plane + space : space + plane;
  experiment.Arena = EyeBotXml("eb", CVector3(0, 0, 0)) +
                     "<foot-bot id='fb'><body position='2,0,0'/><controller config='pilot'/>"
                     "</foot-bot><box id='box' size='1,1,1' movable='false'><body "
                     "position='4,0,0'/></box><box id='high' size='1,1,1' movable='true' mass='1'>"
                     "<body position='4,0,2'/></box>";
  CFlightWorld world(experiment);
  const auto engineOf = [&world](const std::string& id) {
    return world.Body(id).GetPhysicsModel(0).GetEngine().GetId();
  };
  CHECK(engineOf("eb") == "space");
  CHECK(engineOf("fb") == (planeFirst ? "plane" : "space"));
  CHECK(engineOf("high") == "space");
  // an immovable body is in both
  CHECK(world.Body("box").GetPhysicsModelsNum() == 2);
  world.Step(3);
  world.GetSimulator().Reset();
  world.Step(3);
  CHECK(engineOf("eb") == "space");
}

TEST_CASE("flight: results are equal for any number of threads", "[contract][flight]") {
  const auto run = [](UInt32 threads) {
    SFlightExperiment experiment = Fleet("quadrotor_position");
    experiment.Threads = threads;
    experiment.Engines = kPointMass3D.ToTwoXml(0.0);
    CFlightWorld world(experiment);
    std::vector<UInt64> digests;
    for (UInt32 tick = 0; tick < 50; ++tick) {
      for (UInt32 robot = 0; robot < kRobots; ++robot) {
        OrderSomething(world, robot, tick);
      }
      world.Step();
      digests.push_back(world.ComputeDigest());
    }
    return digests;
  };
  const std::vector<UInt64> alone = run(0);
  CHECK(run(1) == alone);
  CHECK(run(4) == alone);
}

TEST_CASE("flight: a tick in steady state allocates nothing", "[contract][flight][allocation]") {
  CFlightWorld world(Fleet("quadrotor_position"));
  std::vector<CCI_QuadRotorPositionActuator*> pilots;
  for (UInt32 robot = 0; robot < kRobots; ++robot) {
    pilots.push_back(&world.Places(Id(robot)));
  }
  const auto step = [&](UInt32 tick) {
    for (size_t i = 0; i < pilots.size(); ++i) {
      pilots[i]->SetRelativePosition(CVector3(std::sin(tick + i), 0.1, 0.0));
      pilots[i]->SetRelativeYaw(CRadians(0.5));
    }
    world.Step();
  };
  for (UInt32 tick = 0; tick < 20; ++tick) {
    step(tick);
  }
  CheckAllocatesNothing([&] {
    for (UInt32 tick = 20; tick < 60; ++tick) {
      step(tick);
    }
  });
}

}  // namespace argos::flight_lifecycle_test
