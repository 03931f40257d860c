#include <argos3/core/simulator/loop_functions.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_grid.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

namespace space_test {

using namespace argos;
using Catch::Contains;

namespace {

const char* const kController =
    "<toy_controller id='c'> <actuators> <toy_drive implementation='default' /> </actuators> "
    "</toy_controller>";

SExperiment TwoRobots() {
  return SExperiment{.Controllers = kController, .Engines = "<toy_engine id='toy' />", .Arena = R"(
    <toy-robot id='r1'> <body position='0,0,0' /> <controller config='c' /> </toy-robot>
    <toy-lamp id='lamp' position='0,0,1' />
    <toy-robot id='r2'> <body position='1,0,0' /> <controller config='c' /> </toy-robot>)"};
}

std::vector<std::string> Ids(const CEntity::TVector& entities) {
  std::vector<std::string> ids;
  for (const CEntity* entity : entities) {
    ids.push_back(entity->GetContext() + entity->GetId());
  }
  return ids;
}

// checks all views of a space against its roots and their components
void CheckViews(CSpace& space) {
  std::map<std::string, CEntity*> all;
  const std::function<void(CEntity&)> collect = [&](CEntity& entity) {
    const std::string id = entity.GetContext() + entity.GetId();
    CHECK(all.emplace(id, &entity).second);
    if (auto* composable = dynamic_cast<CComposableEntity*>(&entity)) {
      for (CEntity* component : composable->GetComponentVector()) {
        collect(*component);
      }
    }
  };
  for (CEntity* root : space.GetRootEntityVector()) {
    collect(*root);
  }
  CHECK(space.GetNumberEntities() == all.size());
  CHECK(space.GetEntityVector().size() == all.size());
  CHECK(std::is_sorted(space.GetEntityVector().begin(), space.GetEntityVector().end(),
                       SEntityComparator()));
  CHECK(space.GetEntityMapPerId().size() == all.size());
  size_t inTypes = 0;
  for (const auto& type : space.GetEntityMapPerTypePerId()) {
    inTypes += type.second.size();
  }
  CHECK(inTypes == all.size());
  for (const auto& [id, entity] : all) {
    CAPTURE(id);
    CHECK(&space.GetEntity(id) == entity);
    CHECK(space.GetEntityMapPerId().at(id) == entity);
    CHECK(space.GetEntitiesByType(entity->GetTypeDescription()).count(id) == 1);
    CHECK(entity->GetIndex() >= 0);
  }
}

}  // namespace

TEST_CASE("space: entities are found by qualified id", "[core][space]") {
  CTestWorld world(TwoRobots());
  CSpace& space = world.GetSpace();
  CHECK(space.GetEntity("r1").GetTypeDescription() == "toy-robot");
  CHECK(space.GetEntity("r1.body_0").GetTypeDescription() == "body");
  CHECK(&space.GetEntity("r2.controller_0").GetRootEntity() == &space.GetEntity("r2"));
  CHECK(space.GetEntity("lamp").GetTypeDescription() == "toy-lamp");
  CHECK_THROWS_WITH(space.GetEntity("r3"), Contains("r3") && Contains("r1"));
  CHECK_THROWS_AS(space.GetEntity("r1.body_1"), CARGoSException);
  CHECK_THROWS_AS(space.GetEntity(""), CARGoSException);
}

TEST_CASE("space: ids may have dots", "[core][space]") {
  SExperiment experiment = TwoRobots();
  experiment.Arena = R"(
    <toy-robot id='a'> <body position='0,0,0' /> <controller config='c' /> </toy-robot>
    <toy-robot id='a.b'> <body position='1,0,0' /> <controller config='c' /> </toy-robot>)";
  CTestWorld world(experiment);
  CHECK(&world.GetSpace().GetEntity("a.b.body_0").GetRootEntity() ==
        &world.GetSpace().GetEntity("a.b"));
  CHECK(&world.GetSpace().GetEntity("a.body_0").GetRootEntity() ==
        &world.GetSpace().GetEntity("a"));
  CheckViews(world.GetSpace());
}

