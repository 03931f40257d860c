// What code of robots changes besides their actuators: what others read is refused or changed when
// all robots have been controlled, so that results do not depend on threads.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/robots/prototype/simulator/prototype_entity.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/cylinder_entity.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/joint_equipped_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/magnet_equipped_entity.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rfid_tag_entity.h>
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>
#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/plugins/simulator/media/pheromone_medium.h>
#include <argos3/plugins/simulator/media/rab_medium.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace shared_changes_test {

using namespace argos;
using Catch::Contains;

namespace {

// what the code of a robot does with the parts of the world
struct SAccess {
  CSpace& Space;
  CFootBotEntity& Robot;  // its own, or another one
  UInt32 Tick;

  template <typename ENTITY>
  ENTITY& Get(const std::string& id) const {
    return dynamic_cast<ENTITY&>(Space.GetEntity(id));
  }
  template <typename COMPONENT>
  COMPONENT& GetPart(const std::string& type) const {
    return Robot.GetComponent<COMPONENT>(type);
  }
  CSimulator& Simulator() const { return Space.GetSimulator(); }
};

struct SChange {
  const char* Name;
  std::function<void(const SAccess&)> Make;
};

const CVector3 kPlace(3.5, 3.5, 0.0);
const CQuaternion kNoTurn;

// never by robots
const std::vector<SChange>& SharedChanges() {
  static const std::vector<SChange> changes = {
      {"MoveTo()", [](auto& a) { a.Robot.GetEmbodiedEntity().MoveTo(kPlace, kNoTurn); }},
      {"MoveTo()",
       [](auto& a) { a.Robot.GetEmbodiedEntity().MoveTo(kPlace, kNoTurn, true, true); }},
      {"MoveTo()",
       [](auto& a) {
         a.Simulator().GetLoopFunctions().MoveEntity(a.Robot.GetEmbodiedEntity(), kPlace, kNoTurn);
       }},
      {"MoveTo()",
       [](auto& a) {
         a.Simulator().GetLoopFunctions().MoveEntity(
             static_cast<CPositionalEntity&>(a.template Get<CLightEntity>("l0")), kPlace, kNoTurn);
       }},
      {"CPhysicsModel::MoveTo()",
       [](auto& a) { a.Robot.GetEmbodiedEntity().GetPhysicsModel(0).MoveTo(kPlace, kNoTurn); }},
      {"SetOriginPose()",
       [](auto& a) { a.Robot.GetEmbodiedEntity().SetOriginPose(kPlace, kNoTurn); }},
      {"SetMovable()", [](auto& a) { a.Robot.GetEmbodiedEntity().SetMovable(false); }},
      {"SetBodyDescription()",
       [](auto& a) { a.Robot.GetEmbodiedEntity().SetBodyDescription(nullptr); }},
      {"RemovePhysicsModel()",
       [](auto& a) { a.Robot.GetEmbodiedEntity().RemovePhysicsModel("engine"); }},
      {"Reset()", [](auto& a) { a.template Get<CLightEntity>("l0").Reset(); }},
      {"SetPosition()", [](auto& a) { a.template Get<CLightEntity>("l0").SetPosition(kPlace); }},
      {"SetOrientation()",
       [](auto& a) { a.template Get<CLightEntity>("l0").SetOrientation(kNoTurn); }},
      {"SetColor()", [](auto& a) { a.template Get<CLightEntity>("l0").SetColor(CColor::RED); }},
      {"SetIntensity()", [](auto& a) { a.template Get<CLightEntity>("l0").SetIntensity(2.0); }},
      {"Disable()", [](auto& a) { a.template Get<CLightEntity>("l0").Disable(); }},
      {"Disable()", [](auto& a) { a.template Get<CBoxEntity>("b0").Disable(); }},
      {"Resize()", [](auto& a) { a.template Get<CBoxEntity>("b0").Resize(CVector3(1, 1, 1)); }},
      {"SetMass()", [](auto& a) { a.template Get<CBoxEntity>("b0").SetMass(2.0); }},
      {"AddLED()", [](auto& a) { a.template Get<CBoxEntity>("b0").AddLED(CVector3()); }},
      {"EnableLEDs()",
       [](auto& a) {
         a.template Get<CBoxEntity>("b0").EnableLEDs(
             a.Simulator().template GetMedium<CLEDMedium>("leds"));
       }},
      {"DisableLEDs()", [](auto& a) { a.template Get<CBoxEntity>("b0").DisableLEDs(); }},
      {"Resize()", [](auto& a) { a.template Get<CCylinderEntity>("c0").Resize(0.2, 0.2); }},
      {"SetData()",
       [](auto& a) { a.template Get<CRFIDTagEntity>("t0").SetData(CByteArray(4, 7)); }},
      {"TryWrite()",
       [](auto& a) { a.template Get<CRFIDTagEntity>("t0").TryWrite(0, CByteArray(1, 7)); }},
      {"RemoveComponent()", [](auto& a) { a.Robot.RemoveComponent("leds"); }},
      {"SetLEDOffset()",
       [](auto& a) { a.Robot.GetLEDEquippedEntity().SetLEDOffset(0, CVector3()); }},
      {"AddLED()",
       [](auto& a) {
         a.Robot.GetLEDEquippedEntity().AddLED(CVector3(),
                                               a.Robot.GetEmbodiedEntity().GetOriginAnchor());
       }},
      {"SetMedium()",
       [](auto& a) {
         a.Robot.GetLEDEquippedEntity().SetMedium(
             a.Simulator().template GetMedium<CLEDMedium>("leds"));
       }},
      {"SetSideLength()",
       [](auto& a) { a.template GetPart<CTagEquippedEntity>("tags").GetTag(0).SetSideLength(1); }},
      {"AddEntity() of a medium",
       [](auto& a) {
         a.Simulator().template GetMedium<CLEDMedium>("leds").AddEntity(
             a.Robot.GetLEDEquippedEntity().GetLED(0));
       }},
      {"RemoveEntity() of a medium",
       [](auto& a) {
         a.Simulator().template GetMedium<CLEDMedium>("leds").RemoveEntity(
             a.Robot.GetLEDEquippedEntity().GetLED(0));
       }},
      {"RemoveEntity() of a medium",
       [](auto& a) {
         a.Simulator().template GetMedium<CRABMedium>("rab").RemoveEntity(
             a.Robot.GetRABEquippedEntity());
       }},
      {"CPheromoneField::Deposit()",
       [](auto& a) {
         a.Simulator().template GetMedium<CPheromoneMedium>("scents").Deposit(0, CVector3(), 1.0);
       }},
      {"CPheromoneField::SetCell()",
       [](auto& a) {
         a.Simulator().template GetMedium<CPheromoneMedium>("scents").GetField(0).SetCell(0, 0, 1);
       }},
      {"CPheromoneField::Clear()",
       [](auto& a) {
         a.Simulator().template GetMedium<CPheromoneMedium>("scents").GetField(0).Clear();
       }},
      {"AddEntity() of a physics engine",
       [](auto& a) { a.Simulator().GetPhysicsEngines()[0]->AddEntity(a.Robot); }},
      {"RemoveEntity() of a physics engine",
       [](auto& a) { a.Simulator().GetPhysicsEngines()[0]->RemoveEntity(a.Robot); }},
      {"CPhysicsEngine::SetMotion()",
       [](auto& a) {
         a.Simulator().GetPhysicsEngines()[0]->SetMotion(a.Robot.GetEmbodiedEntity(), {});
       }},
      {"CSpace::SetArenaSize()", [](auto& a) { a.Space.SetArenaSize(CVector3(9, 9, 9)); }},
      {"CSpace::SetArenaCenter()", [](auto& a) { a.Space.SetArenaCenter(CVector3()); }},
      {"CSpace::SetSimulationClock()", [](auto& a) { a.Space.SetSimulationClock(70); }},
      {"CSpace::SetSimulationClock()", [](auto& a) { a.Space.IncreaseSimulationClock(); }},
      {"adds or removes entities",
       [](auto& a) { a.Space.SetFloorEntity(a.Space.GetFloorEntity()); }},
      {"adds or removes entities",
       [](auto& a) { a.Space.RemoveEntityFromPhysicsEngines(a.Robot.GetEmbodiedEntity()); }},
      {"adds or removes entities",
       [](auto& a) { a.Space.RemoveControllableEntity(a.Robot.GetControllableEntity()); }},
      {"adds or removes entities", [](auto& a) { a.Space.RemoveEntity(a.Robot); }},
      {"CSimulator::GetRNG()", [](auto& a) { a.Simulator().GetRNG()->Uniform(CRange(0.0, 1.0)); }},
      {"CSpace::GetRNG()", [](auto& a) { a.Space.GetRNG().Uniform(CRange(0.0, 1.0)); }},
      {"CSimulator::SetLength()", [](auto& a) { a.Simulator().SetLength(1.0); }},
      {"CSimulator::SetRandomSeed()", [](auto& a) { a.Simulator().SetRandomSeed(3); }},
      {"SetImageSize()", [](auto& a) { a.Space.GetFloorEntity().SetImageSize(1, 1); }}};
  return changes;
}

// of parts that foot-bots do not have
const std::vector<SChange>& ChangesOfOtherTypes() {
  static const std::vector<SChange> changes = {
      {"SetLinkPose()",
       [](auto& a) {
         a.template Get<CPrototypeEntity>("p0").GetEmbodiedEntity().SetLinkPose(0, {});
       }},
      {"SetCommand()",
       [](auto& a) {
         a.template Get<CPrototypeEntity>("p0").GetJointEquippedEntity().SetCommand(0, {});
       }},
      {"SetState()",
       [](auto& a) {
         a.template Get<CPrototypeEntity>("p0").GetJointEquippedEntity().SetState(0, 0.0, 0.0);
       }},
      {"SetCurrent()",
       [](auto& a) {
         a.template Get<CPrototypeEntity>("p0")
             .template GetComponent<CMagnetEquippedEntity>("magnets")
             .GetMagnet(0)
             .SetCurrent(1.0);
       }},
      {"SetPositionControlData()",
       [](auto& a) {
         a.template Get<CEyeBotEntity>("e0").GetQuadRotorEntity().SetPositionControlData({});
       }},
      {"SetSpeedControlData()", [](auto& a) {
         a.template Get<CEyeBotEntity>("e0").GetQuadRotorEntity().SetSpeedControlData({});
       }}};
  return changes;
}

// by the robot that owns the part
const std::vector<SChange>& OwnChanges() {
  static const Real kStill[] = {0.0, 0.0};
  static const std::vector<SChange> changes = {
      {"SetLEDColor()",
       [](auto& a) {
         a.Robot.GetLEDEquippedEntity().SetLEDColor(0,
                                                    a.Tick % 2 == 0 ? CColor::RED : CColor::GREEN);
       }},
      {"SetLEDColor()",
       [](auto& a) {
         a.Robot.GetLEDEquippedEntity().SetAllLEDsColors(a.Tick % 3 == 0 ? CColor::BLUE
                                                                         : CColor::BLACK);
       }},
      {"SetColor()",
       [](auto& a) { a.Robot.GetLEDEquippedEntity().GetLED(1).SetColor(CColor::CYAN); }},
      {"able()",
       [](auto& a) {
         a.Robot.GetLEDEquippedEntity().SetEnabled(!a.Robot.GetLEDEquippedEntity().IsEnabled());
       }},
      {"able()", [](auto& a) { a.Robot.GetRABEquippedEntity().SetEnabled((a.Tick + 1) % 3 != 0); }},
      {"SetData()",
       [](auto& a) {
         a.Robot.GetRABEquippedEntity().SetData(CByteArray(2, static_cast<UInt8>(a.Tick)));
       }},
      {"ClearData()", [](auto& a) { a.Robot.GetRABEquippedEntity().ClearData(); }},
      {"SetRange()", [](auto& a) { a.Robot.GetRABEquippedEntity().SetRange(1.0); }},
      {"SetPayload()",
       [](auto& a) {
         a.template GetPart<CTagEquippedEntity>("tags").SetTagPayloads(std::to_string(a.Tick));
       }},
      {"SetColor()",
       [](auto& a) {
         a.template GetPart<CDirectionalLEDEquippedEntity>("directional_leds")
             .SetLEDColors(CColor::RED);
       }},
      {"SetRange()",
       [](auto& a) {
         a.template GetPart<CSimpleRadioEquippedEntity>("simple_radios")
             .GetInstances()[0]
             .Radio.SetRange(1.0);
       }},
      {"SetVelocities()",
       [](auto& a) { a.template GetPart<CWheeledEntity>("wheels").SetVelocities(kStill); }},
      {"SetAvailableCharge()",
       [](auto& a) { a.Robot.GetBatterySensorEquippedEntity().SetAvailableCharge(0.5); }},
      {"Discharge()", [](auto& a) { a.Robot.GetBatterySensorEquippedEntity().Discharge(0.01); }},
      {"SetLockState()", [](auto& a) { a.Robot.GetGripperEquippedEntity().SetLockState(0.1); }},
      {"Send()",
       [](auto& a) {
         std::vector<CByteArray> messages(1, CByteArray(2));
         a.template GetPart<CSimpleRadioEquippedEntity>("simple_radios")
             .GetInstances()[0]
             .Radio.Send(messages);
       }},
      {"SetDriftingVelocities()",
       [](auto& a) {
         a.template GetPart<CWheeledEntity>("wheels").SetDriftingVelocities(kStill, kStill);
       }},
      {"SetRotation()", [](auto& a) { a.Robot.GetTurretEntity().SetRotation(CRadians(0.1)); }},
      {"SetDesiredRotationSpeed()",
       [](auto& a) { a.Robot.GetTurretEntity().SetDesiredRotationSpeed(0.1); }},
      {"SetDesiredRotation()",
       [](auto& a) { a.Robot.GetTurretEntity().SetDesiredRotation(CRadians(0.1)); }},
      {"SetMode()",
       [](auto& a) { a.Robot.GetTurretEntity().SetMode(CTurretEntity::MODE_POSITION_CONTROL); }},
      {"SetRange()", [](auto& a) { a.Robot.GetPerspectiveCameraEquippedEntity().SetRange(2.0); }},
      {"SAnchor::Enable()", [](auto& a) { a.Robot.GetEmbodiedEntity().EnableAnchor("turret"); }},
      {"SAnchor::Disable()", [](auto& a) { a.Robot.GetEmbodiedEntity().DisableAnchor("turret"); }},
      {"able()", [](auto& a) { a.Robot.SetEnabled(true); }}};
  return changes;
}

/* "changer": what the running test says, in one tick or in each. */
class CChanger : public CCI_Controller {
 public:
  static std::function<void(CChanger&, UInt32 tick)> Act;

