// The same scene far from the world's origin: it gives the same, to the rounding of the positions.

#include <argos3/testing/contract/physics_engines/regions.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/experiment.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace argos::far_test {

namespace {

// m: the distance of two numbers at 200 km
constexpr Real kRounding = 3e-11;

/** "far_robot": constant speeds, or steers by its readings; sends a byte, and records readings. */
class CFarRobot : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override {
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_gripper = GetActuator<CCI_FootBotGripperActuator>("footbot_gripper");
    m_proximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
    m_light = GetSensor<CCI_FootBotLightSensor>("footbot_light");
    m_sender = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
    m_receiver = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
    GetNodeAttributeOrDefault(params, "left", m_left, m_left);
    GetNodeAttributeOrDefault(params, "right", m_right, m_right);
    GetNodeAttributeOrDefault(params, "lock", m_lock, m_lock);
    GetNodeAttributeOrDefault(params, "steers", m_steers, m_steers);
  }
  void ControlStep() override {
    Readings.clear();
    Real turn = 0.0;
    for (const auto& reading : m_proximity->GetReadings()) {
      Readings.push_back(reading.Value);
      turn -= 20.0 * reading.Value * std::sin(reading.Angle.GetValue());
    }
    for (const auto& reading : m_light->GetReadings()) {
      Readings.push_back(reading.Value);
      turn += reading.Value * std::sin(reading.Angle.GetValue());
    }
    for (const auto& packet : m_receiver->GetReadings()) {
      Readings.insert(Readings.end(),
                      {packet.Range, packet.HorizontalBearing.GetValue(), Real(packet.Data[0])});
    }
    m_sender->SetData(0, static_cast<UInt8>(GetId()[0]));
    if (m_lock) {
      m_gripper->LockPositive();
    }
    turn = m_steers ? turn : 0.0;
    m_wheels->SetLinearVelocity(m_left - turn, m_right + turn);
  }

  std::vector<Real> Readings;

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_FootBotGripperActuator* m_gripper = nullptr;
  CCI_FootBotProximitySensor* m_proximity = nullptr;
  CCI_FootBotLightSensor* m_light = nullptr;
  CCI_RangeAndBearingActuator* m_sender = nullptr;
  CCI_RangeAndBearingSensor* m_receiver = nullptr;
  Real m_left = 0.0, m_right = 0.0;  // cm/s
  bool m_lock = false;
  bool m_steers = false;
};

/** The objects of a scene around a place, with the state of all bodies relative to it. */
class CFarScene {
 public:
  explicit CFarScene(const CVector3& place) : m_place(place) {}

  void AddRobot(const std::string& id, Real x, Real y, Real yaw, const std::string& params) {
    m_arena += "<foot-bot id='" + id + "'><body " + PoseText(At(x, y), yaw) +
               "/><controller config='c'><params " + params + "/></controller></foot-bot>";
    m_ids.push_back(id);
    m_robots.push_back(id);
  }
  void AddBox(const std::string& id, Real x, Real y, Real yaw) {
    m_arena += "<box id='" + id + "' size='0.25,0.5,0.125' movable='true' mass='0.5'><body " +
               PoseText(At(x, y), yaw) + "/></box>";
    m_ids.push_back(id);
  }
  void AddCylinder(const std::string& id, Real x, Real y) {
    m_arena += "<cylinder id='" + id +
               "' radius='0.125' height='0.125' movable='true' mass='0.5'>" + "<body " +
               PoseText(At(x, y)) + "/></cylinder>";
    m_ids.push_back(id);
  }
  void AddFixed(Real x, Real y, Real sizeX, Real sizeY) {
    m_arena +=
        BoxText("fixed" + std::to_string(m_arena.size()), CVector3(sizeX, sizeY, 0.5), At(x, y));
  }
  void AddLight(Real x, Real y) {
    m_arena += LightText("light", At(x, y) + CVector3(0.0, 0.0, 0.25));
  }
  CVector3 At(Real x, Real y) const { return m_place + CVector3(x, y, 0.0); }

  /** The text of the experiment; the arena is 16 m wide, or reaches beyond the origin. */
  SExperiment Make(const std::string& engines, bool isWide = false) const {
    SExperiment experiment;
    experiment.Controllers =
        "<far_robot id='c'><actuators><differential_steering implementation='default'/>"
        "<footbot_gripper implementation='default'/><range_and_bearing implementation='default'/>"
        "</actuators><sensors><footbot_proximity implementation='default'/>"
        "<footbot_light implementation='rot_z_only'/>"
        "<range_and_bearing implementation='medium' medium='rab'/></sensors></far_robot>";
    experiment.Media = "<led id='leds'/><range_and_bearing id='rab'/>";
    experiment.Engines = engines;
    const Real wide = 2.0 * (std::abs(m_place.GetX()) + std::abs(m_place.GetY())) + 16.0;
    experiment.ArenaSize = isWide ? ToText(CVector3(wide, wide, 4.0)) : "16,16,4";
    experiment.ArenaCenter = ToText(isWide ? CVector3() : m_place);
    experiment.Arena = m_arena;
    return experiment;
  }

