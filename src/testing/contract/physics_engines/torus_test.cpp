// Arenas of which opposite sides are joined: bodies across the seams.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/experiment.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace argos::torus_test {

namespace {

using Catch::WithinAbs;
using Catch::Matchers::Contains;

const std::vector<SEngineType> kEngines{kKinematics2D, kDynamics2D};

constexpr Real kWidth = 2.5;  // m
constexpr Real kDepth = 2.0;  // m
constexpr Real kEPuck = 0.035;  // m, its radius

/** "torus_test_medium": a user's medium that does not know of periodic arenas. */
class CTorusTestMedium : public CMedium {
 public:
  void Update() override {}
};
REGISTER_MEDIUM(CTorusTestMedium, "torus_test_medium", "tests", "1.0", "Nothing.", "Nothing.",
                "Usable")

/** m, inside of the arena of Torus(). */
CVector3 Wrapped(const CVector3& place) {
  const auto wrap = [](Real x, Real period) { return x - period * std::floor(x / period); };
  return CVector3(wrap(place.GetX(), kWidth), wrap(place.GetY(), kDepth), place.GetZ());
}

/** The shortest of the ways between two places, m. */
CVector3 Way(const CVector3& from, const CVector3& to) {
  const CVector3 way = to - from;
  return CVector3(std::remainder(way.GetX(), kWidth), std::remainder(way.GetY(), kDepth),
                  way.GetZ());
}

/** An arena from (0,0) to (kWidth, kDepth). */
SExperiment Torus(const std::string& engine, const std::string& arena,
                  const std::string& axes = "true", UInt32 threads = 0) {
  SExperiment experiment = CDriveWorld::Describe(engine, arena, threads);
  experiment.ArenaSize = ToText(CVector3(kWidth, kDepth, 1.0));
  experiment.ArenaCenter = ToText(CVector3(0.5 * kWidth, 0.5 * kDepth, 0.5));
  experiment.ArenaAttributes = "periodic='" + axes + "'";
  return experiment;
}

std::string EPuckXml(const std::string& id, const CVector3& place, Real yaw, Real left,
                     Real right) {
  return DriverXml("e-puck", id, place.GetX(), place.GetY(), yaw, left, right);
}

std::string BoxAt(const std::string& id, const CVector3& place, Real yaw = 0.0) {
  return BoxXml(id, place.GetX(), place.GetY(), yaw, "0.12,0.08,0.1");
}

/** Scenes around a point, for arenas with and without joined sides. */
struct SScene {
  std::string Name;
  std::string (*ToXml)(const CVector3& middle);
  std::vector<std::string> Ids;
  UInt32 Ticks;
};

// two robots, head on
std::string HeadOn(const CVector3& m) {
  return EPuckXml("a", m + CVector3(-0.11, 0.003, 0.0), 0.0, 6.0, 6.0) +
         EPuckXml("b", m + CVector3(0.12, 0.0, 0.0), 180.0, 4.0, 4.0);
}

// the same across a corner
std::string Diagonal(const CVector3& m) {
  return EPuckXml("a", m + CVector3(-0.09, -0.08, 0.0), 45.0, 6.0, 6.0) +
         EPuckXml("b", m + CVector3(0.08, 0.07, 0.0), -135.0, 5.0, 5.0);
}

// a robot pushes a box that pushes another one
std::string Pushing(const CVector3& m) {
  return EPuckXml("a", m + CVector3(-0.2, 0.01, 0.0), 0.0, 8.0, 8.0) +
         BoxAt("box", m + CVector3(-0.08, 0.0, 0.0), 10.0) +
         BoxAt("next", m + CVector3(0.09, 0.02, 0.0));
}

// a robot drives against a wall on the other side, and along it
std::string AgainstWall(const CVector3& m) {
  return EPuckXml("a", m + CVector3(-0.15, 0.0, 0.0), 15.0, 8.0, 8.0) +
         WallXml("wall", "0.1,0.6,0.3", m.GetX() + 0.08, m.GetY());
}

// a robot that is no disc pushes a puck
std::string Rover(const CVector3& m) {
  return EPuckXml("a", m + CVector3(-0.17, -0.02, 0.0), 5.0, 7.0, 7.5) +
         "<cylinder id='puck' radius='0.05' height='0.1' movable='true' mass='0.2'><body "
         "position='" +
         ToText(m + CVector3(-0.03, 0.0, 0.0)) + "'/></cylinder>" +
         EPuckXml("b", m + CVector3(0.13, 0.01, 0.0), 180.0, 3.0, 3.0);
}

const std::vector<SScene> kScenes{{"head on", HeadOn, {"a", "b"}, 40},
                                  {"diagonal", Diagonal, {"a", "b"}, 40},
                                  {"pushing", Pushing, {"a", "box", "next"}, 60},
                                  {"wall", AgainstWall, {"a"}, 50},
                                  {"puck", Rover, {"a", "puck", "b"}, 50}};

}  // namespace

