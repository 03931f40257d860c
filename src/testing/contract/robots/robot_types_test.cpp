// Robots whose types the experiment file describes.

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ground_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_planar_drive_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_position_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/robots/generic/simulator/described_robot_entity.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace argos::robot_types_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

// the e-puck of robots.md, in XML
std::string EPuckType(const std::string& id) {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<robot-type id='" << id
      << "'><body mass='0.4' inertia='0.00098'>"
         "<solid geometry='cylinder' radius='0.035' height='0.086'/></body>"
         "<differential_drive wheel_distance='0.053' wheel_radius='0.0205' max_force='1.5' "
         "max_torque='1.5'/><proximity_sensors>";
  for (const Real part : {10.5884, 3.5999, 2.0, 1.2, 0.8571, 0.6667, 0.5806, 0.5247}) {
    const Real angle = ARGOS_PI / part;
    xml << "<sensor offset='" << 0.035 * std::cos(angle) << "," << 0.035 * std::sin(angle)
        << ",0.06' direction='" << std::cos(angle) << "," << std::sin(angle) << ",0' range='0.1'/>";
  }
  xml << "</proximity_sensors><light_sensors><ring center='0,0,0.06' radius='0.035' "
         "start_angle='22.5' range='0.1' num_sensors='8'/></light_sensors>"
         "<ground_sensors><sensor offset='0.03,-0.009'/><sensor offset='0.03,0'/>"
         "<sensor offset='0.03,0.009'/></ground_sensors>"
         "<leds><ring center='0,0,0.086' radius='0.042' start_angle='11.25' num_leds='8'/></leds>"
         "<range_and_bearing offset='0,0,0.086' range='0.8' data_size='2'/></robot-type>";
  return xml.str();
}

const std::string kController =
    "<robot_type_driver id='c'><actuators><differential_steering implementation='default'/>"
    "<range_and_bearing implementation='default'/><leds implementation='default' medium='leds'/>"
    "</actuators><sensors><proximity implementation='default'/><light implementation='default'/>"
    "<ground implementation='rot_z_only'/>"
    "<range_and_bearing implementation='medium' medium='rab'/>"
    "<battery implementation='default'/><positioning implementation='default'/>"
    "</sensors><params/></robot_type_driver>";

/** Drives by what it senses, and keeps the sum of all readings. */
class CRobotTypeDriver : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_proximity = GetSensor<CCI_ProximitySensor>("proximity");
    m_light = GetSensor<CCI_LightSensor>("light");
    m_ground = GetSensor<CCI_GroundSensor>("ground");
    m_messages = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
  }
  void ControlStep() override {
    Readings.clear();
    for (const Real value : m_proximity->GetReadings()) {
      Readings.push_back(value);
    }
    for (const Real value : m_light->GetReadings()) {
      Readings.push_back(value);
    }
    for (const Real value : m_ground->GetReadings()) {
      Readings.push_back(value);
    }
    for (const auto& packet : m_messages->GetReadings()) {
      Readings.push_back(packet.Range);
      Readings.push_back(packet.HorizontalBearing.GetValue());
    }
    Real turn = 0.0;
    for (size_t i = 0; i < 8; ++i) {
      turn += (i < 4 ? 1.0 : -1.0) * Readings[i];
    }
    m_wheels->SetLinearVelocity(8.0 + 4.0 * turn, 8.0 - 4.0 * turn);
  }

  std::vector<Real> Readings;

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_ProximitySensor* m_proximity = nullptr;
  CCI_LightSensor* m_light = nullptr;
  CCI_GroundSensor* m_ground = nullptr;
  CCI_RangeAndBearingSensor* m_messages = nullptr;
};

REGISTER_CONTROLLER(CRobotTypeDriver, "robot_type_driver")

std::string WithTypes(const SExperiment& experiment, const std::string& types) {
  std::string xml = experiment.ToXml();
  const size_t end = xml.rfind("</");
  return xml.insert(end, "<robot_types>" + types + "</robot_types>");
}

