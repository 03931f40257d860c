// Compares the omnidirectional camera with geometry computed by hand, in worlds without motion.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/simulator/entities/led_entity.h>
#include <argos3/plugins/simulator/entities/omnidirectional_camera_equipped_entity.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/support/sight_reference.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::omnidirectional_camera_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

using TSensor = CCI_ColoredBlobOmnidirectionalCameraSensor;

const char* const kSensor = "colored_blob_omnidirectional_camera";
constexpr Real kHeight = 0.288699733;  // m, height of the camera above the base
// half side of the square on the ground that a camera covers, m: 0.793 at 70 degrees
const Real kHalfSide = kHeight * std::tan(70.0 * M_PI / 180.0);
// tolerance of about ten roundings of numbers up to 1000 cm
constexpr Real kRounding = 1e-11;

SRobotExperiment WithCamera(const std::string& arena, const std::string& attributes = "",
                            const std::string& children = "") {
  SRobotExperiment experiment;
  experiment.Sensors = std::string("<") + kSensor +
                       " implementation=\"rot_z_only\" medium=\"leds\" " + attributes + ">" +
                       children + "</" + kSensor + ">";
  experiment.Arena = arena;
  return experiment;
}

std::string FootBot(const std::string& id, const CVector3& position, Real yawDegrees = 0.0) {
  return Robot("foot-bot", id, PoseText(position, yawDegrees));
}

TSensor& Camera(CRobotWorld& world, const std::string& robot = "r") {
  return world.GetSensor<TSensor>(robot, kSensor);
}

const TSensor::TBlobList& Blobs(CRobotWorld& world, const std::string& robot = "r") {
  return Camera(world, robot).GetReadings().BlobList;
}

// enables the camera of robot "r" and runs one tick
const TSensor::TBlobList& Look(CRobotWorld& world) {
  Camera(world).Enable();
  world.Step();
  return Blobs(world);
}

// the angle between two directions, rad
Real AngleBetween(Real a, Real b) {
  return std::abs(std::remainder(a - b, 2.0 * M_PI));
}

// the readings must be those of the points (m, world frame), in the frame of the robot at (x, y)
void CheckBlobs(const TSensor::TBlobList& blobs, const std::vector<CVector3>& points, Real x,
                Real y, Real yawDegrees) {
  REQUIRE(blobs.size() == points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    CAPTURE(i);
    const Real dx = points[i].GetX() - x;
    const Real dy = points[i].GetY() - y;
    CHECK_THAT(blobs[i]->Distance, WithinAbs(100.0 * std::hypot(dx, dy), kRounding));
    const Real angle = blobs[i]->Angle.GetValue();
    CHECK((angle >= -M_PI && angle < M_PI));
    CHECK_THAT(AngleBetween(angle, std::atan2(dy, dx) - yawDegrees * M_PI / 180.0),
               WithinAbs(0.0, 1e-13));
  }
}

}  // namespace

TEST_CASE(
    "omnidirectional camera: blobs are at the positions of the lights, in the order of the file",
    "[contract][cameras]") {
  CRandomStream random(1, "test", "omnidirectional camera", "places");
  for (int trial = 0; trial < 25; ++trial) {
    const Real x = random.Uniform(-4.0, 4.0);
    const Real y = random.Uniform(-4.0, 4.0);
    const Real yaw = random.Uniform(-180.0, 180.0);
    CAPTURE(trial, x, y, yaw);
    std::string arena = LightText("first", CVector3(x + 0.1, y, 0.0), "blue") +
                        FootBot("r", CVector3(x, y, 0.0), yaw);
    std::vector<CVector3> points = {CVector3(x + 0.1, y, 0.0)};
    for (int i = 0; i < 30; ++i) {
      points.emplace_back(x + random.Uniform(-0.79, 0.79), y + random.Uniform(-0.79, 0.79),
                          random.Uniform(0.0, 0.288));
      arena += LightText("l" + std::to_string(i), points.back(), i % 2 == 0 ? "red" : "1,2,3,4");
    }
    CRobotWorld world(WithCamera(arena));
    const TSensor::TBlobList& blobs = Look(world);
    CheckBlobs(blobs, points, x, y, yaw);
    CHECK(blobs[0]->Color == CColor::BLUE);
    CHECK(blobs[1]->Color == CColor::RED);
    CHECK(blobs[2]->Color == CColor(1, 2, 3, 4));
  }
}

