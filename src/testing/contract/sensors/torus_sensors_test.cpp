// Sensors and media in an arena of which opposite sides are joined: a scene gives the same readings
// wherever the seams are.

#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/experiment.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/math/box.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_directional_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_tag_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_sensor.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_model.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace torus_sensors_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kSide = 4.0;  // m

/** "torus_observer": drives in an arc, and lists all its readings. */
class CTorusObserver : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    GetActuator<CCI_DifferentialSteeringActuator>("differential_steering")
        ->SetLinearVelocity(6.0, 7.0);
    GetActuator<CCI_LEDsActuator>("leds")->SetAllColors(CColor::RED);
    GetActuator<CCI_FootBotDistanceScannerActuator>("footbot_distance_scanner")->SetRPM(40.0);
    GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>("colored_blob_omnidirectional_camera")
        ->Enable();
    GetSensor<CCI_CameraSensor>("cameras")->Enable();
    m_radio = GetActuator<CCI_SimpleRadiosActuator>("simple_radios");
    GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing")
        ->SetData(0, static_cast<UInt8>(GetId().back()));
  }
  void ControlStep() override {
    Readings.clear();
    Names.clear();
    ReadRays();
    ReadCameras();
    ReadMessages();
    const auto& steering =
        GetSensor<CCI_DifferentialSteeringSensor>("differential_steering")->GetReading();
    Add("wheels", {steering.CoveredDistanceLeftWheel, steering.CoveredDistanceRightWheel});
    m_radio->GetInterfaces()[0].Messages.push_back(CByteArray(3));
  }

  std::vector<Real> Readings;
  std::vector<std::string> Names;  // of the readings

 private:
  void Add(const std::string& name, const std::vector<Real>& numbers) {
    Readings.insert(Readings.end(), numbers.begin(), numbers.end());
    Names.insert(Names.end(), numbers.size(), name);
  }
  void ReadRays() {
    for (const auto& reading :
         GetSensor<CCI_FootBotProximitySensor>("footbot_proximity")->GetReadings()) {
      Add("footbot_proximity", {reading.Value});
    }
    for (const Real reading : GetSensor<CCI_ProximitySensor>("proximity")->GetReadings()) {
      Add("proximity", {reading});
    }
    for (const auto& reading : GetSensor<CCI_FootBotLightSensor>("footbot_light")->GetReadings()) {
      Add("footbot_light", {reading.Value});
    }
    for (const Real reading : GetSensor<CCI_LightSensor>("light")->GetReadings()) {
      Add("light", {reading});
    }
    auto* const scanner = GetSensor<CCI_FootBotDistanceScannerSensor>("footbot_distance_scanner");
    for (const auto& [angle, distance] : scanner->GetReadingsMap()) {
      Add("scanner", {angle.GetValue(), distance});
    }
  }
  void ReadCameras() {
    for (const auto* blob : GetSensor<CCI_ColoredBlobOmnidirectionalCameraSensor>(
                                "colored_blob_omnidirectional_camera")
                                ->GetReadings()
                                .BlobList) {
      Add("omnidirectional", {blob->Distance, blob->Angle.GetValue(), Real(blob->Color.GetRed())});
    }
    const auto& algorithms = GetSensor<CCI_CameraSensor>("cameras")->GetInterfaces()[0].Algorithms;
    for (const auto& led :
         dynamic_cast<CCI_CameraSensorLEDDetectorAlgorithm&>(*algorithms[0]).GetReadings()) {
      Add("led detector", {led.Center.GetX(), led.Center.GetY()});
    }
    for (const auto& led :
         dynamic_cast<CCI_CameraSensorDirectionalLEDDetectorAlgorithm&>(*algorithms[1])
             .GetReadings()) {
      Add("directional led detector", {led.Center.GetX(), led.Center.GetY()});
    }
    for (const auto& tag :
         dynamic_cast<CCI_CameraSensorTagDetectorAlgorithm&>(*algorithms[2]).GetReadings()) {
      Add("tag detector", {tag.Center.GetX(), tag.Center.GetY(), tag.Corners[2].GetX()});
    }
  }
  void ReadMessages() {
    for (const auto& packet :
         GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing")->GetReadings()) {
      Add("range and bearing",
          {packet.Range, packet.HorizontalBearing.GetValue(), Real(packet.Data[0])});
    }
    for (const auto& tag : GetSensor<CCI_RFIDSensor>("rfid")->GetReadings()) {
      Add("rfid", {tag.Distance, tag.Angle.GetValue()});
    }
    Add("radio", {Real(GetSensor<CCI_SimpleRadiosSensor>("simple_radios")
                           ->GetInterfaces()[0]
                           .Messages.size())});
  }

  CCI_SimpleRadiosActuator* m_radio = nullptr;
};

