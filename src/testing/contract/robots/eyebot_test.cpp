// Components and sensors of the eye-bot; the numbers are those
// published with ARGoS 3, repeated here.

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/sight_reference.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::eyebot_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

// tolerance of a few roundings of numbers below 10
constexpr Real kRounding = 1e-14;

CEyeBotEntity& EyeBot(CRobotWorld& world, const std::string& id = "r") {
  return world.Get<CEyeBotEntity>(id);
}

SRobotExperiment OneEyeBot(const std::string& sensors = "") {
  SRobotExperiment experiment;
  experiment.Engine = "<pointmass3d id=\"engine\"/>";
  experiment.Sensors = sensors;
  experiment.Arena = Robot("eye-bot", "r", PoseText(CVector3(0, 0, 0.25)));
  return experiment;
}

}  // namespace

TEST_CASE("eye-bot: its body has the published measures", "[contract][robots]") {
  SRobotExperiment experiment;
  experiment.Arena = Robot("eye-bot", "r", PoseText(CVector3(1, 2, 0.3), 90.0)) +
                     Robot("eye-bot", "s", PoseText(CVector3(-1, 2, 0.3)));
  CRobotWorld world(experiment);
  CEyeBotEntity& robot = EyeBot(world);
  CHECK(robot.GetTypeDescription() == "eye-bot");
  const SBodyDescription& body = *robot.GetEmbodiedEntity().GetBodyDescription();
  CHECK(&body == EyeBot(world, "s").GetEmbodiedEntity().GetBodyDescription());
  REQUIRE(body.Shapes.size() == 1);
  CHECK(body.Shapes[0].Kind == SShapeDescription::EKind::Cylinder);
  CHECK(body.Shapes[0].Radius == 0.25);
  CHECK(body.Shapes[0].Size.GetZ() == 0.566);
  CHECK(body.Mass == 1.0);
  CHECK(body.GetPlanarInertia() == 0.01);
  CHECK_FALSE(body.Drive.has_value());
  REQUIRE(body.Propellers.has_value());
  const SPropellersDescription& propellers = *body.Propellers;
  CHECK(propellers.Position.Proportional == 20.0);
  CHECK(propellers.Position.Derivative == 10.0);
  CHECK(propellers.Yaw.Proportional == 0.5);
  CHECK(propellers.Yaw.Derivative == 0.1);
  CHECK(propellers.Velocity.Proportional == 20.0);
  CHECK(propellers.Velocity.Derivative == 0.0);
  CHECK(propellers.YawRate.Proportional == 0.5);
  CHECK(propellers.YawRate.Derivative == 0.1);
  CHECK(propellers.MaxForce == 1000.0);
  CHECK(propellers.MaxTorque == 1000.0);
  CHECK(robot.GetEmbodiedEntity().GetOriginAnchor().Position == CVector3(1, 2, 0.3));
  CHECK(robot.GetEmbodiedEntity().IsMovable());
}

TEST_CASE("eye-bot: its LEDs and sensors are at the published positions", "[contract][robots]") {
  CRobotWorld world(OneEyeBot());
  CEyeBotEntity& robot = EyeBot(world);
  const CLEDEquippedEntity& leds = robot.GetLEDEquippedEntity();
  REQUIRE(leds.GetNumLEDs() == 33);
  for (int i = 0; i < 32; ++i) {
    const Real angle = (11.25 + 22.5 * (i % 16)) * M_PI / 180.0;
    const CVector3 expected(0.255 * std::cos(angle), 0.255 * std::sin(angle),
                            i < 16 ? 0.1535 : 0.1635);
    CHECK_THAT(Distance(leds.GetLEDOffset(i), expected), WithinAbs(0.0, kRounding));
  }
  const Real diagonal = 0.1785 * std::sqrt(0.5);
  CHECK_THAT(Distance(leds.GetLEDOffset(32), CVector3(-diagonal, diagonal, 0.1435)),
             WithinAbs(0.0, kRounding));

  auto& proximity = robot.GetProximitySensorEquippedEntity();
  auto& light = robot.GetLightSensorEquippedEntity();
  REQUIRE(proximity.GetNumSensors() == 24);
  REQUIRE(light.GetNumSensors() == 24);
  for (int i = 0; i < 24; ++i) {
    const Real angle = (7.5 + 15.0 * i) * M_PI / 180.0;
    const CVector3 outward(std::cos(angle), std::sin(angle), 0.0);
    const CVector3 place = outward * 0.255 + CVector3(0, 0, 0.1635);
    CHECK_THAT(Distance(proximity.GetSensor(i).Offset, place), WithinAbs(0.0, kRounding));
    CHECK_THAT(Distance(proximity.GetSensor(i).Direction, outward * 3.0),
               WithinAbs(0.0, kRounding));
    CHECK_THAT(Distance(light.GetSensor(i).Position, place), WithinAbs(0.0, kRounding));
  }
}

