// Free robots of dynamics3d, and how they become active and free again.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/closed_form/differential_drive.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::rigid_free_test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using testing::IntegrateDifferentialDrive;
using testing::SPose;

namespace {

constexpr Real kTick = 0.1;  // s
constexpr Real kAxis = 0.14;  // m, of a foot-bot
const std::string kActive = "free_robots='false'";

CDynamics3DModel& ModelOf(CRigidScene& world, const std::string& id) {
  return dynamic_cast<CDynamics3DModel&>(world.Body(id).GetPhysicsModel(size_t(0)));
}

bool IsFree(CRigidScene& world, const std::string& id) {
  return ModelOf(world, id).IsFree();
}

std::string WallXml(const CVector3& size, const CVector3& position, const CVector3& degrees = {}) {
  return SBoxXml{"wall", size, position, degrees, 0.0}.ToXml();
}

// robots that drive arcs, and meet each other and walls now and then
std::string RoamersXml(int side) {
  std::string arena = WallXml(CVector3(0.1, side, 0.3), CVector3(0, 0, 0));
  CRandomStream random(3, "test", "free", "places");
  for (int i = 0; i < side * side; ++i) {
    const Real speed = random.Uniform(4.0, 12.0);
    arena += DriverXml(i % 2 == 0 ? "e-puck" : "foot-bot", "r" + std::to_string(i),
                       0.5 * (i % side - 0.5 * side) + 0.25, 0.5 * (i / side - 0.5 * side) + 0.25,
                       random.Uniform(0.0, 360.0), speed, speed + random.Uniform(-1.0, 1.0));
  }
  return arena;
}

SExperiment Roamers(UInt32 threads, const std::string& method) {
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Method = method;
  experiment.Controllers =
      "<contract_driver id='driver'><actuators><differential_steering implementation='default'/>"
      "</actuators><sensors/></contract_driver>";
  experiment.Engines = GroundedEngine();
  experiment.ArenaSize = "40,40,4";
  experiment.Arena = RoamersXml(20);
  return experiment;
}

// the fastest speed of the box and its place at the end
struct SPush {
  Real Fastest = 0.0;  // m/s
  Real Place = 0.0;  // m
  bool WasFree = false;
};

SPush PushBox(const std::string& attributes, Real mass) {
  CRigidScene world(GroundedEngine(attributes),
                    DriverXml("foot-bot", "r", 0, 0, 0, 20, 20) +
                        SBoxXml{"b", CVector3(0.2, 0.2, 0.2), CVector3(1, 0, 0), {}, mass}.ToXml());
  SPush push;
  for (int tick = 0; tick < 80; ++tick) {
    world.Step();
    push.WasFree = push.WasFree || IsFree(world, "r");
    push.Fastest = std::max(push.Fastest, world.Motion("b").Velocity.GetX());
  }
  push.Place = world.Position("b").GetX();
  return push;
}

}  // namespace

TEST_CASE("rigid free robots: they follow the closed-form arc, to rounding errors",
          "[contract][engine][rigid]") {
  const Real left = GENERATE(10.0, 3.0, -5.0);
  const Real right = GENERATE(10.0, 12.0);
  CAPTURE(left, right);
  CRigidScene world(GroundedEngine(), DriverXml("foot-bot", "r", 1, 2, 30, left, right));
  // by then it has its speed
  world.Step(5);
  REQUIRE(IsFree(world, "r"));
  const SPose start{world.Position("r").GetX(), world.Position("r").GetY(), world.Yaw("r")};
  for (int tick = 1; tick <= 600; ++tick) {
    world.Step();
    const SPose exact =
        IntegrateDifferentialDrive(start, 0.01 * left, 0.01 * right, kAxis, kTick * tick);
    // 600 roundings of the yaw, 2e-16 each, over a path of 6 m
    REQUIRE_THAT(world.Position("r").GetX(), WithinAbs(exact.X, 1e-11));
    REQUIRE_THAT(world.Position("r").GetY(), WithinAbs(exact.Y, 1e-11));
  }
  CHECK(IsFree(world, "r"));
  CHECK(world.Position("r").GetZ() == 0.0);
}