TEST_CASE("omnidirectional camera: covers a square of the world at any yaw",
          "[contract][cameras]") {
  const Real yaw = GENERATE(0.0, 45.0, 100.0);
  const Real aperture = GENERATE(70.0, 45.0, 10.0);
  const Real excess = GENERATE(-1e-9, 1e-9);  // m, beyond the edge
  CAPTURE(yaw, aperture, excess);
  const Real reach = kHeight * std::tan(aperture * M_PI / 180.0) + excess;
  std::string arena = "<foot-bot id=\"r\" omnidirectional_camera_aperture=\"" + ToText(aperture) +
                      "\"><body " + PoseText(CVector3(1.0, -2.0, 0.0), yaw) +
                      "/><controller config=\"c\"/></foot-bot>";
  int number = 0;
  // points on the edges and in the corners
  for (const Real x : {-1.0, 0.0, 1.0}) {
    for (const Real y : {-1.0, 0.0, 1.0}) {
      if (x != 0.0 || y != 0.0) {
        arena += LightText("l" + std::to_string(number++),
                           CVector3(1.0 + x * reach, -2.0 + y * reach, 0.05));
      }
    }
  }
  CRobotWorld world(WithCamera(arena));
  CHECK(Look(world).size() == (excess < 0.0 ? 8 : 0));
}

TEST_CASE("omnidirectional camera: sees lights that are not higher than itself",
          "[contract][cameras]") {
  struct SCase {
    Real Z;  // m
    bool Seen;
  };
  const SCase c = GENERATE(SCase{kHeight, true}, SCase{kHeight + 1e-9, false}, SCase{0.0, true},
                           SCase{-kHeight + 1e-9, true}, SCase{-kHeight - 1e-9, false});
  CAPTURE(c.Z);
  CRobotWorld world(WithCamera(FootBot("r", CVector3()) + LightText("l", CVector3(0.3, 0.2, c.Z)) +
                               LightText("black", CVector3(0.3, 0.3, 0.1), "black")));
  CHECK(Look(world).size() == (c.Seen ? 1 : 0));
}

TEST_CASE("omnidirectional camera: the covered area grows with the height of the robot",
          "[contract][cameras]") {
  const Real elevation = 0.5;
  const Real reach = (kHeight + elevation) * std::tan(70.0 * M_PI / 180.0);
  CRobotWorld world(WithCamera(FootBot("r", CVector3(0.0, 0.0, elevation)) +
                               LightText("in", CVector3(reach - 1e-9, 0.0, 0.0)) +
                               LightText("out", CVector3(0.0, reach + 1e-9, 0.0))));
  CHECK(Look(world).size() == 1);
}

TEST_CASE("omnidirectional camera: takes pictures while it is enabled and counts them",
          "[contract][cameras]") {
  CRobotWorld world(WithCamera(FootBot("r", CVector3()) + LightText("l", CVector3(0.3, 0.0, 0.1))));
  auto& controller = dynamic_cast<CRobotWorldController&>(world.GetRobot("r").GetController());
  auto& component = world.Get<CFootBotEntity>("r").GetOmnidirectionalCameraEquippedEntity();
  world.Step(3);
  CHECK(Camera(world).GetReadings().Counter == 0);
  CHECK(Blobs(world).empty());
  CHECK_FALSE(component.IsEnabled());
  // enabled in one step, it takes its first picture in the next
  controller.OnStep = [&world] { Camera(world).Enable(); };
  world.Step();
  controller.OnStep = {};
  CHECK(component.IsEnabled());
  CHECK(Blobs(world).empty());
  world.Step();
  CHECK(Blobs(world).size() == 1);
  CHECK(Camera(world).GetReadings().Counter == 1);
  world.Step(4);
  CHECK(Camera(world).GetReadings().Counter == 5);
  // the last picture is kept
  Camera(world).Disable();
  world.Get<CLEDEntity>("l").SetColor(CColor::GREEN);
  world.Step(2);
  CHECK_FALSE(component.IsEnabled());
  REQUIRE(Blobs(world).size() == 1);
  CHECK(Blobs(world)[0]->Color == CColor::RED);
  CHECK(Camera(world).GetReadings().Counter == 5);
  Camera(world).Enable();
  world.Step();
  CHECK(Blobs(world)[0]->Color == CColor::GREEN);
  CHECK(Camera(world).GetReadings().Counter == 6);
  // a reset clears the readings and disables the camera
  world.GetSimulator().Reset();
  CHECK(Blobs(world).empty());
  CHECK(Camera(world).GetReadings().Counter == 0);
  CHECK_FALSE(Camera(world).IsEnabled());
  CHECK_FALSE(component.IsEnabled());
}

