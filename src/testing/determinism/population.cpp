#include <argos3/testing/determinism/population.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/plugins/simulator/media/directional_led_medium.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/plugins/simulator/media/rab_medium.h>
#include <argos3/plugins/simulator/media/simple_radio_medium.h>
#include <argos3/plugins/simulator/media/tag_medium.h>
#include <argos3/testing/support/device_world.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace argos {

namespace {

constexpr Real kRABRange = 0.8;  // m
constexpr size_t kRABBytes = 4;

const char* const kRobots[] = {"foot-bot", "e-puck", "eye-bot"};

// number of entities in the index of a medium that belong to each root entity
template <typename ENTITY, typename MEDIUM>
std::map<std::string, size_t> CountOwners(CTestWorld& world, const std::string& medium) {
  class CCount : public CPositionalIndex<ENTITY>::COperation {
   public:
    bool operator()(ENTITY& entity) override {
      ++Owners[entity.GetRootEntity().GetId()];
      return true;
    }
    std::map<std::string, size_t> Owners;
  } count;
  world.GetSimulator().template GetMedium<MEDIUM>(medium).GetIndex().ForAllEntities(count);
  return count.Owners;
}

template <typename ROBOT>
void AddRobot(CLoopFunctions& functions, const std::string& id, const CVector3& position,
              const CQuaternion& orientation) {
  auto robot = std::make_unique<ROBOT>(id, "bare_" + RobotOf(id), position, orientation, kRABRange,
                                       kRABBytes, "time_motion");
  functions.AddEntity(*robot.release());
}

}  // namespace

std::string RobotOf(const std::string& id) {
  static const std::map<std::string, std::string> robots = {
      {"fb", "foot-bot"}, {"ep", "e-puck"}, {"eb", "eye-bot"}};
  const auto found = robots.find(id.substr(0, 2));
  return found != robots.end() ? found->second : "";
}

CPopulation::CPopulation(CTestWorld& world) : m_world(world), m_scope(world.GetSimulator()) {
  for (const CEntity* root : world.GetSpace().GetRootEntityVector()) {
    m_ids.push_back(root->GetId());
  }
}

CEntity& CPopulation::Root(const std::string& id) {
  return m_world.GetSpace().GetEntity(id);
}

void CPopulation::AddFromText(const std::string& id, const CVector3& position, Real yaw) {
  m_documents.emplace_back().Parse(DeviceUserRobotText(RobotOf(id), id, position, yaw));
  CConfigurationNode& node = m_documents.back().GetRoot();
  std::unique_ptr<CEntity> robot(CFactory<CEntity>::New(node.Value()));
  robot->Init(node);
  m_world.GetSimulator().GetLoopFunctions().AddEntity(*robot.release());
  m_ids.push_back(id);
}

void CPopulation::AddFromProgram(const std::string& id, const CVector3& position, Real yaw) {
  CLoopFunctions& functions = m_world.GetSimulator().GetLoopFunctions();
  const CQuaternion orientation(ToRadians(CDegrees(yaw)), CVector3::Z);
  if (RobotOf(id) == "foot-bot") {
    AddRobot<CFootBotEntity>(functions, id, position, orientation);
  } else if (RobotOf(id) == "e-puck") {
    AddRobot<CEPuckEntity>(functions, id, position, orientation);
  } else {
    AddRobot<CEyeBotEntity>(functions, id, position, orientation);
  }
  m_ids.push_back(id);
}

void CPopulation::Remove(const std::string& id) {
  m_world.GetSimulator().GetLoopFunctions().RemoveEntity(id);
  m_ids.erase(std::find(m_ids.begin(), m_ids.end(), id));
  m_gone.push_back(id);
  if (m_gone.size() > 8) {
    m_gone.erase(m_gone.begin());
  }
}

std::vector<std::string> CPopulation::GetRobotIds() const {
  std::vector<std::string> robots;
  std::copy_if(m_ids.begin(), m_ids.end(), std::back_inserter(robots),
               [](const std::string& id) { return !RobotOf(id).empty(); });
  return robots;
}

CDeviceUser& CPopulation::GetUser(const std::string& id) {
  auto& robot = dynamic_cast<CComposableEntity&>(Root(id));
  return dynamic_cast<CDeviceUser&>(
      robot.GetComponent<CControllableEntity>("controller").GetController());
}

void CPopulation::CheckViews() {
  CheckSpace();
  CheckBodies();
  CheckMedia();
}