TEST_CASE("rigid free robots: they accelerate as active ones do", "[contract][engine][rigid]") {
  const std::string robot = GENERATE("foot-bot", "e-puck");
  using TSpeeds = std::pair<Real, Real>;  // cm/s
  const auto [left, right] = GENERATE(TSpeeds(20, 20), TSpeeds(-8, 15), TSpeeds(60, 60));
  CAPTURE(robot, left, right);
  const std::string driver = DriverXml(robot, "r", 0, 0, 0, left, right);
  CRigidScene world(GroundedEngine(), driver);
  CRigidScene reference(GroundedEngine(kActive), driver);
  for (int tick = 0; tick < 12; ++tick) {
    world.Step();
    reference.Step();
    REQUIRE(IsFree(world, "r"));
    // the path of one substep, in which friction and the load of wheels are simplified
    CHECK(Distance(world.Position("r"), reference.Position("r")) <=
          0.01 * 0.01 * std::max(left, right) + 0.02 * world.Position("r").Length());
  }
  CHECK_FALSE(IsFree(reference, "r"));
}

TEST_CASE("rigid free robots: becoming active and free keeps pose and speed",
          "[contract][engine][rigid]") {
  const std::string robot = GENERATE("foot-bot", "e-puck");
  const Real axis = robot == "foot-bot" ? kAxis : 0.053;  // m
  const Real left = 10.0;  // cm/s
  // straight on, or at 0.01 rad/s
  const Real right = left + GENERATE(0.0, 1.0) * axis;
  CAPTURE(robot, right);
  // it passes a pillar at a distance of 5 mm
  const Real radius = robot == "foot-bot" ? kFootBotRadius : kEPuckRadius;
  CRigidScene world(GroundedEngine(),
                    WallXml(CVector3(0.1, 0.1, 0.3), CVector3(1, -0.05 - radius - 0.005, 0)) +
                        DriverXml(robot, "r", 0, 0, 0, left, right));
  // an arc leads away from it
  if (left != right) {
    REQUIRE(world.Body("wall").MoveTo(CVector3(0.3, -0.05 - radius - 0.005, 0), CQuaternion()));
  }
  world.Step(5);
  const SBodyMotion motion = world.Motion("r");
  CVector3 last = world.Position("r");
  Real lastYaw = world.Yaw("r");
  bool wasFree = true;
  int changes = 0;
  for (int tick = 0; tick < 200; ++tick) {
    world.Step();
    const SBodyMotion now = world.Motion("r");
    // rolling without slip: the softness of contacts allows 0.1 % of 0.1 m/s
    CHECK_THAT(now.Velocity.Length(), WithinAbs(motion.Velocity.Length(), 2e-4));
    CHECK_THAT(now.Rotation.GetZ(), WithinAbs(motion.Rotation.GetZ(), 2e-3));
    CHECK_THAT(Distance(world.Position("r"), last),
               WithinAbs(0.005 * (left + right) * kTick, 2e-5));
    CHECK_THAT(world.Yaw("r") - lastYaw, WithinAbs(0.01 * (right - left) / axis * kTick, 2e-4));
    CHECK_THAT(world.Position("r").GetZ(), WithinAbs(0.0, 1e-4));
    changes += IsFree(world, "r") != wasFree ? 1 : 0;
    wasFree = IsFree(world, "r");
    last = world.Position("r");
    lastYaw = world.Yaw("r");
  }
  CHECK(changes == 2);
  CHECK(wasFree);
}

TEST_CASE("rigid free robots: they hand over as much momentum as active ones",
          "[contract][engine][rigid]") {
  const Real mass = GENERATE(0.1, 1.0);
  CAPTURE(mass);
  const SPush push = PushBox("", mass);
  const SPush reference = PushBox(kActive, mass);
  CHECK(push.WasFree);
  CHECK_FALSE(reference.WasFree);
  // a contact occurs up to a substep of 0.01 s earlier or later: 2 mm, of which the solver corrects
  // 20 % in a substep
  CHECK_THAT(push.Place, WithinAbs(reference.Place, 3e-3));
  // upright bodies, whose contacts are anticipated, do not rebound
  CHECK_THAT(push.Fastest, WithinRel(0.2, 0.02));
}