  /** After each of so many ticks: the poses of all bodies, and the readings of all robots. */
  struct SRecord {
    std::vector<Real> Poses, Readings;
  };
  SRecord Run(const SExperiment& experiment, UInt32 ticks, bool testsPlaces = false) const {
    CTestWorld world(experiment);
    const CSimulator::CScope scope(world.GetSimulator());
    SRecord record;
    for (UInt32 tick = 0; tick < ticks; ++tick) {
      for (size_t i = 0; testsPlaces && i < m_ids.size(); ++i) {
        auto& body = world.Get<CComposableEntity>(m_ids[i]).GetComponent<CEmbodiedEntity>("body");
        body.MoveTo(At(4.0, 4.0), CQuaternion(), true);
      }
      world.Step();
      for (const std::string& id : m_ids) {
        auto& body = world.Get<CComposableEntity>(id).GetComponent<CEmbodiedEntity>("body");
        const SAnchor& origin = body.GetOriginAnchor();
        const CVector3 position = origin.Position - m_place;
        const CVector3 middle =
            (body.GetBoundingBox().MinCorner + body.GetBoundingBox().MaxCorner) * 0.5 - m_place;
        record.Poses.insert(
            record.Poses.end(),
            {position.GetX(), position.GetY(), position.GetZ(), origin.Orientation.GetW(),
             origin.Orientation.GetZ(), middle.GetX(), middle.GetY()});
      }
      for (const std::string& id : m_robots) {
        auto& robot =
            world.Get<CComposableEntity>(id).GetComponent<CControllableEntity>("controller");
        const auto& readings = dynamic_cast<CFarRobot&>(robot.GetController()).Readings;
        record.Readings.insert(record.Readings.end(), readings.begin(), readings.end());
      }
      for (int ray = 0; ray < 8; ++ray) {
        CVector3 end(6.0, 0.0, 0.0);
        end.RotateZ(CRadians(ARGOS_PI * ray / 4.0 + 0.1));
        const CVector3 start = At(0.5, 0.5) + CVector3(0.0, 0.0, 0.0625);
        SEmbodiedEntityIntersectionItem hit;
        const bool isHit = GetClosestEmbodiedEntityIntersectedByRay(hit, CRay3(start, start + end));
        record.Readings.push_back(isHit ? hit.TOnRay : -1.0);
      }
    }
    return record;
  }

 private:
  CVector3 m_place;  // m
  std::string m_arena;
  std::vector<std::string> m_ids, m_robots;
};

Real FindGreatestDifference(const std::vector<Real>& a, const std::vector<Real>& b) {
  REQUIRE(a.size() == b.size());
  Real greatest = 0.0;
  for (size_t i = 0; i < a.size(); ++i) {
    greatest = std::max(greatest, std::abs(a[i] - b[i]));
  }
  return greatest;
}

const std::vector<CVector3> kPlaces{
    {1e3, 0.0, 0.0}, {-1e3, 3e3, 0.0}, {0.0, -1e4, 0.0}, {1e5, 7.0, 0.0}, {-2e5, -1e5, 0.0}};

/** Robots that push robots and objects and, where that is possible, grip; no robot steers. */
CFarScene MakeContactScene(const SEngineType& engine, const CVector3& place) {
  CFarScene scene(place);
  scene.AddRobot("a", 0.0, 0.0, 0.0, "left='10' right='10'");
  scene.AddRobot("b", 0.25, 0.03125, 90.0, "left='0'");
  scene.AddRobot("c", 0.0, 2.0, 0.0, "left='10' right='9'");
  scene.AddBox("box", 0.375, 2.0625, 0.0);
  scene.AddCylinder("cylinder", 0.75, 2.0);
  scene.AddRobot("d", 0.0, -2.0, 0.0, "left='8' right='10'");
  scene.AddFixed(1.5, 0.0, 0.25, 4.0);
  const bool grips =
      std::any_of(kEnginesWithGrips.begin(), kEnginesWithGrips.end(),
                  [&engine](const SEngineType& each) { return each.Tag == engine.Tag; });
  scene.AddRobot("g", -1.25, 0.0, 0.0,
                 grips ? "left='-5' right='-6' lock='true'" : "left='-5' right='-6'");
  scene.AddBox("load", -1.25 + 0.125 + 0.09375, 0.0, 0.0);
  return scene;
}

/** Robots that steer by their readings, and touch nothing. */
CFarScene MakeSensingScene(const CVector3& place) {
  CFarScene scene(place);
  scene.AddRobot("a", 0.0, 0.0, 0.0, "left='10' right='10' steers='true'");
  scene.AddRobot("b", 0.5, -0.5, 90.0, "left='5' right='5' steers='true'");
  scene.AddRobot("c", -1.0, 0.5, -90.0, "left='5' right='6' steers='true'");
  scene.AddFixed(1.0, 0.5, 0.25, 2.0);
  scene.AddFixed(-0.5, 1.5, 2.0, 0.25);
  scene.AddLight(-2.0, -2.0);
  return scene;
}

}  // namespace

