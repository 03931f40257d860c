// Compares the LED detector of the sensor "cameras" with the equations of a pinhole camera.

#include "pinhole.h"

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/simulator/entities/led_entity.h>
#include <argos3/testing/support/sight_reference.h>
#include <argos3/testing/support/statistics.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <cmath>

namespace led_detector_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

using TReadings = std::vector<CCI_CameraSensorLEDDetectorAlgorithm::SReading>;

const char* const kDetector = "<led_detector medium=\"leds\"/>";
// tolerance of some roundings of a few thousand pixels
constexpr Real kRounding = 1e-9;

CCI_CameraSensor& Cameras(CRobotWorld& world) {
  return world.GetSensor<CCI_CameraSensor>("r", "cameras");
}

const TReadings& Readings(CRobotWorld& world, size_t camera = 0, size_t algorithm = 0) {
  return dynamic_cast<CCI_CameraSensorLEDDetectorAlgorithm&>(
             *Cameras(world).GetInterfaces()[camera].Algorithms[algorithm])
      .GetReadings();
}

const TReadings& Look(CRobotWorld& world) {
  Cameras(world).Enable();
  world.Step();
  return Readings(world);
}

}  // namespace

TEST_CASE("led detector: pixels follow the equations of a pinhole camera on any robot",
          "[contract][cameras]") {
  const std::string tag = GENERATE("foot-bot", "e-puck", "eye-bot");
  CRandomStream random(1, "test", "led detector", "places");
  size_t seenInAll = 0;
  for (int trial = 0; trial < 20; ++trial) {
    CAPTURE(tag, trial);
    SPinhole camera;
    camera.Robot = CVector3(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0), 0.0);
    camera.Yaw = random.Uniform(-180.0, 180.0);
    std::string arena = camera.RobotXml(tag);
    std::vector<CVector3> seen;
    for (int i = 0; i < 60; ++i) {
      const CVector3 p(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0),
                       random.Uniform(-0.5, 2.5));
      arena += LightText("l" + std::to_string(i), camera.ToWorld(p), "1,2,3,4");
      if (camera.Contains(p)) {
        seen.push_back(p);
      }
    }
    CRobotWorld world(WithCameras(camera.ToXml(kDetector), arena));
    const TReadings& readings = Look(world);
    REQUIRE(readings.size() == seen.size());
    for (size_t i = 0; i < seen.size(); ++i) {
      CHECK_THAT(readings[i].Center.GetX(), WithinAbs(camera.Project(seen[i]).GetX(), kRounding));
      CHECK_THAT(readings[i].Center.GetY(), WithinAbs(camera.Project(seen[i]).GetY(), kRounding));
      CHECK(readings[i].Color == CColor(1, 2, 3, 4));
    }
    seenInAll += seen.size();
  }
  CHECK(seenInAll > 200);
}