TEST_CASE("space: lists are in order of addition, components after their parent", "[core][space]") {
  CTestWorld world(TwoRobots());
  CHECK(Ids(world.GetSpace().GetRootEntityVector()) ==
        std::vector<std::string>{"r1", "lamp", "r2"});
  CHECK(Ids(world.GetSpace().GetEntityVector()) ==
        std::vector<std::string>{"r1", "r1.body_0", "r1.toy_motor_0", "r1.controller_0", "lamp",
                                 "r2", "r2.body_0", "r2.toy_motor_0", "r2.controller_0"});
  CheckViews(world.GetSpace());
  const auto& robots = world.GetSpace().GetControllableEntities();
  REQUIRE(robots.size() == 2);
  CHECK(robots[1]->GetRootEntity().GetId() == "r2");
}

TEST_CASE("space: the lists by type hold pointers to the exact class", "[core][space]") {
  CTestWorld world(TwoRobots());
  CSpace::TMapPerType& robots = world.GetSpace().GetEntitiesByType("toy-robot");
  REQUIRE(robots.size() == 2);
  CHECK(any_cast<CToyRobotEntity*>(robots["r2"])->GetId() == "r2");
  CHECK_THROWS(any_cast<CEntity*>(robots["r2"]));
  CHECK_THROWS(any_cast<CComposableEntity*>(robots["r2"]));
  CSpace::TMapPerType& bodies = world.GetSpace().GetEntitiesByType("body");
  CHECK(any_cast<CEmbodiedEntity*>(bodies["r1.body_0"])->GetId() == "body_0");
  const CSpace& constant = world.GetSpace();
  CHECK(constant.GetEntitiesByType("toy-lamp").size() == 1);
  CHECK(
      any_cast<CToyLampEntity*>(constant.GetEntitiesByType("toy-lamp").begin()->second)->GetId() ==
      "lamp");
  CHECK(constant.GetNumberEntities() == 9);
  CHECK_THROWS_WITH(world.GetSpace().GetEntitiesByType("toy-robto"),
                    Contains("toy-robto") && Contains("toy-robot"));
}

TEST_CASE("space: a search by pattern appends the entities in order", "[core][space]") {
  CTestWorld world(TwoRobots());
  CEntity::TVector found;
  world.GetSpace().GetEntitiesMatching(found, "^r[12]$");
  world.GetSpace().GetEntitiesMatching(found, "motor");
  world.GetSpace().GetEntitiesMatching(found, "nothing");
  CHECK(Ids(found) == std::vector<std::string>{"r1", "r2", "r1.toy_motor_0", "r2.toy_motor_0"});
}

TEST_CASE("space: adding and removing entities during a run updates every view", "[core][space]") {
  const bool viewsExist = GENERATE(false, true);
  CTestWorld world(TwoRobots());
  const CSimulator::CScope scope(world.GetSimulator());
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  if (viewsExist) {
    CheckViews(world.GetSpace());
  }
  world.Step();
  functions.AddEntity(
      *std::make_unique<CToyRobotEntity>("r3", "c", CVector3(2.0, 0.0, 0.0)).release());
  functions.AddEntity(
      *std::make_unique<CToyBlockEntity>("block", CVector3(3.0, 0.0, 0.0), CVector3(1.0, 1.0, 1.0))
           .release());
  CheckViews(world.GetSpace());
  CHECK(Ids(world.GetSpace().GetRootEntityVector()) ==
        std::vector<std::string>{"r1", "lamp", "r2", "r3", "block"});
  world.Step();
  functions.RemoveEntity("r1");
  functions.RemoveEntity(world.GetSpace().GetEntity("block"));
  functions.AddEntity(*std::make_unique<CToyLampEntity>("r1").release());
  functions.RemoveEntity("lamp");
  CheckViews(world.GetSpace());
  CHECK(Ids(world.GetSpace().GetRootEntityVector()) == std::vector<std::string>{"r2", "r3", "r1"});
  CHECK(world.GetSpace().GetEntitiesByType("toy-block").empty());
  CHECK(world.GetSpace().GetControllableEntities().size() == 2);
  CHECK(world.GetSimulator().GetPhysicsEngine("toy").GetNumPhysicsModels() == 2);
  world.Step();
  world.GetSimulator().Reset();
  CheckViews(world.GetSpace());
}