REGISTER_CONTROLLER(CTorusObserver, "torus_observer")

const char* const kController = R"(
  <torus_observer id='c'>
    <actuators>
      <differential_steering implementation='default'/>
      <leds implementation='default' medium='leds'/>
      <range_and_bearing implementation='default'/>
      <simple_radios implementation='default'/>
      <directional_leds implementation='default'/>
      <footbot_distance_scanner implementation='default'/>
    </actuators>
    <sensors>
      <footbot_proximity implementation='default'/>
      <proximity implementation='default'/>
      <footbot_light implementation='rot_z_only'/>
      <light implementation='default'/>
      <footbot_distance_scanner implementation='rot_z_only'/>
      <colored_blob_omnidirectional_camera implementation='rot_z_only' medium='leds'/>
      <range_and_bearing implementation='medium' medium='rab'/>
      <simple_radios implementation='default'/>
      <differential_steering implementation='default'/>
      <rfid implementation='medium' medium='rfid' range='0.6'/>
      <cameras implementation='default'>
        <camera id='front' anchor='origin' position='0.09,0,0.1' orientation='-90,90,0'
                range='0.05:1.5' focal_length='300,300' principal_point='320,240'
                resolution='640,480'>
          <led_detector medium='leds'/>
          <directional_led_detector medium='directional_leds'/>
          <tag_detector medium='tags'/>
        </camera>
      </cameras>
    </sensors>
  </torus_observer>)";

std::string FootBot(const std::string& id, const CVector3& place, Real yaw) {
  return "<foot-bot id='" + id + "' rab_range='1.3' rab_data_size='2'><body " +
         PoseText(place, yaw) +
         "/><controller config='c'/><simple_radios><simple_radio id='r' medium='radios' "
         "range='0.9'/></simple_radios><directional_leds medium='directional_leds'>"
         "<directional_led position='0.09,0,0.1' orientation='0,90,0' anchor='origin' "
         "observable_angle='80' color='red'/></directional_leds><tags medium='tags'><tag "
         "position='-0.09,0,0.08' orientation='0,-90,0' anchor='origin' observable_angle='75' "
         "side_length='0.03' payload='x'/></tags></foot-bot>";
}

/** A box of 0.5 m x 0.1 m x 0.4 m that only the model of a user describes. */
class CHiddenWallEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE();

  CHiddenWallEntity() : CComposableEntity(nullptr) {
    auto body = std::make_unique<CEmbodiedEntity>(this, "body_0");
    m_body = body.get();
    AddComponent(*body.release());
  }
  void Init(TConfigurationNode& tree) override {
    CComposableEntity::Init(tree);
    m_body->Init(GetNode(tree, "body"));
  }
  std::string GetTypeDescription() const override { return "hidden_wall"; }
  CEmbodiedEntity& GetEmbodiedEntity() { return *m_body; }

 private:
  CEmbodiedEntity* m_body = nullptr;
};