TEST_CASE("eye-bot: every getter returns the component of its name", "[contract][robots]") {
  CRobotWorld world(OneEyeBot());
  CEyeBotEntity& robot = EyeBot(world);
  CHECK(&robot.GetComponent("body") == &robot.GetEmbodiedEntity());
  CHECK(&robot.GetComponent("leds") == &robot.GetLEDEquippedEntity());
  CHECK(&robot.GetComponent("proximity_sensors") == &robot.GetProximitySensorEquippedEntity());
  CHECK(&robot.GetComponent("quadrotor") == &robot.GetQuadRotorEntity());
  CHECK(&robot.GetComponent("controller") == &robot.GetControllableEntity());
  CHECK(&robot.GetComponent("light_sensors") == &robot.GetLightSensorEquippedEntity());
  CHECK(&robot.GetComponent("perspective_camera") == &robot.GetPerspectiveCameraEquippedEntity());
  CHECK(&robot.GetComponent("rab") == &robot.GetRABEquippedEntity());
  CHECK(robot.GetRABEquippedEntity().GetMsgSize() == 10);
  CHECK(robot.GetRABEquippedEntity().GetRange() == 3.0);
  // the RAB device is at the origin
  CHECK(robot.GetRABEquippedEntity().GetPosition() ==
        robot.GetEmbodiedEntity().GetOriginAnchor().Position);
  CHECK_THROWS_WITH(robot.GetComponent("wheels"), Contains("no component \"wheels\""));
}

TEST_CASE("eye-bot: its appearance matches its body", "[contract][robots]") {
  CRobotWorld world(OneEyeBot());
  const SAppearance* appearance = EyeBot(world).GetAppearance();
  REQUIRE(appearance != nullptr);
  std::vector<int> leds(33, 0);
  int numTranslucent = 0;
  for (const SVisualPart& part : appearance->Parts) {
    CHECK(part.Size.GetX() > 0.0);
    CHECK(part.Anchor == "origin");
    if (part.Kind == SVisualPart::EKind::LED) {
      REQUIRE(part.LED < 33);
      ++leds[part.LED];
      CHECK_THAT(
          Distance(part.Position, EyeBot(world).GetLEDEquippedEntity().GetLEDOffset(part.LED)),
          WithinAbs(0.0, kRounding));
    } else {
      // everything drawn is inside the body that rays hit
      const SBoundingBox box = [&part] {
        SBodyDescription solid;
        solid.Shapes.push_back(SShapeDescription::Box(part.Size));
        solid.Shapes[0].Orientation = part.Orientation;
        return solid.ComputeBoundingBox(part.Position, CQuaternion());
      }();
      CHECK(box.MaxCorner.GetZ() <= 0.566 + kRounding);
      numTranslucent += part.Color.GetAlpha() < 255 ? 1 : 0;
    }
  }
  CHECK(leds == std::vector<int>(33, 1));
  // discs of four pairs of propellers
  CHECK(numTranslucent == 8);
}

