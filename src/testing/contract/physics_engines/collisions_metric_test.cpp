// The built-in metrics "collisions" and "dispersion" with every engine.

#include <argos3/core/simulator/space/metrics.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
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

void Drive(CRobotWorld& world, const std::string& robot, Real speedCmPerS) {
  world.GetActuator<CCI_DifferentialSteeringActuator>(robot, "differential_steering")
      .SetLinearVelocity(speedCmPerS, speedCmPerS);
}

}  // namespace

TEST_CASE("collisions metric: robots that press against a body count, those near it do not",
          "[contract][metrics]") {
  const std::string engine = GENERATE("dynamics2d", "kinematics2d", "dynamics3d");
  CAPTURE(engine);
  SRobotExperiment experiment;
  experiment.Actuators = "<differential_steering implementation=\"default\"/>";
  experiment.Engine = engine == "dynamics3d"
                          ? "<dynamics3d id=\"e\"><gravity g=\"9.8\"/><floor/></dynamics3d>"
                          : "<" + engine + " id=\"e\"/>";
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
