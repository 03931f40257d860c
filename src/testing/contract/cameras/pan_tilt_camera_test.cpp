// The pan-tilt head of the perspective camera.

#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pan_tilt_camera_actuator.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/support/statistics.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace pan_tilt_camera_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

// position of the camera of a foot-bot at the origin, m
const CVector3 kEye(kFootBotRadius, 0.0, 0.174249733);

SRobotExperiment WithHead(const std::string& arena, const std::string& attributes = "",
                          const std::string& children = "") {
  SRobotExperiment experiment;
  experiment.Actuators = "<pan_tilt_camera implementation=\"default\" " + attributes + ">" +
                         children + "</pan_tilt_camera>";
  experiment.Sensors =
      "<colored_blob_perspective_camera implementation=\"default\" medium=\"leds\"/>";
  experiment.Arena = Robot("foot-bot", "r", PoseText(CVector3())) + arena;
  return experiment;
}

CCI_PanTiltCameraActuator& Head(CRobotWorld& world) {
  return world.GetActuator<CCI_PanTiltCameraActuator>("r", "pan_tilt_camera");
}

CPerspectiveCameraEquippedEntity& Camera(CRobotWorld& world) {
  return world.Get<CFootBotEntity>("r").GetPerspectiveCameraEquippedEntity();
}

CRadians Degrees(Real degrees) {
  return ToRadians(CDegrees(degrees));
}

}  // namespace

TEST_CASE("pan tilt camera: a point on the optical axis is in the middle of the image",
          "[contract][cameras]") {
  const Real pan = GENERATE(0.0, 30.0, -120.0, 180.0);  // degrees
  const Real tilt = GENERATE(0.0, 25.0, -80.0, 90.0);
  CAPTURE(pan, tilt);
  const Real p = pan * M_PI / 180.0;
  const Real t = tilt * M_PI / 180.0;
  // positive angles are left and down; at 0.15 m the point is nearer than the ground
  const CVector3 direction(std::cos(t) * std::cos(p), std::cos(t) * std::sin(p), -std::sin(t));
  CRobotWorld world(WithHead(LightText("l", kEye + direction * 0.15)));
  auto& sensor = world.GetSensor<CCI_ColoredBlobPerspectiveCameraSensor>(
      "r", "colored_blob_perspective_camera");
  sensor.Enable();
  world.Step();
  // before the first order the camera sees 19 degrees up and down
  CHECK(sensor.GetReadings().BlobList.size() == (pan == 0.0 && tilt == 0.0 ? 1 : 0));
  Head(world).SetPan(Degrees(pan));
  Head(world).SetTilt(Degrees(tilt));
  world.Step();
  REQUIRE(sensor.GetReadings().BlobList.size() == 1);
  // a point in the middle is on the border of four pixels: rounding decides
  CHECK_THAT(sensor.GetReadings().BlobList[0]->X + 0.5, WithinAbs(320.0, 0.5));
  CHECK_THAT(sensor.GetReadings().BlobList[0]->Y + 0.5, WithinAbs(240.0, 0.5));
}

TEST_CASE("pan tilt camera: a panned camera stays level and has the image of a turned robot",
          "[contract][cameras]") {
  const Real pan = GENERATE(40.0, -77.0);  // degrees
  CAPTURE(pan);
  CRandomStream random(1, "test", "pan tilt camera", "places");
  std::string panned;
  std::string ahead;
  for (int i = 0; i < 20; ++i) {
    CVector3 point(1.0, random.Uniform(-0.5, 0.5), random.Uniform(-0.3, 0.3));
    ahead += LightText("l" + std::to_string(i), kEye + point);
    panned += LightText("l" + std::to_string(i), kEye + point.RotateZ(Degrees(pan)));
  }
  const auto look = [](CRobotWorld & world) -> const auto& {
    auto& sensor = world.GetSensor<CCI_ColoredBlobPerspectiveCameraSensor>(
        "r", "colored_blob_perspective_camera");
    sensor.Enable();
    world.Step();
    return sensor.GetReadings().BlobList;
  };
  CRobotWorld plain(WithHead(ahead));
  CRobotWorld world(WithHead(panned));
  Head(world).SetPan(Degrees(pan));
  const auto& expected = look(plain);
  const auto& blobs = look(world);
  CHECK(expected.size() > 5);
  REQUIRE(blobs.size() == expected.size());
  for (size_t i = 0; i < blobs.size(); ++i) {
    CHECK(blobs[i]->X == expected[i]->X);
    CHECK(blobs[i]->Y == expected[i]->Y);
  }
}

TEST_CASE("pan tilt camera: without a speed limit it reaches the order in the next tick",
          "[contract][cameras]") {
  CRobotWorld world(WithHead(""));
  Head(world).SetPan(Degrees(50.0));
  Head(world).SetTilt(Degrees(-10.0));
  CHECK(Camera(world).GetPan() == CRadians());
  world.Step();
  CHECK(Camera(world).GetPan() == Degrees(50.0));
  CHECK(Camera(world).GetTilt() == Degrees(-10.0));
  world.GetSimulator().Reset();
  CHECK(Camera(world).GetPan() == CRadians());
  CHECK(Camera(world).GetTilt() == CRadians());
  world.Step();
  CHECK(Camera(world).GetPan() == CRadians());
}

