// The simulator from the view of embedding programs, loop functions and plug-ins.

#include "user_controller.h"
#include "user_loop_functions.h"
#include "user_plugins.h"

#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/simulator/space/positional_indices/positional_index.h>
#include <argos3/core/simulator/space/positional_indices/space_hash.h>
#include <argos3/core/simulator/space/space_multi_thread.h>
#include <argos3/core/simulator/space/space_multi_thread_balance_length.h>
#include <argos3/core/simulator/space/space_multi_thread_balance_quantity.h>
#include <argos3/core/simulator/space/space_no_threads.h>
#include <argos3/core/simulator/visualization/default_visualization.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/cylinder_entity.h>
#include <argos3/plugins/simulator/entities/led_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <cstdio>
#include <fstream>

namespace compat_simulator_test {

using namespace argos;
using Catch::WithinAbs;

static const char* DEVICES = R"(
  <actuators> <differential_steering implementation="default" /> <leds implementation="default" medium="leds" /> </actuators>
  <sensors> <differential_steering implementation="default" /> <proximity implementation="default" />)";

static std::string Experiment() {
  return std::string(R"(<?xml version="1.0" ?>
<argos-configuration>
  <framework>
    <system threads="0" />
    <experiment length="100" ticks_per_second="10" random_seed="124" />
  </framework>
  <controllers>
    <user_controller id="fdc">)") +
         DEVICES + R"( <footbot_proximity implementation="default" show_rays="true" /> </sensors>
      <params alpha="7.5" delta="0.1" velocity="5" />
    </user_controller>
    <user_controller id="epc">)" +
         DEVICES + R"( <epuck_proximity implementation="default" /> </sensors>
      <params />
    </user_controller>
  </controllers>
  <loop_functions label="user_loop_functions">
    <foraging items="5" />
    <boxes center="3,3" />
    <robots />
  </loop_functions>
  <arena size="10, 10, 2" center="0,0,0.5">
    <floor id="floor" source="loop_functions" pixels_per_meter="50" />
    <box id="wall" size="0.1,4,0.5" movable="false"> <body position="2,0,0" orientation="0,0,0" /> </box>
    <cylinder id="can" radius="0.1" height="0.3" movable="true" mass="2.5"> <body position="0,2,0" /> </cylinder>
    <light id="light" position="1,1,1" orientation="0,0,0" color="yellow" intensity="3.0" medium="leds" />
    <foot-bot id="fb0"> <body position="0,0,0" orientation="90,0,0" /> <controller config="fdc" /> </foot-bot>
    <e-puck id="ep0"> <body position="1,-1,0" /> <controller config="epc" /> </e-puck>
  </arena>
  <physics_engines> <dynamics2d id="dyn2d" /> </physics_engines>
  <media> <led id="leds" index="grid" grid_size="20,20,20" /> </media>
  <visualization />
</argos-configuration>)";
}

/* What an embedding program does: one simulator, got from the singleton, loaded from a file. */
class CEmbedding {
 public:
  CEmbedding(const std::string& str_xml = Experiment())
      : m_strFile("compat_test_" + ToString(::getpid()) + ".argos") {
    std::ofstream(m_strFile) << str_xml;
    LOG.DisableColoredOutput();
    CSimulator& cSimulator = CSimulator::GetInstance();
    cSimulator.SetExperimentFileName(m_strFile);
    cSimulator.LoadExperiment();
  }
  ~CEmbedding() {
    CSimulator::GetInstance().Destroy();
    std::remove(m_strFile.c_str());
  }
  CSimulator& operator*() { return CSimulator::GetInstance(); }
  CSimulator* operator->() { return &CSimulator::GetInstance(); }

 private:
  std::string m_strFile;
};

/* 7.1, 7.2, 7.3                        */

TEST_CASE("compat: an embedding program runs an experiment", "[compat]") {
  CEmbedding cEmbedding;
  CSimulator& cSimulator = CSimulator::GetInstance();
  CUserLoopFunctions& cLoopFunctions =
      dynamic_cast<CUserLoopFunctions&>(cSimulator.GetLoopFunctions());
  for (size_t i = 0; i < 2; ++i) {
    cSimulator.Reset();
    cSimulator.Execute();
    CHECK(cSimulator.GetSpace().GetSimulationClock() == 5);
    CHECK(cLoopFunctions.WasPostExperiment());
    // two foot-bots whose controllers have made k - 1 steps in tick k
    CHECK(cLoopFunctions.GetTotalSteps() == 2 * (0 + 1 + 2 + 3 + 4));
    CHECK(cLoopFunctions.GetVisited() == 10);
  }
  CHECK(&cLoopFunctions.GetSimulator() == &cSimulator);
  CHECK(&cLoopFunctions.GetSpace() == &cSimulator.GetSpace());
  CHECK(&static_cast<const CLoopFunctions&>(cLoopFunctions).GetSpace() == &cSimulator.GetSpace());
}

TEST_CASE("compat: every function of the simulator works", "[compat]") {
  CSimulator::GetInstance().SetRandomSeed(77);
  CUserLoopFunctions cOther;  // must outlive the simulation
  CEmbedding cEmbedding;
  CSimulator& cSimulator = CSimulator::GetInstance();
  const CSimulator& cConst = cSimulator;
  CHECK(&cConst.GetSpace() == &cSimulator.GetSpace());
  CHECK(cConst.GetPhysicsEngine("dyn2d").GetId() == "dyn2d");
  CPhysicsEngine::TVector& vecEngines = cSimulator.GetPhysicsEngines();
  CHECK(vecEngines.size() == 1);
  CHECK(cSimulator.GetMedium<CLEDMedium>("leds").GetId() == "leds");
  CHECK_THROWS_AS(cSimulator.GetMedium<CUserMedium>("leds"), CARGoSException);
  CMedium::TVector& vecMedia = cSimulator.GetMedia();
  CHECK(vecMedia.size() == 1);
  CHECK(dynamic_cast<CDefaultVisualization*>(&cSimulator.GetVisualization()) != NULL);
  CHECK(cSimulator.GetConfigurationRoot().Value() == "argos-configuration");
  TConfigurationNode& tParams = GetNode(cSimulator.GetConfigForController("fdc"), "params");
  Real fVelocity;
  GetNodeAttribute(tParams, "velocity", fVelocity);
  CHECK(fVelocity == 5.0);
  CHECK_FALSE(cConst.IsProfiling());
  CHECK(cConst.GetRandomSeed() == 77);
  CHECK(cSimulator.GetRNG() != NULL);
  CHECK(cConst.GetExperimentFileName().find(".argos") != std::string::npos);
  CHECK(cConst.GetMaxSimulationClock() == 1000);
  CHECK(cConst.GetNumThreads() == 0);
  CHECK_FALSE(cConst.IsRealTimeClock());
  cSimulator.SetRealTimeClock(false);
  CHECK_FALSE(cConst.GetInstallationDirectory().empty());
  cSimulator.UpdateSpace();
  CHECK_FALSE(cConst.IsExperimentFinished());
  cSimulator.Terminate();
  CHECK(cConst.IsExperimentFinished());
  cSimulator.Reset(78);
  CHECK(cConst.GetRandomSeed() == 78);
  CHECK_FALSE(cConst.IsExperimentFinished());
  CProfiler& (CSimulator::*pfnProfiler)() = &CSimulator::GetProfiler;
  CHECK(pfnProfiler != nullptr);
  cSimulator.SetLoopFunctions(cOther);
  CHECK(&cSimulator.GetLoopFunctions() == &cOther);
}

