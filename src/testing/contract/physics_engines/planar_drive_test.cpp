// Robots with a drive that moves them to all sides, in every engine.

#include <argos3/plugins/robots/generic/control_interface/ci_planar_drive_actuator.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/contract/physics_engines/rover.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace argos::planar_drive_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kTick = 0.1;  // s

struct SPlace {
  Real X, Y, Yaw;  // m, rad
};

/**
 * The closed form for a constant velocity in the frame of a body that rotates: the integral of the
 * rotation of (ahead, left) by the heading.
 */
SPlace Integrate(const SPlace& start, const SDriveCommand& command, Real duration) {
  const Real end = start.Yaw + command.YawRate * duration;
  if (command.YawRate == 0.0) {
    const Real c = std::cos(start.Yaw) * duration;
    const Real s = std::sin(start.Yaw) * duration;
    return {start.X + command.Ahead * c - command.Left * s,
            start.Y + command.Ahead * s + command.Left * c, end};
  }
  const Real c = (std::sin(end) - std::sin(start.Yaw)) / command.YawRate;
  const Real s = (std::cos(start.Yaw) - std::cos(end)) / command.YawRate;
  return {start.X + command.Ahead * c - command.Left * s,
          start.Y + command.Ahead * s + command.Left * c, end};
}

class CRoverWorld : public CDriveWorld {
 public:
  using CDriveWorld::CDriveWorld;

  CRoverEntity& Rover(const std::string& id = "r") { return Get<CRoverEntity>(id); }
  Real DistanceTo(const SPlace& place, const std::string& id = "r") {
    const CVector3 position = Position(id);
    return std::hypot(position.GetX() - place.X, position.GetY() - place.Y) +
           CRoverEntity::kRadius *
               std::abs(std::remainder(Yaw(id) - place.Yaw, 2.0 * std::numbers::pi));
  }
};

CRoverWorld MakeWorld(const SEngineType& engine, const std::string& arena,
                      const std::string& attributes = "") {
  return CRoverWorld(engine.ToXml("e", attributes), arena);
}

// s m/s, of a rover in 3D: its motors are as soft as all constraints
constexpr Real kSoftness = 1e-4;

const SPlace kStart{0.3, -0.2, 0.7};

std::string StartXml(const std::string& attributes) {
  return RoverXml("r", kStart.X, kStart.Y, kStart.Yaw * 180.0 / std::numbers::pi, attributes);
}

}  // namespace

TEST_CASE("planar drive: a robot follows the closed form for 30 s", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  const std::string shape = GENERATE(as<std::string>(), "disc", "box");
  const std::string iterations = GENERATE(as<std::string>(), "", "iterations='10'");
  const SDriveCommand command =
      GENERATE(SDriveCommand{0.1, 0.0, 0.0}, SDriveCommand{0.0, 0.1, 0.0},
               SDriveCommand{0.1, -0.05, 0.5}, SDriveCommand{-0.03, 0.08, -1.2},
               SDriveCommand{0.0, 0.0, 2.0}, SDriveCommand{0.0, -0.1, 1e-3});
  CAPTURE(type, shape, iterations, command.Ahead, command.Left, command.YawRate);
  CRoverWorld world = CRoverWorld(type.ToXml("e", iterations), StartXml("shape='" + shape + "'"));
  world.Rover().Drive(command.Ahead, command.Left, command.YawRate);
  const Real lag = type.GetLag();
  Real worst = 0.0;
  for (int tick = 1; tick <= 300; ++tick) {
    world.Step();
    worst = std::max(worst, world.DistanceTo(Integrate(kStart, command, kTick * (tick - lag))));
  }
  // 300 roundings of numbers around 1; in space, the robot settles on the floor and starts softly
  CHECK(worst <= (type.Slip > 0.0 ? kSoftness : 1e-9));
  CHECK(std::abs(world.Position("r").GetZ()) <= type.Slack);
}