TEST_CASE("eye-bot: its proximity sensors are at its own height", "[contract][sensors]") {
  // a high wall ahead, and behind the robot a wall that ends 3.5 mm below the rays
  SRobotExperiment experiment = OneEyeBot(
      "<eyebot_proximity implementation=\"default\"/><proximity implementation=\"default\"/>");
  const Real angle = 7.5 * M_PI / 180.0;  // of sensor 0
  experiment.Arena += BoxText("wall", CVector3(0.2, 8, 5), CVector3(2, 0, 0)) +
                      BoxText("low", CVector3(0.2, 8, 0.41), CVector3(-1, 0, 0));
  CRobotWorld world(experiment);
  world.Step();
  const Real distance = 1.9 / std::cos(angle) - 0.255;
  const auto& readings =
      world.GetSensor<CCI_EyeBotProximitySensor>("r", "eyebot_proximity").GetReadings();
  REQUIRE(readings.size() == 24);
  CHECK_THAT(readings[0].Value, WithinAbs(0.0100527 / (distance + 0.000163144), kRounding));
  CHECK_THAT(readings[23].Value, WithinAbs(readings[0].Value, kRounding));
  CHECK_THAT(readings[23].Angle.GetValue(), WithinAbs(-angle, kRounding));
  // 0.25 m + 0.1635 m
  CHECK(readings[11].Value == 0.0);
  CHECK_THAT(world.GetSensor<CCI_ProximitySensor>("r", "proximity").GetReadings()[0],
             WithinAbs(std::exp(-distance), kRounding));
}

TEST_CASE("eye-bot: its light sensors read like those of a foot-bot in its place",
          "[contract][sensors]") {
  const std::string lamps =
      LampText("a", CVector3(1.5, 0.7, 0.8), 1.2) + LampText("b", CVector3(-0.4, 0.3, 0.9), 0.6);
  SRobotExperiment experiment = OneEyeBot("<eyebot_light implementation=\"rot_z_only\"/>");
  experiment.Arena = Robot("eye-bot", "r", PoseText(CVector3(0.2, -0.1, 0.0), 40.0)) + lamps;
  CRobotWorld eyeBot(experiment);
  experiment.Sensors = "<footbot_light implementation=\"rot_z_only\"/>";
  experiment.Arena = Robot("foot-bot", "r", PoseText(CVector3(0.2, -0.1, 0.0), 40.0)) + lamps;
  CRobotWorld footBot(experiment);
  eyeBot.Step();
  footBot.Step();
  const auto& seen = eyeBot.GetSensor<CCI_EyeBotLightSensor>("r", "eyebot_light").GetReadings();
  const auto& expected =
      footBot.GetSensor<CCI_FootBotLightSensor>("r", "footbot_light").GetReadings();
  REQUIRE(seen.size() == expected.size());
  Real sum = 0.0;
  for (size_t i = 0; i < seen.size(); ++i) {
    CAPTURE(i);
    CHECK_THAT(seen[i].Value, WithinAbs(expected[i].Value, kRounding));
    CHECK(seen[i].Angle == expected[i].Angle);
    sum += seen[i].Value;
  }
  // the lamps are not occluded
  CHECK(sum > 0.3);
}

TEST_CASE("eye-bot: without a light, its light sensors read zeros", "[contract][sensors]") {
  CRobotWorld world(OneEyeBot("<eyebot_light implementation=\"rot_z_only\"/>"));
  world.Step();
  for (const auto& reading :
       world.GetSensor<CCI_EyeBotLightSensor>("r", "eyebot_light").GetReadings()) {
    CHECK(reading.Value == 0.0);
  }
}

