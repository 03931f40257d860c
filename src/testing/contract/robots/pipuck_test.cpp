// The Pi-Puck: its parts, its devices in C++ and Lua, and its drive in every engine.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_differential_drive_actuator.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_differential_drive_sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_front_camera_sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_ground_sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_imu_sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_leds_actuator.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_rangefinders_sensor.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_entity.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <vector>

namespace pipuck_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kInterwheelDistance = 0.0565;  // m, of dynamics2d of ARGoS 3

SRobotExperiment PiPuck(const std::string& arena = "") {
  SRobotExperiment experiment;
  experiment.Actuators =
      "<pipuck_differential_drive implementation='default'/><pipuck_leds "
      "implementation='default'/>";
  experiment.Sensors =
      "<pipuck_differential_drive implementation='default'/>"
      "<pipuck_rangefinders implementation='default'/><pipuck_ground implementation='default'/>"
      "<pipuck_system implementation='default'/><pipuck_imu implementation='default'/>"
      "<pipuck_front_camera implementation='default' tag_medium='tags' "
      "directional_led_medium='dl'/>";
  experiment.Media = "<tag id='tags'/><directional_led id='dl'/><simple_radio id='wifi'/>";
  experiment.Arena =
      "<floor id='floor' source='loop_functions' pixels_per_meter='10'/>"
      "<pipuck id='r' wifi_medium='wifi' led_medium='dl'><body position='0,0,0'/>"
      "<controller config='c'/></pipuck>" +
      arena;
  return experiment;
}

void Drive(CRobotWorld& world, Real left, Real right) {
  world.GetActuator<CCI_PiPuckDifferentialDriveActuator>("r", "pipuck_differential_drive")
      .SetLinearVelocity(left, right);
}

const SAnchor& Origin(CRobotWorld& world) {
  return world.Get<CPiPuckEntity>("r").GetEmbodiedEntity().GetOriginAnchor();
}

std::vector<Real> Ranges(CRobotWorld& world) {
  std::vector<Real> ranges;
  world.GetSensor<CCI_PiPuckRangefindersSensor>("r", "pipuck_rangefinders")
      .Visit([&ranges](const CCI_PiPuckRangefindersSensor::SInterface& sensor) {
        CHECK(sensor.Label == ranges.size());
        ranges.push_back(sensor.Proximity);
      });
  return ranges;
}

}  // namespace

TEST_CASE("pi-puck: components, anchors and LEDs are those of ARGoS 3", "[contract][robots]") {
  CRobotWorld world(PiPuck());
  auto& robot = world.Get<CPiPuckEntity>("r");
  std::vector<std::string> components;
  for (CEntity* component : robot.GetComponentVector()) {
    components.push_back(component->GetTypeDescription() + " " + component->GetId());
  }
  CHECK(components ==
        std::vector<std::string>{"body body_0", "differential_drive differential_drive_0",
                                 "simple_radios simple_radios_0", "directional_leds leds_0",
                                 "controller controller_0"});
  for (const char* anchor : {"body", "left_wheel", "right_wheel", "origin"}) {
    CHECK(robot.GetEmbodiedEntity().IsAnchorEnabled(anchor));
  }
  CHECK(robot.GetEmbodiedEntity().GetAnchor("left_wheel").OffsetPosition.GetY() == 0.0255);
  auto& leds = robot.GetDirectionalLEDEquippedEntity();
  REQUIRE(leds.GetInstances().size() == 10);
  CHECK(leds.GetLED(0).GetId() == "ring_led_0");
  CHECK(leds.GetLED(8).GetId() == "front_led");
  CHECK(leds.GetLED(9).GetId() == "body_led");
  CHECK_THAT(ToDegrees(leds.GetLED(3).GetObservableAngle()).GetValue(), WithinAbs(60.0, 1e-9));
  CHECK(robot.GetSimpleRadioEquippedEntity().GetInstances().size() == 1);
  CHECK(robot.GetSimpleRadioEquippedEntity().GetRadio(0).GetRange() == 10.0);
}