TEST_CASE("compat: a simulator loads from an XML tree", "[compat]") {
  std::string strXml = Experiment();
  CConfigurationDocument cDocument;
  cDocument.Parse(strXml);
  CSimulator::GetInstance().Load(cDocument);
  CHECK(CSimulator::GetInstance().GetSpace().GetRootEntityVector().size() == 9);
  CSimulator::GetInstance().Destroy();
}

TEST_CASE("compat: every function of the space works", "[compat]") {
  CEmbedding cEmbedding;
  CSpace& cSpace = CSimulator::GetInstance().GetSpace();
  const CSpace& cConst = cSpace;
  CHECK(cConst.GetNumberEntities() == cSpace.GetEntityVector().size());
  CEntity::TVector& tRoots = cSpace.GetRootEntityVector();
  // floor, wall, can, light, two robots; two boxes and a robot added by the loop functions
  CHECK(tRoots.size() == 9);
  CHECK(cSpace.GetEntity("fb0.leds_0.led_3").GetTypeDescription() == "led");
  CHECK_THROWS_AS(cSpace.GetEntity("nobody"), CARGoSException);
  CEntity::TVector tMatching;
  cSpace.GetEntitiesMatching(tMatching, "user_box_.*");
  CHECK(tMatching.size() == 2);
  CEntity::TMap& tMap = cSpace.GetEntityMapPerId();
  CHECK(tMap["fb0"] == &cSpace.GetEntity("fb0"));
  unordered_map<std::string, CEntity*>::iterator itMap = tMap.find("ep0");
  CHECK(itMap->second->GetId() == "ep0");
  CSpace::TMapPerTypePerId& tTypes = cSpace.GetEntityMapPerTypePerId();
  CHECK(tTypes["e-puck"].size() == 1);
  const CSpace::TMapPerType& tLEDs = cConst.GetEntitiesByType("led");
  CHECK(any_cast<CLEDEntity*>(tLEDs.begin()->second)->GetTypeDescription() == "led");
  CHECK(any_cast<CLightEntity*>(cSpace.GetEntitiesByType("light")["light"])->GetIntensity() == 3.0);
  CHECK_THROWS_AS(cSpace.GetEntitiesByType("eye-bot"), CARGoSException);
  CFloorEntity& cFloor = cSpace.GetFloorEntity();
  cSpace.SetFloorEntity(cFloor);
  CHECK(cConst.GetSimulationClock() == 0);
  cSpace.SetSimulationClock(4);
  cSpace.IncreaseSimulationClock();
  cSpace.IncreaseSimulationClock(2);
  CHECK(cSpace.GetSimulationClock() == 7);
  CHECK(cConst.GetArenaSize() == CVector3(10.0, 10.0, 2.0));
  CHECK(cConst.GetArenaCenter() == CVector3(0.0, 0.0, 0.5));
  CHECK(cConst.GetArenaLimits().GetMin() == CVector3(-5.0, -5.0, -0.5));
  cSpace.SetArenaSize(cConst.GetArenaSize());
  cSpace.SetArenaCenter(cConst.GetArenaCenter());
  std::vector<std::string> vecRobots;
  CSpace::TControllableEntityIterCBType tCallback = [&](CControllableEntity* pc_robot) {
    vecRobots.push_back(pc_robot->GetRootEntity().GetId());
  };
  cSpace.IterateOverControllableEntities(tCallback);
  CHECK(vecRobots.size() == 3);
  const CLoopFunctions& cFunctions = CSimulator::GetInstance().GetLoopFunctions();
  cFunctions.IterateOverControllableEntities(tCallback);
  CHECK(vecRobots.size() == 6);
  static_assert(std::is_base_of<CSpace, CSpaceNoThreads>::value &&
                    std::is_base_of<CSpace, CSpaceMultiThread>::value &&
                    std::is_base_of<CSpace, CSpaceMultiThreadBalanceLength>::value &&
                    std::is_base_of<CSpace, CSpaceMultiThreadBalanceQuantity>::value,
                "");
}

TEST_CASE("compat: loop functions move, add and remove entities", "[compat]") {
  CEmbedding cEmbedding;
  CLoopFunctions& cFunctions = CSimulator::GetInstance().GetLoopFunctions();
  CFootBotEntity& cFootBot = dynamic_cast<CFootBotEntity&>(cFunctions.GetSpace().GetEntity("fb0"));
  CVector3& cPosition = cFootBot.GetEmbodiedEntity().GetOriginAnchor().Position;
  CHECK(cFunctions.MoveEntity(cFootBot.GetEmbodiedEntity(), CVector3(-2.0, -2.0, 0.0),
                              CQuaternion()));
  CHECK(cPosition == CVector3(-2.0, -2.0, 0.0));
  CHECK_FALSE(cFunctions.MoveEntity(cFootBot.GetEmbodiedEntity(), CVector3(2.0, 0.0, 0.0),
                                    CQuaternion(), false));
  CHECK(cPosition == CVector3(-2.0, -2.0, 0.0));
  CHECK(cFunctions.MoveEntity(cFootBot.GetEmbodiedEntity(), CVector3(-3.0, 0.0, 0.0), CQuaternion(),
                              true));
  CHECK(cPosition == CVector3(-2.0, -2.0, 0.0));
  CHECK(cFunctions.MoveEntity(cFootBot.GetEmbodiedEntity(), CVector3(2.0, 0.0, 0.0), CQuaternion(),
                              false, true));
  CLightEntity& cLight = dynamic_cast<CLightEntity&>(cFunctions.GetSpace().GetEntity("light"));
  cFunctions.MoveEntity(cLight, CVector3(2.0, 2.0, 2.0), CQuaternion());
  CHECK(cLight.GetPosition() == CVector3(2.0, 2.0, 2.0));
  CFootBotEntity* pcFootBot = new CFootBotEntity("fb9", "fdc", CVector3(-3.0, -3.0, 0.0));
  CHECK(dynamic_cast<CUserController*>(&pcFootBot->GetControllableEntity().GetController()) !=
        NULL);
  cFunctions.AddEntity(*pcFootBot);
  CHECK(cFunctions.GetSpace().GetEntitiesByType("foot-bot").size() == 3);
  cFunctions.RemoveEntity("fb9");
  cFunctions.RemoveEntity(cFunctions.GetSpace().GetEntity("can"));
  CHECK(cFunctions.GetSpace().GetEntitiesByType("foot-bot").size() == 2);
  CSimulator::GetInstance().UpdateSpace();
}

