// Compares the perspective camera with the equations of its image, in worlds without motion.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/simulator/entities/led_entity.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/support/sight_reference.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace argos::perspective_camera_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using TSensor = CCI_ColoredBlobPerspectiveCameraSensor;

const char* const kSensor = "colored_blob_perspective_camera";
// m, of the foot-bot
constexpr Real kAhead = kFootBotRadius;
constexpr Real kHeight = 0.174249733;

// parameters of the camera's equations; the defaults are those of a foot-bot without attributes
struct SLens {
  Real FocalLength = 0.035;  // m
  Real Aperture = 30.0 * M_PI / 180.0;  // rad
  Real Range = 2.0;  // m

  Real MtHeight() const {
    const Real aspect = 640.0 / 480.0;
    return 2.0 * FocalLength * std::tan(Aperture) / std::sqrt(1.0 + aspect * aspect);
  }
  // the pixel coordinates, before truncation, of a point in the camera's frame
  Real PixelX(const CVector3& p) const {
    const Real width = MtHeight() * 640.0 / 480.0;
    return -(640.0 / width) * (FocalLength * p.GetY() / p.GetX() - width / 2.0);
  }
  Real PixelY(const CVector3& p) const {
    return -(480.0 / MtHeight()) * (FocalLength * p.GetZ() / p.GetX() - MtHeight() / 2.0);
  }
  // the point at that depth (m) with those pixel coordinates
  CVector3 At(Real x, Real y, Real depth) const {
    const Real width = MtHeight() * 640.0 / 480.0;
    return CVector3(depth, depth / FocalLength * width * (0.5 - x / 640.0),
                    depth / FocalLength * MtHeight() * (0.5 - y / 480.0));
  }
};

// a foot-bot's pose, and the direction of its camera: ahead or up
struct SView {
  CVector3 Position;  // of the robot, m
  Real Yaw = 0.0;  // degrees
  bool Front = true;

  // transforms a point from the camera's frame to the world
  CVector3 ToWorld(CVector3 p) const {
    if (!Front) {
      // the camera looks up; left in the image is left of the robot, up in the image is backwards
      p = CVector3(-p.GetZ(), p.GetY(), p.GetX());
    }
    p += CVector3(kAhead, 0.0, kHeight);
    return p.RotateZ(ToRadians(CDegrees(Yaw))) + Position;
  }
  std::string ToXml(const std::string& attributes = "") const {
    return "<foot-bot id=\"r\" perspective_camera_front=\"" +
           std::string(Front ? "true" : "false") + "\" " + attributes + "><body " +
           PoseText(Position, Yaw) + "/><controller config=\"c\"/></foot-bot>";
  }
};

SRobotExperiment WithCamera(const std::string& arena, const std::string& attributes = "",
                            const std::string& children = "") {
  SRobotExperiment experiment;
  experiment.Sensors = std::string("<") + kSensor + " implementation=\"default\" medium=\"leds\" " +
                       attributes + ">" + children + "</" + kSensor + ">";
  experiment.Arena = arena;
  return experiment;
}

TSensor& Camera(CRobotWorld& world) {
  return world.GetSensor<TSensor>("r", kSensor);
}

const TSensor::TBlobList& Look(CRobotWorld& world) {
  Camera(world).Enable();
  world.Step();
  return Camera(world).GetReadings().BlobList;
}

}  // namespace

TEST_CASE("perspective camera: a few pixels equal values computed by hand", "[contract][cameras]") {
  // At 30 degrees the image is 0.0242487 m high and 0.0323316 m wide: a point one metre ahead and
  // 10 cm to the left is 640 * 0.0035 / 0.0323316 = 69.28 pixels left of the middle.
  struct SCase {
    CVector3 Point;  // in the camera's frame, m
    SInt32 X, Y;
  };
  const SCase c = GENERATE(SCase{{1.0, 0.0, 0.0}, 320, 240}, SCase{{1.0, 0.1, 0.0}, 250, 240},
                           SCase{{1.0, -0.1, 0.0}, 389, 240}, SCase{{1.0, 0.0, 0.1}, 320, 170},
                           SCase{{1.0, 0.0, -0.1}, 320, 309}, SCase{{0.5, 0.1, 0.1}, 181, 101});
  // results do not depend on the yaw of the robot
  const Real yaw = GENERATE(0.0, 90.0, -137.0);
  CAPTURE(c.X, c.Y, yaw);
  const SView view{CVector3(1.0, -2.0, 0.0), yaw, true};
  CRobotWorld world(WithCamera(view.ToXml() + LightText("l", view.ToWorld(c.Point), "cyan")));
  const TSensor::TBlobList& blobs = Look(world);
  REQUIRE(blobs.size() == 1);
  // a point in the middle is on the border of four pixels: rounding decides
  CHECK(std::abs(blobs[0]->X - c.X) <= (c.X == 320 ? 1 : 0));
  CHECK(std::abs(blobs[0]->Y - c.Y) <= (c.Y == 240 ? 1 : 0));
  CHECK(blobs[0]->Color == CColor::CYAN);
}

