// The built-in metrics "collisions" and "dispersion", and contact, with every engine.

#include <argos3/core/simulator/space/metrics.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <string>

namespace collisions_metric_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

Real Value(CTestWorld& world, const std::string& metric) {
  return world.GetSimulator().GetMetrics().Find(metric)->Value;
}

SRobotExperiment DriversIn(const std::string& engine) {
  SRobotExperiment experiment;
  experiment.Actuators = "<differential_steering implementation=\"default\"/>";
  experiment.Engine = engine == "dynamics3d"
                          ? "<dynamics3d id=\"e\"><gravity g=\"9.8\"/><floor/></dynamics3d>"
                          : "<" + engine + " id=\"e\"/>";
  return experiment;
}

void Drive(CRobotWorld& world, const std::string& robot, Real speedCmPerS) {
  world.GetActuator<CCI_DifferentialSteeringActuator>(robot, "differential_steering")
      .SetLinearVelocity(speedCmPerS, speedCmPerS);
}

}  // namespace

TEST_CASE("collisions metric: robots that press against a body count, those near it do not",
          "[contract][metrics]") {
  const std::string engine = GENERATE("dynamics2d", "kinematics2d", "dynamics3d");
  CAPTURE(engine);
  SRobotExperiment experiment = DriversIn(engine);
  // a and b meet, c drives against the box, d stands 5 mm from a box
  experiment.Arena = Robot("e-puck", "a", "position=\"-0.1,0,0\"") +
                     Robot("e-puck", "b", "position=\"0.1,0,0\" orientation=\"180,0,0\"") +
                     Robot("foot-bot", "c", "position=\"1,1,0\"") +
                     Robot("foot-bot", "d", "position=\"1,-1,0\"") +
                     "<box id=\"wall\" size=\"0.2,1,0.3\" movable=\"false\">"
                     "<body position=\"1.3,1,0\"/></box>"
                     "<box id=\"far\" size=\"0.2,1,0.3\" movable=\"false\">"
                     "<body position=\"1.1901,-1,0\"/></box>";
  CRobotWorld world(experiment);
  world.GetSimulator().GetMetrics().EnableBuiltIn("collisions");
  CHECK(Value(world, "collisions") == 0.0);
  Drive(world, "a", 5.0);
  Drive(world, "b", 5.0);
  Drive(world, "c", 5.0);
  world.Step(10);
  CHECK(Value(world, "collisions") == 0.0);
  world.Step(60);
  for (int tick = 0; tick < 20; ++tick) {
    world.Step();
    CHECK(Value(world, "collisions") == 3.0);
  }
  Drive(world, "a", -5.0);
  world.Step(20);
  CHECK(Value(world, "collisions") >= 1.0);
  world.GetSimulator().Reset();
  CHECK(Value(world, "collisions") == 0.0);
}

TEST_CASE("contact: functions see the same contacts as the metric", "[contract][metrics]") {
  const std::string engine = GENERATE("dynamics2d", "kinematics2d", "dynamics3d");
  CAPTURE(engine);
  SRobotExperiment experiment = DriversIn(engine);
  // a and b meet, c drives against a wall, d pushes a box, e stands 5 mm from a wall
  const std::string wall = "\" size=\"0.2,1,0.3\" movable=\"false\"><body position=\"";
  experiment.Arena = Robot("e-puck", "a", "position=\"-0.1,0,0\"") +
                     Robot("e-puck", "b", "position=\"0.1,0,0\" orientation=\"180,0,0\"") +
                     Robot("foot-bot", "c", "position=\"1,1,0\"") +
                     Robot("foot-bot", "d", "position=\"-1,1,0\"") +
                     Robot("foot-bot", "e", "position=\"1,-1,0\"") + "<box id=\"wall" + wall +
                     "1.3,1,0\"/></box><box id=\"far" + wall +
                     "1.1901,-1,0\"/></box><box id=\"box\" size=\"0.1,0.1,0.1\" movable=\"true\" "
                     "mass=\"0.5\"><body position=\"-0.8,1,0\"/></box>";
  CRobotWorld world(experiment);
  world.GetSimulator().GetMetrics().EnableBuiltIn("collisions");
  for (const char* const robot : {"a", "b", "c", "d"}) {
    Drive(world, robot, 5.0);
  }
  world.Step(80);
  for (int tick = 0; tick < 20; ++tick) {
    world.Step();
    int colliding = 0;
    for (const char* const robot : {"a", "b", "c", "d", "e"}) {
      auto& body = world.Get<CComposableEntity>(robot).GetComponent<CEmbodiedEntity>("body");
      const SAnchor& origin = body.GetOriginAnchor();
      const bool isColliding = body.IsCollidingWithSomething();
      CAPTURE(robot);
      CHECK(body.MoveTo(origin.Position, origin.Orientation, true) != isColliding);
      colliding += isColliding ? 1 : 0;
    }
    CHECK(Value(world, "collisions") == colliding);
    // a robot of dynamics3d may bounce off a box that slides ahead of it
    CHECK(colliding >= 3);
    CHECK_FALSE(world.Get<CComposableEntity>("e")
                    .GetComponent<CEmbodiedEntity>("body")
                    .IsCollidingWithSomething());
  }
}