TEST_CASE("pan tilt camera: with a speed limit each axis moves independently",
          "[contract][cameras]") {
  // 60 degrees/s are 6 degrees per tick
  CRobotWorld world(WithHead("", "max_speed=\"60\""));
  Head(world).SetPan(Degrees(20.0));
  Head(world).SetTilt(Degrees(-9.0));
  for (const auto& [pan, tilt] :
       {std::pair<Real, Real>{6.0, -6.0}, {12.0, -9.0}, {18.0, -9.0}, {20.0, -9.0}}) {
    world.Step();
    CHECK_THAT(ToDegrees(Camera(world).GetPan()).GetValue(), WithinAbs(pan, 1e-12));
    CHECK_THAT(ToDegrees(Camera(world).GetTilt()).GetValue(), WithinAbs(tilt, 1e-12));
  }
  world.Step();
  CHECK(Camera(world).GetPan() == Degrees(20.0));
  // a new order during a motion takes effect at once
  Head(world).SetPan(Degrees(-50.0));
  world.Step(2);
  CHECK_THAT(ToDegrees(Camera(world).GetPan()).GetValue(), WithinAbs(8.0, 1e-12));
}

TEST_CASE("pan tilt camera: angles are clamped to the limits", "[contract][cameras]") {
  CRobotWorld world(WithHead("", "pan_range=\"-45:30\" tilt_range=\"0:20\""));
  const auto check = [&world](Real pan, Real tilt, Real expectedPan, Real expectedTilt) {
    Head(world).SetPan(Degrees(pan));
    Head(world).SetTilt(Degrees(tilt));
    world.Step();
    CHECK(Camera(world).GetPan() == Degrees(expectedPan));
    CHECK(Camera(world).GetTilt() == Degrees(expectedTilt));
  };
  check(29.0, 19.0, 29.0, 19.0);
  check(31.0, 21.0, 30.0, 20.0);
  check(-400.0, -1.0, -45.0, 0.0);
}

TEST_CASE("pan tilt camera: noise is drawn each time that an angle is set",
          "[contract][cameras][noise]") {
  constexpr int kDraws = 20000;
  CRobotWorld world(
      WithHead("", "", "<noise on=\"pan\" model=\"gaussian\" std_dev=\"0.1\" bias=\"0.05\"/>"));
  std::vector<Real> pans;
  for (int i = 0; i < kDraws; ++i) {
    Head(world).SetPan(CRadians(0.5));
    Head(world).SetTilt(CRadians(0.25));
    world.Step();
    pans.push_back(Camera(world).GetPan().GetValue());
    REQUIRE(Camera(world).GetTilt() == CRadians(0.25));
  }
  CHECK(KolmogorovSmirnovExcess(
            pans, [](Real pan) { return NormalDistribution(pan - 0.55, 0.1); }) < 1.0);
  const CRadians last = Camera(world).GetPan();
  world.Step(3);
  CHECK(Camera(world).GetPan() == last);
}

TEST_CASE("pan tilt camera: invalid orders and experiments are refused with the reason",
          "[contract][cameras][errors]") {
  const SInvalidAttributes c =
      GENERATE(SInvalidAttributes{"pan_range=\"10:20\"", "contains 0, got 10:20"},
               SInvalidAttributes{"tilt_range=\"-20:-10\"", "contains 0, got -20:-10"},
               SInvalidAttributes{"pan_range=\"-181:0\"", "-180:180"},
               SInvalidAttributes{"tilt_range=\"-5:91\"", "-90:90"},
               SInvalidAttributes{"max_speed=\"0\"", "max_speed"},
               SInvalidAttributes{"max_speed=\"-3\"", "> 0"});
  CAPTURE(c.Attributes);
  CHECK_THAT(LoadError(WithHead("", c.Attributes)),
             Contains(c.Reason) && Contains("test.argos:") && Contains("<pan_tilt_camera>"));
  CHECK(LoadError(WithHead("", "pan_range=\"-180:180\" tilt_range=\"-90:90\"")).empty());
  CRobotWorld world(WithHead(""));
  CHECK_THROWS_WITH(Head(world).SetPan(CRadians(std::numeric_limits<Real>::quiet_NaN())),
                    Contains("pan must be finite"));
  SRobotExperiment noCamera;
  noCamera.Actuators = "<pan_tilt_camera implementation=\"default\"/>";
  noCamera.Arena = Robot("e-puck", "ep0", PoseText(CVector3()));
  CHECK_THAT(LoadError(noCamera),
             Contains("ep0") && Contains("no component \"perspective_camera\""));
}

}  // namespace pan_tilt_camera_test