TEST_CASE("torus: a robot goes round as often as its way is long", "[physics][torus]") {
  const SEngineType engine = GENERATE(from_range(kEngines));
  const Real yaw = GENERATE(0.0, 37.0, 90.0, -143.0, 180.0);
  CAPTURE(engine, yaw);
  const CVector3 start(1.1, 0.4, 0.0);
  CDriveWorld world(Torus(engine.ToPromptXml(), EPuckXml("a", start, yaw, 10.0, 10.0)));
  // commands act from the second tick on
  constexpr UInt32 kTicks = 1001;
  const Real speed = 0.1;  // m/s
  const Real radians = yaw * M_PI / 180.0;
  const CVector3 way(100.0 * speed * std::cos(radians), 100.0 * speed * std::sin(radians), 0.0);
  world.Step(kTicks);
  // 1000 roundings of metres; dynamics2d limits the first acceleration
  const Real lost = engine.HasMomentum ? 0.02 : 0.0;
  const CVector3 end = world.Body("a").GetUnwrappedPosition();
  CHECK_THAT(Distance(end, start + way), WithinAbs(0.0, lost + 1e-9));
  CHECK_THAT(Distance(world.Position("a"), Wrapped(end)), WithinAbs(0.0, 1e-9));
  CHECK_THAT(std::remainder(world.Yaw("a") - radians, 2.0 * M_PI), WithinAbs(0.0, 1e-9));
  world.GetSimulator().Reset();
  CHECK(world.Body("a").GetUnwrappedPosition() == start);
}

TEST_CASE("torus: along an axis that is not periodic, bodies leave the arena", "[physics][torus]") {
  const SEngineType engine = GENERATE(from_range(kEngines));
  const std::string axis = GENERATE("x", "y");
  CAPTURE(engine, axis);
  CDriveWorld world(Torus(engine.ToPromptXml(),
                          EPuckXml("a", CVector3(2.4, 1.0, 0.0), 0.0, 10.0, 10.0) +
                              EPuckXml("b", CVector3(1.0, 1.9, 0.0), 90.0, 10.0, 10.0),
                          axis));
  world.Step(60);
  CHECK((world.Position("a").GetX() < kWidth) == (axis == "x"));
  CHECK((world.Position("b").GetY() < kDepth) == (axis == "y"));
}

TEST_CASE("torus: contacts across a seam are those inside of an arena", "[physics][torus]") {
  const SEngineType engine = GENERATE(from_range(kEngines));
  const SScene scene = GENERATE(from_range(kScenes));
  // bodies cross seams in the middle of a tick, too
  const std::string xml = GENERATE_COPY(engine.ToXml(), engine.ToXml("e", "iterations='4'"));
  CAPTURE(xml, scene.Name);
  const CVector3 middle(1.25, 1.0, 0.0);
  CDriveWorld plain(xml, scene.ToXml(middle));
  plain.Step(scene.Ticks);
  for (const CVector3& moved :
       {CVector3(0.0, 0.0, 0.0), CVector3(1.25, 0.0, 0.0), CVector3(0.0, 1.0, 0.0),
        CVector3(1.25, 1.0, 0.0), CVector3(1.21, -0.97, 0.0), CVector3(-1.3125, 1.03125, 0.0)}) {
    CAPTURE(moved);
    CDriveWorld torus(Torus(xml, scene.ToXml(middle + moved)));
    torus.Step(scene.Ticks);
    // kinematics2d: iterations stop at a gap that rounding may decide; dynamics2d: single precision
    const Real tolerance = engine.HasMomentum ? 2e-5 : 1e-9;
    for (const std::string& id : scene.Ids) {
      CAPTURE(id);
      const CVector3 error = Way(plain.Position(id) + moved, torus.Position(id));
      CHECK_THAT(error.Length(), WithinAbs(0.0, tolerance));
      CHECK_THAT(std::remainder(torus.Yaw(id) - plain.Yaw(id), 2.0 * M_PI),
                 WithinAbs(0.0, 20.0 * tolerance));
      CHECK(torus.Position(id).GetX() >= 0.0);
      CHECK(torus.Position(id).GetX() <= kWidth);
      CHECK(torus.Position(id).GetY() >= 0.0);
      CHECK(torus.Position(id).GetY() <= kDepth);
    }
  }
}