  void Init(TConfigurationNode&) override {
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_packets = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
    m_blobs = GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>(
        "colored_blob_omnidirectional_camera");
    m_blobs->Enable();
  }
  void ControlStep() override {
    // what the robot sees and hears changes its way
    Real sum = 0.0;
    for (const auto& packet : m_packets->GetReadings()) {
      sum += packet.Data[0] + packet.Range;
    }
    for (const auto* blob : m_blobs->GetReadings().BlobList) {
      sum += blob->Color.GetRed() + 2 * blob->Color.GetGreen() + 0.01 * blob->Distance;
    }
    m_wheels->SetLinearVelocity(5.0 + std::fmod(sum, 7.0), 8.0);
    Access(GetId()).GetPart<CWheeledEntity>("wheels").EnableDrift();
    Act(*this, CSimulator::GetInstance().GetSpace().GetSimulationClock());
  }
  SAccess Access(const std::string& id) const {
    CSpace& space = CSimulator::GetInstance().GetSpace();
    return {space, dynamic_cast<CFootBotEntity&>(space.GetEntity(id)), space.GetSimulationClock()};
  }

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_RangeAndBearingSensor* m_packets = nullptr;
  CCI_ColoredBlobOmnidirectionalCameraSensor* m_blobs = nullptr;
};

std::function<void(CChanger&, UInt32 tick)> CChanger::Act;

REGISTER_CONTROLLER(CChanger, "changer")

std::string IdOf(UInt32 robot) {
  return "fb" + std::to_string(robot);
}

// robots on a grid of the distance 0.5 m
SExperiment World(UInt32 robots, UInt32 threads) {
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Controllers =
      "<changer id='c'><actuators><differential_steering implementation='default'/>"
      "<leds implementation='default' medium='leds'/></actuators>"
      "<sensors><range_and_bearing implementation='medium' medium='rab'/>"
      "<colored_blob_omnidirectional_camera implementation='rot_z_only' medium='leds'/></sensors>"
      "<params/></changer>";
  experiment.Engines = "<dynamics2d id='engine'/>";
  experiment.Media =
      "<led id='leds'/><range_and_bearing id='rab'/><directional_led id='dleds'/><tag id='tags'/>"
      "<simple_radio id='radios'/><rfid id='rfid'/>"
      "<pheromone id='scents'><layer id='trail'/></pheromone>";
  std::ostringstream arena;
  arena << "<floor id='floor' source='loop_functions' pixels_per_meter='10'/>"
           "<box id='b0' size='.2,.2,.2' movable='true' mass='1'><body position='4,4,0'/></box>"
           "<cylinder id='c0' radius='.1' height='.2' movable='true' mass='1'>"
           "<body position='4,-4,0'/></cylinder>"
           "<light id='l0' position='0,0,1' color='red' intensity='1' medium='leds'/>"
           "<rfid_tag id='t0' medium='rfid' memory='4' position='0,0,0'/>";
  for (UInt32 robot = 0; robot < robots; ++robot) {
    arena << "<foot-bot id='" << IdOf(robot) << "' rab_range='1' rab_data_size='2'><body position='"
          << 0.5 * (robot % 12) - 3 << ',' << 0.5 * (robot / 12) - 3 << ",0'/>"
          << "<tags medium='tags'><tag position='0,0,0.1' payload='x' "
             "anchor='origin' orientation='0,0,0' observable_angle='80' side_length='0.1'/></tags>"
             "<directional_leds medium='dleds'><directional_led position='0,0,0.1' "
             "orientation='0,0,0' anchor='origin' color='black' observable_angle='80'/>"
             "</directional_leds>"
             "<simple_radios><simple_radio id='wifi' medium='radios' range='1'/></simple_radios>"
             "<controller config='c'/></foot-bot>";
  }
  experiment.Arena = arena.str();
  return experiment;
}

// with a flying robot and one that has joints, in an engine of their own
SExperiment MixedWorld(UInt32 robots, UInt32 threads) {
  SExperiment experiment = World(robots, threads);
  experiment.Controllers +=
      "<robot_world_controller id='idle'><actuators/><sensors/><params/></robot_world_controller>";
  experiment.Engines += "<dynamics3d id='air'/>";
  experiment.Arena +=
      "<eye-bot id='e0'><body position='4,0,1'/><controller config='idle'/></eye-bot>"
      "<prototype id='p0' movable='false'><body position='4,1,1'/><links ref='base'>"
      "<link id='base' geometry='box' size='0.1,0.1,0.1' mass='1'/>"
      "<link id='arm' geometry='box' size='0.1,0.1,0.1' mass='1'/></links>"
      "<joints><joint id='j' type='revolute' axis='0,0,1'><parent link='base' "
      "position='0.2,0,0'/><child link='arm'/></joint></joints><devices><magnets><magnet "
      "offset='0,0,0' anchor='base' passive_field='0,0,1'/></magnets></devices></prototype>";
  return experiment;
}

// the error of each change, empty if there is none; made by robot 0 in the first tick
std::vector<std::string> ErrorsOf(const std::vector<SChange>& changes, UInt32 changed,
                                  UInt32 threads) {
  std::vector<std::string> errors;
  CChanger::Act = [&](CChanger& robot, UInt32 tick) {
    if (robot.GetId() != IdOf(0) || tick != 1) {
      return;
    }
    for (const SChange& change : changes) {
      errors.emplace_back();
      try {
        change.Make(robot.Access(IdOf(changed)));
      } catch (const CARGoSException& error) {
        errors.back() = error.what();
      }
    }
  };
  CTestWorld world(MixedWorld(4, threads));
  world.Step(2);
  return errors;
}

void CheckRefused(const std::vector<SChange>& changes, UInt32 changed) {
  const UInt32 threads = GENERATE(0U, 2U);
  const std::vector<std::string> errors = ErrorsOf(changes, changed, threads);
  REQUIRE(errors.size() == changes.size());
  for (size_t i = 0; i < errors.size(); ++i) {
    CAPTURE(i, changes[i].Name);
    CHECK_THAT(errors[i], Contains("robot \"fb0\"") && Contains("ControlStep() in tick 1: ") &&
                              Contains(changes[i].Name) && Contains("must not be called while") &&
                              (Contains("PreStep()") || Contains("at the end of the tick") ||
                               Contains("CRandom::CreateRNG")));
  }
}

}  // namespace

