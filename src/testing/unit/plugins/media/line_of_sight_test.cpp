#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/plugins/simulator/media/line_of_sight.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/testing/support/toy_world.h>

#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

namespace line_of_sight_test {

using namespace argos;

namespace {

// toy robots are discs of radius 0.05 m, 0.1 m high
std::string Disc(const std::string& id, Real x, Real y) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<toy-robot id='" << id << "'><body position='" << x << "," << y
      << ",0'/><controller config='c'/></toy-robot>";
  return xml.str();
}

std::string Block(const std::string& id, Real x, Real y, const std::string& size) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<toy-block id='" << id << "' size='" << size << "' movable='false'><body position='" << x
      << "," << y << ",0'/></toy-block>";
  return xml.str();
}

class CSightWorld : public CTestWorld {
 public:
  explicit CSightWorld(const std::string& arena) : CTestWorld(MakeExperiment(arena)) {}

  // tests the line between points of two robots, at that height above their bases
  bool IsClear(const std::string& from, const std::string& to, Real height = 0.05) {
    const CEmbodiedEntity& start = Get<CToyRobotEntity>(from).GetEmbodiedEntity();
    const CEmbodiedEntity& end = Get<CToyRobotEntity>(to).GetEmbodiedEntity();
    const CVector3 up(0.0, 0.0, height);
    return CLineOfSight(GetSpace())
        .IsClear(CRay3(start.GetOriginAnchor().Position + up, end.GetOriginAnchor().Position + up),
                 start, end);
  }

 private:
  static SExperiment MakeExperiment(const std::string& arena) {
    SExperiment experiment;
    experiment.Controllers =
        "<toy_controller id='c'><actuators/><sensors/><params/></toy_controller>";
    experiment.Engines = "<toy_engine id='toy'/>";
    experiment.Arena = arena;
    return experiment;
  }
};

}  // namespace

TEST_CASE("line of sight: a body between occludes, one beside or behind does not",
          "[core][space]") {
  CSightWorld world(Disc("a", 0.0, 0.0) + Disc("b", 1.0, 0.0) + Disc("c", 2.0, 0.0) +
                    Disc("beside", 0.5, 0.0501) + Disc("d", 0.0, 1.0));
  CHECK(world.IsClear("a", "b"));
  CHECK(world.IsClear("b", "a"));
  CHECK_FALSE(world.IsClear("a", "c"));
  CHECK_FALSE(world.IsClear("c", "a"));
  CHECK(world.IsClear("a", "d"));
  // the tops of the discs are at 0.1 m: the line along them is still occluded
  CHECK_FALSE(world.IsClear("a", "c", 0.1));
  CHECK(world.IsClear("a", "c", 0.1001));
}

TEST_CASE("line of sight: a disc occludes lines that pass its centre closer than its radius",
          "[core][space]") {
  const Real side = GENERATE(-1.0, 1.0);
  const Real offset = GENERATE(0.0499999, 0.0500001);
  CSightWorld world(Disc("a", 0.0, 0.0) + Disc("b", 1.0, 0.0) + Disc("m", 0.4, side * offset));
  CHECK(world.IsClear("a", "b") == (offset > 0.05));
  CHECK(world.IsClear("b", "a") == (offset > 0.05));
}

TEST_CASE("line of sight: walls occlude", "[core][space]") {
  CSightWorld world(Disc("a", -1.0, 0.0) + Disc("b", 1.0, 0.0) + Disc("c", 1.0, 2.0) +
                    Block("wall", 0.0, -1.0, "0.1,2.5,0.08"));
  // the wall ends at y = 0.25
  CHECK_FALSE(world.IsClear("a", "b"));
  CHECK(world.IsClear("a", "b", 0.09));
  // the line passes x = 0 at y = 1
  CHECK(world.IsClear("a", "c"));
}

TEST_CASE("line of sight: a body that overlaps one of the two occludes only outside it",
          "[core][space]") {
  // the line from a to b leaves a at x = 0.05 and enters b at 0.25
  SECTION("a thin block entirely inside a robot") {
    CSightWorld world(Disc("a", 0.0, 0.0) + Disc("b", 0.3, 0.0) +
                      Block("in_b", 0.28, 0.0, "0.02,0.02,0.1"));
    CHECK(world.IsClear("a", "b"));
    CHECK(world.IsClear("b", "a"));
  }
  SECTION("a block that protrudes from the robot towards the other") {
    CSightWorld world(Disc("a", 0.0, 0.0) + Disc("b", 0.3, 0.0) +
                      Block("out_of_b", 0.25, 0.0, "0.02,0.02,0.1"));
    CHECK_FALSE(world.IsClear("a", "b"));
    CHECK_FALSE(world.IsClear("b", "a"));
  }
  SECTION("robots that overlap see each other regardless of other bodies") {
    CSightWorld world(Disc("a", 0.0, 0.0) + Disc("b", 0.09, 0.0) + Disc("c", 0.045, 0.0));
    CHECK(world.IsClear("a", "b"));
    CHECK(world.IsClear("b", "a"));
  }
  SECTION("for points above their bodies the whole line is tested") {
    CSightWorld world(Disc("a", 0.0, 0.0) + Disc("b", 0.3, 0.0) +
                      Block("on_b", 0.3, 0.0, "0.02,0.02,0.3"));
    CHECK_FALSE(world.IsClear("a", "b", 0.2));
    CHECK(world.IsClear("a", "b", 0.05));
  }
}

TEST_CASE("line of sight: equals the closest hit where bodies do not overlap", "[core][space]") {
  CRandomStream random(1, "test", "line of sight", "places");
  constexpr int kDiscs = 60;
  // on a jittered lattice of 0.2 m, so that centres are never closer than 0.11 m
  std::string arena;
  for (int i = 0; i < kDiscs; ++i) {
    arena += Disc("d" + std::to_string(i), 0.2 * (i % 8) + random.Uniform(-0.04, 0.04),
                  0.2 * (i / 8) + random.Uniform(-0.04, 0.04));
  }
  CSightWorld world(arena);
  const CBodyIndex& index = world.GetSpace().GetBodyIndex();
  int numClear = 0;
  for (int i = 0; i < kDiscs; ++i) {
    for (int j = 0; j < kDiscs; ++j) {
      if (i == j) {
        continue;
      }
      const std::string from = "d" + std::to_string(i);
      const std::string to = "d" + std::to_string(j);
      const CEmbodiedEntity& start = world.Get<CToyRobotEntity>(from).GetEmbodiedEntity();
      const CEmbodiedEntity& end = world.Get<CToyRobotEntity>(to).GetEmbodiedEntity();
      const CVector3 up(0.0, 0.0, 0.05);
      SEmbodiedEntityIntersectionItem hit;
      index.FindClosestHit(
          hit, CRay3(start.GetOriginAnchor().Position + up, end.GetOriginAnchor().Position + up),
          &start);
      CAPTURE(i, j);
      CHECK(world.IsClear(from, to) == (hit.IntersectedEntity == &end));
      numClear += world.IsClear(from, to) ? 1 : 0;
    }
  }
  // both outcomes occur
  CHECK(numClear > kDiscs);
  CHECK(numClear < kDiscs * (kDiscs - 1) / 2);
}

}  // namespace line_of_sight_test