TEST_CASE("eye-bot: its camera looks straight down and turns with the robot",
          "[contract][sensors]") {
  // At a height of 1.5 m; ahead of the robot is up in the image, left of it is left.
  const Real yaw = GENERATE(0.0, 90.0, -135.0);  // degrees
  CAPTURE(yaw);
  SRobotExperiment experiment =
      OneEyeBot("<colored_blob_perspective_camera implementation=\"default\" medium=\"leds\"/>");
  const CQuaternion turn(ToRadians(CDegrees(yaw)), CVector3::Z);
  CVector3 ahead(0.2, 0.1, 0.0);
  ahead.Rotate(turn);
  experiment.Arena = "<eye-bot id=\"r\" camera_aperture=\"40\" camera_range=\"3\"><body " +
                     PoseText(CVector3(0, 0, 1.5), yaw) + "/><controller config=\"c\"/></eye-bot>" +
                     LightText("l", ahead);
  experiment.Engine = "<toy_engine id=\"engine\"/>";
  CRobotWorld world(experiment);
  auto& camera = world.GetSensor<CCI_ColoredBlobPerspectiveCameraSensor>(
      "r", "colored_blob_perspective_camera");
  camera.Enable();
  world.Step(2);
  REQUIRE(camera.GetReadings().BlobList.size() == 1);
  // the image height is 2 f tan(40 degrees) 3/5; a pixel is 1/480 of it
  const Real pixelsPerTangent = 480.0 / (2.0 * std::tan(40.0 * M_PI / 180.0) * 0.6);
  CHECK(camera.GetReadings().BlobList[0]->X ==
        static_cast<SInt32>(320.0 - pixelsPerTangent * 0.1 / 1.5));
  CHECK(camera.GetReadings().BlobList[0]->Y ==
        static_cast<SInt32>(240.0 - pixelsPerTangent * 0.2 / 1.5));
}

TEST_CASE("eye-bot: its lower LEDs are seen from beneath, through its own body only",
          "[contract][robots][cameras]") {
  const CVector3 eyeBot = GENERATE(CVector3(0.0, 0.0, 1.5), CVector3(0.2, -0.1, 1.2));
  const bool tilted = GENERATE(false, true);
  const bool hasWall = GENERATE(false, true);
  CAPTURE(eyeBot, tilted, hasWall);
  SRobotExperiment experiment;
  experiment.Actuators = "<leds implementation=\"default\" medium=\"leds\"/>";
  experiment.Sensors =
      "<colored_blob_perspective_camera implementation=\"default\" medium=\"leds\"/>";
  // a wide view straight up, above the middle of the foot-bot's front
  experiment.Arena =
      R"(<foot-bot id="fb" perspective_camera_front="false" perspective_camera_aperture="60"
           perspective_camera_range="5"><body position="-0.085,0,0"/>
         <controller config="c"/></foot-bot>)" +
      Robot("eye-bot", "eb", PoseText(eyeBot, 30.0) /* the pose of the tilted one is set below */);
  if (hasWall) {
    // over the left half of the view
    experiment.Arena += BoxText("ceiling", CVector3(4.0, 2.0, 0.1), CVector3(0.0, 1.0, 0.8));
  }
  CRobotWorld world(experiment);
  if (tilted) {
    EyeBot(world, "eb")
        .GetEmbodiedEntity()
        .SetOriginPose(eyeBot, CQuaternion(CRadians(0.2), CVector3::X));
  }
  auto& camera = world.GetSensor<CCI_ColoredBlobPerspectiveCameraSensor>(
      "fb", "colored_blob_perspective_camera");
  camera.Enable();
  CLEDEquippedEntity& leds = EyeBot(world, "eb").GetLEDEquippedEntity();
  // one after the other, so that a blob is of a known LED
  const auto isSeen = [&](UInt32 led) {
    auto& actuator = world.GetActuator<CCI_LEDsActuator>("eb", "leds");
    actuator.SetAllColors(CColor::BLACK);
    actuator.SetSingleColor(led, CColor::RED);
    world.Step();
    return camera.GetReadings().BlobList.size() == 1;
  };
  const CVector3 eye = world.Get<CComposableEntity>("fb")
                           .GetComponent<CPerspectiveCameraEquippedEntity>("perspective_camera")
                           .ComputePosition();
  leds.UpdateComponents();
  size_t numSeen = 0;
  for (UInt32 led = 0; led < 33; ++led) {
    const CVector3 position = leds.GetLED(led).GetPosition();
    CAPTURE(led, position);
    // only the ceiling hides the lower LEDs; all bodies hide the others
    const bool isLower = led < 16 || led == 32;
    const bool isClear = isLower ? !(hasWall && position.GetY() > eye.GetY())
                                 : ReferenceInSight(world.GetSpace(), eye, position, "fb");
    CHECK(isSeen(led) == isClear);
    numSeen += isClear ? 1 : 0;
  }
  if (!hasWall) {
    CHECK(numSeen >= 17);
  }
}