TEST_CASE("shared changes: no robot may change what others read, for any number of threads",
          "[determinism][threads]") {
  // by itself, and another robot
  const UInt32 changed = GENERATE(0U, 1U);
  CheckRefused(SharedChanges(), changed);
}

TEST_CASE("shared changes: a robot may not change parts of another one", "[determinism][threads]") {
  CheckRefused(OwnChanges(), 1);
  CheckRefused(ChangesOfOtherTypes(), 1);
}

TEST_CASE("shared changes: a robot may change its own parts", "[determinism][threads]") {
  const UInt32 threads = GENERATE(0U, 2U);
  const std::vector<std::string> errors = ErrorsOf(OwnChanges(), 0, threads);
  CHECK(errors == std::vector<std::string>(OwnChanges().size()));
}

TEST_CASE("shared changes: loop functions and callbacks: hooks may, callbacks are robots' code",
          "[determinism][threads]") {
  CChanger::Act = [](CChanger&, UInt32) {};
  CTestWorld world(World(4, 2));
  world.Step(1);
  const CSimulator::CScope scope(world.GetSimulator());
  CLoopFunctions& loop = world.GetSimulator().GetLoopFunctions();
  auto& robot = world.Get<CFootBotEntity>("fb0");
  CHECK(robot.GetEmbodiedEntity().MoveTo(kPlace, kNoTurn));
  CHECK_THROWS_WITH(loop.IterateOverControllableEntities([](CControllableEntity* each) {
    auto& owner = dynamic_cast<CFootBotEntity&>(each->GetRootEntity());
    owner.GetLEDEquippedEntity().SetAllLEDsColors(CColor::RED);
    owner.GetEmbodiedEntity().MoveTo(kPlace, kNoTurn);
  }),
                    Contains("robot \"fb0\"") &&
                        Contains("callback of IterateOverControllableEntities()") &&
                        Contains("MoveTo()"));
  loop.IterateOverControllableEntities([](CControllableEntity* each) {
    dynamic_cast<CFootBotEntity&>(each->GetRootEntity())
        .GetLEDEquippedEntity()
        .SetAllLEDsColors(CColor::RED);
  });
  // what a callback has changed is there when all have returned
  CHECK(robot.GetLEDEquippedEntity().GetLEDColor(3) == CColor::RED);
  // code outside of phases is free afterwards
  CHECK(robot.GetEmbodiedEntity().MoveTo(kPlace, kNoTurn));
}