TEST_CASE("led detector: a camera may have any orientation", "[contract][cameras]") {
  CRandomStream random(2, "test", "led detector", "mounts");
  const auto turn = [](Real degrees, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(degrees * M_PI / 180.0, axis);
  };
  size_t seenInAll = 0;
  for (int trial = 0; trial < 20; ++trial) {
    CAPTURE(trial);
    const Real z = random.Uniform(-180.0, 180.0);
    const Real y = random.Uniform(-90.0, 90.0);
    const Real x = random.Uniform(-180.0, 180.0);
    // rotations about fixed axes: first z, then y, then x
    const Eigen::Matrix3d mount =
        (turn(x, Eigen::Vector3d::UnitX()) * turn(y, Eigen::Vector3d::UnitY()) *
         turn(z, Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    std::string arena = Robot("foot-bot", "r", PoseText(CVector3()));
    std::vector<Eigen::Vector3d> seen;
    for (int i = 0; i < 40; ++i) {
      const Eigen::Vector3d p(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0),
                              random.Uniform(-1.0, 1.0));
      const Eigen::Vector3d place = mount * p + Eigen::Vector3d(0.1, 0.2, 0.5);
      arena += LightText("l" + std::to_string(i), CVector3(place.x(), place.y(), place.z()));
      if (p.z() >= 0.1 && std::abs(100.0 * p.x() / p.z()) < 100.0 &&
          std::abs(100.0 * p.y() / p.z()) < 100.0) {
        seen.push_back(p);
      }
    }
    CRobotWorld world(
        WithCameras("<camera id=\"c\" anchor=\"origin\" position=\"0.1,0.2,0.5\" orientation=\"" +
                        ToText(z) + "," + ToText(y) + "," + ToText(x) +
                        "\" range=\"0.1:9\" focal_length=\"100,100\" principal_point=\"100,100\" "
                        "resolution=\"200,200\">" +
                        kDetector + "</camera>",
                    arena));
    const TReadings& readings = Look(world);
    REQUIRE(readings.size() == seen.size());
    for (size_t i = 0; i < seen.size(); ++i) {
      CHECK_THAT(readings[i].Center.GetX(),
                 WithinAbs(100.0 + 100.0 * seen[i].x() / seen[i].z(), kRounding));
      CHECK_THAT(readings[i].Center.GetY(),
                 WithinAbs(100.0 + 100.0 * seen[i].y() / seen[i].z(), kRounding));
    }
    seenInAll += seen.size();
  }
  CHECK(seenInAll > 50);
}

TEST_CASE("led detector: LEDs beyond the picture's borders or the range are not detected",
          "[contract][cameras]") {
  struct SCase {
    Real U, V, Depth;
    bool Seen;
  };
  const SCase c = GENERATE(
      SCase{1e-6, 1.0, 1.0, true}, SCase{-1e-6, 1.0, 1.0, false}, SCase{639.999999, 1.0, 1.0, true},
      SCase{640.000001, 1.0, 1.0, false}, SCase{1.0, 1e-6, 1.0, true},
      SCase{1.0, -1e-6, 1.0, false}, SCase{1.0, 479.999999, 1.0, true},
      SCase{1.0, 480.000001, 1.0, false}, SCase{320.0, 200.0, 0.05 + 1e-9, true},
      SCase{320.0, 200.0, 0.05 - 1e-9, false}, SCase{320.0, 200.0, 2.0 - 1e-9, true},
      SCase{320.0, 200.0, 2.0 + 1e-9, false}, SCase{320.0, 200.0, -1.0, false});
  CAPTURE(c.U, c.V, c.Depth);
  SPinhole camera;
  camera.Robot = CVector3(0.3, -0.2, 0.0);
  camera.Yaw = 200.0;
  CRobotWorld world(
      WithCameras(camera.ToXml(kDetector),
                  camera.RobotXml() + LightText("l", camera.ToWorld(camera.At(c.U, c.V, c.Depth))) +
                      LightText("black", camera.ToWorld(camera.At(300.0, 200.0, 1.0)), "black")));
  CHECK(Look(world).size() == (c.Seen ? 1 : 0));
}

TEST_CASE("led detector: equals brute force among many bodies and lights", "[contract][cameras]") {
  CRandomStream random(3, "test", "led detector", "crowd");
  size_t seenInAll = 0;
  size_t hiddenInAll = 0;
  for (int trial = 0; trial < 10; ++trial) {
    CAPTURE(trial);
    SPinhole camera;
    camera.Yaw = random.Uniform(-180.0, 180.0);
    std::string arena = camera.RobotXml();
    for (int i = 0; i < 14; ++i) {
      CVector3 place =
          camera.ToWorld(CVector3(random.Uniform(-0.8, 0.8), 0.0, random.Uniform(0.1, 1.5)));
      place.SetZ(0.0);
      const Real height = random.Uniform(0.02, 0.4);
      arena += i % 2 == 0
                   ? PillarText("p" + std::to_string(i), place.GetX(), place.GetY(), 0.04, height)
                   : BoxText("b" + std::to_string(i), CVector3(0.05, 0.1, height), place,
                             random.Uniform(-180.0, 180.0));
    }
    std::vector<CVector3> points;
    for (int i = 0; i < 60; ++i) {
      points.push_back(camera.At(random.Uniform(0.0, 640.0), random.Uniform(0.0, 480.0),
                                 random.Uniform(0.1, 1.9)));
      arena += LightText("l" + std::to_string(i), camera.ToWorld(points.back()));
    }
    CRobotWorld world(WithCameras(camera.ToXml(kDetector), arena));
    const TReadings& readings = Look(world);
    std::vector<CVector3> seen;
    for (const CVector3& point : points) {
      const bool inSight = ReferenceInSight(world.GetSpace(), camera.ToWorld(CVector3()),
                                            camera.ToWorld(point), "r");
      hiddenInAll += inSight ? 0 : 1;
      if (inSight) {
        seen.push_back(point);
      }
    }
    seenInAll += seen.size();
    REQUIRE(readings.size() == seen.size());
    for (size_t i = 0; i < seen.size(); ++i) {
      CHECK_THAT(readings[i].Center.GetX(), WithinAbs(camera.Project(seen[i]).GetX(), kRounding));
    }
  }
  CHECK(seenInAll > 50);
  CHECK(hiddenInAll > 50);
}

TEST_CASE("led detector: mirrored worlds give mirrored pictures, turned worlds equal ones",
          "[contract][cameras]") {
  const bool mirrored = GENERATE(false, true);
  const Real yaw = GENERATE(0.0, 90.0, -70.0);
  CAPTURE(mirrored, yaw);
  const auto build = [](bool mirror, Real degrees) {
    SPinhole camera;
    camera.Offset = CVector3(0.1, 0.0, 0.15);
    camera.Yaw = degrees;
    const auto place = [&](CVector3 p) {
      p.SetX(mirror ? -p.GetX() : p.GetX());
      return camera.ToWorld(p);
    };
    std::string arena = camera.RobotXml();
    CVector3 box = place(CVector3(-0.1, 0.0, 0.5));
    box.SetZ(0.0);
    arena += BoxText("b", CVector3(0.1, 0.1, 0.18), box, degrees + (mirror ? -20.0 : 20.0));
    CRandomStream random(4, "test", "led detector", "symmetry");
    for (int i = 0; i < 60; ++i) {
      arena += LightText("l" + std::to_string(i),
                         place(camera.At(random.Uniform(-50.0, 690.0), random.Uniform(0.0, 460.0),
                                         random.Uniform(0.3, 1.5))));
    }
    return WithCameras(camera.ToXml(kDetector), arena);
  };
  CRobotWorld plain(build(false, 0.0));
  const TReadings& expected = Look(plain);
  CHECK(expected.size() > 20);
  CHECK(expected.size() < 55);
  CRobotWorld world(build(mirrored, yaw));
  const TReadings& readings = Look(world);
  REQUIRE(readings.size() == expected.size());
  for (size_t i = 0; i < readings.size(); ++i) {
    const Real u = expected[i].Center.GetX();
    CHECK_THAT(readings[i].Center.GetX(), WithinAbs(mirrored ? 640.0 - u : u, kRounding));
    CHECK_THAT(readings[i].Center.GetY(), WithinAbs(expected[i].Center.GetY(), kRounding));
  }
}

TEST_CASE("cameras: a robot may have any number of cameras, each with any number of algorithms",
          "[contract][cameras]") {
  SPinhole front;
  SPinhole other;
  other.Offset = CVector3(0.0, 0.0, 0.3);
  other.FX = 400.0;
  CRobotWorld world(
      WithCameras(front.ToXml(std::string(kDetector) + "<tag_detector medium=\"tags\"/>", "front") +
                      other.ToXml(kDetector, "other") + other.ToXml("", "bare"),
                  front.RobotXml() + LightText("l", front.ToWorld(CVector3(0.1, 0.05, 1.0)))));
  Look(world);
  const auto& interfaces = Cameras(world).GetInterfaces();
  REQUIRE(interfaces.size() == 3);
  CHECK(interfaces[0].Id == "front");
  CHECK(interfaces[1].Id == "other");
  CHECK(interfaces[2].Id == "bare");
  REQUIRE(interfaces[0].Algorithms.size() == 2);
  CHECK(interfaces[0].Algorithms[0]->GetLabel() == std::string("led_detector"));
  CHECK(interfaces[0].Algorithms[1]->GetLabel() == std::string("tag_detector"));
  CHECK(interfaces[2].Algorithms.empty());
  REQUIRE(Readings(world, 0).size() == 1);
  CHECK_THAT(Readings(world, 0)[0].Center.GetX(), WithinAbs(320.0 + 50.0, kRounding));
  // from the second camera the light is 1.1 m ahead and 8 cm to the right
  REQUIRE(Readings(world, 1).size() == 1);
  CHECK_THAT(Readings(world, 1)[0].Center.GetX(), WithinAbs(320.0 + 400.0 * 0.08 / 1.1, kRounding));
}

TEST_CASE("cameras: detect nothing of their own robot, but other robots", "[contract][cameras]") {
  SPinhole camera;
  // the camera is behind the robot and looks over the robot's ring of LEDs
  camera.Offset = CVector3(-0.3, 0.0, 0.2);
  SRobotExperiment experiment =
      WithCameras(camera.ToXml(kDetector),
                  camera.RobotXml() + Robot("foot-bot", "a", PoseText(CVector3(0.8, 0.0, 0.0))));
  experiment.Actuators = "<leds implementation=\"default\" medium=\"leds\"/>";
  CRobotWorld world(experiment);
  world.GetActuator<CCI_LEDsActuator>("r", "leds").SetAllColors(CColor::RED);
  world.GetActuator<CCI_LEDsActuator>("a", "leds").SetAllColors(CColor::GREEN);
  const TReadings& readings = Look(world);
  // the rear half of the other robot's ring and its beacon; the camera's own robot does not occlude
  CHECK(readings.size() == 7);
  for (const auto& reading : readings) {
    CHECK(reading.Color == CColor::GREEN);
  }
}

TEST_CASE("cameras: take pictures while enabled, from the pose of their anchor",
          "[contract][cameras]") {
  const SPinhole camera;
  CRobotWorld world(
      WithCameras(camera.ToXml(kDetector, "front", "turret"),
                  camera.RobotXml() + LightText("l", camera.ToWorld(CVector3(0.1, 0.05, 1.0)))));
  auto& body = world.Get<CFootBotEntity>("r").GetEmbodiedEntity();
  SAnchor& turret = body.GetAnchor("turret");
  world.Step(2);
  CHECK(Readings(world).empty());
  CHECK(turret.InUseCount == 0);
  CHECK(Look(world).size() == 1);
  CHECK(turret.InUseCount == 1);
  Cameras(world).Enable();
  CHECK(turret.InUseCount == 1);
  // moving back by 0.2 m moves the light by 500 * 0.1 * (1 / 1.2 - 1) pixels
  REQUIRE(body.MoveTo(CVector3(-0.2, 0.0, 0.0), CQuaternion()));
  world.Step();
  CHECK_THAT(Readings(world)[0].Center.GetX(), WithinAbs(320.0 + 500.0 * 0.1 / 1.2, kRounding));
  Cameras(world).Disable();
  CHECK(turret.InUseCount == 0);
  world.Get<CLEDEntity>("l").SetColor(CColor::BLACK);
  world.Step();
  // the last readings are kept
  CHECK(Readings(world).size() == 1);
  world.GetSimulator().Reset();
  CHECK(Readings(world).empty());
  CHECK_FALSE(Cameras(world).IsEnabled());
  CHECK(turret.InUseCount == 0);
}

TEST_CASE("cameras: view frusta and lines of sight are recorded only on request",
          "[contract][cameras]") {
  const bool frustum = GENERATE(false, true);
  const bool rays = GENERATE(false, true);
  const SPinhole camera;
  CRobotWorld world(
      WithCameras(camera.ToXml(std::string("<led_detector medium=\"leds\" show_rays=\"") +
                               (rays ? "true" : "false") + "\"/>"),
                  camera.RobotXml() + LightText("l", camera.ToWorld(CVector3(0.1, 0.05, 1.0))),
                  frustum ? "show_frustum=\"true\"" : ""));
  Look(world);
  const auto& shown = world.GetRobot("r").GetCheckedRays();
  REQUIRE(shown.size() == (rays ? 1U : 0U) + (frustum ? 12U : 0U));
  if (frustum) {
    // every edge ends at corners of the picture, at the near or the far limit of the range
    for (size_t i = shown.size() - 12; i < shown.size(); ++i) {
      for (const CVector3& end : {shown[i].second.GetStart(), shown[i].second.GetEnd()}) {
        CVector3 p = end - camera.Offset;
        const CVector2 pixel = camera.Project(CVector3(-p.GetY(), -p.GetZ(), p.GetX()));
        CHECK((std::abs(pixel.GetX()) < 1e-9 || std::abs(pixel.GetX() - 640.0) < 1e-9));
        CHECK((std::abs(pixel.GetY()) < 1e-9 || std::abs(pixel.GetY() - 480.0) < 1e-9));
        CHECK((std::abs(p.GetX() - 0.05) < 1e-12 || std::abs(p.GetX() - 2.0) < 1e-12));
      }
    }
  }
}

TEST_CASE("led detector noise: is on the pixels as stated and differs between two cameras",
          "[contract][cameras][noise]") {
  constexpr int kDraws = 20000;
  const SPinhole camera;
  const std::string noisy =
      "<led_detector medium=\"leds\"><noise on=\"x\" model=\"gaussian\" std_dev=\"2\"/>"
      "<noise on=\"y\" model=\"uniform\" level=\"1.5\"/></led_detector>";
  CRobotWorld world(
      WithCameras(camera.ToXml(noisy, "one") + camera.ToXml(noisy, "two"),
                  camera.RobotXml() + LightText("l", camera.ToWorld(CVector3(0.1, 0.05, 1.0)))));
  Cameras(world).Enable();
  std::vector<Real> us;
  std::vector<Real> vs;
  Real product = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    world.Step();
    us.push_back(Readings(world, 0)[0].Center.GetX() - 370.0);
    vs.push_back(Readings(world, 0)[0].Center.GetY() - 252.5);
    product += us.back() * (Readings(world, 1)[0].Center.GetX() - 370.0);
  }
  CHECK(KolmogorovSmirnovExcess(us, [](Real u) { return NormalDistribution(u, 2.0); }) < 1.0);
  CHECK(KolmogorovSmirnovExcess(vs, [](Real v) { return (v + 1.5) / 3.0; }) < 1.0);
  // the mean of the product of independent draws has a standard deviation of 4 / sqrt(n)
  CHECK(std::abs(product / kDraws) < 5.0 * 4.0 / std::sqrt(kDraws));
}