TEST_CASE("pi-puck: it drives alike in every engine", "[contract][robots]") {
  const char* const engines[] = {"<dynamics2d id='e'/>", "<kinematics2d id='e'/>",
                                 "<dynamics3d id='e'/>", "<pointmass3d id='e'/>"};
  for (const char* const engine : engines) {
    CAPTURE(engine);
    SRobotExperiment experiment = PiPuck();
    experiment.Engine = engine;
    CRobotWorld world(experiment);
    auto& drive = world.Get<CPiPuckEntity>("r").GetDifferentialDriveEntity();
    Drive(world, 0.1, 0.1);
    world.Step(3);
    const Real before = Origin(world).Position.GetX();
    world.Step();
    // 0.1 m/s in 0.1 s
    CHECK_THAT(Origin(world).Position.GetX() - before, WithinAbs(0.01, 1e-4));
    CHECK_THAT(drive.GetVelocityLeft(), WithinAbs(0.1, 1e-3));
    CHECK(drive.GetTargetVelocityRight() == 0.1);
    Drive(world, -0.01, 0.01);
    world.Step(3);
    const CQuaternion heading = Origin(world).Orientation;
    world.Step();
    CRadians angle;
    CVector3 axis;
    (heading.Inverse() * Origin(world).Orientation).ToAngleAxis(angle, axis);
    CHECK_THAT(angle.GetValue() * axis.GetZ(), WithinAbs(0.1 * 0.02 / kInterwheelDistance, 1e-4));
    auto& encoders =
        world.GetSensor<CCI_PiPuckDifferentialDriveSensor>("r", "pipuck_differential_drive");
    CHECK_THAT(encoders.GetLeftVelocity(), WithinAbs(-0.01, 1e-4));
    CHECK_THAT(encoders.GetRightVelocity(), WithinAbs(0.01, 1e-4));
    world.GetSimulator().Reset();
    CHECK(drive.GetTargetVelocityRight() == 0.0);
    CHECK(drive.GetVelocityLeft() == 0.0);
  }
}

TEST_CASE("pi-puck: range sensors read distances in metres", "[contract][robots]") {
  // the face of the box is 5 cm to the left of the sensor at y = 0.035
  CRobotWorld world(
      PiPuck("<box id='b' size='0.1,0.1,0.1' movable='false'>"
             "<body position='0,0.135,0'/></box>"));
  CHECK(Ranges(world) == std::vector<Real>(8, 0.0));
  world.Step();
  const std::vector<Real> ranges = Ranges(world);
  REQUIRE(ranges.size() == 8);
  CHECK_THAT(ranges[5], WithinAbs(0.05, 1e-9));
  CHECK(ranges[0] == 0.1);
  CHECK(ranges[2] == 0.1);
  world.GetSimulator().Reset();
  CHECK(Ranges(world) == std::vector<Real>(8, 0.1));
}

TEST_CASE("pi-puck: ground sensors read the floor below them", "[contract][robots]") {
  CRobotWorld world(PiPuck());
  world.Step();
  size_t count = 0;
  world.GetSensor<CCI_PiPuckGroundSensor>("r", "pipuck_ground")
      .Visit([&count](const CCI_PiPuckGroundSensor::SInterface& sensor) {
        CHECK(sensor.Reflected == 1.0);
        CHECK(sensor.Background == 0.0);
        ++count;
      });
  CHECK(count == 3);
  SRobotExperiment withoutFloor = PiPuck();
  withoutFloor.Arena = Robot("pipuck", "r", "position='0,0,0'");
  CHECK_THAT(LoadError(withoutFloor), Contains("needs a floor"));
}