TEST_CASE("shared changes: PostStep() sees what robots have changed of their own parts",
          "[determinism][threads]") {
  CChanger::Act = [](CChanger& robot, UInt32) {
    CFootBotEntity& body = robot.Access(robot.GetId()).Robot;
    body.GetLEDEquippedEntity().SetAllLEDsColors(CColor::GREEN);
    // others may have seen the old color in this tick, or may see it still
    CHECK(body.GetLEDEquippedEntity().GetLEDColor(0) == CColor::BLACK);
    CChanger::Act = [](CChanger&, UInt32) {};
  };
  CTestWorld world(World(1, 0));
  world.Step(1);
  CHECK(world.Get<CFootBotEntity>("fb0").GetLEDEquippedEntity().GetLEDColor(0) == CColor::GREEN);
}

TEST_CASE("shared changes: a robot may say that the floor has changed", "[determinism][threads]") {
  CChanger::Act = [](CChanger& robot, UInt32) {
    robot.Access(robot.GetId()).Space.GetFloorEntity().SetChanged();
  };
  CTestWorld world(World(130, 4));
  CFloorEntity& floor = world.GetSpace().GetFloorEntity();
  const UInt64 before = floor.GetVersion();
  world.Step(3);
  CHECK(floor.GetVersion() == before + 3 * 130);
}