TEST_CASE("rigid free robots: two that collide head-on stop as active ones do",
          "[contract][engine][rigid]") {
  const std::string robots =
      DriverXml("foot-bot", "a", 0, 0, 0, 20, 20) + DriverXml("e-puck", "b", 2, 0, 180, 10, 10);
  CRigidScene world(GroundedEngine(), robots);
  CRigidScene reference(GroundedEngine(kActive), robots);
  // Until 1.7 s after they meet: what is pushed from behind and brakes turns aside, at a rate of
  // speed by radius, so that any rounding has grown by a factor of 1e9 after 3.7 s.
  for (int tick = 0; tick < 80; ++tick) {
    world.Step();
    reference.Step();
    // 2 % of the smaller radius
    REQUIRE(Distance(world.Position("a"), world.Position("b")) >= 0.98 * 0.035 + 0.085);
  }
  CHECK_FALSE(IsFree(world, "a"));
  // the heavier one pushes the other
  CHECK_THAT(world.Position("a").GetX(), WithinAbs(reference.Position("a").GetX(), 0.02));
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(reference.Position("b").GetX(), 0.02));
}

TEST_CASE("rigid free robots: one that is struck within a tick takes part in the collision",
          "[contract][engine][rigid]") {
  // a heavy box at 4 m/s strikes a light one, which then is faster than anything at the start
  CRigidScene world(
      GroundedEngine("", "<contacts restitution='1'/>"),
      SBoxXml{"heavy", CVector3(0.2, 0.2, 0.2), CVector3(-0.21, 0, 0), {}, 20.0}.ToXml() +
          SBoxXml{"light", CVector3(0.2, 0.2, 0.2), CVector3(0, 0, 0), {}, 0.2}.ToXml() +
          DriverXml("foot-bot", "r", 0.75, 0, 0, 0, 0));
  world.Step(2);
  REQUIRE(IsFree(world, "r"));
  world.Launch("heavy", CVector3(4, 0, 0));
  for (int tick = 0; tick < 5; ++tick) {
    world.Step();
    // half of the box, and the radius; in a substep the box moves by 8 cm at most
    REQUIRE(world.Position("light").GetX() + 0.1 + 0.085 <= world.Position("r").GetX() + 0.02);
  }
  CHECK_FALSE(IsFree(world, "r"));
  CHECK(world.Position("r").GetX() > 0.8);
}

TEST_CASE("rigid free robots: one stays free far below a collision within a tick",
          "[contract][engine][rigid]") {
  const Real height = GENERATE(0.3, 2.0);  // m
  CAPTURE(height);
  const auto box = [height](const std::string& id, Real x, Real mass) {
    return SBoxXml{id, CVector3(0.2, 0.2, 0.2), CVector3(x, 0, height), {}, mass}.ToXml();
  };
  CRigidScene world(GroundedEngine("", "<contacts restitution='1'/>"),
                    box("heavy", -0.21, 20.0) + box("light", 0, 0.2) +
                        DriverXml("foot-bot", "r", 0.75, 0, 0, 0, 0));
  world.Step();
  REQUIRE(IsFree(world, "r"));
  world.Launch("heavy", CVector3(4, 0, 0));
  world.Step();
  CHECK(world.Motion("light").Velocity.GetX() > 6.0);
  // the light box may still move by 1 m, up or down as well
  CHECK(IsFree(world, "r") == (height > 1.5));
}