SExperiment Swarm(const std::string& tag, const std::string& engine) {
  SExperiment experiment;
  experiment.Engines = engine;
  experiment.Controllers = kController;
  experiment.Media = "<led id='leds'/><range_and_bearing id='rab'/>";
  experiment.ArenaSize = "2,2,1";
  experiment.Arena =
      "<floor id='floor' source='loop_functions' pixels_per_meter='10'/>"
      "<light id='light' position='0,0,0.5' color='yellow' intensity='0.5' medium='leds'/>"
      "<box id='wall' size='0.02,1,0.1' movable='false'><body position='0.5,0,0'/></box>"
      "<distribute><position method='uniform' min='-0.4,-0.4,0' max='0.4,0.4,0'/>"
      "<orientation method='uniform' min='0,0,0' max='360,0,0'/>"
      "<entity quantity='12' max_trials='200'><" +
      tag + " id='r'><controller config='c'/></" + tag + "></entity></distribute>";
  return experiment;
}

CRobotTypeDriver& DriverOf(CTestWorld& world, const std::string& id) {
  auto& robot = world.Get<CComposableEntity>(id);
  return dynamic_cast<CRobotTypeDriver&>(
      robot.GetComponent<CControllableEntity>("controller").GetController());
}

template <typename ACTUATOR>
ACTUATOR& ActuatorOf(CTestWorld& world, const std::string& id, const std::string& type) {
  return *world.Get<CComposableEntity>(id)
              .GetComponent<CControllableEntity>("controller")
              .GetController()
              .GetActuator<ACTUATOR>(type);
}

std::string TypeError(const std::string& types, const std::string& arena = "") {
  SExperiment experiment;
  experiment.Engines = "<dynamics2d id='e'/>";
  experiment.Arena = arena;
  try {
    CTestWorld world(WithTypes(experiment, types));
  } catch (CARGoSException& error) {
    return error.what();
  }
  return "";
}

const std::string kDrive =
    "<differential_drive wheel_distance='0.05' wheel_radius='0.02' max_force='1' max_torque='1'/>";
const std::string kBody =
    "<body mass='0.4'><solid geometry='cylinder' radius='0.035' height='0.05'/></body>";

}  // namespace

TEST_CASE("robot types: an e-puck described in XML moves and senses as the built-in one",
          "[contract][robots][types]") {
  const std::string engine = GENERATE(as<std::string>(), "<dynamics2d id='e'/>",
                                      "<kinematics2d id='e'/>", "<dynamics3d id='e'/>");
  CAPTURE(engine);
  CTestWorld builtIn(Swarm("e-puck", engine));
  CTestWorld described(WithTypes(Swarm("puck", engine), EPuckType("puck")));
  for (int tick = 0; tick < 50; ++tick) {
    builtIn.Step();
    described.Step();
  }
  for (int i = 0; i < 12; ++i) {
    const std::string id = "r" + std::to_string(i);
    CAPTURE(id);
    const auto pose = [&id](CTestWorld& world) -> const SAnchor& {
      return world.Get<CComposableEntity>(id)
          .GetComponent<CEmbodiedEntity>("body")
          .GetOriginAnchor();
    };
    // the directions of the rays pass through text, so what they feel differs by roundings; ODE's
    // contacts enlarge them to 4e-5 m in these 5 s, in which robots push the wall
    const bool isRigid = engine.find("dynamics3d") != std::string::npos;
    CHECK_THAT((pose(builtIn).Position - pose(described).Position).Length(),
               WithinAbs(0.0, isRigid ? 2e-4 : 1e-6));
    const std::vector<Real>& a = DriverOf(builtIn, id).Readings;
    const std::vector<Real>& b = DriverOf(described, id).Readings;
    REQUIRE(a.size() == b.size());
    REQUIRE(a.size() > 19);
    for (size_t k = 0; k < a.size(); ++k) {
      // ranges in cm, bearings in rad
      CHECK_THAT(a[k], WithinAbs(b[k], isRigid ? 0.05 : 1e-3));
    }
  }
}

TEST_CASE("robot types: robots have the tag, body and parameters of their type",
          "[contract][robots][types]") {
  SExperiment experiment;
  experiment.Engines = "<dynamics2d id='e'/>";
  experiment.Controllers = kController;
  experiment.Media = "<led id='leds'/><range_and_bearing id='rab'/>";
  experiment.Arena =
      "<floor id='floor' source='loop_functions' pixels_per_meter='10'/>"
      "<puck id='a'><body position='1,0,0'/><controller config='c'/></puck>"
      "<puck id='b' rab_range='0.3'><body position='-1,0,0'/><controller config='c'/></puck>";
  CTestWorld world(WithTypes(experiment, EPuckType("puck")));
  world.Step();
  auto& a = world.Get<CDescribedRobotEntity>("a");
  auto& b = world.Get<CDescribedRobotEntity>("b");
  CHECK(a.GetTypeDescription() == "puck");
  CHECK(a.GetEmbodiedEntity().GetBodyDescription() == b.GetEmbodiedEntity().GetBodyDescription());
  CHECK(a.GetEmbodiedEntity().GetBodyDescription()->Mass == 0.4);
  CHECK(a.GetDeviceParameters().RAB.Range == 0.8);
  CHECK(b.GetDeviceParameters().RAB.Range == 0.3);
  CHECK(a.GetLEDEquippedEntity().GetNumLEDs() == 8);
}

