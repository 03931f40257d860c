#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <set>

namespace distribution_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

const char* const kUniform = "<position method='uniform' min='-2,-2,0' max='2,2,0' />";
const char* const kAnyYaw = "<orientation method='uniform' min='-180,0,0' max='180,0,0' />";
const char* const kNoYaw = "<orientation method='constant' values='0,0,0' />";
const char* const kRobot = "<toy-robot id='fb'> <controller config='c' /> </toy-robot>";

std::string Distribute(const std::string& position, const std::string& orientation,
                       const std::string& entityAttributes, const std::string& entity) {
  return "<distribute>\n" + position + "\n" + orientation + "\n<entity " + entityAttributes +
         ">\n" + entity + "\n</entity>\n</distribute>\n";
}

SExperiment Experiment(const std::string& arena, UInt32 seed = 1) {
  return SExperiment{.Seed = seed,
                     .Controllers = "<toy_controller id='c' />",
                     .Engines = "<toy_engine id='toy' />",
                     .Arena = arena};
}

std::vector<CVector3> Positions(CTestWorld& world) {
  std::vector<CVector3> positions;
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    positions.push_back(dynamic_cast<CToyRobotEntity&>(robot->GetRootEntity())
                            .GetEmbodiedEntity()
                            .GetOriginAnchor()
                            .Position);
  }
  return positions;
}

}  // namespace

TEST_CASE("distribute: places the requested number of entities within the limits, without overlaps",
          "[core][space][distribute]") {
  CTestWorld world(Experiment(
      Distribute(kUniform, kAnyYaw, "quantity='200' max_trials='1000' base_num='7'", kRobot)));
  const std::vector<CVector3> positions = Positions(world);
  REQUIRE(positions.size() == 200);
  for (int i = 0; i < 200; ++i) {
    CHECK(world.GetSpace().GetEntity("fb" + std::to_string(7 + i)).GetTypeDescription() ==
          "toy-robot");
  }
  Real nearest = HUGE_VAL;
  for (size_t i = 0; i < positions.size(); ++i) {
    CHECK(std::abs(positions[i].GetX()) <= 2.0);
    CHECK(std::abs(positions[i].GetY()) <= 2.0);
    CHECK(positions[i].GetZ() == 0.0);
    for (size_t j = 0; j < i; ++j) {
      nearest = std::min(nearest, Distance(positions[i], positions[j]));
    }
  }
  // two radii, less the gap that counts as touching
  CHECK(nearest >= 2.0 * CToyRobotEntity::kRadius - 1e-8);
}

TEST_CASE("distribute: places avoid bodies that exist already, also those of another block",
          "[core][space][distribute]") {
  CTestWorld world(Experiment(
      "<toy-block id='b' size='3,3,1' movable='false'> <body position='0,0,0' orientation='30,0,0' "
      "/> </toy-block>" +
      Distribute(kUniform, kAnyYaw, "quantity='40' max_trials='1000'", kRobot) +
      Distribute(kUniform, kAnyYaw, "quantity='40' max_trials='1000' base_num='40'", kRobot)));
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    CHECK_FALSE(dynamic_cast<CToyRobotEntity&>(robot->GetRootEntity())
                    .GetEmbodiedEntity()
                    .IsCollidingWithSomething());
  }
  CHECK(Positions(world).size() == 80);
}

TEST_CASE(
    "distribute: entities outside <distribute> are placed first, wherever they stand in the file",
    "[core][space][distribute]") {
  CTestWorld world(Experiment(
      Distribute(kUniform, kNoYaw, "quantity='3' max_trials='1000'", kRobot) +
      "<toy-block id='b' size='3,3,1' movable='false'> <body position='0,0,0' /> </toy-block>"));
  CHECK(world.GetSpace().GetRootEntityVector().front()->GetId() == "b");
  for (const CVector3& position : Positions(world)) {
    CHECK((std::abs(position.GetX()) > 1.5 || std::abs(position.GetY()) > 1.5));
  }
}

TEST_CASE("distribute: equal seeds give equal places bit by bit, another seed gives others",
          "[core][space][distribute]") {
  const std::string arena =
      Distribute(kUniform, kAnyYaw, "quantity='50' max_trials='1000'", kRobot);
  CTestWorld first(Experiment(arena, 5));
  CTestWorld second(Experiment(arena, 5));
  CTestWorld other(Experiment(arena, 6));
  CHECK(first.ComputeDigest() == second.ComputeDigest());
  CHECK(first.ComputeDigest() != other.ComputeDigest());
  // a reset does not draw the places again
  const std::vector<CVector3> before = Positions(first);
  first.Step(3);
  first.GetSimulator().Reset();
  CHECK(Positions(first) == before);
}

