// Devices that several robots share, on the robots that the devices' own tests do not cover.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pan_tilt_camera_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_position_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/support/robot_sizes.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>

namespace shared_devices_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

// tolerance of about ten roundings of numbers of the order of 1, and of cm
constexpr Real kRounding = 1e-13;
constexpr Real kRoundingCm = 1e-11;

// positions of a robot's LEDs in its frame, m
std::vector<CVector3> PublishedLEDs(const std::string& robot) {
  std::vector<CVector3> places;
  const auto addRing = [&places](int count, Real firstDegrees, Real radius, Real height) {
    for (int i = 0; i < count; ++i) {
      const Real angle = (firstDegrees + 360.0 * i / count) * M_PI / 180.0;
      places.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  };
  if (robot == "e-puck") {
    addRing(8, 11.25, 0.042, 0.086);
  } else if (robot == "foot-bot") {
    addRing(12, 15.0, kFootBotRadius + 0.005, 0.085);
    places.emplace_back(0.0, 0.0, 0.174249733);
  } else {
    addRing(16, 11.25, 0.255, 0.1535);
    addRing(16, 11.25, 0.255, 0.1635);
    const Real angle = 0.75 * M_PI;
    places.emplace_back(0.1785 * std::cos(angle), 0.1785 * std::sin(angle), 0.1435);
  }
  return places;
}

// positions of all LEDs in the medium's index
std::map<size_t, CVector3> FindLitLEDs(CRobotWorld& world) {
  class CCollect : public CPositionalIndex<CLEDEntity>::COperation {
   public:
    bool operator()(CLEDEntity& led) override {
      const std::string& id = led.GetId();
      Places[std::stoul(id.substr(id.rfind('_') + 1))] = led.GetPosition();
      return true;
    }
    std::map<size_t, CVector3> Places;
  } collect;
  world.GetSimulator().GetMedium<CLEDMedium>("leds").GetIndex().ForEntitiesInBoxRange(
      CVector3(), CVector3(100.0, 100.0, 100.0), collect);
  return collect.Places;
}

SRobotExperiment WithSensors(const std::string& sensors, const std::string& arena) {
  SRobotExperiment experiment;
  experiment.Sensors = sensors;
  experiment.Arena = arena;
  return experiment;
}

}  // namespace

TEST_CASE("leds actuator: every LED of every robot is at the published position",
          "[contract][robots]") {
  const std::string robot = GENERATE("foot-bot", "e-puck", "eye-bot");
  const std::vector<CVector3> published = PublishedLEDs(robot);
  SRobotExperiment experiment;
  experiment.Actuators = "<leds implementation=\"default\" medium=\"leds\"/>";
  const CVector3 position(1.0, -2.0, 0.5);
  experiment.Arena = Robot(robot, "r", PoseText(position, 90.0));
  CRobotWorld world(experiment);
  auto& leds = world.GetActuator<CCI_LEDsActuator>("r", "leds");
  REQUIRE(leds.GetNumLEDs() == published.size());
  for (size_t i = 0; i < published.size(); ++i) {
    CAPTURE(robot, i);
    leds.SetAllColors(CColor::BLACK);
    leds.SetSingleColor(static_cast<UInt32>(i), CColor::CYAN);
    world.Step();
    const std::map<size_t, CVector3> lit = FindLitLEDs(world);
    REQUIRE(lit.size() == 1);
    REQUIRE(lit.count(i) == 1);
    // a quarter turn maps x to y
    const CVector3 expected =
        position + CVector3(-published[i].GetY(), published[i].GetX(), published[i].GetZ());
    CHECK_THAT(Distance(lit.at(i), expected), WithinAbs(0.0, kRounding));
  }
}

