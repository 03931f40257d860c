// Adding, moving, removing, resetting and transferring rigid bodies; threads.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/no_allocation.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <thread>

namespace argos::rigid_lifecycle_test {

using Catch::Matchers::WithinAbs;

namespace {

// robots that collide with each other and with boxes of all kinds, some of which fall
std::string CollidingBodiesXml(int robots = 24) {
  std::string arena;
  CRandomStream random(7, "test", "turmoil", "places");
  for (int i = 0; i < robots; ++i) {
    arena += DriverXml(i % 3 == 0 ? "e-puck" : "foot-bot", "r" + std::to_string(i),
                       0.4 * (i % 6 - 2.5), 0.4 * (i / 6 - 1.5), random.Uniform(0.0, 360.0),
                       random.Uniform(2.0, 15.0), random.Uniform(2.0, 15.0));
  }
  for (int i = 0; i < 8; ++i) {
    arena += SBoxXml{"b" + std::to_string(i), CVector3(0.1, 0.15, 0.1 + 0.02 * i),
                     CVector3(0.4 * (i % 4 - 1.5) + 0.1, 0.8 * (i / 4) - 0.35, 0.3),
                     CVector3(20.0 * i, 15.0 * i, 0.0), 0.2}
                 .ToXml();
  }
  return arena;
}

// four engines around the origin
std::string Quarters() {
  std::ostringstream xml;
  for (int i = 0; i < 4; ++i) {
    const int west = i % 2 == 0 ? -10 : 0;
    const int south = i / 2 == 0 ? -10 : 0;
    xml << "<dynamics3d id='q" << i << "'><floor/><gravity g='9.81'/><boundaries><sides><vertex "
        << "point='" << west << "," << south << "'/><vertex point='" << west + 10 << "," << south
        << "'/><vertex point='" << west + 10 << "," << south + 10 << "'/><vertex point='" << west
        << "," << south + 10 << "'/></sides></boundaries></dynamics3d>";
  }
  return xml.str();
}

std::string ControllersOf() {
  return "<contract_driver id='driver'><actuators><differential_steering implementation='default'/>"
         "</actuators><sensors/></contract_driver>";
}

SExperiment CollidingBodiesIn(const std::string& engines, UInt32 threads) {
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Controllers = ControllersOf();
  experiment.Engines = engines;
  experiment.ArenaSize = "20,20,4";
  experiment.Arena = CollidingBodiesXml();
  return experiment;
}

}  // namespace

TEST_CASE("rigid lifecycle: a moved body is at rest at its new pose", "[contract][engine][rigid]") {
  CRigidScene world(RigidEngine("", "<gravity g='9.81'/>"),
                    SBoxXml{"b", CVector3(1, 1, 1), CVector3(0, 0, 1)}.ToXml());
  world.Step(10);
  const CQuaternion turn(CRadians(0.3), CVector3::Y);
  REQUIRE(world.Body("b").MoveTo(CVector3(1, 2, 3), turn));
  CHECK(world.Position("b") == CVector3(1, 2, 3));
  // testing a place for collisions changes nothing
  CHECK(world.Body("b").MoveTo(CVector3(5, 5, 5), CQuaternion(), true));
  world.Step();
  const CVector3 fallen(1.0, 2.0, 3.0 - 9.81 * 1e-4 * 55.0);
  CHECK(Distance(world.Position("b"), fallen) < 1e-9);
  CHECK_THAT(world.Tilt("b"), WithinAbs(0.3, 1e-9));
}

TEST_CASE("rigid lifecycle: testing a place for collisions does not affect the motion",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine(), CollidingBodiesXml());
  CRigidScene other(GroundedEngine(), CollidingBodiesXml());
  for (int tick = 0; tick < 30; ++tick) {
    world.Step();
    other.Step();
    other.Body("r3").MoveTo(CVector3(5, 5, 0), CQuaternion(), true);
    REQUIRE(world.ComputeDigest() == other.ComputeDigest());
  }
}

TEST_CASE("rigid lifecycle: immovable bodies can be moved by commands",
          "[contract][engine][rigid]") {
  CRigidScene world(RigidEngine("", "<gravity g='9.81'/>"),
                    SBoxXml{"table", CVector3(1, 1, 0.5), CVector3(0, 0, 0), {}, 0.0}.ToXml() +
                        SBoxXml{"b", CVector3(0.2, 0.2, 0.2), CVector3(0, 0, 0.5)}.ToXml());
  world.Step(20);
  CHECK_THAT(world.Position("b").GetZ(), WithinAbs(0.5, 1e-3));
  REQUIRE(world.Body("table").MoveTo(CVector3(5, 0, 0), CQuaternion()));
  world.Step(5);
  CHECK(world.Position("b").GetZ() < 0.0);
}

TEST_CASE("rigid lifecycle: after a reset the run repeats bit by bit",
          "[contract][engine][rigid]") {
  const std::string stepper = GENERATE("mixed", "direct", "iterative");
  CAPTURE(stepper);
  CRigidScene world(GroundedEngine("", "<solver stepper='" + stepper + "' max_direct_rows='40'/>"),
                    CollidingBodiesXml());
  const std::vector<UInt64> first = RecordDigests(world, 100);
  world.Body("r1").MoveTo(CVector3(4, 4, 0), CQuaternion());
  for (int repetition = 0; repetition < 2; ++repetition) {
    world.GetSimulator().Reset();
    REQUIRE(RecordDigests(world, 100) == first);
  }
  if (stepper == "direct") {
    // warns once of contacts that ODE has left unsolved
    TakeLogErr();
  }
}

TEST_CASE("rigid determinism: equal bit by bit for any number of threads",
          "[contract][engine][rigid]") {
  const int engines = GENERATE(1, 4);
  const std::string stepper = GENERATE("mixed", "iterative");
  CAPTURE(engines, stepper);
  std::string xml = engines == 1 ? GroundedEngine() : Quarters();
  // a limit on rows so low that "mixed" uses both steppers
  const std::string solver = "<solver stepper='" + stepper + "' max_direct_rows='40'/><floor/>";
  for (size_t at = xml.find("<floor/>"); at != std::string::npos;
       at = xml.find("<floor/>", at + solver.size())) {
    xml.replace(at, 8, solver);
  }
  CTestWorld reference(CollidingBodiesIn(xml, 0));
  const std::vector<UInt64> expected = RecordDigests(reference, 100);
  for (const UInt32 threads : {1U, 4U}) {
    CAPTURE(threads);
    CTestWorld world(CollidingBodiesIn(xml, threads));
    CHECK(RecordDigests(world, 100) == expected);
  }
}

TEST_CASE("rigid determinism: simulators in several threads do not affect each other",
          "[contract][engine][rigid]") {
  const std::string engine = GroundedEngine("", "<solver stepper='iterative'/>");
  CTestWorld reference(CollidingBodiesIn(engine, 0));
  const std::vector<UInt64> expected = RecordDigests(reference, 60);
  std::vector<std::vector<UInt64>> results(4);
  {
    std::vector<std::jthread> threads;
    for (std::vector<UInt64>& result : results) {
      threads.emplace_back([&result, &engine] {
        CTestWorld world(CollidingBodiesIn(engine, 0));
        result = RecordDigests(world, 60);
      });
    }
  }
  for (const std::vector<UInt64>& result : results) {
    CHECK(result == expected);
  }
}

TEST_CASE("rigid lifecycle: a tick in steady state allocates nothing",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine("sleep='false'"), CollidingBodiesXml());
  world.Step(200);
  CheckAllocatesNothing([&] { world.Step(20); });
}

}  // namespace argos::rigid_lifecycle_test