TEST_CASE(
    "omnidirectional camera: sees each LED of other robots as a blob, and none of its own robot",
    "[contract][cameras]") {
  SRobotExperiment experiment =
      WithCamera(FootBot("a", CVector3()) + FootBot("r", CVector3(0.5, 0.0, 0.0), 90.0) +
                 Robot("e-puck", "e", PoseText(CVector3(0.5, 0.6, 0.0))));
  experiment.Sensors = "";
  experiment.Actuators = "<leds implementation=\"default\" medium=\"leds\"/>";
  // the e-puck has no camera: it needs a controller without one
  SExperiment text = experiment.ToExperiment();
  text.Controllers +=
      "<robot_world_controller id=\"seeing\"><actuators><leds "
      "implementation=\"default\" medium=\"leds\"/></actuators><sensors><" +
      std::string(kSensor) +
      " implementation=\"rot_z_only\" medium=\"leds\"/></sensors><params/>"
      "</robot_world_controller>";
  const std::string from = PoseText(CVector3(0.5, 0.0, 0.0), 90.0) + "/><controller config=\"c\"";
  const size_t place = text.Arena.find(from);
  REQUIRE(place != std::string::npos);
  text.Arena.replace(place + from.size() - 2, 1, "seeing");
  CTestWorld world(text);
  const CSimulator::CScope scope(world.GetSimulator());
  const auto controller = [&world](const std::string& id) -> CCI_Controller& {
    return world.Get<CComposableEntity>(id)
        .GetComponent<CControllableEntity>("controller")
        .GetController();
  };
  auto& camera = *controller("r").GetSensor<TSensor>(kSensor);
  camera.Enable();
  for (const char* id : {"a", "r", "e"}) {
    controller(id).GetActuator<CCI_LEDsActuator>("leds")->SetAllColors(CColor::YELLOW);
  }
  world.Step();
  const CVector3 eye(0.5, 0.0, kHeight);
  std::vector<CVector3> seen;
  size_t own = 0;
  for (const CLEDEntity* led : ReferenceLitLEDs(world.GetSpace())) {
    if (led->GetRootEntity().GetId() == "r") {
      ++own;
    } else if (ReferenceInSight(world.GetSpace(), eye, led->GetPosition(), "r")) {
      seen.push_back(led->GetPosition());
    }
  }
  CHECK(own == 13);
  // the beacon and at least the near half of each ring; other LEDs are behind the robots' bodies
  CHECK(seen.size() >= 1 + 6 + 4);
  CHECK(seen.size() < 13 + 8);
  CheckBlobs(camera.GetReadings().BlobList, seen, 0.5, 0.0, 90.0);
  controller("a").GetActuator<CCI_LEDsActuator>("leds")->SetAllColors(CColor::BLACK);
  world.Step();
  CHECK(camera.GetReadings().BlobList.size() < seen.size());
}

TEST_CASE("omnidirectional camera: a wall occludes lights below the line over its far edge",
          "[contract][cameras]") {
  // The line of sight to a light at height h and distance d passes the far face of the wall, at
  // distance w, at the height H + (h - H) w / d.
  const Real near = 0.2;
  const Real far = 0.25;
  const Real light = 0.6;
  const Real lightHeight = 0.05;
  const Real grazing = kHeight + (lightHeight - kHeight) * far / light;
  const Real excess = GENERATE(-1e-9, 1e-9);
  const bool wallFirst = GENERATE(true, false);
  CAPTURE(excess, wallFirst);
  const std::string wall = BoxText("w", CVector3(far - near, 1.0, grazing + excess),
                                   CVector3(0.5 * (near + far), 0.0, 0.0));
  const std::string rest =
      FootBot("r", CVector3(), 30.0) + LightText("l", CVector3(light, 0.0, lightHeight));
  CRobotWorld world(WithCamera(wallFirst ? wall + rest : rest + wall));
  CHECK(Look(world).size() == (excess < 0.0 ? 1 : 0));
}

