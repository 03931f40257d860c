// Turrets, without and with a load in the gripper mounted on them.

#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/contract/physics_engines/grip_world.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <string>

namespace argos::turret_test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using TMode = CCI_FootBotTurretActuator;

constexpr Real kRadius = kFootBotRadius;
constexpr Real kRoll = 0.1;  // m, radius of a load
constexpr Real kGap = 0.005;  // m
constexpr Real kFriction = 1.49;  // N, the engine's default
constexpr Real kAhead = kRadius + kGap + kRoll;
constexpr Real kRadiansPerRpm = ARGOS_PI / 30.0;

// friction resists displacement of loads, but not rotation
const std::string kSwivel =
    "<dynamics2d id='e'><friction cylinder_angular_friction='0' box_angular_friction='0'/>"
    "</dynamics2d>";

Real Rotation(CGripWorld& world, const std::string& id) {
  return world.Turret(id).GetRotation().GetValue();
}

Real Wrap(Real angle) {
  return std::remainder(angle, 2.0 * ARGOS_PI);
}

/** Angle of the load about the robot, rad. */
Real Azimuth(CGripWorld& world, const std::string& robot, const std::string& load) {
  const CVector3 arm = world.Position(load) - world.Position(robot);
  return std::atan2(arm.GetY(), arm.GetX());
}

/** Errors under the control law e' = e - tick (0.4 e + 0.2 (e - last) / tick), rad. */
class CControlLaw {
 public:
  CControlLaw(Real error, Real tick) : m_error(error), m_last(error), m_tick(tick) {}
  Real Next() {
    const Real rate = 0.4 * m_error + 0.2 * (m_error - m_last) / m_tick;
    m_last = m_error;
    m_error -= rate * m_tick;
    return m_error;
  }

 private:
  Real m_error, m_last;
  Real m_tick;
};

}  // namespace

TEST_CASE("turret: speed control turns it relative to the base for any motion of the base",
          "[contract][engine][turret]") {
  const SInt32 rpm = GENERATE(-3, 4, 1000);
  const Real turn = GENERATE(0.0, 5.0);  // cm/s of the wheels, in opposite directions
  CAPTURE(rpm, turn);
  CGripWorld world(GripperXml("r", 1, 2, 30, ""));
  world.Drive("r", -turn, turn);
  world.Driver("r").Mode = TMode::MODE_SPEED_CONTROL;
  world.Driver("r").TurretSpeed = rpm;
  world.Step();  // sends the order
  CHECK(Rotation(world, "r") == 0.0);
  for (int tick = 1; tick <= 100; ++tick) {
    world.Step();
    const Real exact = kRadiansPerRpm * rpm * 0.1 * tick;
    // tolerance of 100 additions of up to 10 rad
    REQUIRE_THAT(Wrap(Rotation(world, "r") - exact), WithinAbs(0.0, 1e-10));
  }
}

TEST_CASE("turret: position control follows its law in the shorter direction",
          "[contract][engine][turret]") {
  const Real target = GENERATE(0.5, 3.0, -2.0);
  const UInt32 ticksPerSecond = GENERATE(10U, 100U);
  CAPTURE(target, ticksPerSecond);
  CGripWorld world(GripperXml("r", 0, 0, 0, ""), {.TicksPerSecond = ticksPerSecond});
  world.Driver("r").Mode = TMode::MODE_POSITION_CONTROL;
  world.Driver("r").TurretRotation = CRadians(target);
  world.Step();
  CControlLaw law(target, 1.0 / ticksPerSecond);
  for (UInt32 tick = 1; tick <= 10 * ticksPerSecond; ++tick) {
    world.Step();
    REQUIRE_THAT(Rotation(world, "r"), WithinAbs(target - law.Next(), 1e-12));
  }
  // back in the other direction: from 3 rad to -3 rad it is 0.28 rad across pi
  world.Driver("r").TurretRotation = CRadians(-target);
  world.Step(300 * ticksPerSecond / 10);
  CHECK_THAT(Wrap(Rotation(world, "r") + target), WithinAbs(0.0, 1e-3));
}

TEST_CASE("turret: in modes off and passive it keeps its rotation relative to the base",
          "[contract][engine][turret]") {
  const auto mode = GENERATE(TMode::MODE_OFF, TMode::MODE_PASSIVE);
  CGripWorld world(GripperXml("r", 0, 0, 0, ""));
  world.Driver("r").Mode = TMode::MODE_SPEED_CONTROL;
  world.Driver("r").TurretSpeed = 2;
  world.Step(11);
  const Real there = Rotation(world, "r");
  CHECK_THAT(there, WithinAbs(2.0 * kRadiansPerRpm, 1e-12));
  world.Driver("r").Mode = mode;
  world.Drive("r", -5, 5);
  world.Step(20);
  CHECK_THAT(Rotation(world, "r"), WithinAbs(there + 0.1 * 2.0 * kRadiansPerRpm, 1e-12));
  world.GetSimulator().Reset();
  CHECK(Rotation(world, "r") == 0.0);
}

