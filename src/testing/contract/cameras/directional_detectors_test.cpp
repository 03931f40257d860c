// Directional LEDs and tags in the images of cameras.

#include "pinhole.h"

#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_algorithms/ci_camera_sensor_directional_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_tag_detector_algorithm.h>
#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/robot_sizes.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace directional_detectors_test {

using namespace argos;
using Catch::Matchers::WithinAbs;

namespace {

// tolerance of some roundings of a few thousand pixels
constexpr Real kRounding = 1e-9;

template <typename ALGORITHM>
const auto& Look(CRobotWorld& world) {
  auto& sensor = world.GetSensor<CCI_CameraSensor>("r", "cameras");
  sensor.Enable();
  world.Step();
  return dynamic_cast<ALGORITHM&>(*sensor.GetInterfaces()[0].Algorithms[0]).GetReadings();
}

const auto& LookAtLEDs(CRobotWorld& world) {
  return Look<CCI_CameraSensorDirectionalLEDDetectorAlgorithm>(world);
}

const auto& LookAtTags(CRobotWorld& world) {
  return Look<CCI_CameraSensorTagDetectorAlgorithm>(world);
}

// A foot-bot with an LED on its back, 9 cm behind its centre and as high as the camera. The robot
// faces away, turned by an angle.
std::string RobotWithLED(Real distance, Real turnDegrees, Real observableAngle,
                         const std::string& color = "red") {
  return Carrier("a", CVector3(0.1 + distance, 0.0, 0.0), turnDegrees,
                 "<directional_leds medium=\"directional_leds\"><directional_led "
                 "position=\"-0.09,0,0.15\" orientation=\"0,-90,0\" anchor=\"origin\" "
                 "observable_angle=\"" +
                     ToText(observableAngle) + "\" color=\"" + color + "\"/></directional_leds>");
}

SPinhole LevelCamera() {
  SPinhole camera;
  camera.Offset = CVector3(0.1, 0.0, 0.15);
  return camera;
}

SRobotExperiment WatchLEDs(const std::string& arena) {
  const SPinhole camera = LevelCamera();
  return WithCameras(camera.ToXml("<directional_led_detector medium=\"directional_leds\"/>"),
                     camera.RobotXml() + arena);
}

// A robot with a tag above it that its body does not occlude.
// @param yaw  of the tag's face from the direction to the camera, degrees
std::string RobotWithTag(const CVector3& place, Real yaw, Real sideLength,
                         const std::string& payload = "hello", Real observableAngle = 75.0) {
  // with a yaw of 180 degrees the robot faces the camera; the tag can
  // be read from ahead of the robot
  return Carrier("a", CVector3(place.GetX(), place.GetY(), 0.0), 180.0 + yaw,
                 "<tags medium=\"tags\"><tag position=\"0,0," + ToText(place.GetZ()) +
                     "\" orientation=\"90,90,0\" anchor=\"origin\" observable_angle=\"" +
                     ToText(observableAngle) + "\" side_length=\"" + ToText(sideLength) +
                     "\" payload=\"" + payload + "\"/></tags>");
}

SRobotExperiment WatchTags(const std::string& arena, const SPinhole& camera = LevelCamera()) {
  return WithCameras(camera.ToXml("<tag_detector medium=\"tags\"/>"), camera.RobotXml() + arena);
}

}  // namespace

TEST_CASE("directional led detector: detects LEDs that shine towards the camera",
          "[contract][cameras]") {
  // The robot is turned by t about its centre. The LED is 9 cm from it and shines in the direction
  // straight back plus t; from the LED, the camera is at the angle t + asin(...).
  const Real turn = GENERATE(0.0, 20.0, -35.0);  // degrees
  const Real distance = 1.0;
  const Real t = turn * M_PI / 180.0;
  const CVector3 led(distance - 0.09 * std::cos(t), -0.09 * std::sin(t), 0.0);
  const Real away = std::abs(std::remainder(std::atan2(-led.GetY(), -led.GetX()) -
                                                std::atan2(-std::sin(t), -std::cos(t)),
                                            2.0 * M_PI)) *
                    180.0 / M_PI;
  const Real excess = GENERATE(-1e-9, 1e-9);  // degrees, of the cone beyond that angle
  CAPTURE(turn, away, excess);
  if (away + excess <= 0.0) {
    WARN("skipped: a cone has a positive angle");
    return;
  }
  CRobotWorld world(WatchLEDs(RobotWithLED(distance, turn, std::max(away + excess, 1e-6))));
  const auto& readings = LookAtLEDs(world);
  const bool seen = away == 0.0 || excess > 0.0;
  REQUIRE(readings.size() == (seen ? 1 : 0));
  if (seen) {
    CHECK(readings[0].Color == CColor::RED);
    CHECK_THAT(readings[0].Center.GetX(),
               WithinAbs(320.0 - 500.0 * led.GetY() / led.GetX(), kRounding));
    CHECK_THAT(readings[0].Center.GetY(), WithinAbs(230.0, kRounding));
  }
}