TEST_CASE("distribute: positions and orientations are exact, not rounded to six digits",
          "[core][space][distribute]") {
  CTestWorld world(
      Experiment(Distribute("<position method='constant' values='0.123456789012345,1e-9,0' />",
                            "<orientation method='constant' values='33.3333333333333,0,0' />",
                            "quantity='1' max_trials='0'", kRobot)));
  const SAnchor& origin = world.Get<CToyRobotEntity>("fb0").GetEmbodiedEntity().GetOriginAnchor();
  CHECK(origin.Position == CVector3(0.123456789012345, 1e-9, 0.0));
  CRadians z;
  CRadians y;
  CRadians x;
  origin.Orientation.ToEulerAngles(z, y, x);
  CHECK_THAT(ToDegrees(z).GetValue(), WithinAbs(33.3333333333333, 1e-13));
}

TEST_CASE("distribute: orientation triples are z, y, x in degrees", "[core][space][distribute]") {
  CTestWorld world(Experiment(Distribute("<position method='constant' values='0,0,0' />",
                                         "<orientation method='constant' values='90,0,0' />",
                                         "quantity='1' max_trials='0'", kRobot)));
  CVector3 ahead = CVector3::X;
  ahead.Rotate(world.Get<CToyRobotEntity>("fb0").GetEmbodiedEntity().GetOriginAnchor().Orientation);
  CHECK_THAT(ahead.GetY(), WithinAbs(1.0, 1e-15));
}

TEST_CASE("distribute: a grid follows the documented order", "[core][space][distribute]") {
  CTestWorld world(Experiment(
      Distribute("<position method='grid' center='1,0,0' distances='0.5,1,1' layout='3,2,1' />",
                 kNoYaw, "quantity='5' max_trials='0'", kRobot)));
  CHECK(Positions(world) == std::vector<CVector3>{CVector3(1.5, 0.5, 0.0), CVector3(1.0, 0.5, 0.0),
                                                  CVector3(0.5, 0.5, 0.0), CVector3(1.5, -0.5, 0.0),
                                                  CVector3(1.0, -0.5, 0.0)});
}

TEST_CASE("distribute: grids that collide or overflow are errors", "[core][space][distribute]") {
  const auto grid = [](const std::string& layout, const std::string& distances) {
    return "<position method='grid' center='0,0,0' distances='" + distances + "' layout='" +
           layout + "' />";
  };
  CHECK_THAT(LoadError(Experiment(Distribute(grid("3,1,1", "0.5,1,1"), kNoYaw,
                                             "quantity='4' max_trials='9'", kRobot))),
             Contains("3 x 1 x 1") && Contains("item number 4") && Contains("test.argos:"));
  CHECK_THAT(LoadError(Experiment(Distribute(grid("3,1,1", "0.09,1,1"), kNoYaw,
                                             "quantity='3' max_trials='9'", kRobot))),
             Contains("\"fb1\"") && Contains("after 1 trial;") && Contains("\"fb0\""));
}

TEST_CASE(
    "distribute: the error on a full area names the entity, the area and the number of trials",
    "[core][space][distribute]") {
  const std::string error =
      LoadError(Experiment(Distribute("<position method='uniform' min='0,0,0' max='0.15,0.15,0' />",
                                      kNoYaw, "quantity='7' max_trials='20'", kRobot)));
  CAPTURE(error);
  // max_trials failures are tolerated: 21 trials in all
  CHECK_THAT(error, Contains("after 21 trials") && Contains("(0,0,0) to (0.15,0.15,0)") &&
                        Contains("<toy-robot id=\"fb\">") && Contains("test.argos:9"));
}

TEST_CASE("distribute: max_trials = 0 is one trial", "[core][space][distribute]") {
  CHECK(LoadError(Experiment(Distribute(kUniform, kNoYaw, "quantity='1' max_trials='0'", kRobot)))
            .empty());
  CHECK_THAT(
      LoadError(Experiment(
          "<toy-block id='b' size='5,5,1' movable='false'> <body position='0,0,0' /> </toy-block>" +
          Distribute(kUniform, kNoYaw, "quantity='1' max_trials='0'", kRobot))),
      Contains("after 1 trial;") && Contains("\"b\""));
}

TEST_CASE("distribute: a controller is initialised once for each robot, for any number of trials",
          "[core][space][distribute]") {
  const int before = CToyController::NumInits;
  CTestWorld world(Experiment(Distribute("<position method='uniform' min='0,0,0' max='1,1,0' />",
                                         kNoYaw, "quantity='40' max_trials='10000'", kRobot)));
  CHECK(CToyController::NumInits == before + 40);
  CHECK(CToyController::NumAlive == 40);
}