/* 7.4 entities                         */

TEST_CASE("compat: every function of the core entities works", "[compat]") {
  CEmbedding cEmbedding;
  CSpace& cSpace = CSimulator::GetInstance().GetSpace();
  CFootBotEntity& cFootBot = dynamic_cast<CFootBotEntity&>(cSpace.GetEntity("fb0"));
  CEntity& cEntity = cFootBot;
  CHECK((cEntity.GetId() == "fb0" && cEntity.GetContext().empty() && !cEntity.HasParent()));
  CHECK(cEntity.GetTypeDescription() == "foot-bot");
  CHECK(cEntity.GetIndex() >= 0);
  CHECK(cEntity.IsEnabled());
  cEntity.Disable();
  cEntity.Enable();
  cEntity.SetEnabled(true);
  CHECK(cEntity.GetConfigurationNode()->Value() == "foot-bot");
  CHECK(SEntityComparator()(&cEntity, &cSpace.GetEntity("ep0")));
  CHECK(cEntity.GetTag() == (::argos::GetTag<CFootBotEntity, CEntity>()));

  CComposableEntity& cComposable = cFootBot;
  CHECK(cComposable.HasComponent("leds.led[led_0]"));
  CHECK(cComposable.GetComponent<CLEDEntity>("leds.led[led_0]").GetId() == "led_0");
  CEntity& cComponent = cComposable.GetComponent("body");
  CHECK(&cComponent.GetParent() == &cFootBot);
  CHECK(&cComponent.GetRootEntity() == &cFootBot);
  const CEntity& cConstComponent = cComponent;
  CHECK(
      (&cConstComponent.GetParent() == &cFootBot && &cConstComponent.GetRootEntity() == &cFootBot));
  cComponent.SetParent(cFootBot);
  CHECK(cComponent.GetContext() == "fb0.");
  CEntity::TMultiMap::iterator itComponent = cComposable.FindComponent("wheels");
  CHECK(itComponent->second->GetTypeDescription() == "wheels");
  CHECK(cComposable.GetComponentMap().count("controller") == 1);
  CHECK(cComposable.GetComponentVector().size() >= 5);
  cComposable.Update();
  cComposable.UpdateComponents();

  CEmbodiedEntity& cBody = cFootBot.GetEmbodiedEntity();
  const CEmbodiedEntity& cConstBody = cBody;
  CHECK(cConstBody.IsMovable());
  cBody.SetMovable(true);
  CHECK(&cConstBody.GetOriginAnchor() == &cBody.GetOriginAnchor());
  SAnchor& sAnchor = cBody.AddAnchor("user", CVector3(0.1, 0.0, 0.2), CQuaternion());
  CHECK((&sAnchor.Body == &cBody && sAnchor.Id == "user" && sAnchor.Index >= 1 &&
         sAnchor.InUseCount == 0));
  CHECK((sAnchor.OffsetPosition == CVector3(0.1, 0.0, 0.2) &&
         sAnchor.OffsetOrientation.GetW() == 1.0));
  sAnchor.Enable();
  CHECK(cBody.IsAnchorEnabled("user"));
  cBody.DisableAnchor("user");
  cBody.EnableAnchor("user");
  sAnchor.Disable();
  CHECK(&cConstBody.GetAnchor("user") == &cBody.GetAnchor("user"));
  std::map<std::string, SAnchor*>& mapAnchors = cBody.GetAnchors();
  CHECK(mapAnchors["origin"] == &cBody.GetOriginAnchor());
  std::vector<SAnchor*>& vecAnchors = cBody.GetEnabledAnchors();
  CHECK(vecAnchors[0] == &cBody.GetOriginAnchor());
  cBody.CalculateBoundingBox();
  const SBoundingBox& sBox = cConstBody.GetBoundingBox();
  CHECK(sBox.MinCorner < sBox.MaxCorner);
  CHECK(sBox.Intersects(sBox));
  CHECK(cConstBody.GetPhysicsModelsNum() == 1);
  CHECK(&cConstBody.GetPhysicsModel(0) == &cBody.GetPhysicsModel("dyn2d"));
  CHECK(&cConstBody.GetPhysicsModel("dyn2d") == &cBody.GetPhysicsModel(0));
  CHECK_FALSE(cConstBody.IsCollidingWithSomething());
  CHECK(cBody.MoveTo(CVector3(-2.0, 2.0, 0.0), CQuaternion()));

  CControllableEntity& cControllable = cFootBot.GetControllableEntity();
  const CControllableEntity& cConstControllable =
      const_cast<const CFootBotEntity&>(cFootBot).GetControllableEntity();
  CHECK(&cConstControllable.GetController() == &cControllable.GetController());
  const std::map<std::string, CSimulatedActuator*>& mapActuators =
      cConstControllable.GetActuators();
  CHECK(mapActuators.size() == 2);
  CHECK(cConstControllable.GetSensors().size() == 3);
  CRay3 cRay(CVector3(), CVector3::X);
  cControllable.AddCheckedRay(true, cRay);
  cControllable.AddIntersectionPoint(cRay, 0.5);
  std::vector<std::pair<bool, CRay3> >& vecRays = cControllable.GetCheckedRays();
  std::vector<CVector3>& vecPoints = cControllable.GetIntersectionPoints();
  CHECK((vecRays.size() == 1 && vecPoints.size() == 1));
  cControllable.Sense();
  // 24 rays of the proximity sensor, which has show_rays
  CHECK(cControllable.GetCheckedRays().size() == 24);
  cControllable.ControlStep();
  cControllable.Act();
  cControllable.SetController("fdc");
  CConfigurationDocument cParams;
  cParams.Parse("<params velocity='1' />");
  cControllable.SetController("fdc", cParams.GetRoot());
  CSimulator::GetInstance().UpdateSpace();

  CPositionalEntity cPositional(NULL, "p", CVector3::X, CQuaternion());
  cPositional.SetPosition(CVector3::Y);
  cPositional.SetOrientation(CQuaternion());
  cPositional.SetInitPosition(CVector3::Z);
  cPositional.SetInitOrientation(CQuaternion());
  cPositional.MoveTo(CVector3::X, CQuaternion());
  const CPositionalEntity& cConstPositional = cPositional;
  CHECK(cConstPositional.GetPosition() == CVector3::X);
  CHECK(cConstPositional.GetInitPosition() == CVector3::Z);
  CHECK((cConstPositional.GetOrientation().GetW() == 1.0 &&
         cConstPositional.GetInitOrientation().GetW() == 1.0));
  CHECK(CPositionalEntity(NULL, "q").GetTypeDescription() == "position");

  CFloorEntity& cFloor = cSpace.GetFloorEntity();
  CHECK(cFloor.GetColorAtPoint(-2.0, 0.0) == CColor::GRAY50);
  cFloor.SetChanged();
  CHECK(cFloor.HasChanged());
  cFloor.ClearChanged();
  CHECK_FALSE(cFloor.HasChanged());
  CFloorEntity cOwn("own", 10);
  /* the arena is 10 m x 10 m, and the saved image has ten pixels per metre */
  const std::string strFloor = InBuildTree("compat_floor.png");
  cOwn.SaveAsImage(strFloor);
  CFloorEntity cImage("image", strFloor);
  CHECK(cImage.GetColorAtPoint(-2.0, 0.05) == cOwn.GetColorAtPoint(-2.0, 0.05));
  CHECK(cImage.GetColorAtPoint(2.0, 0.05) == cOwn.GetColorAtPoint(2.0, 0.05));
  CHECK(cImage.GetColorAtPoint(-2.0, 0.05) != cImage.GetColorAtPoint(2.0, 0.05));
  cImage.SaveAsImage(strFloor);
  std::remove(strFloor.c_str());
  CHECK(CFloorEntity::UNSET != CFloorEntity::FROM_IMAGE);
  CFloorEntity::EColorSource eSource = CFloorEntity::FROM_LOOP_FUNCTIONS;
  CHECK(eSource == CFloorEntity::FROM_LOOP_FUNCTIONS);
}