TEST_CASE("torus: momentum is conserved over a seam", "[physics][torus]") {
  // 0 N: nothing brakes the boxes
  CDriveWorld world(
      Torus(kDynamics2D.ToBrakingXml(0.0, 1.0),
            BoxAt("a", CVector3(2.38, 1.96, 0.0)) + BoxAt("b", CVector3(0.07, 0.01, 0.0))));
  world.Step();
  world.Launch("a", CVector3(0.4, 0.05, 0.0));
  world.Step(40);
  const CVector3 sum = world.Motion("a").Velocity + world.Motion("b").Velocity;
  // it has hit the other one
  CHECK(world.Motion("b").Velocity.GetX() > 0.1);
  // impulses are in single precision
  CHECK_THAT(sum.GetX(), WithinAbs(0.4, 1e-6));
  CHECK_THAT(sum.GetY(), WithinAbs(0.05, 1e-6));
}

TEST_CASE("torus: a crowd moves alike wherever the seams cross it", "[physics][torus]") {
  const SEngineType engine = GENERATE(from_range(kEngines));
  CAPTURE(engine);
  const auto crowd = [](const CVector3& moved) {
    CRandomStream random(1, "test", "torus", "crowd");
    std::string xml;
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 4; ++j) {
        const CVector3 place(0.5 * i + 0.1 * random.Uniform(-1.0, 1.0),
                             0.5 * j + 0.1 * random.Uniform(-1.0, 1.0), 0.0);
        const std::string id = std::to_string(4 * i + j);
        xml += EPuckXml(id, Wrapped(place + moved), random.Uniform(-180.0, 180.0),
                        random.Uniform(4.0, 12.0), random.Uniform(4.0, 12.0));
      }
    }
    return xml;
  };
  CDriveWorld one(Torus(engine.ToXml(), crowd(CVector3())));
  const CVector3 moved(0.777, 1.313, 0.0);
  CDriveWorld other(Torus(engine.ToXml(), crowd(moved)));
  one.Step(60);
  other.Step(60);
  for (int i = 0; i < 20; ++i) {
    const std::string id = std::to_string(i);
    CAPTURE(id);
    CHECK_THAT(Way(one.Position(id) + moved, other.Position(id)).Length(),
               WithinAbs(0.0, engine.HasMomentum ? 1e-4 : 1e-9));
  }
}

TEST_CASE("torus: results do not depend on threads", "[physics][torus]") {
  const SEngineType engine = GENERATE(from_range(kEngines));
  CAPTURE(engine);
  std::string xml;
  CRandomStream random(1, "test", "torus", "threads");
  for (int i = 0; i < 22; ++i) {
    for (int j = 0; j < 18; ++j) {
      xml += EPuckXml(std::to_string(18 * i + j), CVector3(0.113 * i + 0.05, 0.11 * j + 0.05, 0.0),
                      random.Uniform(-180.0, 180.0), 9.0, random.Uniform(4.0, 9.0));
    }
  }
  CDriveWorld alone(Torus(engine.ToXml(), xml));
  CDriveWorld threads(Torus(engine.ToXml(), xml, "true", 4));
  for (int tick = 0; tick < 40; ++tick) {
    alone.Step();
    threads.Step();
    REQUIRE(alone.ComputeDigest() == threads.ComputeDigest());
  }
  // robots press each other all around the arena, and overlap by no more than the engine tolerates
  for (int a = 0; a < 396; ++a) {
    for (int b = 0; b < a; ++b) {
      const Real distance =
          Way(alone.Position(std::to_string(a)), alone.Position(std::to_string(b))).Length();
      if (distance < 2.0 * kEPuck * 0.98) {
        CAPTURE(a, b, distance);
        FAIL("robots overlap");
      }
    }
  }
}