TEST_CASE("omnidirectional camera: a pillar occludes lights in its shadow", "[contract][cameras]") {
  // from the camera, a pillar of radius r at distance D covers asin(r / D) to either side
  const Real radius = 0.05;
  const Real distance = 0.3;
  const Real half = std::asin(radius / distance);
  const Real excess = GENERATE(-1e-9, 1e-9);  // rad, outside the shadow
  const int side = GENERATE(-1, 1);
  CAPTURE(excess, side);
  const Real angle = 0.4 + side * (half + excess);
  CRobotWorld world(
      WithCamera(FootBot("r", CVector3()) +
                 PillarText("p", distance * std::cos(0.4), distance * std::sin(0.4), radius, 1.0) +
                 LightText("l", CVector3(0.6 * std::cos(angle), 0.6 * std::sin(angle), 0.1))));
  CHECK(Look(world).size() == (excess > 0.0 ? 1 : 0));
}

TEST_CASE("omnidirectional camera: LEDs flush with the surface are visible from their own side",
          "[contract][cameras]") {
  const Real yaw = GENERATE(0.0, 17.0, 90.0, 180.0, 233.0);
  CAPTURE(yaw);
  // an LED on each side of a cube of 10 cm, 40 cm ahead and with one side facing the camera, and
  // one in the middle of its top
  const std::string cube =
      "<box id=\"b\" size=\"0.1,0.1,0.1\" movable=\"false\"><body " +
      PoseText(
          CVector3(0.4 * std::cos(yaw * M_PI / 180.0), 0.4 * std::sin(yaw * M_PI / 180.0), 0.0),
          yaw) +
      "/><leds medium=\"leds\"><led offset=\"-0.05,0,0.05\" anchor=\"origin\" color=\"red\"/>"
      "<led offset=\"0.05,0,0.05\" anchor=\"origin\" color=\"green\"/>"
      "<led offset=\"0,0.05,0.05\" anchor=\"origin\" color=\"green\"/>"
      "<led offset=\"0,-0.05,0.05\" anchor=\"origin\" color=\"green\"/>"
      "<led offset=\"0,0,0.1\" anchor=\"origin\" color=\"blue\"/></leds></box>";
  CRobotWorld world(WithCamera(FootBot("r", CVector3()) + cube));
  const TSensor::TBlobList& blobs = Look(world);
  REQUIRE(blobs.size() == 2);
  CHECK(blobs[0]->Color == CColor::RED);
  CHECK_THAT(blobs[0]->Distance, WithinAbs(35.0, kRounding));
  CHECK(blobs[1]->Color == CColor::BLUE);
  CHECK_THAT(blobs[1]->Distance, WithinAbs(40.0, kRounding));
}

TEST_CASE("omnidirectional camera: equals brute force among many bodies and lights",
          "[contract][cameras]") {
  const std::string index = GENERATE("grid", "hash");
  CRandomStream random(2, "test", "omnidirectional camera", "crowd");
  size_t seenInAll = 0;
  size_t hiddenInAll = 0;
  for (int trial = 0; trial < 10; ++trial) {
    CAPTURE(index, trial);
    std::string arena = FootBot("r", CVector3());
    for (int i = 0; i < 16; ++i) {
      const Real distance = random.Uniform(0.15, 0.8);
      const Real angle = random.Uniform(-M_PI, M_PI);
      const CVector3 place(distance * std::cos(angle), distance * std::sin(angle), 0.0);
      const Real height = random.Uniform(0.02, 0.4);
      if (i % 2 == 0) {
        arena += PillarText("p" + std::to_string(i), place.GetX(), place.GetY(), 0.04, height);
      } else {
        arena += BoxText("b" + std::to_string(i), CVector3(0.05, 0.1, height), place,
                         random.Uniform(-180.0, 180.0));
      }
    }
    for (int i = 0; i < 90; ++i) {
      arena += LightText(
          "l" + std::to_string(i),
          CVector3(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(0.0, 0.4)));
    }
    SRobotExperiment experiment = WithCamera(arena);
    experiment.Media = "<led id=\"leds\" index=\"" + index + "\"/>";
    CRobotWorld world(experiment);
    const TSensor::TBlobList& blobs = Look(world);
    std::vector<CVector3> seen;
    for (const CLEDEntity* led : ReferenceLitLEDs(world.GetSpace())) {
      const CVector3& p = led->GetPosition();
      if (std::abs(p.GetX()) < kHalfSide && std::abs(p.GetY()) < kHalfSide && p.GetZ() <= kHeight) {
        const bool inSight =
            ReferenceInSight(world.GetSpace(), CVector3(0.0, 0.0, kHeight), p, "r");
        hiddenInAll += inSight ? 0 : 1;
        if (inSight) {
          seen.push_back(p);
        }
      }
    }
    seenInAll += seen.size();
    CheckBlobs(blobs, seen, 0.0, 0.0, 0.0);
  }
  // the comparison covers enough blobs
  CHECK(seenInAll > 50);
  CHECK(hiddenInAll > 50);
}