TEST_CASE("robot types: mistakes are reported with file and line", "[contract][robots][types]") {
  const auto [types, message] = GENERATE_COPY(table<std::string, std::string>(
      {{"<robot-type>" + kBody + kDrive + "</robot-type>", "id"},
       {"<robot-type id='foot-bot'>" + kBody + kDrive + "</robot-type>",
        "there are already entities <foot-bot>"},
       {"<robot-type id='x'>" + kBody + kDrive + "</robot-type><robot-type id='x'>" + kBody +
            kDrive + "</robot-type>",
        "there are already entities <x>"},
       {"<robot-typ id='x'/>", "did you mean \"robot-type\"?"},
       {"<robot-type id='x'>" + kDrive + "</robot-type>", "<body>"},
       {"<robot-type id='x'><body mass='0.4'/>" + kDrive + "</robot-type>",
        "needs at least one child <solid>"},
       {"<robot-type id='x'><body mass='-1'/>" + kDrive + "</robot-type>",
        "\"mass\" must be a number from"},
       {"<robot-type id='x'>" + kBody + "</robot-type>",
        "needs one of the children <differential_drive>, <planar_drive> and <propellers>, found "
        "none"},
       {"<robot-type id='x'>" + kBody + kDrive +
            "<planar_drive max_force='1' max_torque='1'/></robot-type>",
        "found several"},
       {"<robot-type id='x'>" + kBody + "<planar_drive max_force='1'/></robot-type>",
        "\"max_torque\""},
       {"<robot-type id='x'>" + kBody +
            "<propellers max_force='1' max_torque='1' yaw_gains='0,1'/></robot-type>",
        "\"yaw_gains\" must be \"proportional,derivative\", the first > 0 and the second > 0"},
       {"<robot-type id='x'>" + kBody +
            "<propellers max_force='1' max_torque='1' position_gains='1,0'/></robot-type>",
        "\"position_gains\" must be"},
       {"<robot-type id='x'>" + kBody +
            "<propellers max_force='1' max_torque='1' velocity_gains='1,-1'/></robot-type>",
        "\"velocity_gains\" must be \"proportional,derivative\", the first > 0 and the second >= "
        "0"},
       {"<robot-type id='x'>" + kBody + kDrive +
            "<proximity_sensors><rings/></proximity_sensors></robot-type>",
        "unknown child of <proximity_sensors>"},
       {"<robot-type id='x'>" + kBody + kDrive +
            "<proximity_sensors><sensor offset='0,0,0' direction='0,0,0' range='1'/>"
            "</proximity_sensors></robot-type>",
        "\"direction\" must not be zero"},
       {"<robot-type id='x'>" + kBody + kDrive + "<leds><rings/></leds></robot-type>",
        "unknown child of <leds>; did you mean \"ring\"?"},
       {"<robot-type id='x'>" + kBody + kDrive +
            "<light_sensors><ring radius='0.1' range='0' num_sensors='3'/></light_sensors>"
            "</robot-type>",
        "\"range\" (m)"},
       {"<robot-type id='x'>" + kBody + kDrive +
            "<ground_sensors><sensor offset='0,0' type='grey'/></ground_sensors></robot-type>",
        "unknown type \"grey\""}}));
  CAPTURE(types);
  CHECK_THAT(TypeError(types), Contains(message) && Contains("test.argos:"));
  CHECK_THAT(TypeError("<robot-type id='wheely'>" + kBody + kDrive + "</robot-type>",
                       "<wheelly id='a'><body/></wheelly>"),
             Contains("there is no entity \"wheelly\"; did you mean \"wheely\"?"));
}