TEST_CASE("space: an entity that is removed before the views were updated appears in none",
          "[core][space]") {
  CTestWorld world(TwoRobots());
  const CSimulator::CScope scope(world.GetSimulator());
  CheckViews(world.GetSpace());
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  functions.AddEntity(
      *std::make_unique<CToyRobotEntity>("r3", "c", CVector3(2.0, 0.0, 0.0)).release());
  functions.RemoveEntity("r3");
  CheckViews(world.GetSpace());
}

TEST_CASE("space: a duplicate id is an error that names the other entity, and nothing is added",
          "[core][space]") {
  SExperiment experiment = TwoRobots();
  experiment.Arena += "\n<toy-lamp id='r1' position='0,0,0' />";
  CHECK_THAT(LoadError(experiment),
             Contains("\"r1\"") && Contains("toy-robot") && Contains("test.argos:10"));

  CTestWorld world(TwoRobots());
  const CSimulator::CScope scope(world.GetSimulator());
  CheckViews(world.GetSpace());
  const int alive = CToyController::NumAlive;
  CHECK_THROWS_WITH(
      world.GetSimulator().GetLoopFunctions().AddEntity(
          *std::make_unique<CToyRobotEntity>("r2", "c", CVector3(2.0, 0.0, 0.0)).release()),
      Contains("r2"));
  // the space owns entities that are passed to it, even those that it refuses
  CHECK(CToyController::NumAlive == alive);
  CheckViews(world.GetSpace());
  CHECK(world.GetSimulator().GetPhysicsEngine("toy").GetNumPhysicsModels() == 2);
  world.Step();
}

TEST_CASE("space: the element of an entity lives as long as the entity", "[core][space]") {
  CTestWorld world(TwoRobots());
  const CSimulator::CScope scope(world.GetSimulator());
  CSpace& space = world.GetSpace();
  const std::string block =
      "\n<toy-block id='b' size='1,1,1' movable='false'><body position='3,0,0'/></toy-block>";
  const bool isCopy = GENERATE(false, true);
  const auto add = [&space, isCopy](const std::string& xml) -> CEntity& {
    CConfigurationDocument document;
    document.Parse(xml, "added.xml");
    TConfigurationNode node = document.GetRoot();
    return space.CreateEntity(isCopy ? node : document.GetRoot());
  };
  CEntity& added = add(block);
  REQUIRE(added.GetConfigurationNode() != nullptr);
  CHECK(added.GetConfigurationNode()->Value() == "toy-block");
  CHECK(added.GetConfigurationNode()->GetLocation() == "added.xml:2");
  auto& body = dynamic_cast<CToyBlockEntity&>(added).GetEmbodiedEntity();
  CHECK(body.GetConfigurationNode()->GetAttribute("position") == "3,0,0");
  CHECK_THROWS_WITH(add(block), Contains("already an entity with id \"b\" (<toy-block> at "
                                         "added.xml:2)"));
  // those of the experiment are not copied
  CEntity& robot = space.GetEntity("r1");
  CHECK(robot.GetConfigurationNode()->Parent()->Value() == "arena");
  CHECK(robot.GetConfigurationNode()->IsLasting());
}