TEST_CASE("torus: placement refuses overlaps across the seams", "[physics][torus]") {
  const SEngineType engine = GENERATE(from_range(kEngines));
  CAPTURE(engine);
  // 150 discs cover 29 % of the arena: without images some would overlap across a side
  const std::string xml =
      "<distribute><position method='uniform' min='0,0,0' max='2.5,2,0'/><orientation "
      "method='constant' values='0,0,0'/><entity quantity='150' max_trials='1000'><e-puck id='e'>"
      "<controller config='driver'/></e-puck></entity></distribute>";
  CDriveWorld world(Torus(engine.ToXml(), xml));
  for (int a = 0; a < 150; ++a) {
    for (int b = 0; b < a; ++b) {
      CAPTURE(a, b);
      const Real distance =
          Way(world.Position("e" + std::to_string(a)), world.Position("e" + std::to_string(b)))
              .Length();
      REQUIRE(distance >= 2.0 * kEPuck - 1e-6);
    }
  }
}

TEST_CASE("torus: moving an entity out of the arena puts it inside", "[physics][torus]") {
  const SEngineType engine = GENERATE(from_range(kEngines));
  CAPTURE(engine);
  CDriveWorld world(
      Torus(engine.ToXml(), EPuckXml("a", CVector3(1.0, 1.0, 0.0), 0.0, 0.0, 0.0) +
                                EPuckXml("b", CVector3(0.02, 0.5, 0.0), 0.0, 0.0, 0.0)));
  CLoopFunctions& loop = world.GetSimulator().GetLoopFunctions();
  CHECK(loop.MoveEntity(world.Body("a"), CVector3(-0.4, 4.1, 0.0), CQuaternion()));
  CHECK_THAT(Distance(world.Position("a"), CVector3(2.1, 0.1, 0.0)), WithinAbs(0.0, 1e-12));
  // the other robot is there, across the side
  CHECK_FALSE(loop.MoveEntity(world.Body("a"), CVector3(2.48, 0.5, 0.0), CQuaternion()));
  CHECK_THAT(Distance(world.Position("a"), CVector3(2.1, 0.1, 0.0)), WithinAbs(0.0, 1e-12));
  world.Step();
  CHECK_THAT(Distance(world.Position("a"), CVector3(2.1, 0.1, 0.0)), WithinAbs(0.0, 1e-12));
  // one that the file places outside
  CDriveWorld outside(
      Torus(engine.ToXml(), EPuckXml("a", CVector3(-0.1, 2.3, 0.0), 0.0, 0.0, 0.0)));
  CHECK_THAT(Distance(outside.Position("a"), CVector3(2.4, 0.3, 0.0)), WithinAbs(0.0, 1e-12));
  outside.Step();
  outside.GetSimulator().Reset();
  CHECK_THAT(Distance(outside.Position("a"), CVector3(2.4, 0.3, 0.0)), WithinAbs(0.0, 1e-12));
}