/* plug-ins use protected members of entities */
class COpenControllable : public CControllableEntity {
 public:
  COpenControllable() : CControllableEntity(NULL, "controller_0") {}
  bool IsEmpty() {
    return m_pcController == NULL && m_mapActuators.empty() && m_mapSensors.empty() &&
           m_vecCheckedRays.empty() && m_vecIntersectionPoints.empty();
  }
  virtual void Sense() { CControllableEntity::Sense(); }
  virtual void ControlStep() { CControllableEntity::ControlStep(); }
  virtual void Act() { CControllableEntity::Act(); }
};

class COpenBody : public CEmbodiedEntity {
 public:
  COpenBody() : CEmbodiedEntity(NULL, "body_0", CVector3::X) {}
  bool IsUsual() {
    return m_bMovable && m_tPhysicsModelMap.empty() && m_tPhysicsModelVector.empty() &&
           m_sBoundingBox == NULL && m_psOriginAnchor == m_mapAnchors["origin"] &&
           m_vecEnabledAnchors.size() == 1 && m_cInitOriginPosition == CVector3::X &&
           m_cInitOriginOrientation.GetW() == 1.0;
  }
  virtual void AddPhysicsModel(const std::string& str_engine_id, CPhysicsModel& c_model) {
    CEmbodiedEntity::AddPhysicsModel(str_engine_id, c_model);
  }
  virtual bool MoveTo(const CVector3& c_position, const CQuaternion& c_orientation,
                      bool b_check_only = false, bool b_ignore_collisions = false) {
    return CEmbodiedEntity::MoveTo(c_position, c_orientation, b_check_only, b_ignore_collisions);
  }
  virtual bool IsCollidingWithSomething() const {
    return CEmbodiedEntity::IsCollidingWithSomething();
  }
};

TEST_CASE("compat: protected members of entities are accessible", "[compat]") {
  CHECK(COpenControllable().IsEmpty());
  CHECK(COpenBody().IsUsual());
}

/* 7.5, 7.6 stock and robot entities    */