TEST_CASE("range and bearing: flying robots receive each other at different heights",
          "[contract][sensors]") {
  const auto robot = [](const std::string& id, const CVector3& place, Real yaw) {
    return "<eye-bot id=\"" + id + "\" rab_range=\"6\" rab_data_size=\"2\"><body " +
           PoseText(place, yaw) + "/><controller config=\"c\"/></eye-bot>";
  };
  SRobotExperiment experiment =
      WithSensors("<range_and_bearing implementation=\"medium\" medium=\"rab\"/>",
                  robot("a", CVector3(1.0, 1.0, 1.0), 90.0) +
                      robot("b", CVector3(1.0 + 1.2, 1.0 + 1.6, 1.0 + 1.5), -30.0));
  experiment.Actuators = "<range_and_bearing implementation=\"default\"/>";
  experiment.Media = "<range_and_bearing id=\"rab\"/>";
  CRobotWorld world(experiment);
  world.GetActuator<CCI_RangeAndBearingActuator>("b", "range_and_bearing").SetData(1, 77);
  world.Step();
  const auto& heard =
      world.GetSensor<CCI_RangeAndBearingSensor>("a", "range_and_bearing").GetReadings();
  REQUIRE(heard.size() == 1);
  // the devices are at the robots' origins: (1.2, 1.6) is 2 m away in the plane and 1.5 m higher
  CHECK_THAT(heard[0].Range, WithinAbs(250.0, kRoundingCm));
  CHECK_THAT(heard[0].HorizontalBearing.GetValue(),
             WithinAbs(std::atan2(1.6, 1.2) - 0.5 * M_PI, kRounding));
  CHECK_THAT(heard[0].VerticalBearing.GetValue(), WithinAbs(std::atan2(1.5, 2.0), kRounding));
  CHECK(heard[0].Data[1] == 77);
  const auto& back =
      world.GetSensor<CCI_RangeAndBearingSensor>("b", "range_and_bearing").GetReadings();
  REQUIRE(back.size() == 1);
  CHECK_THAT(back[0].HorizontalBearing.GetValue(),
             WithinAbs(std::atan2(-1.6, -1.2) + M_PI / 6.0, kRounding));
  CHECK_THAT(back[0].VerticalBearing.GetValue(), WithinAbs(-std::atan2(1.5, 2.0), kRounding));
}

TEST_CASE("battery: the charge of a flying robot falls with its path and its rotation",
          "[contract][sensors]") {
  SRobotExperiment experiment = WithSensors(
      "<battery implementation=\"default\"/>",
      "<eye-bot id=\"r\"><body " + PoseText(CVector3(0.0, 0.0, 0.5), 20.0) +
          "/><controller config=\"c\"/><battery discharge_model=\"motion\" pos_delta=\"0.02\" "
          "orient_delta=\"0.03\"/></eye-bot>");
  experiment.Actuators = "<quadrotor_position implementation=\"default\"/>";
  experiment.Engine = "<pointmass3d id=\"air\"/>";
  CRobotWorld world(experiment);
  auto& flight = world.GetActuator<CCI_QuadRotorPositionActuator>("r", "quadrotor_position");
  flight.SetAbsolutePosition(CVector3(0.6, -0.4, 1.2));
  flight.SetAbsoluteYaw(CRadians(1.0));
  const auto& body = world.Get<CEyeBotEntity>("r").GetEmbodiedEntity().GetOriginAnchor();
  const auto& reading = world.GetSensor<CCI_BatterySensor>("r", "battery").GetReading();
  const auto yawOf = [&body] {
    return 2.0 * std::atan2(body.Orientation.GetZ(), body.Orientation.GetW());
  };
  CVector3 place = body.Position;
  Real yaw = yawOf();
  Real charge = 1.0;
  for (int tick = 0; tick < 40; ++tick) {
    world.Step();
    charge -= 0.02 * Distance(body.Position, place) + 0.03 * std::abs(yawOf() - yaw);
    place = body.Position;
    yaw = yawOf();
    // angles of the order of the rounding of a quaternion have only half of the digits
    CHECK_THAT(reading.AvailableCharge, WithinAbs(charge, 1e-9));
  }
  // the charge has fallen by the expected amount
  CHECK(charge < 1.0 - 0.02 * 0.9);
}