TEST_CASE("cameras: invalid experiments are refused with the reason",
          "[contract][cameras][errors]") {
  const SPinhole pinhole;
  const std::string good = pinhole.ToXml(kDetector);
  const auto error = [&](const std::string& cameras) {
    return LoadError(WithCameras(cameras, pinhole.RobotXml()));
  };
  const auto replaced = [&good](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  CHECK(error(good).empty());
  SECTION("invalid attributes") {
    struct SCase {
      const char* From;
      const char* To;
      const char* Reason;
    };
    const SCase c =
        GENERATE(SCase{"anchor=\"origin\"", "anchor=\"orign\"", "origin"},
                 SCase{"anchor=\"origin\"", "", "anchor"}, SCase{"id=\"front\"", "", "id"},
                 SCase{"range=\"0.05:2\"", "range=\"-1:2\"", "got -1:2"},
                 SCase{"range=\"0.05:2\"", "range=\"2:2\"", "min < max"},
                 SCase{"range=\"0.05:2\"", "", "range"},
                 SCase{"resolution=\"640,480\"", "resolution=\"640,0\"", "resolution"},
                 SCase{"focal_length=\"500,450\"", "focal_length=\"-500,450\"", "got -500,450"},
                 SCase{"focal_length=\"500,450\"", "focal_length=\"500\"", "focal_length"},
                 SCase{"principal_point=\"320,230\"", "", "principal_point"},
                 SCase{"orientation=\"-90,90,0\"", "", "orientation"});
    CAPTURE(c.From, c.To);
    CHECK_THAT(error(replaced(c.From, c.To)), Contains(c.Reason) && Contains("test.argos:"));
  }
  SECTION("an unknown algorithm") {
    CHECK_THAT(error(pinhole.ToXml("<lde_detector medium=\"leds\"/>")),
               Contains("<lde_detector>") && Contains("led_detector") && Contains("test.argos:"));
  }
  SECTION("a medium of the wrong type") {
    CHECK_THAT(error(pinhole.ToXml("<led_detector medium=\"tags\"/>")),
               Contains("an LED medium") && Contains("\"tags\"") && Contains("<led_detector>"));
    CHECK_THAT(error(pinhole.ToXml("<tag_detector medium=\"leds\"/>")), Contains("a tag medium"));
    CHECK_THAT(error(pinhole.ToXml("<directional_led_detector medium=\"lamps\"/>")),
               Contains("a directional LED medium") && Contains("lamps"));
  }
  SECTION("two cameras with one name") {
    CHECK_THAT(error(good + good), Contains("camera id \"front\" is used twice"));
  }
}

}  // namespace led_detector_test