TEST_CASE("perspective camera: pixels follow the equations of the image, in the order of the file",
          "[contract][cameras]") {
  const bool front = GENERATE(true, false);
  CRandomStream random(1, "test", "perspective camera", "places");
  for (int trial = 0; trial < 20; ++trial) {
    CAPTURE(front, trial);
    SLens lens;
    lens.Aperture = random.Uniform(0.2, 1.4);
    lens.FocalLength = random.Uniform(0.001, 0.1);
    lens.Range = random.Uniform(0.5, 3.0);
    const SView view{CVector3(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0), 0.0),
                     random.Uniform(-180.0, 180.0), front};
    std::string arena =
        view.ToXml("perspective_camera_aperture=\"" + ToText(lens.Aperture * 180.0 / M_PI) +
                   "\" perspective_camera_focal_length=\"" + ToText(lens.FocalLength) +
                   "\" perspective_camera_range=\"" + ToText(lens.Range) + "\"");
    std::vector<CVector3> seen;
    for (int i = 0; i < 60; ++i) {
      const CVector3 p(random.Uniform(-1.0, 4.0), random.Uniform(-3.0, 3.0),
                       random.Uniform(-3.0, 3.0));
      arena += LightText("l" + std::to_string(i), view.ToWorld(p));
      const Real x = lens.PixelX(p);
      const Real y = lens.PixelY(p);
      const Real angle = std::acos(p.GetX() / p.Length());
      if (p.GetX() < lens.Range && angle < lens.Aperture && std::trunc(x) >= 0.0 &&
          std::trunc(x) <= 639.0 && std::trunc(y) >= 0.0 && std::trunc(y) <= 479.0) {
        seen.push_back(p);
      }
    }
    CRobotWorld world(WithCamera(arena));
    const TSensor::TBlobList& blobs = Look(world);
    REQUIRE(blobs.size() == seen.size());
    for (size_t i = 0; i < seen.size(); ++i) {
      // the equations of test and camera differ by roundings only: 1e-9 pixels at most
      CHECK_THAT(blobs[i]->X + 0.5, WithinAbs(lens.PixelX(seen[i]), 0.5 + 1e-9));
      CHECK_THAT(blobs[i]->Y + 0.5, WithinAbs(lens.PixelY(seen[i]), 0.5 + 1e-9));
    }
  }
}

TEST_CASE("perspective camera: lights beyond the image's borders or the range are not seen",
          "[contract][cameras]") {
  // pixel coordinates are truncated towards 0: a point less than a pixel left
  // of the first pixel belongs to it
  struct SCase {
    Real X, Y, Depth;
    bool Seen;
  };
  const SCase c =
      GENERATE(SCase{-0.999, 240.5, 1.0, true}, SCase{-1.001, 240.5, 1.0, false},
               SCase{639.999, 240.5, 1.0, true}, SCase{640.001, 240.5, 1.0, false},
               SCase{320.5, -0.999, 1.0, true}, SCase{320.5, -1.001, 1.0, false},
               SCase{320.5, 479.999, 1.0, true}, SCase{320.5, 480.001, 1.0, false},
               // the corners of the image are on the cone of the aperture
               SCase{0.001, 0.001, 1.0, true}, SCase{-0.001, -0.001, 1.0, false},
               SCase{320.5, 240.5, 2.0 - 1e-9, true}, SCase{320.5, 240.5, 2.0 + 1e-9, false},
               SCase{320.5, 240.5, -0.5, false}, SCase{320.5, 240.5, 1e-6, true});
  const bool front = GENERATE(true, false);
  CAPTURE(c.X, c.Y, c.Depth, front);
  const SView view{CVector3(0.5, 0.25, 0.0), 70.0, front};
  CRobotWorld world(
      WithCamera(view.ToXml() + LightText("l", view.ToWorld(SLens().At(c.X, c.Y, c.Depth)))));
  const TSensor::TBlobList& blobs = Look(world);
  REQUIRE(blobs.size() == (c.Seen ? 1 : 0));
  if (c.Seen) {
    CHECK(blobs[0]->X == static_cast<SInt32>(c.X));
    CHECK(blobs[0]->Y == static_cast<SInt32>(c.Y));
  }
}