TEST_CASE("pan tilt camera: the camera of an eye-bot follows its head", "[contract][sensors]") {
  const Real pan = GENERATE(0.0, 30.0, -50.0) * M_PI / 180.0;
  const Real tilt = GENERATE(0.0, 25.0, -40.0) * M_PI / 180.0;
  CAPTURE(pan, tilt);
  // in the camera's frame: x straight down, y to the robot's left, z ahead
  const CVector3 inCamera(std::cos(tilt) * std::cos(pan), std::cos(tilt) * std::sin(pan),
                          -std::sin(tilt));
  const CVector3 inRobot(inCamera.GetZ(), inCamera.GetY(), -inCamera.GetX());
  const CVector3 eye(0.5, -0.3, 1.5);
  // the robot is turned by 90 degrees
  const CVector3 inWorld(-inRobot.GetY(), inRobot.GetX(), inRobot.GetZ());
  SRobotExperiment experiment =
      WithSensors("<colored_blob_perspective_camera implementation=\"default\" medium=\"leds\"/>",
                  Robot("eye-bot", "r", PoseText(eye, 90.0)) + LightText("l", eye + inWorld * 1.2));
  experiment.Actuators = "<pan_tilt_camera implementation=\"default\"/>";
  CRobotWorld world(experiment);
  auto& head = world.GetActuator<CCI_PanTiltCameraActuator>("r", "pan_tilt_camera");
  auto& camera = world.GetSensor<CCI_ColoredBlobPerspectiveCameraSensor>(
      "r", "colored_blob_perspective_camera");
  camera.Enable();
  head.SetPan(CRadians(pan));
  head.SetTilt(CRadians(tilt));
  world.Step();
  REQUIRE(camera.GetReadings().BlobList.size() == 1);
  // a point in the middle is on the border of four pixels: rounding decides
  CHECK_THAT(camera.GetReadings().BlobList[0]->X + 0.5, WithinAbs(320.0, 0.5));
  CHECK_THAT(camera.GetReadings().BlobList[0]->Y + 0.5, WithinAbs(240.0, 0.5));
}

TEST_CASE("rings: sensors of foot-bot and eye-bot have equal readings on either robot",
          "[contract][sensors]") {
  const std::string robot = GENERATE("foot-bot", "eye-bot");
  const Real radius = robot == "foot-bot" ? kFootBotRadius : 0.255;
  CAPTURE(robot);
  CRobotWorld world(WithSensors(
      "<footbot_proximity implementation=\"default\"/><eyebot_proximity "
      "implementation=\"default\"/><footbot_light implementation=\"rot_z_only\"/><eyebot_light "
      "implementation=\"rot_z_only\"/>",
      Robot(robot, "r", PoseText(CVector3(0.0, 0.0, 0.0))) +
          // the ray of sensor 0 hits the wall after 5 cm
          BoxText("wall", CVector3(0.2, 6.0, 1.0),
                  CVector3((radius + 0.05) * std::cos(7.5 * M_PI / 180.0) + 0.1, 0.0, 0.0)) +
          // directly to the left, not occluded
          LampText("lamp", CVector3(0.0, 1.0, 0.0), 1.0)));
  world.Step();
  const auto& footBotEyes =
      world.GetSensor<CCI_FootBotProximitySensor>("r", "footbot_proximity").GetReadings();
  const auto& eyeBotEyes =
      world.GetSensor<CCI_EyeBotProximitySensor>("r", "eyebot_proximity").GetReadings();
  const auto& footBotLight =
      world.GetSensor<CCI_FootBotLightSensor>("r", "footbot_light").GetReadings();
  const auto& eyeBotLight =
      world.GetSensor<CCI_EyeBotLightSensor>("r", "eyebot_light").GetReadings();
  REQUIRE(footBotEyes.size() == 24);
  REQUIRE(eyeBotEyes.size() == 24);
  CHECK_THAT(eyeBotEyes[0].Value, WithinAbs(0.0100527 / (0.05 + 0.000163144), 1e-11));
  for (size_t i = 0; i < 24; ++i) {
    CAPTURE(i);
    CHECK(eyeBotEyes[i].Value == footBotEyes[i].Value);
    CHECK(eyeBotLight[i].Value == footBotLight[i].Value);
    // e^(-2) straight ahead of a sensor, decreasing to 0 at a right
    // angle; at most 13 sensors see it
    const Real apart = std::abs(7.5 + 15.0 * static_cast<Real>(i) - 90.0);
    const Real expected = std::exp(-2.0) * std::max(0.0, 1.0 - apart / 90.0);
    CHECK_THAT(footBotLight[i].Value, WithinAbs(expected, kRounding));
  }
}

}  // namespace shared_devices_test