TEST_CASE("planar drive: a new command takes effect with the engine's lag", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  const std::string shape = GENERATE(as<std::string>(), "disc", "box");
  if (!type.HasLag) {
    return;
  }
  const Real lag = GENERATE(0.0, 0.1, 0.5, 1.0);
  CAPTURE(type, shape, lag);
  CRoverWorld world(type.ToXml("e", "velocity_lag='" + std::to_string(lag) + "'"),
                    StartXml("shape='" + shape + "'"));
  const std::array<SDriveCommand, 5> commands{
      {{0.1, 0.05, 0.3}, {-0.05, 0.1, -0.8}, {0.0, 0.0, 0.0}, {0.0, -0.1, 0.0}, {0.07, 0.0, 1.0}}};
  SDriveCommand last;
  SPlace place = kStart;
  for (int tick = 0; tick < 50; ++tick) {
    const SDriveCommand& now = commands[static_cast<size_t>(tick / 2) % commands.size()];
    world.Rover().Drive(now.Ahead, now.Left, now.YawRate);
    world.Step();
    place = Integrate(Integrate(place, last, lag * kTick), now, (1.0 - lag) * kTick);
    last = now;
    REQUIRE(world.DistanceTo(place) <= 1e-9);
  }
}

TEST_CASE("planar drive: a command that is too fast keeps its direction and its rate",
          "[contract][engine]") {
  using TCommand = SDriveCommand;
  CHECK(TCommand{3.0, 4.0, 7.0}.Limited(2.5) == TCommand{1.5, 2.0, 7.0});
  CHECK(TCommand{3.0, -4.0, 7.0}.Limited(5.5) == TCommand{3.0, -4.0, 7.0});
  CHECK(TCommand{3.0, 0.0, 7.0}.Limited(2.5) == TCommand{2.5, 0.0, 7.0});
  CHECK(TCommand{-3.0, 0.0, 7.0}.Limited(2.5) == TCommand{-2.5, 0.0, 7.0});
  CHECK(TCommand{0.0, -3.0, 7.0}.Limited(2.5) == TCommand{0.0, -2.5, 7.0});
}

TEST_CASE("planar drive: force and torque bound the acceleration", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  const std::string shape = GENERATE(as<std::string>(), "disc", "box");
  if (!type.HasMomentum) {
    return;
  }
  CAPTURE(type, shape);
  // 0.5 m/s^2
  CRoverWorld world(type.ToXml("e", type.HasLag ? "velocity_lag='0'" : ""),
                    StartXml("shape='" + shape + "' max_force='0.4' max_torque='0.001'"));
  world.Step(5);
  world.Rover().Drive(0.0, 0.2, 0.0);
  for (int tick = 1; tick <= 6; ++tick) {
    world.Step();
    CHECK_THAT(world.Motion("r").Velocity.Length(),
               WithinAbs(std::min(0.2, 0.5 * kTick * tick), 1e-4));
  }
  CVector3 left = CVector3::Y;
  left.RotateZ(CRadians(kStart.Yaw));
  CHECK_THAT(world.Motion("r").Velocity.DotProduct(left), WithinAbs(0.2, 1e-4));
  world.Rover().Drive(0.0, 0.0, 0.0);
  world.Step(10);
  world.Rover().Drive(0.0, 0.0, 1.0);
  const Real inertia = world.Body("r").GetBodyDescription()->GetPlanarInertia();
  for (int tick = 1; tick <= 3; ++tick) {
    world.Step();
    CHECK_THAT(world.Motion("r").Rotation.GetZ(),
               WithinAbs(std::min(1.0, 0.001 / inertia * kTick * tick), 1e-3));
  }
}