TEST_CASE("eye-bot: programs create it by one call", "[contract][robots]") {
  SRobotExperiment experiment;
  experiment.Engine = "<pointmass3d id=\"engine\"/>";
  experiment.Actuators = "<quadrotor_position implementation=\"default\"/>";
  CRobotWorld world(experiment);
  // no robot of the file uses the controller
  CHECK_THAT(TakeLogErr(), Contains("no robot has the controller \"c\""));
  world.Add(std::make_unique<CEyeBotEntity>("eb", "c", CVector3(1, 2, 0.25), CQuaternion(), 2.5, 7,
                                            "", CRadians::PI_OVER_FOUR, 0.05, 1.5));
  world.Step(10);
  CEyeBotEntity& robot = EyeBot(world, "eb");
  CHECK(robot.GetEmbodiedEntity().GetOriginAnchor().Position == CVector3(1, 2, 0.25));
  CHECK(robot.GetDeviceParameters().RAB.Range == 2.5);
  CHECK(robot.GetDeviceParameters().RAB.DataSize == 7);
  CHECK(robot.GetDeviceParameters().PerspectiveCamera.Aperture == CRadians::PI_OVER_FOUR);
  CHECK(robot.GetDeviceParameters().PerspectiveCamera.FocalLength == 0.05);
  CHECK(robot.GetDeviceParameters().PerspectiveCamera.Range == 1.5);
  CHECK_THROWS_WITH(CEyeBotEntity("e", "", CVector3(), CQuaternion(), -1.0),
                    Contains("eye-bot \"e\"") && Contains("rab_range"));
  CHECK_THROWS_WITH(
      CEyeBotEntity("e", "", CVector3(), CQuaternion(), 3.0, 10, "", CRadians::PI_OVER_TWO),
      Contains("eye-bot \"e\"") && Contains("camera_aperture"));
}

namespace {

struct SDevices {
  Real RABRange;  // m
  UInt32 DataSize;
  Real Aperture;  // degrees
  Real FocalLength, CameraRange;  // m
};

void CheckDevices(CRobotWorld& world, const SDevices& expected) {
  const SDeviceParameters& parameters = EyeBot(world).GetDeviceParameters();
  CHECK(parameters.RAB.Range == expected.RABRange);
  CHECK(parameters.RAB.DataSize == expected.DataSize);
  CHECK_THAT(ToDegrees(parameters.PerspectiveCamera.Aperture).GetValue(),
             WithinAbs(expected.Aperture, kRounding));
  CHECK(parameters.PerspectiveCamera.FocalLength == expected.FocalLength);
  CHECK(parameters.PerspectiveCamera.Range == expected.CameraRange);
}

}  // namespace

TEST_CASE("eye-bot: attributes are read and checked, and have the documented defaults",
          "[contract][robots][errors]") {
  const auto withAttributes = [](const std::string& attributes) {
    SRobotExperiment experiment;
    experiment.Arena = "<eye-bot id=\"r\" " + attributes +
                       "><body position=\"0,0,0\"/><controller config=\"c\"/></eye-bot>";
    return experiment;
  };
  {
    CRobotWorld world(withAttributes(""));
    CheckDevices(world, {3.0, 10, 30.0, 0.035, 2.0});
  }
  {
    CRobotWorld world(withAttributes(
        "rab_range=\"5\" rab_data_size=\"2\" camera_aperture=\"20\" camera_focal_length=\"0.1\" "
        "camera_range=\"4\" camera_front=\"false\""));
    CheckDevices(world, {5.0, 2, 20.0, 0.1, 4.0});
    // no warning about unused attributes
    CHECK(TakeLogErr() == "");
  }
  for (const std::string attribute :
       {"rab_range=\"-1\"", "camera_aperture=\"90\"", "camera_focal_length=\"0\"",
        "camera_range=\"-2\"", "camera_front=\"maybe\""}) {
    CAPTURE(attribute);
    CHECK_THAT(LoadError(withAttributes(attribute)),
               Contains(attribute.substr(0, attribute.find('='))) && Contains("<eye-bot>"));
  }
}

}  // namespace argos::eyebot_test