TEST_CASE("pi-puck: the front LED is in front, and the ring has eight", "[contract][robots]") {
  CRobotWorld world(PiPuck());
  auto& actuator = world.GetActuator<CCI_PiPuckLEDsActuator>("r", "pipuck_leds");
  auto& leds = world.Get<CPiPuckEntity>("r").GetDirectionalLEDEquippedEntity();
  actuator.SetRingLEDIndex(2, true);
  actuator.SetFrontLED(true);
  actuator.SetRingLEDIndex(8, true);
  CHECK_THAT(TakeLogErr(),
             Contains("there is no LED 8 in the ring; they are numbered from 0 to 7"));
  world.Step();
  for (UInt32 i = 0; i < 10; ++i) {
    CHECK(leds.GetLED(i).GetColor() == (i == 2 || i == 8 ? CColor::WHITE : CColor::BLACK));
  }
  CHECK(leds.GetLED(8).GetPosition().GetX() > 0.02);
  actuator.SetRingLEDs(true);
  actuator.SetBodyLED(true);
  world.Step();
  for (UInt32 i = 0; i < 10; ++i) {
    CHECK(leds.GetLED(i).GetColor() == CColor::WHITE);
  }
}

TEST_CASE("pi-puck: the camera finds tags and LEDs in its frame", "[contract][robots]") {
  // at (-0.000275, 0.03, 0.185925) of the camera, as measured in ARGoS 3: x down, y left, z ahead;
  // it shows its back to +x, so it is turned to face the camera
  const std::string tag =
      "<prototype id='p' movable='false'><body position='0.222225,0.03,0'/>"
      "<links ref='base'><link id='base' geometry='box' size='0.001,0.001,0.001' mass='1'"
      " position='0,0,0.01'/></links><devices><tags medium='tags'>"
      "<tag anchor='origin' position='0,0,0.027775' orientation='0,-90,0' observable_angle='75'"
      " side_length='0.02' payload='42 things'/></tags></devices></prototype>";
  CRobotWorld world(PiPuck(tag));
  auto& camera = world.GetSensor<CCI_PiPuckFrontCameraSensor>("r", "pipuck_front_camera");
  CHECK_THAT(camera.GetTimestamp(), WithinAbs(0.1, 1e-12));
  world.Step();
  CHECK(camera.GetTags().empty());
  camera.Enable();
  world.Step();
  CHECK_THAT(camera.GetTimestamp(), WithinAbs(0.3, 1e-12));
  REQUIRE(camera.GetTags().size() == 1);
  const CCI_PiPuckFrontCameraSensor::STag& found = camera.GetTags()[0];
  CHECK(found.Id == 42);
  CHECK_THAT(found.Position.GetX(), WithinAbs(-0.000275, 1e-9));
  CHECK_THAT(found.Position.GetY(), WithinAbs(0.03, 1e-9));
  CHECK_THAT(found.Position.GetZ(), WithinAbs(0.185925, 1e-9));
  CHECK_THAT(found.Center.GetX(), WithinAbs(318.521, 1e-3));
  CHECK_THAT(found.Center.GetY(), WithinAbs(401.355, 1e-3));
  CHECK(camera.DetectLed(found.Position) == CCI_PiPuckFrontCameraSensor::ELedState::OFF);
  camera.Disable();
  CHECK(camera.GetTags().empty());
}

TEST_CASE("pi-puck: the camera sees no tag from behind, behind it, too near or too far",
          "[contract][robots]") {
  // a tag at a distance in front of the camera, m, turned about z, degrees
  const auto [distance, turn, isSeen] = GENERATE(table<Real, Real, bool>({{0.2, 0.0, true},
                                                                          {0.2, 180.0, false},
                                                                          {0.2, 80.0, false},
                                                                          {-0.2, 180.0, false},
                                                                          {-0.2, 0.0, false},
                                                                          {0.49, 0.0, true},
                                                                          {0.51, 0.0, false},
                                                                          {0.011, 0.0, true},
                                                                          {0.009, 0.0, false}}));
  CAPTURE(distance, turn);
  std::ostringstream tag;
  tag << "<prototype id='p' movable='false'><body position='" << 0.0363 + distance
      << ",0,0' orientation='" << turn << ",0,0'/><links ref='base'><link id='base' "
      << "geometry='box' size='0.001,0.001,0.001' mass='1' position='0,0,0.0005'/></links>"
      << "<devices><tags medium='tags'><tag anchor='origin' position='0,0,0.0275' "
      << "orientation='0,-90,0' observable_angle='75' side_length='0.001' payload='42'/></tags>"
      << "</devices></prototype>";
  CRobotWorld world(PiPuck(tag.str()));
  auto& camera = world.GetSensor<CCI_PiPuckFrontCameraSensor>("r", "pipuck_front_camera");
  camera.Enable();
  world.Step();
  CHECK(camera.GetTags().size() == (isSeen ? 1 : 0));
}