TEST_CASE("turret: its anchor and its LEDs turn with it", "[contract][engine][turret]") {
  CGripWorld world(GripperXml("r", 1, 0, 90, ""));
  CEmbodiedEntity& body = world.Body("r");
  body.EnableAnchor("turret");
  auto& leds = world.Get<CComposableEntity>("r").GetComponent<CLEDEquippedEntity>("leds");
  leds.Enable();
  world.Driver("r").Mode = TMode::MODE_SPEED_CONTROL;
  world.Driver("r").TurretSpeed = 3;
  world.Drive("r", 5, 5);
  world.Step(26);
  const Real yaw = 0.5 * ARGOS_PI + Rotation(world, "r");
  CHECK_THAT(Rotation(world, "r"), WithinAbs(2.5 * 3.0 * kRadiansPerRpm, 1e-10));
  const SAnchor& turret = body.GetAnchor("turret");
  CHECK(turret.Position == world.Position("r"));
  CRadians z, y, x;
  turret.Orientation.ToEulerAngles(z, y, x);
  CHECK_THAT(Wrap(z.GetValue() - yaw), WithinAbs(0.0, 1e-10));
  // LED 0 is at 15 degrees on a ring 5 mm outside the body
  const CVector3 led = leds.GetLED(0).GetPosition() - world.Position("r");
  CHECK_THAT(Wrap(std::atan2(led.GetY(), led.GetX()) - yaw - ARGOS_PI / 12.0),
             WithinAbs(0.0, 1e-10));
  CHECK_THAT(std::hypot(led.GetX(), led.GetY()), WithinAbs(kRadius + 0.005, 1e-12));
}

TEST_CASE("turret: it swings a load on a circle around the robot", "[contract][engine][turret]") {
  const SInt32 rpm = GENERATE(-2, 1, 3);
  const Real mass = GENERATE(0.1, 2.0);
  CAPTURE(rpm, mass);
  // the load touches the robot where it is gripped, so its centre stays on the line to that point
  constexpr Real kDistance = kRadius + kRoll;
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + RollXml("roll", kDistance, 0, mass),
                   {.Engine = kSwivel});
  const CGripGauge gauge = CGripGauge::Grip(world, "r", "roll");
  world.Driver("r").Mode = TMode::MODE_SPEED_CONTROL;
  world.Driver("r").TurretSpeed = rpm;
  world.Step();
  const Real rate = kRadiansPerRpm * rpm;  // rad/s
  // m, see below, plus a fifth for the friction between the discs, plus the
  // stretch while the load accelerates
  const Real longest = 1.2 * 1.2e-3 + std::abs(rate) * kDistance * std::sqrt(mass / 1e4);
  for (int tick = 1; tick <= 400; ++tick) {
    world.Step();
    // tolerance for single precision and for the error of the tick's last substep
    REQUIRE_THAT(Wrap(Rotation(world, "r") - 0.1 * rate * tick), WithinAbs(0.0, 2e-3));
    // The load lags. If it is turned back by an angle f, the spring along the arm must be longer,
    // by s = f^2 kRadius kDistance / (2 kRoll) less a slop. Friction pulls
    // with F kDistance per rad of f, which balances k s ds/df at f = 0.144 and s = 1.2 mm.
    REQUIRE_THAT(Wrap(Azimuth(world, "r", "roll") - world.Yaw("r") - Rotation(world, "r")),
                 WithinAbs(0.0, 1.2 * 0.144));
    REQUIRE(std::abs(gauge.Stretch()) <= longest);
    REQUIRE(std::abs(gauge.Sideways()) <= 1e-3);
    REQUIRE_THAT(Distance(world.Position("roll"), world.Position("r")),
                 WithinAbs(kDistance, longest));
  }
  // the drive holds the base against the load, except for a creep of 1 % of the turret's rotation
  CHECK_THAT(world.Yaw("r"), WithinAbs(0.0, 0.01 * std::abs(rate) * 40.0));
  CHECK_THAT(world.Position("r").Length(), WithinAbs(0.0, 2e-3));
}