TEST_CASE("rigid free robots: never on slopes, on boxes, in the air or leaning",
          "[contract][engine][rigid]") {
  const std::string children = GENERATE("<floor/><gravity g='9.81'/>", "");
  CAPTURE(children);
  const auto never = [&](const std::string& arena) {
    CRigidScene world(RigidEngine("", children), arena);
    for (int tick = 0; tick < 15; ++tick) {
      world.Step();
      REQUIRE_FALSE(IsFree(world, "r"));
    }
  };
  const auto robot = [](const std::string& position, const std::string& orientation) {
    return "<foot-bot id='r'><body position='" + position + "' orientation='" + orientation +
           "'/><controller config='driver'/></foot-bot>";
  };
  // a slope, a table, a tile of 1 mm, a tile whose surface is that of the floor
  never(WallXml(CVector3(8, 4, 0.2), CVector3(0, 0, 0.3), CVector3(0, -5, 0)) +
        robot("0,0,0.505", "0,-5,0"));
  never(WallXml(CVector3(2, 2, 0.5), CVector3(0, 0, 0)) + robot("0,0,0.5", "0,0,0"));
  never(WallXml(CVector3(2, 2, 0.001), CVector3(0, 0, 0)) + robot("0,0,0.001", "0,0,0"));
  never(WallXml(CVector3(2, 2, 0.1), CVector3(0, 0, -0.1)) + robot("0,0,0", "0,0,0"));
  never(robot("0,0,20", "0,0,0"));
  // on its side
  never(robot("0,0,0.1", "0,90,0"));
  // beside a pole, a hair's breadth away
  never(WallXml(CVector3(0.1, 0.1, 0.5), CVector3(0.1356, 0, 0)) + robot("0,0,0", "0,0,0"));
}

TEST_CASE("rigid free robots: never under what is less than 2 cm above them",
          "[contract][engine][rigid]") {
  const std::string robot = DriverXml("foot-bot", "r", 0, 0, 0, 10, 10);
  CRigidScene alone(GroundedEngine(), robot);
  alone.Step();
  const Real top = alone.Body("r").GetBoundingBox().MaxCorner.GetZ();
  const Real gap = GENERATE(-0.002, 0.002, 0.018, 0.022);  // m
  CAPTURE(gap);
  CRigidScene world(GroundedEngine(),
                    WallXml(CVector3(0.4, 2, 0.1), CVector3(0.7, 0, top + gap)) + robot);
  bool wasAlwaysFree = true;
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    wasAlwaysFree = wasAlwaysFree && IsFree(world, "r");
  }
  CHECK(wasAlwaysFree == (gap > 0.02));
  if (gap < 0.0) {
    CHECK(world.Position("r").GetX() < 0.5);
  } else {
    // it accelerates first
    CHECK_THAT(world.Position("r").GetX(), WithinAbs(1.0, 0.02));
  }
}

TEST_CASE("rigid free robots: a fallen one is free when it rests on the floor",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine(),
                    "<foot-bot id='r'><body position='0,0,0.02'/><controller config='driver'/>"
                    "</foot-bot>");
  world.Step();
  CHECK_FALSE(IsFree(world, "r"));
  world.Step(30);
  CHECK(IsFree(world, "r"));
  CHECK_THAT(world.Position("r").GetZ(), WithinAbs(0.0, 1e-4));
  CHECK(world.Tilt("r") == 0.0);
}

TEST_CASE("rigid free robots: never with a closed gripper, or near one",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine(), DriverXml("foot-bot", "r", 0, 0, 0, 0, 0) +
                                          DriverXml("foot-bot", "near", 0.18, 0, 0, 0, 0) +
                                          DriverXml("foot-bot", "far", 1, 0, 0, 0, 0));
  world.Step();
  REQUIRE(IsFree(world, "r"));
  auto& gripper = world.Get<CFootBotEntity>("r").GetGripperEquippedEntity();
  gripper.SetLockState(1.0);
  world.Step();
  CHECK_FALSE(IsFree(world, "r"));
  CHECK_FALSE(IsFree(world, "near"));
  CHECK(IsFree(world, "far"));
  CHECK(gripper.IsGripping());
  world.Step(5);
  CHECK_FALSE(IsFree(world, "near"));
  gripper.SetLockState(0.0);
  world.Driver("near").Left = world.Driver("near").Right = 10.0;
  world.Step(20);
  CHECK(IsFree(world, "r"));
  CHECK(IsFree(world, "near"));
}

TEST_CASE("rigid free robots: none with other add-ons, or without gravity on a floor",
          "[contract][engine][rigid]") {
  const std::string grounded = "<floor/><gravity g='9.81'/>";
  const std::string children =
      GENERATE_COPY(grounded + "<magnetism/>", grounded + KickXml("r", CVector3(0, 0, 0)),
                    std::string("<floor/>"), std::string("<gravity g='9.81'/>"),
                    std::string("<floor/><gravity vector='0,0.1,-9.8'/>"),
                    std::string("<floor friction='0'/><gravity g='9.81'/>"));
  CAPTURE(children);
  CRigidScene world(RigidEngine("", children), DriverXml("foot-bot", "r", 0, 0, 0, 0, 0));
  TakeLogErr();
  for (int tick = 0; tick < 10; ++tick) {
    world.Step();
    CHECK_FALSE(IsFree(world, "r"));
  }
}