TEST_CASE("perspective camera: the camera tilts with its robot", "[contract][cameras]") {
  // nose down by 20 degrees: a light 20 degrees below the horizon is in the middle
  const Real tilt = 20.0 * M_PI / 180.0;
  const CVector3 eye(kAhead * std::cos(tilt) + kHeight * std::sin(tilt), 0.0,
                     kHeight * std::cos(tilt) - kAhead * std::sin(tilt));
  CRobotWorld world(WithCamera(
      "<foot-bot id=\"r\"><body orientation=\"0,20,0\"/><controller config=\"c\"/></foot-bot>" +
      LightText("l", eye + CVector3(std::cos(tilt), 0.001, -std::sin(tilt)))));
  const TSensor::TBlobList& blobs = Look(world);
  REQUIRE(blobs.size() == 1);
  CHECK(blobs[0]->X == 319);
  CHECK((blobs[0]->Y == 239 || blobs[0]->Y == 240));
}

TEST_CASE("perspective camera: equals brute force among many bodies and lights",
          "[contract][cameras]") {
  CRandomStream random(2, "test", "perspective camera", "crowd");
  const SLens lens{0.035, 0.9, 2.0};
  size_t seenInAll = 0;
  size_t hiddenInAll = 0;
  for (int trial = 0; trial < 10; ++trial) {
    CAPTURE(trial);
    const SView view{CVector3(), random.Uniform(-180.0, 180.0), true};
    std::string arena =
        view.ToXml("perspective_camera_aperture=\"" + ToText(0.9 * 180.0 / M_PI) + "\"");
    for (int i = 0; i < 14; ++i) {
      const CVector3 place =
          view.ToWorld(CVector3(random.Uniform(0.1, 1.5), random.Uniform(-1.0, 1.0), 0.0));
      const Real height = random.Uniform(0.02, 0.4);
      if (i % 2 == 0) {
        arena += PillarText("p" + std::to_string(i), place.GetX(), place.GetY(), 0.04, height);
      } else {
        arena += BoxText("b" + std::to_string(i), CVector3(0.05, 0.1, height),
                         CVector3(place.GetX(), place.GetY(), 0.0), random.Uniform(-180.0, 180.0));
      }
    }
    std::vector<CVector3> points;
    for (int i = 0; i < 60; ++i) {
      points.emplace_back(lens.At(random.Uniform(0.0, 640.0), random.Uniform(0.0, 480.0),
                                  random.Uniform(0.1, 1.9)));
      arena += LightText("l" + std::to_string(i), view.ToWorld(points.back()));
    }
    CRobotWorld world(WithCamera(arena));
    const TSensor::TBlobList& blobs = Look(world);
    std::vector<CVector3> seen;
    for (const CVector3& point : points) {
      const bool inSight =
          ReferenceInSight(world.GetSpace(), view.ToWorld(CVector3()), view.ToWorld(point), "r");
      hiddenInAll += inSight ? 0 : 1;
      if (inSight) {
        seen.push_back(point);
      }
    }
    seenInAll += seen.size();
    REQUIRE(blobs.size() == seen.size());
    for (size_t i = 0; i < seen.size(); ++i) {
      CHECK_THAT(blobs[i]->X + 0.5, WithinAbs(lens.PixelX(seen[i]), 0.5 + 1e-9));
    }
  }
  CHECK(seenInAll > 50);
  CHECK(hiddenInAll > 50);
}