class CHiddenWallModel : public CPointMass3DModel {
 public:
  CHiddenWallModel(CPointMass3DEngine& engine, CHiddenWallEntity& wall)
      : CPointMass3DModel(engine, wall.GetEmbodiedEntity()),
        m_box(kSize, Place(wall).Position, Place(wall).Orientation) {
    Reset();
  }
  void UpdateFromEntityStatus() override {}
  void Step() override {}
  void CalculateBoundingBox() override {
    const CVector3 half(0.5, 0.5, 0.5);
    m_sBoundingBox.MinCorner = m_cPosition - half;
    m_sBoundingBox.MaxCorner = m_cPosition + half;
  }
  bool CheckIntersectionWithRay(Real& tOnRay, const CRay3& ray) const override {
    return m_box.Intersects(tOnRay, ray) && tOnRay <= 1.0;
  }

 private:
  static const SAnchor& Place(CHiddenWallEntity& wall) {
    return wall.GetEmbodiedEntity().GetOriginAnchor();
  }
  inline static const CVector3 kSize{0.5, 0.1, 0.4};
  CBox m_box;
};

REGISTER_ENTITY(CHiddenWallEntity, "hidden_wall", "a test", "1.0", "A wall.", "Stands.", "Usable")
REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CHiddenWallEntity)
REGISTER_STANDARD_POINTMASS3D_OPERATIONS_ON_ENTITY(CHiddenWallEntity, CHiddenWallModel)

/** Four robots, a pillar, a box, a ball and lights around a point. */
std::string Scene(const CVector3& middle) {
  return FootBot("r0", middle + CVector3(-0.3, 0.02, 0.0), 10.0) +
         FootBot("r1", middle + CVector3(0.2, 0.06, 0.0), 175.0) +
         FootBot("r2", middle + CVector3(-0.05, -0.35, 0.0), 80.0) +
         FootBot("r3", middle + CVector3(0.7, 0.5, 0.0), -30.0) +
         PillarText("pillar", middle.GetX() + 0.05, middle.GetY() + 0.3, 0.08, 0.4) +
         BoxText("wall", CVector3(0.5, 0.1, 0.4), middle + CVector3(-0.4, -0.3, 0.0), 30.0) +
         "<rfid_tag id='t0' medium='rfid' position='" + ToText(middle + CVector3(0.0, 0.1, 0.0)) +
         "'/><rfid_tag id='t1' medium='rfid' position='" +
         ToText(middle + CVector3(0.3, -0.2, 0.0)) + "'/>" +
         LightText("l0", middle + CVector3(-0.1, 0.9, 0.5)) +
         LightText("l1", middle + CVector3(0.4, -0.8, 0.2), "blue");
}

SExperiment World(const CVector3& middle, const std::string& engine, bool isTorus,
                  UInt32 threads = 0) {
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Controllers = kController;
  experiment.Engines = engine;
  experiment.Media =
      "<range_and_bearing id='rab'/><led id='leds'/><simple_radio id='radios'/>"
      "<directional_led id='directional_leds'/><tag id='tags'/><rfid id='rfid'/>";
  experiment.ArenaSize = isTorus ? ToText(CVector3(kSide, kSide, 2.0)) : "40,40,2";
  experiment.ArenaAttributes = isTorus ? "periodic='true'" : "";
  experiment.Arena = Scene(middle);
  return experiment;
}

CTorusObserver& Observer(CTestWorld& world, const std::string& id) {
  auto& robot = world.Get<CComposableEntity>(id).GetComponent<CControllableEntity>("controller");
  return dynamic_cast<CTorusObserver&>(robot.GetController());
}

}  // namespace