TEST_CASE("shared changes: results do not depend on threads", "[determinism][threads]") {
  // more robots than one thread handles in a row
  constexpr UInt32 kRobots = 130;
  constexpr UInt32 kTicks = 6;
  // assertions are for the main thread only
  std::atomic<int> numMade{0};
  SECTION("of own changes") {
    CChanger::Act = [](CChanger& robot, UInt32) {
      for (const SChange& change : OwnChanges()) {
        change.Make(robot.Access(robot.GetId()));
      }
    };
  }
  SECTION("of changes that are refused") {
    CChanger::Act = [&numMade](CChanger& robot, UInt32 tick) {
      const SAccess other = robot.Access(IdOf((std::stoul(robot.GetId().substr(2)) + 7) % kRobots));
      for (const SChange& change : SharedChanges()) {
        try {
          change.Make(other);
          ++numMade;
        } catch (const CARGoSException&) {
          // as it should
        }
      }
      robot.Access(robot.GetId())
          .Robot.GetLEDEquippedEntity()
          .SetAllLEDsColors(tick % 2 == 0 ? CColor::RED : CColor::BLUE);
    };
  }
  SECTION("of look-ups that create components") {
    CChanger::Act = [&numMade](CChanger& robot, UInt32 tick) {
      const SAccess other = robot.Access(IdOf((7 * tick) % kRobots));
      numMade += other.Robot.HasComponent("light_sensors") &&
                         other.Robot.GetComponentVector().size() > 5 &&
                         other.Space.GetEntitiesByType("foot-bot").size() == kRobots
                     ? 0
                     : 1;
    };
  }
  UInt64 digest = 0;
  for (const UInt32 threads : {0U, 1U, 2U, 4U}) {
    CAPTURE(threads);
    CTestWorld world(World(kRobots, threads));
    world.Step(kTicks);
    if (threads == 0) {
      digest = world.ComputeDigest();
    }
    CHECK(world.ComputeDigest() == digest);
    CHECK(numMade == 0);
  }
}

}  // namespace shared_changes_test