TEST_CASE("perspective camera: mirrored worlds give mirrored images, turned worlds equal ones",
          "[contract][cameras]") {
  const bool mirrored = GENERATE(false, true);
  const Real turn = GENERATE(0.0, 33.0, 90.0, -121.0);
  CAPTURE(mirrored, turn);
  const auto build = [](bool mirror, Real degrees) {
    const SView view{CVector3(), degrees, true};
    const auto place = [&](const CVector3& p) {
      return view.ToWorld(CVector3(p.GetX(), mirror ? -p.GetY() : p.GetY(), p.GetZ()));
    };
    std::string arena = view.ToXml();
    CVector3 box = place(CVector3(0.5, 0.1, 0.0));
    box.SetZ(0.0);
    arena += BoxText("b", CVector3(0.1, 0.1, 0.2), box, degrees + (mirror ? -20.0 : 20.0));
    const CVector3 pillar = place(CVector3(0.4, -0.1, 0.0));
    arena += PillarText("p", pillar.GetX(), pillar.GetY(), 0.03, 0.16);
    CRandomStream random(3, "test", "perspective camera", "symmetry");
    for (int i = 0; i < 60; ++i) {
      const Real depth = random.Uniform(0.2, 1.5);
      arena += LightText("l" + std::to_string(i),
                         place(CVector3(depth, depth * random.Uniform(-0.5, 0.5),
                                        depth * random.Uniform(-0.3, 0.3))));
    }
    return WithCamera(arena);
  };
  CRobotWorld plain(build(false, 0.0));
  const TSensor::TBlobList& expected = Look(plain);
  CHECK(expected.size() > 20);
  CHECK(expected.size() < 50);
  CRobotWorld world(build(mirrored, turn));
  const TSensor::TBlobList& blobs = Look(world);
  REQUIRE(blobs.size() == expected.size());
  for (size_t i = 0; i < blobs.size(); ++i) {
    CHECK(blobs[i]->X == (mirrored ? 639 - expected[i]->X : expected[i]->X));
    CHECK(blobs[i]->Y == expected[i]->Y);
  }
}

TEST_CASE("perspective camera: sees the LEDs of a robot ahead, but not its own",
          "[contract][cameras]") {
  SRobotExperiment experiment =
      WithCamera(Robot("foot-bot", "r", PoseText(CVector3())) +
                 Robot("foot-bot", "a", PoseText(CVector3(1.0, 0.0, 0.0))));
  experiment.Actuators = "<leds implementation=\"default\" medium=\"leds\"/>";
  CRobotWorld world(experiment);
  for (const char* id : {"r", "a"}) {
    world.GetActuator<CCI_LEDsActuator>(id, "leds").SetAllColors(CColor::RED);
  }
  const TSensor::TBlobList& blobs = Look(world);
  // the near half of the ring and the beacon; the camera is as high as the beacon
  REQUIRE(blobs.size() == 7);
  CHECK((blobs[6]->Y == 239 || blobs[6]->Y == 240));
  // from behind, LEDs 3 to 8 are visible from left to right
  for (int i = 0; i < 5; ++i) {
    CHECK(blobs[i]->X < blobs[i + 1]->X);
  }
}

TEST_CASE("perspective camera: takes pictures while it is enabled and counts them",
          "[contract][cameras]") {
  const SView view;
  CRobotWorld world(
      WithCamera(view.ToXml() + LightText("l", view.ToWorld(CVector3(1.0, 0.1, 0.0)))));
  auto& component = world.Get<CFootBotEntity>("r").GetPerspectiveCameraEquippedEntity();
  world.Step(2);
  CHECK(Camera(world).GetReadings().Counter == 0);
  CHECK_FALSE(component.IsEnabled());
  CHECK(Look(world).size() == 1);
  CHECK(component.IsEnabled());
  CHECK(Camera(world).GetReadings().Counter == 1);
  Camera(world).Disable();
  world.Get<CLEDEntity>("l").SetColor(CColor::BLACK);
  world.Step(2);
  CHECK(Camera(world).GetReadings().Counter == 1);
  CHECK(Camera(world).GetReadings().BlobList.size() == 1);
  CHECK_FALSE(component.IsEnabled());
  CHECK(Look(world).empty());
  CHECK(Camera(world).GetReadings().Counter == 2);
  world.GetSimulator().Reset();
  CHECK(Camera(world).GetReadings().Counter == 0);
  CHECK_FALSE(Camera(world).IsEnabled());
  CHECK_FALSE(component.IsEnabled());
}

TEST_CASE("perspective camera: lines of sight are recorded only on request",
          "[contract][cameras]") {
  const bool show = GENERATE(false, true);
  const SView view;
  CRobotWorld world(WithCamera(view.ToXml() +
                                   LightText("in", view.ToWorld(CVector3(1.0, 0.1, 0.0))) +
                                   LightText("out", view.ToWorld(CVector3(-1.0, 0.1, 0.0))),
                               show ? "show_rays=\"true\"" : ""));
  Look(world);
  CHECK(world.GetRobot("r").GetCheckedRays().size() == (show ? 1 : 0));
}