TEST_CASE("planar drive: a wall stops a robot that moves sideways, and lets it slide along",
          "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithContacts));
  const std::string shape = GENERATE(as<std::string>(), "disc", "box");
  CAPTURE(type, shape);
  // the face is at y = 0.5
  CRoverWorld world = MakeWorld(
      type, RoverXml("r", 0, 0, 0, "shape='" + shape + "'") +
                "<box id='w' size='8,0.2,0.5' movable='false'><body position='0,0.6,0'/></box>");
  world.Rover().Drive(0.0, 0.1, 0.0);
  world.Step(80);
  const Real half = (shape == "disc" ? 1.0 : 0.75) * CRoverEntity::kRadius;
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(0.5 - half, 1e-3));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.0, 1e-2));
  // with gravity, friction on the wall is as strong as the push
  world.Rover().Drive(0.1, type.Ground == EGround::Weight ? 0.0 : 0.02, 0.0);
  world.Step(80);
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(0.5 - half, 1e-3));
  CHECK(world.Position("r").GetX() > 0.5);
}

TEST_CASE("planar drive: a robot pushes what its force can move, and nothing else",
          "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(type);
  const Real mass = 0.5;
  const Real hold = type.GetHold(mass);
  const bool isStrong = GENERATE(true, false);
  const Real force = (isStrong ? 2.0 : 0.5) * hold;
  CRoverWorld world = MakeWorld(
      type, RoverXml("r", 0, 0, 0, "shape='box' max_force='" + std::to_string(force) + "'") +
                "<box id='b' size='0.2,0.2,0.05' movable='true' mass='0.5'>"
                "<body position='0,0.25,0'/></box>");
  world.Rover().Drive(0.0, 0.1, 0.0);
  world.Step(60);
  const Real way = world.Position("b").GetY() - 0.25;
  if (isStrong) {
    CHECK(way > 0.3);
  } else {
    // an impact may move it slightly
    CHECK(std::abs(way) < 0.01);
  }
}

TEST_CASE("planar drive: in space, it acts only on the ground", "[contract][engine]") {
  CRoverWorld world(kDynamics3D.ToXml(), "<rover id='r'><body position='0,0,1.0'/></rover>");
  world.Rover().Drive(0.5, 0.5, 0.0);
  world.Step(3);
  REQUIRE(world.Position("r").GetZ() > 0.3);
  CHECK_THAT(std::hypot(world.Position("r").GetX(), world.Position("r").GetY()),
             WithinAbs(0.0, 1e-12));
  world.Step(20);
  CHECK(world.Position("r").GetX() > 0.3);
}

TEST_CASE("planar drive: a robot continues its path in another engine", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(type);
  const SDriveCommand command{0.1, 0.1, -0.2};
  CRoverWorld world(type.ToTwoXml(0.0), RoverXml("r", -0.3, 0, 0));
  world.Rover().Drive(command.Ahead, command.Left, command.YawRate);
  REQUIRE(world.EngineOf("r") == "west");
  for (int tick = 1; tick <= 45; ++tick) {
    world.Step();
    const SPlace exact = Integrate({-0.3, 0.0, 0.0}, command, kTick * (tick - type.GetLag()));
    REQUIRE(world.DistanceTo(exact) <= (type.Slip > 0.0 ? 2e-3 : 1e-9));
  }
  CHECK(world.EngineOf("r") == "east");
}

TEST_CASE("planar drive: robots of two engines stay apart", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithContacts));
  const std::string shape = GENERATE(as<std::string>(), "disc", "box");
  CAPTURE(type, shape);
  const std::string attributes = "shape='" + shape + "'";
  CRoverWorld world(type.ToTwoXml(0.0), RoverXml("a", -0.3, 0, 90, attributes) +
                                            RoverXml("b", 0.3, 0.01, 90, attributes));
  world.Rover("a").Drive(0.0, -0.1, 0.0);
  world.Rover("b").Drive(0.0, 0.1, 0.0);
  Real closest = 1.0;
  for (int tick = 0; tick < 60; ++tick) {
    world.Step();
    closest = std::min(closest, Distance(world.Position("a"), world.Position("b")));
  }
  // boxes stop at the circles around them, or touch with their long sides
  const Real least = (shape == "disc" ? 2.0 : 1.5) * CRoverEntity::kRadius;
  CHECK(closest >= 0.98 * least);
  CHECK(closest <= 3.0 * CRoverEntity::kRadius);
}