TEST_CASE("torus: metrics use the shortest distances, fields have wrapped and unwrapped places",
          "[physics][torus][metrics]") {
  CDriveWorld world(Torus(kKinematics2D.ToPromptXml(),
                          EPuckXml("a", CVector3(2.4652, 1.99, 0.0), 0.0, 10.0, 10.0) +
                              EPuckXml("b", CVector3(0.036, 1.99, 0.0), 0.0, 10.0, 10.0)));
  CMetrics& metrics = world.GetSimulator().GetMetrics();
  metrics.EnableBuiltIn("collisions");
  metrics.EnableBuiltIn("dispersion");
  const auto read = [&world](const std::string& field, const std::string& id) {
    const SFieldName name(field);
    double numbers[7] = {};
    CRowTexts texts;
    const SBoundField bound = name.Bind(world.GetSpace().GetEntity(id));
    REQUIRE(bound.Reader != nullptr);
    bound.Reader->Read(0, {numbers, texts, bound.Columns.data()});
    return std::vector<double>(numbers, numbers + 2);
  };
  world.Step(11);
  // they touch, and the mean of the two is half-way across the seam
  CHECK(metrics.Find("collisions")->Value == 2.0);
  CHECK_THAT(metrics.Find("dispersion")->Value, WithinAbs(0.0354, 1e-9));
  // 10 ticks of 1 cm
  CHECK_THAT(read("pose", "a")[0], WithinAbs(0.0652, 1e-9));
  CHECK_THAT(read("unwrapped", "a")[0], WithinAbs(2.5652, 1e-9));
  CHECK_THAT(read("unwrapped", "a")[1], WithinAbs(1.99, 1e-9));
  CHECK_THAT(read("unwrapped", "b")[0], WithinAbs(0.136, 1e-9));
}

TEST_CASE("torus: what cannot be done is an error with its place", "[physics][torus]") {
  const std::string robot = EPuckXml("a", CVector3(1.0, 1.0, 0.0), 0.0, 0.0, 0.0);
  const auto error = [&robot](const std::string& engines, const std::string& attributes,
                              const std::string& media = "") {
    SExperiment experiment = Torus(engines, robot);
    experiment.ArenaAttributes = attributes;
    experiment.Media = media;
    return LoadError(experiment);
  };
  const std::string engine = "<kinematics2d id='k'/>";
  const std::string periodic = "periodic='true'";
  CHECK(error(engine, periodic).empty());
  CHECK(error(engine, "periodic='y,x'").empty());
  CHECK(error(engine, "periodic='false' walls='0.1,0.3'").empty());
  CHECK_THAT(error(engine, "periodic='z'"),
             Contains("test.argos:") && Contains("\"periodic\" must be") && Contains("\"z\""));
  CHECK_THAT(error(engine, periodic + " walls='0.1,0.3'"),
             Contains("test.argos:") && Contains("stand along all sides"));
  {
    SExperiment walls = Torus(engine, "<walls thickness='0.1' height='0.2'/>");
    CHECK_THAT(LoadError(walls), Contains("test.argos:") && Contains("stand along all sides"));
  }
  for (const std::string type : {"dynamics3d", "pointmass3d"}) {
    CHECK_THAT(error("<" + type + " id='e'/>", periodic),
               Contains("test.argos:") && Contains("<" + type + " id=\"e\">") &&
                   Contains("does not know the joined sides") &&
                   Contains(": use dynamics2d or kinematics2d"));
  }
  CHECK_THAT(error(engine + "<dynamics2d id='d'/>", periodic),
             Contains("<dynamics2d id=\"d\">") && Contains("one engine only"));
  CHECK_THAT(error("<dynamics2d id='d'><boundaries><top height='1'/><bottom height='0'/><sides>"
                   "<vertex point='0,0'/><vertex point='2.5,0'/><vertex point='2.5,2'/>"
                   "<vertex point='0,2'/></sides></boundaries></dynamics2d>",
                   periodic),
             Contains("<dynamics2d id=\"d\">") && Contains("<boundaries>"));
  CHECK_THAT(error(engine, periodic, "<torus_test_medium id='mine'/>"),
             Contains("test.argos:") && Contains("<torus_test_medium id=\"mine\">"));
  CHECK_THAT(error(engine, periodic, "<pheromone id='p' size='2,2'><layer id='l'/></pheromone>"),
             Contains("test.argos:") && Contains("\"size\" and \"center\""));
}