TEST_CASE("space: a robot that no engine accepts is an error, and nothing is added",
          "[core][space]") {
  SExperiment experiment = TwoRobots();
  experiment.Engines = R"(<toy_engine id='left'> <boundaries>
      <top height='1' /> <bottom height='-1' />
      <sides> <vertex point='-5,-5' /> <vertex point='5,-5' /> <vertex point='5,5' /> <vertex point='-5,5' /> </sides>
    </boundaries> </toy_engine>)";
  CTestWorld world(experiment);
  const CSimulator::CScope scope(world.GetSimulator());
  const int alive = CToyController::NumAlive;
  CHECK_THROWS_WITH(
      world.GetSimulator().GetLoopFunctions().AddEntity(
          *std::make_unique<CToyRobotEntity>("far", "c", CVector3(6.0, 0.0, 0.0)).release()),
      Contains("far") && Contains("6,0,0") && Contains("left"));
  CHECK(CToyController::NumAlive == alive);
  CheckViews(world.GetSpace());
  CHECK_THROWS_AS(world.GetSpace().GetEntity("far"), CARGoSException);
  world.Step();

  experiment.Arena =
      "\n<toy-robot id='r'> <body position='0,7,0' /> <controller config='c' /> </toy-robot>";
  CHECK_THAT(LoadError(experiment), Contains("\"r\"") && Contains("0,7,0") &&
                                        Contains("outside the region (<boundaries>) of \"left\""));
  experiment.Engines = "<toy_engine id='toy' refuses='toy-robot' />";
  CHECK_THAT(LoadError(experiment), Contains("\"toy\" does not accept a <toy-robot>"));
  experiment.Engines = "";
  CHECK_THAT(LoadError(experiment), Contains("there is none in <physics_engines>"));
}

TEST_CASE("space: only root entities can be removed", "[core][space]") {
  CTestWorld world(TwoRobots());
  const CSimulator::CScope scope(world.GetSimulator());
  CHECK_THROWS_WITH(world.GetSimulator().GetLoopFunctions().RemoveEntity("r1.toy_motor_0"),
                    Contains("r1.toy_motor_0"));
  world.Step();
  CheckViews(world.GetSpace());
}

TEST_CASE(
    "space: immovable bodies are in every engine that contains them, movable ones in the first",
    "[core][space]") {
  SExperiment experiment = TwoRobots();
  experiment.Engines = "<toy_engine id='one' /> <toy_engine id='two' />";
  experiment.Arena += R"(
    <toy-block id='wall' size='1,1,1' movable='false'> <body position='3,0,0' /> </toy-block>
    <toy-block id='crate' size='1,1,1' movable='true'> <body position='-3,0,0' /> </toy-block>)";
  CTestWorld world(experiment);
  CHECK(world.Get<CToyBlockEntity>("wall").GetEmbodiedEntity().GetPhysicsModelsNum() == 2);
  CHECK(world.Get<CToyBlockEntity>("crate").GetEmbodiedEntity().GetPhysicsModelsNum() == 1);
  CHECK(&world.Get<CToyBlockEntity>("crate").GetEmbodiedEntity().GetPhysicsModel(0).GetEngine() ==
        &world.GetSimulator().GetPhysicsEngine("one"));
}

TEST_CASE("space: a body that leaves its engine's region is transferred to the next engine",
          "[core][space]") {
  const auto half = [](const std::string& id, const std::string& from, const std::string& to) {
    return "<toy_engine id='" + id + "'> <boundaries> <sides> <vertex point='" + from +
           ",-5' /> <vertex point='" + to + ",-5' /> <vertex point='" + to +
           ",5' /> <vertex point='" + from + ",5' /> </sides> </boundaries> </toy_engine>";
  };
  SExperiment experiment;
  experiment.Controllers =
      "<toy_controller id='c'> <actuators> <toy_drive implementation='default' /> </actuators>"
      "<params velocity='1,0,0' /> </toy_controller>";
  experiment.Engines = half("left", "-5", "0") + half("right", "0", "5");
  experiment.Arena =
      "<toy-robot id='r'> <body position='-0.25,0,0' /> <controller config='c' /> </toy-robot>";
  CTestWorld world(experiment);
  CEmbodiedEntity& body = world.Get<CToyRobotEntity>("r").GetEmbodiedEntity();
  CPhysicsEngine& left = world.GetSimulator().GetPhysicsEngine("left");
  CPhysicsEngine& right = world.GetSimulator().GetPhysicsEngine("right");
  // the command acts from the second tick on: 0.1 m per tick
  world.Step(3);
  CHECK(&body.GetPhysicsModel(0).GetEngine() == &left);
  world.Step(1);
  REQUIRE(body.GetPhysicsModelsNum() == 1);
  CHECK(&body.GetPhysicsModel(0).GetEngine() == &right);
  CHECK(left.GetNumPhysicsModels() == 0);
  CHECK(right.GetNumPhysicsModels() == 1);
  CHECK_THAT(body.GetOriginAnchor().Position.GetX(), Catch::WithinAbs(0.05, 1e-15));
  world.GetSimulator().Reset();
  CHECK_THAT(body.GetOriginAnchor().Position.GetX(), Catch::WithinAbs(-0.25, 1e-15));
  CHECK(&body.GetPhysicsModel(0).GetEngine() == &left);
  // a body that leaves the last region ends the run with an error
  CHECK_THROWS_WITH(world.Step(100), Contains("\"r\"") && Contains("outside"));
}