TEST_CASE("distribute: entities without a body are placed without an overlap test",
          "[core][space][distribute]") {
  CTestWorld world(Experiment(
      "<toy-block id='b' size='5,5,1' movable='false'> <body position='0,0,0' /> </toy-block>" +
      Distribute("<position method='constant' values='0.5,0.25,0.5' />", kNoYaw,
                 "quantity='3' max_trials='0'", "<toy-lamp id='lamp' />")));
  CHECK(world.Get<CToyLampEntity>("lamp2").GetPosition() == CVector3(0.5, 0.25, 0.5));
  CHECK(world.GetSpace().GetEntitiesByType("toy-lamp").size() == 3);
}

TEST_CASE("distribute: the pose in the template is overwritten", "[core][space][distribute]") {
  CTestWorld world(Experiment(Distribute(
      "<position method='constant' values='1,1,0' />", kNoYaw, "quantity='1' max_trials='0'",
      "<toy-robot id='fb'> <body position='7,7,7' orientation='1,2,3' /> <controller config='c' /> "
      "</toy-robot>")));
  CHECK(Positions(world).front() == CVector3(1.0, 1.0, 0.0));
}

TEST_CASE("distribute: quantity 0 creates no entity", "[core][space][distribute]") {
  CTestWorld world(Experiment(Distribute(kUniform, kNoYaw, "quantity='0' max_trials='0'", kRobot)));
  CHECK(world.GetSpace().GetRootEntityVector().empty());
  TakeLogErr();
}

TEST_CASE("distribute: invalid settings are errors", "[core][space][distribute]") {
  const std::string attributes = "quantity='1' max_trials='1'";
  CHECK_THAT(LoadError(Experiment(Distribute("", kNoYaw, attributes, kRobot))),
             Contains("position"));
  CHECK_THAT(LoadError(Experiment(Distribute(kUniform, "", attributes, kRobot))),
             Contains("orientation"));
  CHECK_THAT(LoadError(Experiment(Distribute(kUniform, kNoYaw, "max_trials='1'", kRobot))),
             Contains("quantity"));
  CHECK_THAT(LoadError(Experiment(Distribute(kUniform, kNoYaw, "quantity='1'", kRobot))),
             Contains("max_trials"));
  CHECK_THAT(
      LoadError(Experiment(Distribute(kUniform, kNoYaw, "quantity='-1' max_trials='1'", kRobot))),
      Contains("quantity") && Contains("-1"));
  CHECK_THAT(LoadError(Experiment(Distribute(kUniform, kNoYaw, attributes, ""))),
             Contains("<entity>"));
  CHECK_THAT(LoadError(Experiment(Distribute(kUniform, kNoYaw, attributes,
                                             std::string(kRobot) + "<toy-lamp id='l'/>"))),
             Contains("<toy-lamp>: <entity> holds one element, and that is already <toy-robot>"));
  for (const std::string tooMany :
       {"quantity='10000001' max_trials='1'", "quantity='1' max_trials='10000001'"}) {
    CHECK_THAT(LoadError(Experiment(Distribute(kUniform, kNoYaw, tooMany, kRobot))),
               Contains("must be an integer from 0 to 10000000, found 10000001"));
  }
  CHECK_THAT(
      LoadError(Experiment(Distribute(kUniform, kNoYaw, attributes, "<toy-robto id='r' />"))),
      Contains("toy-robto") && Contains("toy-robot"));
  CHECK_THAT(
      LoadError(Experiment(Distribute(kUniform, kNoYaw, attributes,
                                      "<toy-robot> <controller config='c' /> </toy-robot>"))),
      Contains("id"));
  CHECK_THAT(LoadError(Experiment(
                 Distribute(kUniform, kNoYaw, attributes,
                            "<toy-robot id='r'> <controller config='d' /> </toy-robot>"))),
             Contains("\"d\"") && Contains("known: c"));
  CHECK_THAT(LoadError(Experiment(Distribute("<position method='constant' values='0,0,0' />",
                                             kNoYaw, attributes, kRobot) +
                                  "<toy-lamp id='fb0' />")),
             Contains("\"fb0\"") && Contains("unique"));
}