TEST_CASE("rigid free robots: a force or a move between ticks takes effect",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine(), DriverXml("foot-bot", "r", 0, 0, 0, 0, 0));
  world.Step(3);
  REQUIRE(IsFree(world, "r"));
  CDynamics3DModel& model = ModelOf(world, "r");
  model.AddForce(CVector3(300, 0, 0), model.GetCentreOfMass());
  CHECK_FALSE(IsFree(world, "r"));
  world.Step();
  // 3 N s on 1.6 kg are 1.9 m/s; wheels slow it down with 12.6 N at most
  CHECK(world.Position("r").GetX() > 0.1);
  CHECK(world.Motion("r").Velocity.GetX() > 0.5);
  REQUIRE(world.Body("r").MoveTo(CVector3(3, 1, 0), CQuaternion(CRadians(1.0), CVector3::Z)));
  world.Step(20);
  CHECK(Distance(world.Position("r"), CVector3(3, 1, 0)) < 1e-4);
  CHECK(IsFree(world, "r"));
}

TEST_CASE("rigid free robots: a wall that is moved stops them where it is, not where it was",
          "[contract][engine][rigid]") {
  const bool isPushing = GENERATE(false, true);
  CAPTURE(isPushing);
  const std::string box =
      SBoxXml{"b", CVector3(0.2, 0.2, 0.1), CVector3(0.3, 0, 0), CVector3(), 0.3}.ToXml();
  CRigidScene world(GroundedEngine(), WallXml(CVector3(0.1, 2, 0.3), CVector3(3, 0, 0)) +
                                          DriverXml("foot-bot", "r", 0, 0, 0, 10, 10) +
                                          (isPushing ? box : ""));
  world.Step(20);
  CHECK(IsFree(world, "r") != isPushing);
  REQUIRE(world.Body("wall").MoveTo(CVector3(0.85, 0, 0), CQuaternion()));
  world.Step(80);
  const Real stop = 0.8 - kFootBotRadius - (isPushing ? 0.2 : 0.0);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(stop, 5e-3));
  REQUIRE(world.Body("wall").MoveTo(CVector3(-2, 0, 0), CQuaternion()));
  world.Step(40);
  CHECK(world.Position("r").GetX() > stop + 0.3);
}

TEST_CASE("rigid free robots: equal for any number of threads and schedule, and after a reset",
          "[contract][engine][rigid]") {
  CTestWorld reference(Roamers(0, "balance_quantity"));
  const std::vector<UInt64> expected = RecordDigests(reference, 60);
  reference.GetSimulator().Reset();
  CHECK(RecordDigests(reference, 60) == expected);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  const UInt32 threads = GENERATE(1U, 2U, 4U);
  CAPTURE(threads, method);
  CTestWorld world(Roamers(threads, method));
  CHECK(RecordDigests(world, 60) == expected);
}

TEST_CASE("rigid free robots: a tick in which robots become active and free allocates nothing",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine(), WallXml(CVector3(0.1, 0.1, 0.3), CVector3(1, 0, 0)) +
                                          DriverXml("foot-bot", "r", 1, 0.4, 0, 0, 0));
  REQUIRE(world.Body("r").MoveTo(CVector3(0.6, 0.145, 0), CQuaternion()));
  CContractDriver& driver = world.Driver("r");
  const CDynamics3DModel& model = ModelOf(world, "r");
  // there and back, past the wall
  int changes = 0;
  const auto pass = [&] {
    bool wasFree = model.IsFree();
    for (int tick = 0; tick < 90; ++tick) {
      driver.Left = driver.Right = tick < 45 ? 20.0 : -20.0;
      world.Step();
      changes += model.IsFree() != wasFree ? 1 : 0;
      wasFree = model.IsFree();
    }
  };
  pass();
  changes = 0;
  CheckAllocatesNothing(pass);
  CHECK(changes == 4);
}

}  // namespace argos::rigid_free_test