TEST_CASE("robot types: a planar drive moves to all sides, within its force",
          "[contract][robots][types]") {
  const std::string engine = GENERATE(as<std::string>(), "<dynamics2d id='e'/>",
                                      "<kinematics2d id='e'/>", "<dynamics3d id='e'/>");
  CAPTURE(engine);
  SExperiment experiment;
  experiment.Engines = engine;
  experiment.Controllers =
      "<robot_world_controller id='c'><actuators><planar_drive "
      "implementation='default'/></actuators>"
      "<sensors/><params/></robot_world_controller>";
  experiment.Arena =
      "<rover id='r'><body position='0,0,0' orientation='90,0,0'/>"
      "<controller config='c'/></rover>";
  CTestWorld world(WithTypes(experiment, "<robot-type id='rover'>" + kBody +
                                             "<planar_drive max_force='4' max_torque='4'/>"
                                             "</robot-type>"));
  auto& drive = ActuatorOf<CCI_PlanarDriveActuator>(world, "r", "planar_drive");
  drive.SetVelocity(10.0, 5.0, CRadians::ZERO);  // cm/s
  constexpr int kTicks = 51;  // the command acts from the second one
  for (int tick = 0; tick < kTicks; ++tick) {
    world.Step();
  }
  const SAnchor& origin =
      world.Get<CComposableEntity>("r").GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
  // it faces y; 4 N bring 0.4 kg to 0.112 m/s within 11 ms
  CHECK_THAT(origin.Position.GetX(), WithinAbs(-0.25, 0.01));
  CHECK_THAT(origin.Position.GetY(), WithinAbs(0.5, 0.01));
  CHECK(world.Get<CDescribedRobotEntity>("r").GetTypeDescription() == "rover");
}

TEST_CASE("robot types: propellers lift a robot to its target, as those of an eye-bot do",
          "[contract][robots][types]") {
  SExperiment experiment;
  experiment.Engines = "<pointmass3d id='e'/>";
  experiment.Controllers =
      "<robot_world_controller id='c'><actuators><quadrotor_position "
      "implementation='default'/></actuators>"
      "<sensors/><params/></robot_world_controller>";
  experiment.Arena =
      "<drone id='d'><body position='1,0,0'/><controller config='c'/></drone>"
      "<eye-bot id='e'><body position='-1,0,0'/><controller config='c'/></eye-bot>";
  // heavier than an eye-bot, so its gains must follow the mass for the same motion
  CTestWorld world(
      WithTypes(experiment,
                "<robot-type id='drone'><body mass='3' inertia='0.04'><solid geometry='cylinder' "
                "radius='0.2' height='0.3'/></body>"
                "<propellers max_force='3000' max_torque='4000'/></robot-type>"));
  const auto position = [&world](const std::string& id) {
    return world.Get<CComposableEntity>(id)
        .GetComponent<CEmbodiedEntity>("body")
        .GetOriginAnchor()
        .Position;
  };
  const CVector3 way(0.3, 0.4, 0.3);  // below the ceiling
  for (const std::string id : {"d", "e"}) {
    ActuatorOf<CCI_QuadRotorPositionActuator>(world, id, "quadrotor_position")
        .SetAbsolutePosition(position(id) + way);
  }
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    CAPTURE(tick);
    CHECK_THAT((position("d") - position("e") - CVector3(2.0, 0.0, 0.0)).Length(),
               WithinAbs(0.0, 1e-9));
  }
  CHECK_THAT((position("d") - CVector3(1.3, 0.4, 0.3)).Length(), WithinAbs(0.0, 1e-3));
}

TEST_CASE("robot types: a device needs the part that the type may lack",
          "[contract][robots][types]") {
  SExperiment experiment = Swarm("bare", "<dynamics2d id='e'/>");
  std::string error;
  try {
    CTestWorld world(
        WithTypes(experiment, "<robot-type id='bare'>" + kBody + kDrive + "</robot-type>"));
  } catch (CARGoSException& caught) {
    error = caught.what();
  }
  CHECK_THAT(error, Contains("light_sensors") || Contains("rab"));
}