TEST_CASE("compat: stock entities work as documented", "[compat]") {
  CEmbedding cEmbedding;
  CLEDMedium& cMedium = CSimulator::GetInstance().GetMedium<CLEDMedium>("leds");
  CLoopFunctions& cFunctions = CSimulator::GetInstance().GetLoopFunctions();
  CBoxEntity* pcBox =
      new CBoxEntity("b", CVector3(-3, 3, 0), CQuaternion(), true, CVector3(0.1, 0.2, 0.3), 2.0f);
  pcBox->AddLED(CVector3(0, 0, 0.3));
  pcBox->AddLED(CVector3(0, 0, 0.3), CColor::RED);
  cFunctions.AddEntity(*pcBox);
  pcBox->EnableLEDs(cMedium);
  CHECK(pcBox->GetLEDEquippedEntity().GetLEDs().size() == 2);
  pcBox->DisableLEDs();
  CHECK((pcBox->GetSize() == CVector3(0.1, 0.2, 0.3) && pcBox->GetMass() == 2.0));
  pcBox->Resize(CVector3(0.2, 0.2, 0.2));
  pcBox->SetMass(1.0);
  const CBoxEntity& cConstBox = *pcBox;
  CHECK(&cConstBox.GetEmbodiedEntity() == &pcBox->GetEmbodiedEntity());
  CHECK(&cConstBox.GetLEDEquippedEntity() == &pcBox->GetLEDEquippedEntity());
  CHECK(CBoxEntity().GetTypeDescription() == "box");

  CCylinderEntity* pcCylinder =
      new CCylinderEntity("c", CVector3(-3, -3, 0), CQuaternion(), false, 0.1, 0.2);
  cFunctions.AddEntity(*pcCylinder);
  CHECK((pcCylinder->GetRadius() == 0.1 && pcCylinder->GetHeight() == 0.2));
  pcCylinder->Resize(0.2, 0.3);
  pcCylinder->SetMass(1.0);
  CHECK(pcCylinder->GetMass() == 1.0);
  pcCylinder->AddLED(CVector3(), CColor::BLUE);
  CHECK(pcCylinder->GetLEDEquippedEntity().GetLED(0).GetColor() == CColor::BLUE);
  CHECK_FALSE(pcCylinder->GetEmbodiedEntity().IsMovable());

  CLEDEntity cLED(NULL, "led", CVector3::X, CColor::GREEN);
  CHECK((cLED.GetColor() == CColor::GREEN && cLED.GetInitColor() == CColor::GREEN &&
         !cLED.HasMedium()));
  CHECK_THROWS_AS(cLED.GetMedium(), CARGoSException);
  cLED.SetColor(CColor::RED);
  cLED.SetInitColor(CColor::RED);
  cLED.SetMedium(cMedium);
  CHECK(&cLED.GetMedium() == &cMedium);
  CLEDEntity::TList tList(1, &cLED);
  CLEDEntity::TSet tSet;
  tSet.insert(&cLED);
  CHECK((tList.size() == 1 && tSet.size() == 1));
  cMedium.AddEntity(cLED);
  cMedium.RemoveEntity(cLED);

  CLightEntity* pcLight = new CLightEntity("l2", CVector3::Z, CColor::WHITE, 2.0);
  cFunctions.AddEntity(*pcLight);
  pcLight->SetIntensity(4.0);
  CHECK(pcLight->GetIntensity() == 4.0);

  CFootBotEntity& cFootBot = dynamic_cast<CFootBotEntity&>(cFunctions.GetSpace().GetEntity("fb0"));
  CLEDEquippedEntity& cLEDs = cFootBot.GetLEDEquippedEntity();
  CLEDEquippedEntity::SActuator::TList& tLEDs = cLEDs.GetLEDs();
  REQUIRE(tLEDs.size() == 13);
  CHECK((&tLEDs[0]->LED == &cLEDs.GetLED(0) && tLEDs[0]->Offset == cLEDs.GetLEDOffset(0) &&
         tLEDs[0]->Anchor.Id.size() > 0));
  cLEDs.SetLEDColor(3, CColor::RED);
  cLEDs.SetAllLEDsColors(CColor::GREEN);
  cLEDs.SetAllLEDsColors(std::vector<CColor>(13, CColor::YELLOW));
  CHECK(cLEDs.GetLED(12).GetColor() == CColor::YELLOW);
  cLEDs.SetLEDOffset(0, CVector3(0.1, 0.0, 0.1));
  cLEDs.SetMedium(cMedium);
  cLEDs.Disable();
  cLEDs.Enable();
  CLEDEquippedEntity cRing(&cFootBot, "own_leds");
  cRing.AddLED(CVector3(0, 0, 0.1), cFootBot.GetEmbodiedEntity().GetOriginAnchor());
  cRing.AddLEDRing(CVector3(0, 0, 0.1), 0.1, CRadians::ZERO, 4,
                   cFootBot.GetEmbodiedEntity().GetOriginAnchor(), CColor::RED);
  CHECK(cRing.GetLEDs().size() == 5);
  // positions at start + i * 2 PI / num, counter-clockwise
  CHECK_THAT(cRing.GetLEDOffset(2).GetY(), WithinAbs(0.1, 1e-15));

  CProximitySensorEquippedEntity& cProximity = cFootBot.GetProximitySensorEquippedEntity();
  CHECK(cProximity.GetNumSensors() == 24);
  CProximitySensorEquippedEntity::SSensor& sSensor = cProximity.GetSensor(0);
  CHECK(sSensor.Offset.GetZ() == 0.06);
  CHECK_THAT(sSensor.Direction.Length(), WithinAbs(0.1, 1e-15));
  CHECK(sSensor.Anchor.Id == "origin");
  CProximitySensorEquippedEntity::SSensor::TList& tSensors = cProximity.GetSensors();
  CHECK(tSensors.size() == 24);
  CProximitySensorEquippedEntity cOwn(&cFootBot, "own_proximity");
  SAnchor& sOrigin = cFootBot.GetEmbodiedEntity().GetOriginAnchor();
  cOwn.AddSensor(CVector3(0.1, 0, 0), CVector3::X, 0.5, sOrigin);
  cOwn.AddSensorRing(CVector3(), 0.1, CRadians::ZERO, 0.5, 4, sOrigin);
  cOwn.AddSensorFan(CVector3(), 0.1, CRadians::ZERO, CRadians::PI, 0.5, 4, sOrigin);
  CHECK(cOwn.GetNumSensors() == 9);
  CHECK_THAT(cOwn.GetSensor(2).Direction.GetY(), WithinAbs(0.5, 1e-15));
  cProximity.Disable();
  cProximity.Enable();

  CWheeledEntity& cWheels = cFootBot.GetWheeledEntity();
  CHECK(cWheels.GetNumWheels() == 2);
  CHECK(cWheels.GetWheelPosition(0) == CVector3(0, 0.07, 0));
  CHECK(cWheels.GetWheelPositions()[1] == CVector3(0, -0.07, 0));
  CHECK(cWheels.GetWheelRadius(0) == 0.029112741);
  CHECK(cWheels.GetWheelRadia()[1] == 0.029112741);
  const Real* pfVelocities = cWheels.GetWheelVelocities();
  Real pfNew[2] = {0.1, 0.2};
  cWheels.SetVelocities(pfNew);
  CHECK((pfVelocities[1] == 0.2 && cWheels.GetWheelVelocity(0) == 0.1));
  CWheeledEntity cOwnWheels(&cFootBot, "own_wheels", 3), cUnnamed(&cFootBot, 1);
  cOwnWheels.SetWheel(2, CVector3::X, 0.5);
  CHECK(cOwnWheels.GetWheelRadius(2) == 0.5);
}

TEST_CASE("compat: robot entities work as documented", "[compat]") {
  CEmbedding cEmbedding;
  CFootBotEntity cFootBot("f", "fdc", CVector3(1, 2, 0), CQuaternion(), 3.0f, 10, "",
                          ToRadians(CDegrees(70.0f)), true, ToRadians(CDegrees(30.0f)), 0.035, 2.0);
  CHECK(cFootBot.GetEmbodiedEntity().GetOriginAnchor().Position == CVector3(1, 2, 0));
  CHECK(cFootBot.GetControllableEntity().GetController().GetId() == "f");
  CHECK(CFootBotEntity().GetTypeDescription() == "foot-bot");
  CEPuckEntity cEPuck("e", "epc", CVector3(1, 2, 0), CQuaternion(), 0.8f, 2, "");
  CHECK(cEPuck.GetTypeDescription() == "e-puck");
  CHECK(cEPuck.GetWheeledEntity().GetWheelPosition(0).GetY() == 0.0265);
  CHECK(cEPuck.GetLEDEquippedEntity().GetLEDs().size() == 8);
  CHECK(cEPuck.GetProximitySensorEquippedEntity().GetNumSensors() == 8);
  CHECK(cEPuck.GetControllableEntity().GetController().GetId() == "e");
  CHECK(cEPuck.GetEmbodiedEntity().IsMovable());
}