TEST_CASE("torus: sensors and media see across the seams by the shortest way",
          "[contract][sensors][torus]") {
  const std::string engine = GENERATE("<kinematics2d id='e'/>", "<dynamics2d id='e'/>");
  CAPTURE(engine);
  CTestWorld plain(World(CVector3(0.0, 0.0, 0.0), engine, false));
  std::vector<std::unique_ptr<CTestWorld>> worlds;
  const std::vector<CVector3> places{CVector3(0.0, 0.0, 0.0), CVector3(2.0, 0.3, 0.0),
                                     CVector3(-0.4, -2.0, 0.0), CVector3(2.0, 2.0, 0.0),
                                     CVector3(1.87, -1.93, 0.0)};
  for (const CVector3& place : places) {
    worlds.push_back(std::make_unique<CTestWorld>(World(place, engine, true)));
  }
  size_t numSeen = 0;
  for (int tick = 0; tick < 12; ++tick) {
    plain.Step();
    for (size_t i = 0; i < worlds.size(); ++i) {
      worlds[i]->Step();
      for (const std::string id : {"r0", "r1", "r2", "r3"}) {
        const CTorusObserver& expected = Observer(plain, id);
        const CTorusObserver& found = Observer(*worlds[i], id);
        CAPTURE(tick, places[i], id);
        REQUIRE(found.Names == expected.Names);
        for (size_t k = 0; k < found.Readings.size(); ++k) {
          CAPTURE(found.Names[k], k);
          // pixels have magnitudes of hundreds
          REQUIRE_THAT(found.Readings[k], WithinAbs(expected.Readings[k], 1e-9));
        }
        numSeen += found.Readings.size();
      }
    }
  }
  // every sensor has had something to see
  for (const std::string name : {"footbot_proximity", "footbot_light", "light", "scanner",
                                 "omnidirectional", "led detector", "directional led detector",
                                 "tag detector", "range and bearing", "radio", "rfid", "wheels"}) {
    CAPTURE(name);
    bool isSeen = false;
    for (const std::string id : {"r0", "r1", "r2", "r3"}) {
      const CTorusObserver& observer = Observer(plain, id);
      for (size_t k = 0; k < observer.Names.size(); ++k) {
        isSeen = isSeen || (observer.Names[k] == name && observer.Readings[k] != 0.0);
      }
    }
    CHECK(isSeen);
  }
  CHECK(numSeen > 1000);
}

TEST_CASE("torus: readings across the seams do not depend on threads",
          "[contract][sensors][torus]") {
  CTestWorld alone(World(CVector3(2.0, 2.0, 0.0), "<dynamics2d id='e'/>", true));
  CTestWorld threads(World(CVector3(2.0, 2.0, 0.0), "<dynamics2d id='e'/>", true, 4));
  for (int tick = 0; tick < 10; ++tick) {
    alone.Step();
    threads.Step();
    for (const std::string id : {"r0", "r1", "r2", "r3"}) {
      REQUIRE(Observer(alone, id).Readings == Observer(threads, id).Readings);
    }
  }
}

TEST_CASE("torus: a robot hears each other one once, where it is nearest",
          "[contract][sensors][torus]") {
  // the range is longer than half of the arena
  SExperiment experiment = World(CVector3(), "<kinematics2d id='e'/>", true);
  experiment.ArenaSize = "1.6,1.8,2";
  experiment.Arena =
      FootBot("r0", CVector3(-0.7, 0.0, 0.0), 0.0) + FootBot("r1", CVector3(0.6, 0.1, 0.0), 0.0);
  CTestWorld world(experiment);
  world.Step();
  const CTorusObserver& observer = Observer(world, "r0");
  std::vector<Real> heard;
  for (size_t k = 0; k < observer.Names.size(); ++k) {
    if (observer.Names[k] == "range and bearing") {
      heard.push_back(observer.Readings[k]);
    }
  }
  REQUIRE(heard.size() == 3);
  // 0.3 m to the left through the side, and 0.1 m along it
  CHECK_THAT(heard[0], WithinAbs(100.0 * std::hypot(0.3, 0.1), 1e-9));
  CRadians yaw;
  CRadians pitch;
  CRadians roll;
  world.Get<CComposableEntity>("r0")
      .GetComponent<CEmbodiedEntity>("body")
      .GetOriginAnchor()
      .Orientation.ToEulerAngles(yaw, pitch, roll);
  CHECK_THAT(heard[1], WithinAbs(std::atan2(0.1, -0.3) - yaw.GetValue(), 1e-9));
}