TEST_CASE("directional led detector: ignores black LEDs, those turned away and occluded ones",
          "[contract][cameras]") {
  struct SCase {
    std::string Arena;
    size_t Seen;
  };
  const SCase c = GENERATE(
      SCase{RobotWithLED(1.0, 0.0, 60.0), 1}, SCase{RobotWithLED(1.0, 0.0, 60.0, "black"), 0},
      SCase{RobotWithLED(1.0, 180.0, 60.0), 0},
      // with a cone of 180 degrees the LED is visible over its robot, which is 14.7 cm high
      SCase{RobotWithLED(1.0, 180.0, 180.0), 1},
      SCase{RobotWithLED(1.0, 0.0, 60.0) +
                BoxText("w", CVector3(0.1, 0.1, 0.151), CVector3(0.5, 0.0, 0.0)),
            0},
      SCase{RobotWithLED(1.0, 0.0, 60.0) +
                BoxText("w", CVector3(0.1, 0.1, 0.149), CVector3(0.5, 0.0, 0.0)),
            1});
  CAPTURE(c.Arena);
  CRobotWorld world(WatchLEDs(c.Arena));
  CHECK(LookAtLEDs(world).size() == c.Seen);
}

TEST_CASE("tag detector: reads payload, centre and corners", "[contract][cameras]") {
  const Real yaw = GENERATE(0.0, 30.0, -60.0);  // degrees
  CAPTURE(yaw);
  const Real y = yaw * M_PI / 180.0;
  const CVector3 center(0.8, 0.1, 0.25);  // world frame, m
  const Real half = 0.03;
  SPinhole camera = LevelCamera();
  CRobotWorld world(WatchTags(RobotWithTag(center, yaw, 2.0 * half), camera));
  const auto& readings = LookAtTags(world);
  REQUIRE(readings.size() == 1);
  CHECK(readings[0].Payload == "hello");
  // The tag's frame: x to the right of its reader, y up, z towards the reader. With a yaw of 0
  // these are -y, z and -x of the world.
  const auto pixel = [&](Real x, Real up) {
    const CVector3 place = center + CVector3(x * std::sin(y), -x * std::cos(y), up);
    const CVector3 fromCamera = place - camera.Offset;
    return camera.Project(CVector3(-fromCamera.GetY(), -fromCamera.GetZ(), fromCamera.GetX()));
  };
  const auto check = [](const CVector2& seen, const CVector2& expected) {
    CHECK_THAT(seen.GetX(), WithinAbs(expected.GetX(), kRounding));
    CHECK_THAT(seen.GetY(), WithinAbs(expected.GetY(), kRounding));
  };
  check(readings[0].Center, pixel(0.0, 0.0));
  check(readings[0].Corners[0], pixel(half, half));
  check(readings[0].Corners[1], pixel(-half, half));
  check(readings[0].Corners[2], pixel(-half, -half));
  check(readings[0].Corners[3], pixel(half, -half));
}

TEST_CASE("tag detector: reads a tag from within its observable angle", "[contract][cameras]") {
  const Real turn = GENERATE(30.0, -50.0);
  const Real excess = GENERATE(-1e-9, 1e-9);
  CAPTURE(turn, excess);
  // the tag is straight ahead of the camera and at its height, so its yaw is the angle of view
  SPinhole camera;
  camera.Offset = CVector3(0.1, 0.0, 0.25);
  CRobotWorld world(WatchTags(
      RobotWithTag(CVector3(0.8, 0.0, 0.25), turn, 0.02, "x", std::abs(turn) + excess), camera));
  CHECK(LookAtTags(world).size() == (excess > 0.0 ? 1 : 0));
}