TEST_CASE("far: robots push and grip as at the origin, to the rounding of positions",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  const CVector3 place = GENERATE(from_range(kPlaces));
  CAPTURE(engine, place);
  const auto run = [&](const CVector3& at) {
    const CFarScene scene = MakeContactScene(engine, at);
    return scene.Run(scene.Make(engine.ToXml()), 80);
  };
  // all numbers of the scene are exact at each place, so the engine computes the same there
  const CFarScene::SRecord near = run(CVector3());
  const CFarScene::SRecord far = run(place);
  CHECK(FindGreatestDifference(far.Poses, near.Poses) <= kRounding);
  // the slope of a reading of proximity is up to 200 a metre, that of a bearing below 10
  CHECK(FindGreatestDifference(far.Readings, near.Readings) <= 1e3 * kRounding);
}

TEST_CASE("far: a place that is tested and not taken has no effect", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  CAPTURE(engine);
  const CFarScene scene = MakeContactScene(engine, CVector3(1e5, -1e4, 0.0));
  const SExperiment experiment = scene.Make(engine.ToXml());
  const CFarScene::SRecord without = scene.Run(experiment, 40);
  CHECK(scene.Run(experiment, 40, true).Poses == without.Poses);
}

TEST_CASE("far: an engine of an arena that reaches to the origin computes near its robots",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  const auto run = [&](const CVector3& at) {
    const CFarScene scene = MakeContactScene(engine, at);
    return scene.Run(scene.Make(engine.ToXml(), true), 80);
  };
  const CFarScene::SRecord near = run(CVector3(1e3, -1e3, 0.0));
  const CFarScene::SRecord far = run(CVector3(-1e5, 2e4, 0.0));
  CHECK(FindGreatestDifference(far.Poses, near.Poses) <= kRounding);
}

TEST_CASE("far: robots that steer by walls, lights and messages drive as at the origin",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  const CVector3 place = GENERATE(from_range(kPlaces));
  CAPTURE(engine, place);
  const auto run = [&](const CVector3& at) {
    const CFarScene scene = MakeSensingScene(at);
    return scene.Run(scene.Make(engine.ToXml()), 100);
  };
  const CFarScene::SRecord near = run(CVector3());
  const CFarScene::SRecord far = run(place);
  // what is sensed of rounded positions changes speeds, for 10 s: the rounding grows by a factor
  // of about 100
  CHECK(FindGreatestDifference(far.Poses, near.Poses) <= 1e3 * kRounding);
  CHECK(FindGreatestDifference(far.Readings, near.Readings) <= 1e5 * kRounding);
}

TEST_CASE("far: bodies cross borders and meet there as at the origin",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  const CVector3 place = GENERATE(from_range(kPlaces));
  CAPTURE(engine, place);
  const auto run = [&](const CVector3& at) {
    CFarScene scene(at);
    scene.AddRobot("a", -0.5, 0.0, 0.0, "left='10' right='10'");
    scene.AddRobot("b", 0.25, 0.0, 180.0, "left='10' right='10'");
    scene.AddRobot("c", -0.25, 2.0, 0.0, "left='10' right='9'");
    scene.AddRobot("d", 0.25, -2.0, 180.0, "left='8' right='8'");
    scene.AddBox("box", -0.125, -2.0, 0.0);
    const auto region = [&at](Real from, Real to) {
      const Real x = at.GetX();
      const Real y = at.GetY();
      return std::vector<SCorner>{{x + from, y - 8.0, "wall='true'"},
                                  {x + to, y - 8.0},
                                  {x + to, y + 8.0, "wall='true'"},
                                  {x + from, y + 8.0}};
    };
    return scene.Run(scene.Make(RegionXml(engine, "west", region(-8.0, 0.0)) +
                                RegionXml(engine, "east", region(0.0, 8.0))),
                     60);
  };
  const CFarScene::SRecord near = run(CVector3());
  const CFarScene::SRecord far = run(place);
  // The frames of the two engines are elsewhere in the scene than at the origin, so forces, in
  // single precision in dynamics2d, are rounded otherwise; roundings of wheels that slip while
  // robots press each other grow.
  // Without contacts nothing grows; those of kinematics2d are solved to a relative 1e-6.
  Real tolerance = engine.HasMomentum ? 1e-6 : engine.HasContacts ? 1e-8 : kRounding;
  if (engine.Slip > 0.0) {
    tolerance = 1e-3;
  }
  CHECK(FindGreatestDifference(far.Poses, near.Poses) <= tolerance);
}

REGISTER_CONTROLLER(CFarRobot, "far_robot")

}  // namespace argos::far_test