TEST_CASE("robot types: a robot may have more sensors than are cast at a time",
          "[contract][robots][types]") {
  constexpr size_t kSensors = 75;
  SExperiment experiment;
  experiment.Engines = "<dynamics2d id='e'/>";
  experiment.Controllers =
      "<robot_world_controller id='c'><actuators/><sensors><light implementation='default'/>"
      "<proximity implementation='default'/></sensors><params/></robot_world_controller>";
  experiment.Media = "<led id='leds'/>";
  // a light at (2,1) of the height of the sensors, and a long wall 0.15 m ahead of the robot
  experiment.Arena =
      "<urchin id='u'><body position='0,0,0'/><controller config='c'/></urchin>"
      "<light id='l' position='2,1,0.05' color='red' intensity='0.8' medium='leds'/>"
      "<box id='wall' size='9,0.1,0.04' movable='false'><body position='0,-0.2,0'/></box>";
  const std::string ring =
      "<ring center='0,0,0.05' radius='0.05' start_angle='2' range='0.2' num_sensors='75'/>";
  const std::string low =
      "<ring center='0,0,0.02' radius='0.05' start_angle='2' range='0.2' num_sensors='75'/>";
  CTestWorld world(WithTypes(experiment,
                             "<robot-type id='urchin'><body mass='0.4'><solid geometry='cylinder' "
                             "radius='0.05' height='0.1'/></body>" +
                                 kDrive + "<proximity_sensors>" + low +
                                 "</proximity_sensors><light_sensors>" + ring +
                                 "</light_sensors>"
                                 "</robot-type>"));
  world.Step();
  auto& controller = world.Get<CComposableEntity>("u")
                         .GetComponent<CControllableEntity>("controller")
                         .GetController();
  const std::vector<Real>& lights = controller.GetSensor<CCI_LightSensor>("light")->GetReadings();
  const std::vector<Real>& near =
      controller.GetSensor<CCI_ProximitySensor>("proximity")->GetReadings();
  REQUIRE(lights.size() == kSensors);
  REQUIRE(near.size() == kSensors);
  for (size_t i = 0; i < kSensors; ++i) {
    CAPTURE(i);
    const Real angle = (2.0 + 360.0 / kSensors * static_cast<Real>(i)) * ARGOS_PI / 180.0;
    const CVector2 direction(std::cos(angle), std::sin(angle));
    const CVector2 toLight = CVector2(2.0, 1.0) - direction * 0.05;
    const bool isAhead = toLight.DotProduct(direction) > 0.0;
    CHECK_THAT(lights[i], WithinAbs(isAhead ? 0.64 / toLight.SquareLength() : 0.0, 1e-12));
    // from the surface along the sensor to y = -0.15
    const Real way = direction.GetY() < 0.0 ? 0.15 / -direction.GetY() - 0.05 : HUGE_VAL;
    CHECK_THAT(near[i], WithinAbs(way < 0.2 ? std::exp(-way) : 0.0, 1e-12));
  }
}

TEST_CASE("robot types: light from straight above passes beside a body, but not through it",
          "[contract][robots][types]") {
  SExperiment experiment;
  experiment.Engines = "<dynamics2d id='e'/>";
  experiment.Controllers =
      "<robot_world_controller id='c'><actuators/><sensors><light implementation='default'/>"
      "</sensors><params/></robot_world_controller>";
  experiment.Media = "<led id='leds'/>";
  const Real aside = GENERATE(0.0, 0.09, 0.11);  // m, of the plate's middle
  const Real base = GENERATE(0.2, 0.6);  // m
  CAPTURE(aside, base);
  const std::string height = std::to_string(base);
  experiment.Engines += "<dynamics2d id='above' elevation='" + height + "'/>";
  experiment.Arena =
      "<watcher id='u'><body position='0,0,0'/><controller config='c'/></watcher>"
      "<light id='l' position='0,0,0.5' color='red' intensity='0.2' medium='leds'/>"
      "<box id='plate' size='0.2,0.2,0.1' movable='false'><body position='" +
      std::to_string(aside) + ",0," + height + "'/></box>";
  CTestWorld world(
      WithTypes(experiment,
                "<robot-type id='watcher'><body mass='0.4'><solid geometry='cylinder' "
                "radius='0.05' height='0.1'/></body>" +
                    kDrive +
                    "<light_sensors><sensor "
                    "offset='0,0,0.1' direction='0,0,1' range='1'/></light_sensors></robot-type>"));
  world.Step();
  const bool isBlocked = aside < 0.1 && base < 0.5;
  const std::vector<Real>& readings = world.Get<CComposableEntity>("u")
                                          .GetComponent<CControllableEntity>("controller")
                                          .GetController()
                                          .GetSensor<CCI_LightSensor>("light")
                                          ->GetReadings();
  REQUIRE(readings.size() == 1);
  CHECK_THAT(readings[0], WithinAbs(isBlocked ? 0.0 : 0.25, 1e-12));
}

}  // namespace argos::robot_types_test