TEST_CASE("tag detector: reads tags only if all corners are in the picture and in sight",
          "[contract][cameras]") {
  const SPinhole camera = LevelCamera();
  const Real half = 0.03;
  const CVector3 center(0.8, 0.0, 0.25);
  SECTION("a wall occludes a corner") {
    // The lower corners are at a height of 0.22 m, 0.7 m from the camera at 0.15 m: at the near
    // face of a wall, 0.3 m away, the rising line of sight is at 0.15 + 0.07 * 0.3 / 0.7.
    const Real grazing = 0.15 + 0.07 * 0.3 / 0.7;
    const Real excess = GENERATE(-1e-9, 1e-9);
    // the wall is to the left and occludes one lower corner only
    CRobotWorld world(
        WatchTags(RobotWithTag(center, 0.0, 2.0 * half) +
                  BoxText("w", CVector3(0.1, 0.1, grazing + excess), CVector3(0.45, 0.06, 0.0))));
    CHECK(LookAtTags(world).size() == (excess < 0.0 ? 1 : 0));
  }
  SECTION("a corner is outside the picture") {
    // at a distance of 0.7 m the left border of the picture is 0.448 m to the left
    const Real excess = GENERATE(-1e-9, 1e-9);
    CRobotWorld world(WatchTags(
        RobotWithTag(CVector3(0.8, 0.448 - half + excess, 0.25), 0.0, 2.0 * half), camera));
    CHECK(LookAtTags(world).size() == (excess < 0.0 ? 1 : 0));
  }
}

TEST_CASE("tag detector: reads tags flush with the surface of bodies", "[contract][cameras]") {
  // the tag is in a plane tangent to the foot-bot's round body at the middle of its back
  const auto tag = [](const std::string& orientation) {
    return Carrier("a", CVector3(0.8, 0.0, 0.0), 0.0,
                   "<tags medium=\"tags\"><tag position=\"" +
                       ToText(CVector3(-kFootBotRadius, 0.0, 0.1)) + "\" orientation=\"" +
                       orientation +
                       "\" anchor=\"origin\" observable_angle=\"80\" side_length=\"0.04\" "
                       "payload=\"back\"/></tags>");
  };
  CRobotWorld world(WatchTags(tag("0,-90,0")));
  REQUIRE(LookAtTags(world).size() == 1);
  CHECK(LookAtTags(world)[0].Payload == "back");
  // the same tag facing the inside of the robot
  CRobotWorld turned(WatchTags(tag("0,90,0")));
  CHECK(LookAtTags(turned).empty());
}

TEST_CASE("tag detector: mirrored worlds give mirrored centres and corners",
          "[contract][cameras]") {
  const Real side = GENERATE(-1.0, 1.0);
  const SPinhole camera = LevelCamera();
  CRobotWorld world(
      WatchTags(RobotWithTag(CVector3(0.8, side * 0.2, 0.25), side * 25.0, 0.05), camera));
  const auto& readings = LookAtTags(world);
  REQUIRE(readings.size() == 1);
  CHECK_THAT(readings[0].Center.GetX(), WithinAbs(320.0 - side * 500.0 * 0.2 / 0.7, kRounding));
  // mirroring exchanges left and right corners: 0 and 1, 3 and 2
  static Real right = 0.0;
  if (side < 0.0) {
    right = readings[0].Corners[0].GetX();
  } else {
    CHECK_THAT(readings[0].Corners[1].GetX(), WithinAbs(640.0 - right, kRounding));
  }
}

TEST_CASE("tag detector: payloads of any length are read in steady state without allocations",
          "[contract][cameras][allocation]") {
  std::string arena;
  for (int i = 0; i < 5; ++i) {
    std::string robot = RobotWithTag(CVector3(0.8, 0.25 * (i - 2), 0.25), 0.0, 0.05,
                                     std::string(20 * (i + 1), 'x'));
    robot.replace(robot.find("\"a\""), 3, "\"a" + std::to_string(i) + "\"");
    arena += robot;
  }
  CRobotWorld world(WatchTags(arena));
  for (int i = 0; i < 20; ++i) {
    REQUIRE(LookAtTags(world).size() == 3);
  }
  CheckAllocatesNothing([&] { world.Step(10); });
}

}  // namespace directional_detectors_test