TEST_CASE("omnidirectional camera: mirrored worlds give mirrored blobs, turned worlds equal ones",
          "[contract][cameras]") {
  // the covered square has mirror planes and quarter turns as symmetries
  const bool mirrored = GENERATE(false, true);
  const int quarters = GENERATE(0, 1, 2, 3);
  CAPTURE(mirrored, quarters);
  const auto build = [](bool mirror, int turns) {
    const Real yaw = 90.0 * turns;
    const Real cosine = std::cos(yaw * M_PI / 180.0);
    const Real sine = std::sin(yaw * M_PI / 180.0);
    const auto place = [&](Real x, Real y, Real z) {
      const Real side = mirror ? -y : y;
      return CVector3(cosine * x - sine * side, sine * x + cosine * side, z);
    };
    const auto turn = [&](Real degrees) { return yaw + (mirror ? -degrees : degrees); };
    std::string arena = FootBot("r", place(0.0, 0.0, 0.0), turn(25.0));
    arena += BoxText("b", CVector3(0.1, 0.2, 0.2), place(0.3, 0.1, 0.0), turn(20.0));
    const CVector3 pillar = place(-0.2, 0.25, 0.0);
    arena += PillarText("p", pillar.GetX(), pillar.GetY(), 0.05, 0.25);
    CRandomStream random(3, "test", "omnidirectional camera", "symmetry");
    for (int i = 0; i < 40; ++i) {
      const Real x = random.Uniform(-0.9, 0.9);
      const Real y = random.Uniform(-0.9, 0.9);
      arena += LightText("l" + std::to_string(i), place(x, y, random.Uniform(0.0, 0.3)));
    }
    return WithCamera(arena);
  };
  CRobotWorld plain(build(false, 0));
  const TSensor::TBlobList& expected = Look(plain);
  CHECK(expected.size() > 10);
  CHECK(expected.size() < 35);
  CRobotWorld world(build(mirrored, quarters));
  const TSensor::TBlobList& blobs = Look(world);
  REQUIRE(blobs.size() == expected.size());
  for (size_t i = 0; i < blobs.size(); ++i) {
    CHECK_THAT(blobs[i]->Distance, WithinAbs(expected[i]->Distance, kRounding));
    const Real angle = expected[i]->Angle.GetValue();
    CHECK_THAT(AngleBetween(blobs[i]->Angle.GetValue(), mirrored ? -angle : angle),
               WithinAbs(0.0, 1e-13));
  }
}

TEST_CASE("omnidirectional camera: robots in a row have symmetric views", "[contract][cameras]") {
  // equal neighbours at equal distances to the left and to the right of robot "r"
  SRobotExperiment experiment =
      WithCamera(FootBot("left", CVector3(0.0, 0.4, 0.0), 180.0) + FootBot("r", CVector3()) +
                 FootBot("right", CVector3(0.0, -0.4, 0.0)));
  experiment.Actuators = "<leds implementation=\"default\" medium=\"leds\"/>";
  CRobotWorld world(experiment);
  for (const char* id : {"left", "right"}) {
    world.GetActuator<CCI_LEDsActuator>(id, "leds").SetAllColors(CColor::RED);
    Camera(world, id).Enable();
  }
  const TSensor::TBlobList& blobs = Look(world);
  REQUIRE(blobs.size() % 2 == 0);
  const size_t half = blobs.size() / 2;
  CHECK(half >= 7);
  for (size_t i = 0; i < half; ++i) {
    // a half turn about robot "r" maps one neighbour to the other
    CHECK_THAT(blobs[i]->Distance, WithinAbs(blobs[half + i]->Distance, kRounding));
    CHECK_THAT(AngleBetween(blobs[i]->Angle.GetValue(), blobs[half + i]->Angle.GetValue() + M_PI),
               WithinAbs(0.0, 1e-13));
  }
  // The outer robots see each other over the unlit one between, 80 cm away. The beacon and the far
  // half of the ring are outside the covered square.
  CHECK(Blobs(world, "left").size() == Blobs(world, "right").size());
}