TEST_CASE("pi-puck: what its devices cannot do is an error", "[contract][robots]") {
  CRobotWorld world(PiPuck());
  CHECK_THROWS_WITH(Drive(world, std::nan(""), 0.1), Contains("wheel speeds must be finite"));
  CHECK_THROWS_WITH(Drive(world, 0.1, HUGE_VAL), Contains("wheel speeds must be finite"));
  SRobotExperiment experiment = PiPuck();
  const std::string attribute = GENERATE("focal_length='0,1000'", "resolution='640,-480'");
  experiment.Sensors =
      "<pipuck_front_camera implementation='default' tag_medium='tags' "
      "directional_led_medium='dl' " +
      attribute + "/>";
  CHECK_THAT(LoadError(experiment), Contains("must be two numbers > 0"));
}

TEST_CASE("pi-puck: the camera tells the colour of an LED", "[contract][robots]") {
  using TState = CCI_PiPuckFrontCameraSensor::ELedState;
  const std::pair<const char*, TState> states[] = {{"magenta", TState::Q1}, {"orange", TState::Q2},
                                                   {"green", TState::Q3},   {"blue", TState::Q4},
                                                   {"white", TState::OFF},  {"black", TState::OFF}};
  for (const auto& [color, state] : states) {
    CAPTURE(color);
    CRobotWorld world(
        PiPuck("<prototype id='p' movable='false'><body position='0.1363,0,0'/><links ref='base'>"
               "<link id='base' geometry='box' size='0.001,0.001,0.001' mass='1'/></links><devices>"
               "<directional_leds medium='dl'><directional_led anchor='origin'"
               " position='0,0,0.0275' orientation='0,-90,0' observable_angle='80' color='" +
               std::string(color) + "'/></directional_leds></devices></prototype>"));
    auto& camera = world.GetSensor<CCI_PiPuckFrontCameraSensor>("r", "pipuck_front_camera");
    camera.Enable();
    world.Step();
    CHECK(camera.DetectLed(CVector3(0.0, 0.0, 0.1)) == state);
    CHECK(camera.DetectLed(CVector3(0.0, 0.0, 0.12)) == TState::OFF);
  }
}

TEST_CASE("pi-puck: the inertial unit reads weight and turning", "[contract][robots]") {
  SRobotExperiment experiment = PiPuck();
  experiment.Engine = "<kinematics2d id='e'/>";
  CRobotWorld world(experiment);
  Drive(world, -0.01, 0.01);
  world.Step(3);
  auto& imu = world.GetSensor<CCI_PiPuckImuSensor>("r", "pipuck_imu");
  CHECK_THAT(imu.GetGryoscope().GetZ(), WithinAbs(0.02 / kInterwheelDistance, 1e-6));
  CHECK_THAT(imu.GetAccelerometer().GetZ(), WithinAbs(9.81, 1e-9));
  CHECK_THAT(imu.GetAccelerometer().GetX(), WithinAbs(0.0, 1e-6));
  CHECK(imu.GetMagnetometer() == CVector3());
}

TEST_CASE("pi-puck: devices that need other parts do not fit", "[contract][robots]") {
  for (const char* sensor :
       {"<proximity implementation='default'/>", "<battery implementation='default'/>"}) {
    SRobotExperiment experiment = PiPuck();
    experiment.Sensors = sensor;
    CHECK_THAT(LoadError(experiment), Contains("pipuck"));
  }
}

}  // namespace pipuck_test