TEST_CASE("space: the arena's limits are centre -+ size / 2", "[core][space]") {
  SExperiment experiment = TwoRobots();
  experiment.ArenaSize = "4,6,2' center='1,-1,0.5";
  CTestWorld world(experiment);
  CHECK(world.GetSpace().GetArenaSize() == CVector3(4.0, 6.0, 2.0));
  CHECK(world.GetSpace().GetArenaCenter() == CVector3(1.0, -1.0, 0.5));
  CHECK(world.GetSpace().GetArenaLimits().GetMin() == CVector3(-1.0, -4.0, -0.5));
  CHECK(world.GetSpace().GetArenaLimits().GetMax() == CVector3(3.0, 2.0, 1.5));
  CHECK_THROWS_WITH(world.GetSpace().GetFloorEntity(), Contains("floor"));
  experiment.ArenaSize = "4,0,2";
  CHECK_THAT(LoadError(experiment),
             Contains("size") && Contains("4,0,2") && Contains("test.argos:"));
}

TEST_CASE("space: the clock can be set", "[core][space]") {
  CTestWorld world(TwoRobots());
  CHECK(world.GetSpace().GetSimulationClock() == 0);
  world.Step(3);
  CHECK(world.GetSpace().GetSimulationClock() == 3);
  world.GetSpace().IncreaseSimulationClock();
  world.GetSpace().IncreaseSimulationClock(10);
  CHECK(world.GetSpace().GetSimulationClock() == 14);
  world.GetSpace().SetSimulationClock(2);
  CHECK(world.GetSpace().GetSimulationClock() == 2);
}

TEST_CASE("space: every robot is visited once, on any number of threads",
          "[core][space][threads]") {
  const UInt32 threads = GENERATE(0U, 2U, 4U);
  CAPTURE(threads);
  SExperiment experiment = TwoRobots();
  experiment.Threads = threads;
  experiment.Arena = ToyRobotGrid(20);
  CTestWorld world(experiment);
  std::map<CControllableEntity*, std::atomic<int>> visits;
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    visits[robot] = 0;
  }
  REQUIRE(visits.size() == 400);
  world.GetSimulator().GetLoopFunctions().IterateOverControllableEntities(
      [&](CControllableEntity* robot) { ++visits.at(robot); });
  CHECK(std::all_of(visits.begin(), visits.end(),
                    [](const auto& visit) { return visit.second == 1; }));
}

namespace {

/** An entity class whose author has not registered its space operations. */
class CUnregisteredEntity : public CPositionalEntity {
 public:
  ENABLE_VTABLE()
  CUnregisteredEntity() : CPositionalEntity(nullptr) {}
  std::string GetTypeDescription() const override { return "forgetful"; }
};

}  // namespace

REGISTER_ENTITY(CUnregisteredEntity, "forgetful", "", "", "", "", "")

TEST_CASE("space: adding an entity of a class without space operations is an error",
          "[core][space]") {
  SExperiment experiment = TwoRobots();
  experiment.Arena = "<forgetful id='f' />";
  CHECK_THAT(LoadError(experiment), Contains("forgetful") && Contains("REGISTER_"));
}

}  // namespace space_test