TEST_CASE("turret: position control with a load follows the same law",
          "[contract][engine][turret]") {
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + RollXml("roll", kAhead, 0, 0.5),
                   {.Engine = kSwivel});
  world.Step(2);
  REQUIRE(world.HeldBy("r") == "roll");
  world.Driver("r").Mode = TMode::MODE_POSITION_CONTROL;
  world.Driver("r").TurretRotation = CRadians(1.5);
  world.Step();
  CControlLaw law(1.5, 0.1);
  for (int tick = 1; tick <= 100; ++tick) {
    world.Step();
    // the motor has 150 N m: the error is due to single precision
    REQUIRE_THAT(Rotation(world, "r"), WithinAbs(1.5 - law.Next(), 1e-3));
  }
}

TEST_CASE("turret: with a load and the motor off the base turns below it",
          "[contract][engine][turret]") {
  const auto mode = GENERATE(TMode::MODE_OFF, TMode::MODE_PASSIVE);
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("box", kAhead, 0, 2.0));
  world.Step(2);
  REQUIRE(world.HeldBy("r") == "box");
  world.Driver("r").Mode = mode;
  world.Drive("r", -2, 2);
  world.Step(101);
  // 4 cm/s over 14 cm for 10 s, less the lag of the first tick
  const Real duration = 10.0 - 0.1 * kDynamics2D.GetLag();
  CHECK_THAT(world.Yaw("r"), WithinAbs(Wrap(0.04 / 0.14 * duration), 1e-3));
  CHECK_THAT(Wrap(Rotation(world, "r") + world.Yaw("r")), WithinAbs(0.0, 1e-3));
  CHECK_THAT(world.Position("box").GetX(), WithinAbs(kAhead, 1e-4));
  CHECK_THAT(world.Position("box").GetY(), WithinAbs(0.0, 1e-4));
  // after the release the turret keeps its rotation relative to the base, which turns on
  world.Driver("r").Lock = false;
  world.Step(2);
  const Real there = Rotation(world, "r");
  world.Step(20);
  CHECK(Rotation(world, "r") == there);
}

TEST_CASE("turret: it swings a braking robot", "[contract][engine][turret]") {
  // the held robot brakes with 5 N and hardly resists rotation
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") +
                   GripperXml("held", 2.0 * kRadius + kGap, 0, 0, "", 5.0, 0.01));
  world.Step(2);
  REQUIRE(world.HeldBy("r") == "held");
  world.Driver("r").Mode = TMode::MODE_SPEED_CONTROL;
  world.Driver("r").TurretSpeed = 1;
  world.Step(51);
  const Real azimuth = Azimuth(world, "r", "held");
  world.Step(50);
  // 5 s at 6 degrees per second
  CHECK_THAT(Azimuth(world, "r", "held") - azimuth, WithinAbs(5.0 * kRadiansPerRpm, 2e-3));
  CHECK_THAT(world.Position("r").Length(), WithinAbs(0.0, 1e-3));
}

TEST_CASE("turret: it pushes a load with at most the torque of its motor",
          "[contract][engine][turret]") {
  const SInt32 rpm = GENERATE(-3, 3);
  const UInt32 iterations = GENERATE(1, 2, 10);
  CAPTURE(rpm, iterations);
  // a load that accelerates slowly, and does not rotate; a wall holds the robot against its force,
  // and the arm turns by 0.01 rad at most
  constexpr Real kMass = 1e7;  // kg
  const Real side = rpm > 0 ? 1.0 : -1.0;
  std::ostringstream wall;
  wall << "<box id='wall' size='1,0.2,0.1' movable='false'><body position='0,"
       << -side * (kRadius + 0.1001) << ",0'/></box>";
  CGripWorld::SOptions options;
  options.Engine = "<dynamics2d id='e' iterations='" + std::to_string(iterations) +
                   "'><friction box_angular_friction='1e9'/></dynamics2d>";
  CGripWorld world(
      GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("box", kAhead, 0, kMass) + wall.str(),
      options);
  const CGripGauge gauge = CGripGauge::Grip(world, "r", "box");
  world.Driver("r").Mode = TMode::MODE_SPEED_CONTROL;
  world.Driver("r").TurretSpeed = rpm;
  world.Step(11);
  const CVector3 before = world.Position("box");
  world.Step(10);
  const Real early = side * (world.Position("box").GetY() - before.GetY());
  world.Step(10);
  const Real late = side * (world.Position("box").GetY() - before.GetY()) - early;
  // 150 N m at the point that is held, less the friction of the load
  const Real acceleration = (150.0 / gauge.GetArmLength() - kFriction) / kMass;
  CHECK_THAT(late - early, WithinRel(acceleration, 0.01));
}

}  // namespace argos::turret_test