TEST_CASE("torus: a robot that is no disc pushes and is stopped across a seam",
          "[physics][torus]") {
  const SEngineType engine = GENERATE(from_range(kEngines));
  CAPTURE(engine);
  const auto drive = [](CDriveWorld& world) {
    world.Reshape("a", SShapeDescription::Box(CVector3(0.1, 0.06, 0.05)));
    world.Reshape("b", SShapeDescription::Box(CVector3(0.08, 0.08, 0.05)));
    world.Step(60);
  };
  const auto scene = [](const CVector3& middle) {
    return EPuckXml("a", middle + CVector3(-0.25, 0.01, 0.0), 3.0, 7.0, 7.2) +
           BoxAt("box", middle + CVector3(-0.1, 0.0, 0.0), 5.0) +
           EPuckXml("b", middle + CVector3(0.2, -0.02, 0.0), 180.0, 4.0, 4.0);
  };
  const CVector3 middle(1.25, 1.0, 0.0);
  CDriveWorld plain(engine.ToXml(), scene(middle));
  drive(plain);
  for (const CVector3& moved : {CVector3(1.25, 0.0, 0.0), CVector3(1.24, 1.03, 0.0)}) {
    CAPTURE(moved);
    CDriveWorld torus(Torus(engine.ToXml(), scene(middle + moved)));
    drive(torus);
    for (const std::string id : {"a", "box", "b"}) {
      CAPTURE(id);
      CHECK_THAT(Way(plain.Position(id) + moved, torus.Position(id)).Length(),
                 WithinAbs(0.0, engine.HasMomentum ? 5e-5 : 1e-9));
    }
  }
}

TEST_CASE("torus: a gripper holds and drags what is across a seam", "[physics][torus]") {
  const auto withGrippers = [](SExperiment experiment) {
    experiment.Controllers =
        "<contract_driver id='driver'><actuators><differential_steering implementation='default'/>"
        "<footbot_gripper implementation='default'/></actuators><sensors/></contract_driver>";
    return experiment;
  };
  const auto scene = [](const CVector3& middle) {
    return DriverXml("foot-bot", "a", middle.GetX() - 0.088, middle.GetY(), 0.0, 0.0, 0.0) +
           DriverXml("foot-bot", "b", middle.GetX() + 0.255, middle.GetY() + 0.01, 180.0, 0.0,
                     0.0) +
           BoxXml("box", middle.GetX() + 0.08, middle.GetY(), 0.0, "0.16,0.1,0.1");
  };
  // both grip the box, and one drags it and the other one on an arc
  const auto drive = [](CDriveWorld& world) {
    world.Step(2);
    for (const std::string id : {"a", "b"}) {
      world.Driver(id).GetActuator<CCI_FootBotGripperActuator>("footbot_gripper")->LockPositive();
    }
    world.Step(5);
    world.Driver("a").Left = -7.0;
    world.Driver("a").Right = -8.0;
    world.Driver("b").Left = 7.0;
    world.Driver("b").Right = 7.5;
    world.Step(100);
  };
  const CVector3 middle(1.25, 1.0, 0.0);
  CDriveWorld plain(withGrippers(CDriveWorld::Describe("<dynamics2d id='d'/>", scene(middle))));
  drive(plain);
  CHECK(Way(middle, plain.Position("box")).Length() > 0.5);
  for (const CVector3& moved : {CVector3(1.25, 0.0, 0.0), CVector3(1.24, 1.03, 0.0)}) {
    CAPTURE(moved);
    CDriveWorld torus(withGrippers(Torus("<dynamics2d id='d'/>", scene(middle + moved))));
    drive(torus);
    for (const std::string id : {"a", "box", "b"}) {
      CAPTURE(id);
      CHECK_THAT(Way(plain.Position(id) + moved, torus.Position(id)).Length(),
                 WithinAbs(0.0, 5e-5));
    }
  }
}

TEST_CASE("torus: an arena that is too small for its bodies is an error", "[physics][torus]") {
  const SEngineType engine = GENERATE(from_range(kEngines));
  CAPTURE(engine);
  SExperiment experiment =
      Torus(engine.ToXml(), EPuckXml("a", CVector3(0.05, 0.05, 0.0), 0.0, 0.0, 0.0));
  experiment.ArenaSize = "0.12,2,1";
  CHECK_THAT(LoadError(experiment), Contains("test.argos:") && Contains("four times the radius of "
                                                                        "\"a\", 0.14 m"));
  // too small for its way in a tick
  experiment.ArenaSize = "0.2,2,1";
  CDriveWorld world(experiment);
  CHECK_THROWS_WITH(world.Step(), Contains("a periodic arena must be wider"));
}

}  // namespace argos::torus_test