TEST_CASE("omnidirectional camera: sees LEDs at their positions after this tick's physics",
          "[contract][cameras]") {
  SRobotExperiment experiment =
      WithCamera(FootBot("r", CVector3(), 10.0) + FootBot("other", CVector3(0.4, 0.2, 0.0), 120.0));
  experiment.Engine = "<dynamics2d id=\"engine\"/>";
  experiment.Actuators =
      "<leds implementation=\"default\" medium=\"leds\"/>"
      "<differential_steering implementation=\"default\"/>";
  CRobotWorld world(experiment);
  const char* const kWheels = "differential_steering";
  world.GetActuator<CCI_LEDsActuator>("other", "leds").SetAllColors(CColor::RED);
  world.GetActuator<CCI_DifferentialSteeringActuator>("other", kWheels)
      .SetLinearVelocity(30.0, 10.0);
  world.GetActuator<CCI_DifferentialSteeringActuator>("r", kWheels).SetLinearVelocity(-5.0, 5.0);
  Camera(world).Enable();
  auto& body = world.Get<CFootBotEntity>("r").GetEmbodiedEntity();
  auto& otherBody = world.Get<CFootBotEntity>("other").GetEmbodiedEntity();
  for (int tick = 0; tick < 20; ++tick) {
    world.Step();
    CAPTURE(tick);
    const CVector3& place = body.GetOriginAnchor().Position;
    CRadians yaw;
    CRadians pitch;
    CRadians roll;
    body.GetOriginAnchor().Orientation.ToEulerAngles(yaw, pitch, roll);
    // positions computed from the pose of the body, not read from the LED entities
    const SAnchor& other = otherBody.GetOriginAnchor();
    std::vector<CVector3> seen;
    for (int i = 0; i < 13; ++i) {
      const CRadians angle = ToRadians(CDegrees(15.0 + 30.0 * i));
      CVector3 led = i == 12 ? CVector3(0.0, 0.0, 0.174249733)
                             : CVector3(0.090036758 * Cos(angle), 0.090036758 * Sin(angle), 0.085);
      led.Rotate(other.Orientation);
      led += other.Position;
      if (ReferenceInSight(world.GetSpace(), place + CVector3(0.0, 0.0, kHeight), led, "r")) {
        seen.push_back(led);
      }
    }
    CHECK(seen.size() >= 7);
    CheckBlobs(Blobs(world), seen, place.GetX(), place.GetY(), ToDegrees(yaw).GetValue());
  }
  // the robots have moved
  CHECK(Distance(otherBody.GetOriginAnchor().Position, CVector3(0.4, 0.2, 0.0)) > 0.1);
}

TEST_CASE("omnidirectional camera: lines of sight are recorded only on request",
          "[contract][cameras]") {
  const bool show = GENERATE(false, true);
  CRobotWorld world(WithCamera(
      FootBot("r", CVector3()) + BoxText("w", CVector3(0.1, 0.2, 1.0), CVector3(0.3, 0.0, 0.0)) +
          LightText("hidden", CVector3(0.6, 0.0, 0.0)) + LightText("seen", CVector3(0.0, 0.6, 0.1)),
      show ? "show_rays=\"true\"" : ""));
  CHECK(Look(world).size() == 1);
  CControllableEntity& robot = world.GetRobot("r");
  REQUIRE(robot.GetCheckedRays().size() == (show ? 2 : 0));
  REQUIRE(robot.GetIntersectionPoints().size() == (show ? 1 : 0));
  if (show) {
    CHECK(robot.GetCheckedRays()[0].first);
    CHECK_FALSE(robot.GetCheckedRays()[1].first);
    CHECK(robot.GetCheckedRays()[1].second.GetEnd() == CVector3(0.0, 0.6, 0.1));
    // the wall begins at x = 0.25
    const CVector3 expected(0.25, 0.0, kHeight * (1.0 - 0.25 / 0.6));
    CHECK_THAT(Distance(robot.GetIntersectionPoints()[0], expected), WithinAbs(0.0, 1e-14));
  }
}