void CPopulation::CheckSpace() {
  CSpace& space = m_world.GetSpace();
  std::vector<std::string> roots;
  for (const CEntity* root : space.GetRootEntityVector()) {
    roots.push_back(root->GetId());
  }
  CHECK(roots == m_ids);
  for (const std::string& id : m_ids) {
    const bool isFound = Root(id).GetId() == id;
    REQUIRE(isFound);
  }
  for (const std::string& id : m_gone) {
    if (std::find(m_ids.begin(), m_ids.end(), id) == m_ids.end()) {
      CHECK_THROWS_AS(Root(id), CARGoSException);
      CHECK_THROWS_AS(space.GetEntity(id + ".body"), CARGoSException);
    }
  }
  std::vector<std::string> controlled;
  for (CControllableEntity* robot : space.GetControllableEntities()) {
    controlled.push_back(robot->GetRootEntity().GetId());
  }
  CHECK(controlled == GetRobotIds());
  size_t numRobots = 0;
  for (const char* robot : kRobots) {
    const auto& byType = space.GetEntitiesByType(robot);
    numRobots += byType.size();
    for (const auto& [id, entity] : byType) {
      const bool isOfType = RobotOf(id) == robot && Root(id).GetTypeDescription() == robot;
      REQUIRE(isOfType);
    }
  }
  CHECK(numRobots == controlled.size());
  CHECK(space.GetEntitiesByType("controller").size() == numRobots);
  CHECK(space.GetEntitiesByType("rab").size() == numRobots);
}

void CPopulation::CheckBodies() {
  std::set<const CEmbodiedEntity*> expected;
  size_t models = 0;
  for (const std::string& id : m_ids) {
    auto* root = dynamic_cast<CComposableEntity*>(&Root(id));
    if (root != nullptr && root->HasComponent("body")) {
      const auto& body = root->GetComponent<CEmbodiedEntity>("body");
      expected.insert(&body);
      models += body.GetPhysicsModelsNum();
    }
  }
  const CBodyIndex& index = m_world.GetSpace().GetBodyIndex();
  std::set<const CEmbodiedEntity*> indexed;
  index.ForEachBody([&indexed](CEmbodiedEntity& body) { indexed.insert(&body); });
  CHECK(indexed == expected);
  CHECK(index.GetNumBodies() == expected.size());
  std::set<const CEmbodiedEntity*> near;
  index.ForShapesNear(0.0, 0.0, 1e3,
                      [&](const SIndexedShape& shape) { near.insert(&index.GetBody(shape.Body)); });
  CHECK(near == expected);
  size_t housed = 0;
  for (CPhysicsEngine* engine : m_world.GetSimulator().GetPhysicsEngines()) {
    housed += engine->GetNumPhysicsModels();
  }
  CHECK(housed == models);
}

void CPopulation::CheckMedia() {
  std::map<std::string, size_t> leds;
  std::map<std::string, size_t> carriers;
  const std::map<std::string, size_t> numLEDs = {{"foot-bot", 13}, {"e-puck", 8}, {"eye-bot", 33}};
  for (const std::string& id : m_ids) {
    if (!RobotOf(id).empty()) {
      leds[id] = numLEDs.at(RobotOf(id));
      if (dynamic_cast<CComposableEntity&>(Root(id)).HasComponent("tags")) {
        carriers[id] = 1;
      }
    } else if (Root(id).GetTypeDescription() == "light") {
      leds[id] = 1;
    }
  }
  CHECK(CountOwners<CLEDEntity, CLEDMedium>(m_world, "leds") == leds);
  CHECK(CountOwners<CTagEntity, CTagMedium>(m_world, "tags") == carriers);
  CHECK(CountOwners<CSimpleRadioEntity, CSimpleRadioMedium>(m_world, "radios") == carriers);
  for (auto& carrier : carriers) {
    carrier.second = 2;
  }
  CHECK(CountOwners<CDirectionalLEDEntity, CDirectionalLEDMedium>(m_world, "directional_leds") ==
        carriers);
  // robots receive packets of existing robots only
  auto& medium = m_world.GetSimulator().GetMedium<CRABMedium>("rab");
  for (const std::string& id : GetRobotIds()) {
    auto& device =
        dynamic_cast<CComposableEntity&>(Root(id)).GetComponent<CRABEquippedEntity>("rab");
    for (const CRABEquippedEntity* sender : medium.GetRABsCommunicatingWith(device)) {
      const std::string& heard = sender->GetRootEntity().GetId();
      const bool isThere = std::find(m_ids.begin(), m_ids.end(), heard) != m_ids.end();
      REQUIRE(isThere);
    }
  }
}

}  // namespace argos