TEST_CASE("redistribution: places are those of an experiment that is loaded with the seed",
          "[core][space][distribute]") {
  const std::string arena =
      "<toy-block id='b' size='1,1,1' movable='false'><body position='0,0,0'/></toy-block>" +
      Distribute(kUniform, kAnyYaw, "quantity='40' max_trials='1000'", kRobot) +
      Distribute("<position method='gaussian' mean='0,0,0' std_dev='1,1,0' />", kAnyYaw,
                 "quantity='20' max_trials='1000' base_num='40'", kRobot) +
      Distribute(kUniform, kNoYaw, "quantity='3' max_trials='0'", "<toy-lamp id='lamp'/>");
  CTestWorld world(Experiment(arena, 1));
  const auto lamp = [](CTestWorld& from) {
    return from.Get<CToyLampEntity>("lamp1").GetPosition();
  };
  const std::vector<CVector3> first = Positions(world);
  const UInt64 digest = world.ComputeDigest();
  for (const UInt32 seed : {2U, 3U, 1U}) {
    CAPTURE(seed);
    CTestWorld fresh(Experiment(arena, seed));
    world.Step(3);
    world.GetSimulator().Redistribute(seed);
    CHECK(Positions(world) == Positions(fresh));
    CHECK(lamp(world) == lamp(fresh));
    CHECK(world.ComputeDigest() == fresh.ComputeDigest());
    CHECK((Positions(world) == first) == (seed == 1));
    // later resets keep the places
    world.GetSimulator().Reset(4);
    CHECK(Positions(world) == Positions(fresh));
  }
  CHECK(world.ComputeDigest() == digest);
}

TEST_CASE("redistribution: with the attribute each reset draws the places of its seed",
          "[core][space][distribute]") {
  SExperiment experiment =
      Experiment(Distribute(kUniform, kAnyYaw, "quantity='40' max_trials='1000'", kRobot));
  const std::string kept = experiment.ToXml();
  const size_t size = kept.find("<arena ") + 7;
  const std::string drawn = std::string(kept).insert(size, "redistribute='true' ");
  CTestWorld keeping(kept);
  CTestWorld drawing(drawn);
  const std::vector<CVector3> places = Positions(keeping);
  CHECK(Positions(drawing) == places);
  keeping.GetSimulator().Reset(2);
  drawing.GetSimulator().Reset(2);
  CHECK(Positions(keeping) == places);
  CHECK(Positions(drawing) != places);
  drawing.GetSimulator().Reset(1);
  CHECK(Positions(drawing) == places);
  drawing.GetSimulator().Reset();
  CHECK(Positions(drawing) == places);
  CHECK_THROWS_WITH(CTestWorld(std::string(kept).insert(size, "redistribute='often' ")),
                    Contains("redistribute"));
}

namespace {

class CPlacelessEntity : public CEntity {
 public:
  ENABLE_VTABLE()
  CPlacelessEntity() : CEntity(nullptr) {}
  std::string GetTypeDescription() const override { return "placeless"; }
};

}  // namespace

REGISTER_ENTITY(CPlacelessEntity, "placeless", "", "", "", "", "")

TEST_CASE("distribute: what has neither a body nor a position is an error",
          "[core][space][distribute]") {
  CHECK_THROWS_WITH(
      CTestWorld(Experiment(
          Distribute(kUniform, kNoYaw, "quantity='1' max_trials='1'", "<placeless id='p' />"))),
      Contains("<placeless> has neither a body nor a position: it cannot be distributed"));
}

TEST_CASE("redistribution: many bodies, and bodies that were removed, get the places of the seed",
          "[core][space][distribute]") {
  // from CSpace::kFewRobots on, loading creates bodies in the order of the ground
  const std::string arena = Distribute("<position method='uniform' min='-5,-5,0' max='5,5,0' />",
                                       kNoYaw, "quantity='600' max_trials='1000'", kRobot);
  CTestWorld world(Experiment(arena, 1));
  CTestWorld fresh(Experiment(arena, 2));
  std::vector<CVector3> places = Positions(fresh);
  world.GetSimulator().Redistribute(2);
  CHECK(Positions(world) == places);
  {
    const CSimulator::CScope scope(world.GetSimulator());
    world.GetSimulator().GetLoopFunctions().RemoveEntity("fb7");
  }
  world.GetSimulator().Redistribute(2);
  places.erase(places.begin() + 7);
  CHECK(Positions(world) == places);
}

TEST_CASE("redistribution: without a free place nothing changes", "[core][space][distribute]") {
  // some seeds leave no place for the second one
  const std::string arena = Distribute("<position method='uniform' min='0,0,0' max='0.2,0,0' />",
                                       kNoYaw, "quantity='2' max_trials='1'", kRobot);
  UInt32 good = 0;
  UInt32 bad = 0;
  for (UInt32 seed = 1; good == 0 || bad == 0; ++seed) {
    REQUIRE(seed < 100);
    (LoadError(Experiment(arena, seed)).empty() ? good : bad) = seed;
  }
  CTestWorld world(Experiment(arena, good));
  const std::vector<CVector3> places = Positions(world);
  CHECK_THROWS_WITH(world.GetSimulator().Redistribute(bad),
                    Contains("no free place for \"fb1\"") && Contains("is taken by \"fb0\""));
  world.GetSimulator().Reset();
  CHECK(Positions(world) == places);
  world.GetSimulator().Redistribute(good);
  CHECK(Positions(world) == places);
}

}  // namespace distribution_test