/* 7.7, 7.8, 7.9, 7.11, 7.12            */

static std::string UserExperiment() {
  return R"(<argos-configuration>
  <framework> <experiment length="1" ticks_per_second="10" random_seed="1" /> </framework>
  <controllers>
    <user_controller_of_robots id="c">
      <actuators> <user_horn implementation="default" /> </actuators>
      <sensors> <user_ear implementation="default" show_rays="true" /> </sensors>
      <params />
    </user_controller_of_robots>
  </controllers>
  <arena size="10,10,2"> <user-robot id="u0"> <body position="0,0,0" /> <controller config="c" /> </user-robot> </arena>
  <physics_engines>
    <user_engine id="user" iterations="5">
      <boundaries> <top height="1" /> <bottom height="-1" />
        <sides> <vertex point="-5,-5" /> <vertex point="5,-5" /> <vertex point="5,5" /> <vertex point="-5,5" /> </sides>
      </boundaries>
    </user_engine>
  </physics_engines>
  <media> <user_medium id="air" /> </media>
  <visualization> <user_visualization frames="0" /> </visualization>
</argos-configuration>)";
}

class CRobotController : public CCI_Controller {
 public:
  virtual void Init(TConfigurationNode&) {
    m_pcHorn = GetActuator<CCI_UserHornActuator>("user_horn");
    m_pcEar = GetSensor<CCI_UserEarSensor>("user_ear");
  }
  virtual void ControlStep() {
    m_vecHeard.push_back(m_pcEar->GetReading());
    m_pcHorn->Blow(m_vecHeard.size());
  }
  std::vector<Real> m_vecHeard;

 private:
  CCI_UserHornActuator* m_pcHorn = NULL;
  CCI_UserEarSensor* m_pcEar = NULL;
};

REGISTER_CONTROLLER(CRobotController, "user_controller_of_robots")