TEST_CASE("omnidirectional camera: is a component that robots create on demand, and can be changed",
          "[contract][cameras]") {
  SRobotExperiment experiment;
  experiment.Arena = FootBot("r", CVector3(), 90.0);
  CRobotWorld blind(experiment);
  for (const CEntity* component : blind.Get<CFootBotEntity>("r").GetExistingComponents()) {
    CHECK(component->GetTypeDescription() != "omnidirectional_camera");
  }
  CRobotWorld world(
      WithCamera(FootBot("r", CVector3(), 90.0) + LightText("l", CVector3(0.9, 0.0, 0.0))));
  auto& robot = world.Get<CFootBotEntity>("r");
  auto& camera = robot.GetOmnidirectionalCameraEquippedEntity();
  CHECK(&robot.GetComponent("omnidirectional_camera") == &camera);
  CHECK(camera.GetOffset() == CVector3(0.0, 0.0, kHeight));
  CHECK_THAT(ToDegrees(camera.GetAperture()).GetValue(), WithinAbs(70.0, 1e-12));
  CHECK(Look(world).empty());
  // an offset to the right of the robot is along world x
  camera.SetOffset(CVector3(0.0, -0.2, kHeight));
  world.Step();
  REQUIRE(Blobs(world).size() == 1);
  CHECK_THAT(Blobs(world)[0]->Distance, WithinAbs(70.0, kRounding));
  CHECK_THAT(Blobs(world)[0]->Angle.GetValue(), WithinAbs(-M_PI / 2.0, 1e-14));
  camera.SetAperture(ToRadians(CDegrees(60.0)));
  world.Step();
  CHECK(Blobs(world).empty());
  CHECK_THROWS_WITH(camera.SetAperture(CRadians::PI_OVER_TWO),
                    Contains("aperture") && Contains("90 degrees"));
}

TEST_CASE("omnidirectional camera: invalid experiments are refused with the reason",
          "[contract][cameras][errors]") {
  SRobotExperiment experiment = WithCamera(FootBot("fb0", CVector3()));
  CHECK(LoadError(experiment).empty());
  SECTION("a missing medium") {
    experiment.Sensors = std::string("<") + kSensor + " implementation=\"rot_z_only\"/>";
    CHECK_THAT(LoadError(experiment), Contains("medium") && Contains("test.argos:"));
  }
  SECTION("an unknown medium") {
    experiment.Media = "<led id=\"lamps\"/>";
    CHECK_THAT(LoadError(experiment), Contains("LED medium") && Contains("\"leds\"") &&
                                          Contains("lamps") && Contains("test.argos:"));
  }
  SECTION("a medium of the wrong type") {
    experiment.Media = "<toy_medium id=\"leds\"/>";
    CHECK_THAT(LoadError(experiment), Contains("LED medium") && Contains("\"leds\""));
  }
  SECTION("negative noise") {
    experiment = WithCamera(FootBot("fb0", CVector3()), "noise_std_dev=\"-1\"");
    CHECK_THAT(LoadError(experiment),
               Contains("noise_std_dev") && Contains(">= 0") && Contains("-1") && Contains("fb0"));
  }
  SECTION("noise on an unknown quantity") {
    experiment = WithCamera(FootBot("fb0", CVector3()), "",
                            "<noise on=\"range\" model=\"gaussian\" std_dev=\"1\"/>");
    CHECK_THAT(LoadError(experiment),
               Contains("no \"range\"") && Contains("distance") && Contains("angle"));
  }
  SECTION("a robot without such a camera") {
    experiment = WithCamera(Robot("e-puck", "ep0", PoseText(CVector3())));
    CHECK_THAT(LoadError(experiment),
               Contains("ep0") && Contains("no component \"omnidirectional_camera\""));
  }
  SECTION("an unknown implementation") {
    experiment.Sensors =
        std::string("<") + kSensor + " implementation=\"default\" medium=\"leds\"/>";
    CHECK_THAT(LoadError(experiment), Contains("rot_z_only"));
  }
}

}  // namespace argos::omnidirectional_camera_test