TEST_CASE("contact: a place that touches something is not free, but can be moved to",
          "[contract][metrics]") {
  const std::string engine = GENERATE("dynamics2d", "kinematics2d", "dynamics3d", "pointmass3d");
  const std::string shape = GENERATE("box", "cylinder", "prism");
  CAPTURE(engine, shape);
  CDriveWorld world("<" + engine + " id='e'/>",
                    "<cylinder id='a' radius='0.1' height='0.2' movable='true' mass='1'><body "
                    "position='0,0,0'/></cylinder><box id='b' size='0.2,0.2,0.2' movable='true' "
                    "mass='1'><body position='2,0,0'/></box>");
  if (shape == "cylinder") {
    world.Reshape("b", SShapeDescription::Cylinder(0.1, 0.2));
  } else if (shape == "prism") {
    world.Reshape(
        "b", SShapeDescription::Prism({{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}, 0.2));
  }
  CEmbodiedEntity& body = world.Body("b");
  const auto moveTo = [&](Real gap, bool checkOnly) {
    return body.MoveTo(CVector3(0.2 + gap, 0.0, 0.0), CQuaternion(), checkOnly);
  };
  CHECK(moveTo(0.002, true));
  CHECK_FALSE(moveTo(0.0005, true));
  CHECK_FALSE(moveTo(-0.01, true));
  CHECK_FALSE(body.IsCollidingWithSomething());
  CHECK_FALSE(moveTo(-0.01, false));
  CHECK(moveTo(0.0005, false));
  CHECK(body.IsCollidingWithSomething());
  CHECK(world.Body("a").IsCollidingWithSomething());
  CHECK(moveTo(0.002, false));
  CHECK_FALSE(body.IsCollidingWithSomething());
}

TEST_CASE("collisions metric: what hooks move, add and remove counts in the same tick",
          "[contract][metrics]") {
  SRobotExperiment experiment;
  experiment.Arena =
      Robot("e-puck", "a", "position=\"0,0,0\"") + Robot("e-puck", "b", "position=\"1,0,0\"");
  CRobotWorld world(experiment);
  world.GetSimulator().GetMetrics().EnableBuiltIn("collisions");
  world.GetSimulator().GetMetrics().EnableBuiltIn("dispersion");
  world.Step();
  CHECK(Value(world, "collisions") == 0.0);
  CHECK_THAT(Value(world, "dispersion"), WithinAbs(0.5, 1e-15));
  // e-pucks have a radius of 3.5 cm
  world.Get<CComposableEntity>("b").GetComponent<CEmbodiedEntity>("body").MoveTo(
      CVector3(0.0705, 0.0, 0.0), CQuaternion());
  world.Step();
  CHECK(Value(world, "collisions") == 2.0);
  CHECK_THAT(Value(world, "dispersion"), WithinAbs(0.03525, 1e-15));
  world.Get<CComposableEntity>("b").GetComponent<CEmbodiedEntity>("body").MoveTo(
      CVector3(0.0715, 0.0, 0.0), CQuaternion());
  world.Step();
  CHECK(Value(world, "collisions") == 0.0);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("b");
  world.Step();
  CHECK(Value(world, "dispersion") == 0.0);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("a");
  world.Step();
  CHECK(world.GetSimulator().GetMetrics().Find("dispersion")->Count == 0);
  CHECK(Value(world, "collisions") == 0.0);
}

}  // namespace collisions_metric_test