TEST_CASE("compat: plug-ins of users run", "[compat]") {
  CEmbedding cEmbedding(UserExperiment());
  CSimulator& cSimulator = CSimulator::GetInstance();
  CUserMedium& cMedium = cSimulator.GetMedium<CUserMedium>("air");
  CHECK((cMedium.m_bReady && cMedium.GetId() == "air" &&
         &cMedium.GetSpace() == &cSimulator.GetSpace()));
  CUserRobotEntity& cRobot =
      *any_cast<CUserRobotEntity*>(cSimulator.GetSpace().GetEntitiesByType("user-robot")["u0"]);
  CHECK(cSimulator.GetSpace().GetEntity("u0.body_0").GetTypeDescription() == "body");
  CHECK(any_cast<CUserHornEntity*>(cSimulator.GetSpace().GetEntitiesByType("horn")["u0.horn_0"])
            ->GetVolume() == 0.0);
  const UInt32 unUpdates = cRobot.GetHorn().GetUpdates();
  cSimulator.Execute();
  CHECK(dynamic_cast<CUserVisualization&>(cSimulator.GetVisualization()).m_unFrames == 10);
  CHECK(cMedium.m_unUpdates == 10);
  CHECK(cRobot.GetHorn().GetUpdates() == unUpdates + 10);
  // a sound of one step is heard in the next
  CRobotController& cController =
      dynamic_cast<CRobotController&>(cRobot.GetControllableEntity().GetController());
  CHECK(cController.m_vecHeard == std::vector<Real>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(cRobot.GetControllableEntity().GetCheckedRays().size() == 1);
  // 0.1 m/s for 1 s, in 50 additions
  CHECK_THAT(cRobot.GetEmbodiedEntity().GetOriginAnchor().Position.GetX(), WithinAbs(0.1, 1e-15));
  cSimulator.Reset();
  CHECK(cRobot.GetEmbodiedEntity().GetOriginAnchor().Position == CVector3());
  CHECK(cRobot.GetHorn().GetVolume() == 0.0);
}

TEST_CASE("compat: a sensor that never calls Enable() is updated until it is disabled",
          "[compat]") {
  CEmbedding cEmbedding(UserExperiment());
  CSimulator& cSimulator = CSimulator::GetInstance();
  CUserRobotEntity& cRobot =
      *any_cast<CUserRobotEntity*>(cSimulator.GetSpace().GetEntitiesByType("user-robot")["u0"]);
  CRobotController& cController =
      dynamic_cast<CRobotController&>(cRobot.GetControllableEntity().GetController());
  CCI_UserEarSensor& cEar = *cController.GetSensor<CCI_UserEarSensor>("user_ear");
  CHECK_FALSE(cEar.IsEnabled());
  for (int i = 0; i < 3; ++i)
    cSimulator.UpdateSpace();
  cEar.Disable();
  for (int i = 0; i < 3; ++i)
    cSimulator.UpdateSpace();
  cEar.Enable();
  cSimulator.UpdateSpace();
  CHECK(cController.m_vecHeard == std::vector<Real>{0, 1, 2, 2, 2, 2, 6});
  cSimulator.Reset();
  CHECK_FALSE(cEar.IsEnabled());
  cController.m_vecHeard.clear();
  cSimulator.UpdateSpace();
  cSimulator.UpdateSpace();
  CHECK(cController.m_vecHeard == std::vector<Real>{0, 1});
}

/* asks for an engine where there is none yet, as foraging projects do */
class CImpatientLoopFunctions : public CLoopFunctions {
 public:
  CImpatientLoopFunctions()
      : m_fTicksPerSecond(GetSimulator().GetPhysicsEngine("user").GetInverseSimulationClockTick()) {
  }
  Real m_fTicksPerSecond;
};

REGISTER_LOOP_FUNCTIONS(CImpatientLoopFunctions, "impatient_loop_functions")

TEST_CASE("compat: constructors of loop functions may ask for engines", "[compat]") {
  std::string strXml = UserExperiment();
  Replace(strXml, "<physics_engines>",
          "<loop_functions label=\"impatient_loop_functions\" /><physics_engines>");
  CEmbedding cEmbedding(strXml);
  CSimulator& cSimulator = CSimulator::GetInstance();
  CHECK(dynamic_cast<CImpatientLoopFunctions&>(cSimulator.GetLoopFunctions()).m_fTicksPerSecond ==
        10.0);
  CHECK_THAT(TakeLogErr(), Catch::Contains("GetPhysicsEngine(\"user\")"));
  CHECK(cSimulator.GetPhysicsEngine("user").GetIterations() == 5);
  CHECK(TakeLogErr().empty());
}

TEST_CASE("compat: every function of engines and models works", "[compat]") {
  CEmbedding cEmbedding(UserExperiment());
  CSimulator& cSimulator = CSimulator::GetInstance();
  CPhysicsEngine& cEngine = cSimulator.GetPhysicsEngine("user");
  const CPhysicsEngine& cConst = cEngine;
  CHECK((cConst.GetIterations() == 5 && cConst.GetId() == "user"));
  CHECK_THAT(cConst.GetPhysicsClockTick(), WithinAbs(0.02, 1e-15));
  CHECK(CPhysicsEngine::GetSimulationClockTick() == 0.1);
  CHECK_THAT(CPhysicsEngine::GetInverseSimulationClockTick(), WithinAbs(10.0, 1e-14));
  CPhysicsEngine::SetSimulationClockTick(0.1);
  CHECK(cEngine.IsPointContained(CVector3(1, 1, 0)));
  CHECK_FALSE(cEngine.IsPointContained(CVector3(6, 1, 0)));
  // a body without a description of its solids is a point
  for (const Real fX : {1.0, 6.0}) {
    const CEmbodiedEntity cBody(nullptr, "bare", CVector3(fX, 1, 0), CQuaternion(), false);
    CHECK(cEngine.IsTouchedBy(cBody) == (fX < 5.0));
  }
  CHECK(cEngine.GetNumPhysicsModels() == 1);
  CHECK_FALSE(cConst.IsEntityTransferNeeded());
  CHECK(cConst.IsEntityTransferActive());
  SVolume& sVolume = cEngine.GetVolume();
  const SVolume& sConstVolume = cConst.GetVolume();
  CHECK((&sVolume == &sConstVolume && sVolume.IsActive()));
  CHECK((sVolume.TopFace->Height == 1.0 && sVolume.BottomFace->Height == -1.0 &&
         sVolume.SideFaces.size() == 4));
  CHECK(sVolume.SideFaces[0]->BaseSegment.GetStart() == CVector2(-5, -5));
  SVolume sOwn;
  CConfigurationDocument cDocument;
  cDocument.Parse("<boundaries> <top height='2' /> </boundaries>");
  sOwn.Init(cDocument.GetRoot());
  CHECK((sOwn.IsActive() && sOwn.BottomFace == NULL));
  cEngine.SetId("user");
  CPhysicsEngine::TMap tEngines;
  tEngines["user"] = &cEngine;

  CEmbodiedEntity& cBody =
      dynamic_cast<CUserRobotEntity&>(cSimulator.GetSpace().GetEntity("u0")).GetEmbodiedEntity();
  CPhysicsModel& cModel = cBody.GetPhysicsModel(0);
  const CPhysicsModel& cConstModel = cModel;
  CHECK((&cModel.GetEngine() == &cEngine && &cModel.GetEmbodiedEntity() == &cBody &&
         &cConstModel.GetEmbodiedEntity() == &cBody));
  CHECK(&cConstModel.GetBoundingBox() == &cModel.GetBoundingBox());
  CPhysicsModel::TVector tModels(1, &cModel);
  CHECK(tModels.size() == 1);
  CHECK(cBody.MoveTo(CVector3(1, 1, 0), CQuaternion(CRadians::PI, CVector3::Z)));
  CHECK(cBody.GetOriginAnchor().Position == CVector3(1, 1, 0));
  cModel.UpdateEntityStatus();
  cModel.CalculateAnchors();
  CHECK_FALSE(cModel.IsCollidingWithSomething());
}

TEST_CASE("compat: rays hit bodies that only a user's engine contains", "[compat]") {
  CEmbedding cEmbedding(UserExperiment());
  CEmbodiedEntity& cBody =
      dynamic_cast<CUserRobotEntity&>(CSimulator::GetInstance().GetSpace().GetEntity("u0"))
          .GetEmbodiedEntity();
  const CRay3 cRay(CVector3(-1, 0, 0.1), CVector3(1, 0, 0.1));
  TEmbodiedEntityIntersectionData tData(3);
  CHECK(GetEmbodiedEntitiesIntersectedByRay(tData, cRay));
  REQUIRE(tData.size() == 1);
  CHECK(tData[0].IntersectedEntity == &cBody);
  CHECK_THAT(tData[0].TOnRay, WithinAbs(0.45, 1e-15));
  SEmbodiedEntityIntersectionItem sItem;
  CHECK((sItem.IntersectedEntity == NULL && sItem.TOnRay == 1.0));
  CHECK(GetClosestEmbodiedEntityIntersectedByRay(sItem, cRay));
  CHECK(sItem.IntersectedEntity == &cBody);
  CHECK_FALSE(GetClosestEmbodiedEntityIntersectedByRay(sItem, cRay, cBody));
  CHECK(SEmbodiedEntityIntersectionItem(&cBody, 0.1) <
        SEmbodiedEntityIntersectionItem(&cBody, 0.2));
}

/* 7.10 positional indices              */

class CUserLamp : public CPositionalEntity {
 public:
  ENABLE_VTABLE();
  CUserLamp(const std::string& str_id, const CVector3& c_position)
      : CPositionalEntity(NULL, str_id, c_position) {}
};

class CLampGridUpdater : public CGrid<CUserLamp>::COperation {
 public:
  CLampGridUpdater(CGrid<CUserLamp>& c_grid) : m_cGrid(c_grid) {}
  virtual bool operator()(CUserLamp& c_entity) {
    SInt32 i, j, k;
    m_cGrid.PositionToCell(i, j, k, c_entity.GetPosition());
    m_cGrid.UpdateCell(i, j, k, c_entity);
    return true;
  }

 private:
  CGrid<CUserLamp>& m_cGrid;
};

class CLampHashUpdater : public CSpaceHashUpdater<CUserLamp> {
 public:
  virtual void operator()(CAbstractSpaceHash<CUserLamp>& c_hash, CUserLamp& c_entity) {
    SInt32 i, j, k;
    c_hash.SpaceToHashTable(i, j, k, c_entity.GetPosition());
    c_hash.UpdateCell(i, j, k, c_entity);
  }
};

class CLampCollector : public CPositionalIndex<CUserLamp>::COperation {
 public:
  virtual bool operator()(CUserLamp& c_entity) {
    m_strIds += c_entity.GetId();
    return true;
  }
  std::string m_strIds;
};

class CCellCounter : public CGrid<CUserLamp>::CCellOperation {
 public:
  virtual bool operator()(SInt32, SInt32, SInt32, CGrid<CUserLamp>::SCell& s_cell) {
    ++m_unCells;
    m_unEntities += s_cell.Entities.size();
    return true;
  }
  size_t m_unCells = 0, m_unEntities = 0;
};

TEST_CASE("compat: positional indices work as documented", "[compat]") {
  CUserLamp cA("a", CVector3(0.5, 0.5, 0.5)), cB("b", CVector3(3.5, 3.5, 0.5));
  cA.SetIndex(1);
  cB.SetIndex(2);
  CGrid<CUserLamp> cGrid(CVector3(0, 0, 0), CVector3(4, 4, 1), 4, 4, 1);
  CLampGridUpdater cUpdater(cGrid);
  cGrid.SetUpdateEntityOperation(&cUpdater);
  CPositionalIndex<CUserLamp>& cIndex = cGrid;
  cIndex.AddEntity(cA);
  cIndex.AddEntity(cB);
  cIndex.Update();
  CSet<CUserLamp*, SEntityComparator> cSet;
  cIndex.GetEntitiesAt(cSet, CVector3(0.4, 0.4, 0.4));
  CHECK((cSet.size() == 1 && cSet.first() == &cA));
  CLampCollector cAll, cSphere, cBox, cCircle, cRectangle, cRay;
  cIndex.ForAllEntities(cAll);
  CHECK(cAll.m_strIds == "ab");
  cIndex.ForEntitiesInSphereRange(CVector3(0.5, 0.5, 0.5), 0.3, cSphere);
  CHECK(cSphere.m_strIds.find('a') != std::string::npos);
  CHECK(cSphere.m_strIds.find('b') == std::string::npos);
  cIndex.ForEntitiesInBoxRange(CVector3(3.5, 3.5, 0.5), CVector3(0.1, 0.1, 0.1), cBox);
  CHECK(cBox.m_strIds.find('b') != std::string::npos);
  cIndex.ForEntitiesInCircleRange(CVector3(0.5, 0.5, 0.5), 0.3, cCircle);
  CHECK(cCircle.m_strIds.find('a') != std::string::npos);
  cIndex.ForEntitiesInRectangleRange(CVector3(0.5, 0.5, 0.5), CVector2(0.3, 0.3), cRectangle);
  CHECK(cRectangle.m_strIds.find('a') != std::string::npos);
  cIndex.ForEntitiesAlongRay(CRay3(CVector3(0.1, 0.1, 0.5), CVector3(3.9, 3.9, 0.5)), cRay);
  cIndex.ForEntitiesAlongRay(CRay3(CVector3(0.1, 0.1, 0.5), CVector3(3.9, 3.9, 0.5)), cRay, true);
  CHECK(cRay.m_strIds.find('b') != std::string::npos);
  CHECK((cGrid.GetSizeI() == 4 && cGrid.GetSizeJ() == 4 && cGrid.GetSizeK() == 1));
  SInt32 i, j, k;
  cGrid.PositionToCell(i, j, k, CVector3(3.5, 0.5, 0.5));
  CHECK((i == 3 && j == 0 && k == 0));
  CHECK_THROWS_AS(cGrid.PositionToCell(i, j, k, CVector3(9, 0, 0)), CARGoSException);
  cGrid.PositionToCellUnsafe(i, j, k, CVector3(2.5, 0.5, 0.5));
  CHECK(i == 2);
  i = 99;
  cGrid.ClampCoordinates(i, j, k);
  CHECK(i == 3);
  CGrid<CUserLamp>::SCell& sCell = cGrid.GetCellAt(0, 0, 0);
  CHECK((sCell.Entities.size() == 1 && sCell.Timestamp > 0));
  CCellCounter cCells;
  cGrid.ForAllCells(cCells);
  CHECK(cCells.m_unCells == 16);
  cGrid.ForCellsInSphereRange(CVector3(0.5, 0.5, 0.5), 0.3, cCells);
  cGrid.ForCellsInBoxRange(CVector3(0.5, 0.5, 0.5), CVector3(0.1, 0.1, 0.1), cCells);
  cGrid.ForCellsInCircleRange(CVector3(0.5, 0.5, 0.5), 0.3, cCells);
  cGrid.ForCellsInRectangleRange(CVector3(0.5, 0.5, 0.5), CVector2(0.1, 0.1), cCells);
  cGrid.ForCellsAlongRay(CRay3(CVector3(0.1, 0.1, 0.5), CVector3(0.9, 0.1, 0.5)), cCells);
  CHECK(cCells.m_unCells >= 21);
  cIndex.RemoveEntity(cA);
  cIndex.Update();
  CLampCollector cLeft;
  cIndex.ForAllEntities(cLeft);
  CHECK(cLeft.m_strIds == "b");

  CSpaceHash<CUserLamp, CLampHashUpdater> cHash;
  CAbstractSpaceHash<CUserLamp>& cAbstract = cHash;
  cAbstract.SetSize(100);
  cAbstract.SetCellSize(CVector3(1, 1, 1));
  cAbstract.AddElement(cA);
  cAbstract.Update();
  cAbstract.SpaceToHashTable(i, j, k, CVector3(0.5, 0.5, 0.5));
  CAbstractSpaceHash<CUserLamp>::TElementList tElements;
  CHECK(cAbstract.CheckCell(i, j, k, tElements));
  CVector3 cCorner;
  cAbstract.HashTableToSpace(cCorner, i, j, k);
  CHECK(cAbstract.HashTableToSpace(i, 0) == cCorner.GetX());
  cAbstract.SetCellSize(CVector3(1, 0.5, 0.25));
  CHECK(cAbstract.HashTableToSpace(-3, 1) == -1.5);
  CHECK(cAbstract.HashTableToSpace(2, 2) == 0.5);
  std::ostringstream cDump;
  cAbstract.Dump(cDump);
  CHECK_FALSE(cDump.str().empty());
  cAbstract.RemoveElement(cA);
}

}  // namespace compat_simulator_test