TEST_CASE("planar drive: impossible descriptions are refused", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(type);
  const auto error = [&](const std::string& attributes) {
    return LoadError(
        SExperiment{.Engines = type.ToXml(), .Arena = RoverXml("r", 0, 0, 0, attributes)});
  };
  CHECK_THAT(error("flaw='two_drives'"),
             Contains("robot \"r\" has a planar drive and a differential one"));
  CHECK_THAT(error("flaw='no_component'"), Contains("planar_drive"));
  if (type.HasMomentum) {
    CHECK_THAT(error("max_force='0'"), Contains("greatest force"));
    CHECK_THAT(error("max_torque='-1'"), Contains("torque"));
  }
}

TEST_CASE("planar drive: the actuator moves a robot, in cm/s", "[contract][robot]") {
  SRobotExperiment experiment;
  experiment.Actuators = "<planar_drive implementation=\"default\"/>";
  experiment.Engine = kKinematics2D.ToXml("e", "velocity_lag='0'");
  experiment.Arena = RoverXml("r", 0, 0, 0, "", "<controller config='c'/>");
  CRobotWorld world(experiment);
  auto& drive = world.GetActuator<CCI_PlanarDriveActuator>("r", "planar_drive");
  drive.SetVelocity(10.0, -5.0, CRadians(0.5));
  world.Step(10);
  const SAnchor& origin =
      world.Get<CRoverEntity>("r").GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
  const SPlace end = Integrate({0.0, 0.0, 0.0}, {0.1, -0.05, 0.5}, 1.0);
  CHECK_THAT(origin.Position.GetX(), WithinAbs(end.X, 1e-12));
  CHECK_THAT(origin.Position.GetY(), WithinAbs(end.Y, 1e-12));
  CHECK_THROWS_WITH(drive.SetVelocity(std::nan(""), 0.0, CRadians()),
                    Contains("robot \"r\"") && Contains("must be finite"));
  world.GetSimulator().Reset();
  const CVector3 start = origin.Position;
  world.Step();
  CHECK(origin.Position == start);
}

TEST_CASE("planar drive: a command that is not finite is refused", "[contract][robot]") {
  CRoverWorld world(kKinematics2D.ToXml(), RoverXml("r", 0, 0));
  CHECK_THROWS_WITH(world.Rover().Drive(0.0, std::numeric_limits<Real>::infinity(), 0.0),
                    Contains("left = inf m/s"));
}

TEST_CASE("drive: speeds that lead out of the world are an error of the tick",
          "[contract][robot]") {
  // 1e20 m/s for 0.1 s
  CDriveWorld wheels(kPointMass3D.ToXml(), DriverXml("e-puck", "r", 0, 0, 0, 1e22, 1e22));
  CHECK_THROWS_WITH(wheels.Step(2), Contains("robot \"r\": wheel speeds of left = 1e+20 m/s") &&
                                        Contains("lead beyond 1e+09 m"));
  CRoverWorld rover(kPointMass3D.ToXml(), RoverXml("r", 0, 0));
  rover.Rover().Drive(0.0, 1e12, 0.0);
  CHECK_THROWS_WITH(rover.Step(), Contains("robot \"r\": drive commands of ahead = 0 m/s") &&
                                      Contains("lead beyond 1e+09 m"));
}

TEST_CASE("drive: wheels of opposite speeds whose difference is infinite are an error of the tick",
          "[contract][robot]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  SRobotExperiment experiment;
  experiment.Engine = engine.ToXml();
  experiment.Arena = Robot("foot-bot", "f", "position='0,0,0'");
  CRobotWorld world(experiment);
  world.Step();
  const Real speeds[] = {-1e308, 1e308};  // m/s
  world.Get<CComposableEntity>("f").GetComponent<CWheeledEntity>("wheels").SetVelocities(speeds);
  CHECK_THROWS_WITH(
      world.Step(),
      Contains("robot \"f\"") && Contains("wheel speeds must be finite numbers, found left = -1"));
}

}  // namespace argos::planar_drive_test