TEST_CASE("users' models: sensors and media see bodies that only an engine knows as others",
          "[contract][sensors]") {
  const auto world = [](bool isHidden, const std::string& angle) {
    SExperiment experiment =
        World(CVector3(), "<kinematics2d id='e'/><pointmass3d id='users'/>", false);
    const std::string place = ToText(CVector3(-0.4, -0.3, 0.0));
    const std::string body = "<body position='" + place + "' orientation='" + angle + ",0,0'/>";
    const std::string box = "<box id='wall' size='0.5,0.1,0.4' movable='false'>";
    const size_t start = experiment.Arena.find("<box ");
    const std::string end = "</box>";
    const size_t length = experiment.Arena.find(end) + end.size() - start;
    experiment.Arena.replace(
        start, length,
        isHidden ? "<hidden_wall id='wall'>" + body + "</hidden_wall>" : box + body + "</box>");
    return experiment;
  };
  const std::string angle = GENERATE("30", "-20");
  CTestWorld known(world(false, angle));
  CTestWorld hidden(world(true, angle));
  for (int tick = 0; tick < 8; ++tick) {
    known.Step();
    hidden.Step();
    for (const std::string id : {"r0", "r1", "r2", "r3"}) {
      const CTorusObserver& expected = Observer(known, id);
      const CTorusObserver& found = Observer(hidden, id);
      CAPTURE(tick, id);
      REQUIRE(found.Names == expected.Names);
      for (size_t k = 0; k < found.Readings.size(); ++k) {
        CAPTURE(found.Names[k], k);
        REQUIRE_THAT(found.Readings[k], WithinAbs(expected.Readings[k], 1e-9));
      }
    }
  }
}

TEST_CASE("torus: radios and tags are found once, whatever the range",
          "[contract][sensors][torus]") {
  // ranges of 0.9 m and 0.6 m: several images of most of them are within it
  SExperiment experiment = World(CVector3(), "<kinematics2d id='e'/>", true);
  experiment.ArenaSize = "1,1.1,2";
  const std::vector<CVector3> tags{CVector3(0.15, 0.02, 0.0), CVector3(-0.4, 0.53, 0.0),
                                   CVector3(-0.4, -0.2, 0.0)};
  experiment.Arena = FootBot("r0", CVector3(-0.4, 0.0, 0.0), 0.0) +
                     FootBot("r1", CVector3(0.3, 0.1, 0.0), 0.0) +
                     FootBot("r2", CVector3(-0.1, 0.45, 0.0), 0.0);
  for (size_t i = 0; i < tags.size(); ++i) {
    experiment.Arena += "<rfid_tag id='t" + std::to_string(i) + "' medium='rfid' position='" +
                        ToText(tags[i]) + "'/>";
  }
  CTestWorld world(experiment);
  world.Step(3);
  const auto readings = [&world](const std::string& id, const std::string& name) {
    const CTorusObserver& observer = Observer(world, id);
    std::vector<Real> found;
    for (size_t k = 0; k < observer.Names.size(); ++k) {
      if (observer.Names[k] == name) {
        found.push_back(observer.Readings[k]);
      }
    }
    return found;
  };
  for (const std::string id : {"r0", "r1", "r2"}) {
    CAPTURE(id);
    // a message of each of the others
    CHECK(readings(id, "radio") == std::vector<Real>{2.0});
  }
  const std::vector<Real> found = readings("r0", "rfid");
  REQUIRE(found.size() == 2 * tags.size());
  const CVector3 place = world.Get<CComposableEntity>("r0")
                             .GetComponent<CEmbodiedEntity>("body")
                             .GetOriginAnchor()
                             .Position;
  for (size_t i = 0; i < tags.size(); ++i) {
    const CVector3 way = tags[i] - place;
    CHECK_THAT(found[2 * i], WithinAbs(100.0 * std::hypot(std::remainder(way.GetX(), 1.0),
                                                          std::remainder(way.GetY(), 1.1)),
                                       1e-9));
  }
}

}  // namespace torus_sensors_test