TEST_CASE(
    "perspective camera: is a component that robots create on demand, with the published values",
    "[contract][cameras]") {
  SRobotExperiment experiment;
  experiment.Arena = SView().ToXml(
      "perspective_camera_aperture=\"40\" perspective_camera_focal_length=\"0.01\" "
      "perspective_camera_range=\"3\"");
  CRobotWorld world(experiment);
  auto& robot = world.Get<CFootBotEntity>("r");
  const size_t before = robot.GetExistingComponents().size();
  auto& camera = robot.GetPerspectiveCameraEquippedEntity();
  CHECK(robot.GetExistingComponents().size() == before + 1);
  CHECK(&robot.GetComponent("perspective_camera") == &camera);
  CHECK_THAT(ToDegrees(camera.GetAperture()).GetValue(), WithinAbs(40.0, 1e-12));
  CHECK(camera.GetFocalLength() == 0.01);
  CHECK(camera.GetRange() == 3.0);
  CHECK(camera.GetImagePxWidth() == 640);
  CHECK(camera.GetImagePxHeight() == 480);
  // the angle of view along the diagonal is twice the aperture
  CHECK_THAT(std::hypot(camera.GetImageMtWidth(), camera.GetImageMtHeight()),
             WithinRel(2.0 * 0.01 * std::tan(40.0 * M_PI / 180.0), 1e-14));
  CHECK(&camera.GetAnchor() == &robot.GetEmbodiedEntity().GetOriginAnchor());
  CHECK_THAT(Distance(camera.ComputePosition(), CVector3(kAhead, 0.0, kHeight)),
             WithinAbs(0.0, 1e-16));
}

TEST_CASE("perspective camera: enables its anchor while it is enabled", "[contract][cameras]") {
  SRobotExperiment experiment;
  experiment.Arena = SView().ToXml();
  CRobotWorld world(experiment);
  auto& robot = world.Get<CFootBotEntity>("r");
  auto& camera = robot.GetPerspectiveCameraEquippedEntity();
  SAnchor& turret = robot.GetEmbodiedEntity().GetAnchor("turret");
  camera.Enable();
  CHECK(turret.InUseCount == 0);
  camera.SetAnchor(turret);
  CHECK(turret.InUseCount == 1);
  camera.Disable();
  camera.Disable();
  CHECK(turret.InUseCount == 0);
  camera.SetMount(CVector3(1.0, 0.0, 0.0), CQuaternion(CRadians::PI, CVector3::Z));
  CVector3 view = CVector3::X;
  view.Rotate(camera.ComputeView());
  CHECK_THAT(Distance(view, -CVector3::X), WithinAbs(0.0, 1e-15));
}

TEST_CASE("perspective camera: components refuse invalid values", "[contract][cameras][errors]") {
  CPerspectiveCameraEquippedEntity camera(nullptr);
  CHECK_THROWS_WITH(camera.GetAnchor(), Contains("no anchor"));
  CHECK_THROWS_WITH(camera.SetAperture(CRadians()), Contains("aperture") && Contains("got 0"));
  CHECK_THROWS_WITH(camera.SetFocalLength(0.0), Contains("focal length") && Contains("> 0"));
  CHECK_THROWS_WITH(camera.SetRange(std::numeric_limits<Real>::infinity()), Contains("range"));
  CHECK_THROWS_WITH(camera.SetImagePxSize(640, 0), Contains("640 and 0"));
  CHECK(camera.GetImagePxHeight() == 480);
}

TEST_CASE("perspective camera: invalid experiments are refused with the reason",
          "[contract][cameras][errors]") {
  SRobotExperiment experiment = WithCamera(Robot("foot-bot", "fb0", PoseText(CVector3())));
  CHECK(LoadError(experiment).empty());
  SECTION("a medium of the wrong type") {
    experiment.Media = "<toy_medium id=\"leds\"/>";
    CHECK_THAT(LoadError(experiment),
               Contains("LED medium") && Contains("\"leds\"") && Contains("test.argos:"));
  }
  SECTION("negative noise") {
    experiment = WithCamera(Robot("foot-bot", "fb0", PoseText(CVector3())), "noise_std_dev=\"-2\"");
    CHECK_THAT(LoadError(experiment), Contains("noise_std_dev") && Contains("-2"));
  }
  SECTION("noise on an unknown quantity") {
    experiment = WithCamera(Robot("foot-bot", "fb0", PoseText(CVector3())), "",
                            "<noise on=\"z\" model=\"gaussian\" std_dev=\"1\"/>");
    CHECK_THAT(LoadError(experiment), Contains("no \"z\""));
  }
  SECTION("a robot without such a camera") {
    experiment = WithCamera(Robot("e-puck", "ep0", PoseText(CVector3())));
    CHECK_THAT(LoadError(experiment),
               Contains("ep0") && Contains("no component \"perspective_camera\""));
  }
}

}  // namespace argos::perspective_camera_test
