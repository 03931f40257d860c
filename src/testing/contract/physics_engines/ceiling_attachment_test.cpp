// Flying robots that hold on to the ceiling, in each engine in which robots fly.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ceiling_attachment_actuator.h>
#include <argos3/testing/contract/physics_engines/flight_world.h>
#include <argos3/testing/contract/physics_engines/rigid_scene.h>

#include <catch2/catch.hpp>

namespace argos::ceiling_attachment_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kCeiling = 3.0;  // m
constexpr Real kHeight = 0.566;  // m, of an eye-bot
// base of a robot that touches the ceiling, m
constexpr Real kHighest = kCeiling - kHeight;

SFlightExperiment Rooms(const std::string& engine, const std::string& reach = "0.05") {
  SFlightExperiment experiment;
  experiment.Engines = engine;
  // from -3 m to the ceiling
  experiment.ArenaSize = "10,10,6";
  experiment.MoreActuators = "<ceiling_attachment implementation='default' reach='" + reach + "'/>";
  return experiment;
}

std::string GenerateEngine() {
  return GENERATE(as<std::string>(), "<pointmass3d id='e'/>",
                  "<pointmass3d id='e' motion='argos3'/>", RigidEngine("", "<gravity g='9.81'/>"));
}

CCI_CeilingAttachmentActuator& Magnet(CFlightWorld& world, const std::string& id = "r") {
  auto& robot = world.Get<CComposableEntity>(id).GetComponent<CControllableEntity>("controller");
  return *robot.GetController().GetActuator<CCI_CeilingAttachmentActuator>("ceiling_attachment");
}

}  // namespace

TEST_CASE("ceiling: a robot attaches when it is in reach, stays put to the bit, and flies on",
          "[contract][engine][ceiling]") {
  const std::string engine = GenerateEngine();
  CAPTURE(engine);
  SFlightExperiment experiment = Rooms(engine);
  experiment.Arena = EyeBotXml("r", CVector3(0.5, 0.25, 1.0));
  CFlightWorld world(experiment);
  Magnet(world).Attach();
  // too low: it hovers
  world.Step(10);
  CHECK_FALSE(Magnet(world).IsAttached());
  CHECK_THAT(world.Position().GetZ(), WithinAbs(1.0, 1e-6));

  // 2 cm below the ceiling, once it is there
  world.Places().SetAbsolutePosition(CVector3(0.5, 0.25, kHighest - 0.02));
  UInt32 ticks = 0;
  while (!Magnet(world).IsAttached() && ticks < 100) {
    world.Step();
    ++ticks;
  }
  REQUIRE(Magnet(world).IsAttached());
  CHECK(world.Position().GetZ() >= kHighest - 0.05);

  // orders have no effect
  const CVector3 place = world.Position();
  const Real yaw = world.Yaw();
  world.Places().SetAbsolutePosition(CVector3(-1.0, 0.0, 1.0));
  world.Places().SetAbsoluteYaw(CRadians(1.0));
  for (UInt32 i = 0; i < 50; ++i) {
    world.Step();
    CHECK(world.Position() == place);
    CHECK(world.Yaw() == yaw);
  }

  Magnet(world).Detach();
  world.Step();
  CHECK_FALSE(Magnet(world).IsAttached());
  world.Step(60);
  // the control loop of ARGoS 3 oscillates for long
  const Real tolerance = engine.find("argos3") == std::string::npos ? 0.01 : 0.15;
  CHECK(Distance(world.Position(), CVector3(-1.0, 0.0, 1.0)) < tolerance);
  CHECK_THAT(world.Yaw(), WithinAbs(1.0, tolerance));
}

TEST_CASE("ceiling: the largest distance is an attribute", "[contract][engine][ceiling]") {
  const std::string reach = GENERATE("0.3", "0.1");
  CAPTURE(reach);
  SFlightExperiment experiment = Rooms("<pointmass3d id='e'/>", reach);
  experiment.Arena = EyeBotXml("r", CVector3(0, 0, kHighest - 0.2));
  CFlightWorld world(experiment);
  Magnet(world).Attach();
  world.Step(2);
  CHECK(Magnet(world).IsAttached() == (reach == "0.3"));
  experiment.MoreActuators = "<ceiling_attachment implementation='default' reach='-1'/>";
  CHECK_THROWS_WITH(CFlightWorld(experiment),
                    Contains("<ceiling_attachment>") && Contains("\"reach\"") && Contains("-1"));
}

TEST_CASE("ceiling: an attached robot is not pushed", "[contract][engine][rigid][ceiling]") {
  SFlightExperiment experiment = Rooms(RigidEngine("", "<gravity g='9.81'/>"));
  experiment.Arena = EyeBotXml("r", CVector3(0, 0, kHighest)) +
                     EyeBotXml("pusher", CVector3(-1.0, 0, kHighest - 0.2));
  CFlightWorld world(experiment);
  Magnet(world).Attach();
  world.Step();
  REQUIRE(Magnet(world).IsAttached());
  const CVector3 place = world.Position();
  world.Places("pusher").SetAbsolutePosition(CVector3(1.0, 0.0, kHighest - 0.2));
  world.Step(50);
  CHECK(world.Position() == place);
  // the arms of both reach 0.25 m: the other is stopped by it
  CHECK_THAT(world.Position("pusher").GetX(), WithinAbs(-0.5, 0.02));
}

TEST_CASE("ceiling: a reset detaches, and the run repeats itself", "[contract][engine][ceiling]") {
  const std::string engine = GenerateEngine();
  CAPTURE(engine);
  SFlightExperiment experiment = Rooms(engine);
  experiment.Arena = EyeBotXml("r", CVector3(0.1, 0.2, kHighest - 0.01));
  CFlightWorld world(experiment);
  const auto run = [&world] {
    Magnet(world).Attach();
    world.Step(5);
    CHECK(Magnet(world).IsAttached());
    Magnet(world).Detach();
    world.Places().SetAbsolutePosition(CVector3(0.0, 0.0, 1.0));
    world.Step(5);
    return world.ComputeDigest();
  };
  const UInt64 first = run();
  Magnet(world).Attach();
  world.Places().SetAbsolutePosition(CVector3(0.0, 0.0, kHighest));
  world.Step(100);
  REQUIRE(Magnet(world).IsAttached());
  world.GetSimulator().Reset();
  CHECK_FALSE(Magnet(world).IsAttached());
  CHECK(run() == first);
}

}  // namespace argos::ceiling_attachment_test
