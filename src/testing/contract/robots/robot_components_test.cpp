// Components of robots; the numbers are those published with ARGoS 3, repeated here.

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_equipped_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_entity.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/ground_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/omnidirectional_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <utility>

namespace argos::robot_components_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct SExpected {
  const char* Tag;
  Real Radius, Height, Mass, Inertia;  // m, kg, kg m^2
  Real Axis, WheelRadius, MaxForce, MaxTorque;  // m, N, N m
  size_t NumLEDs, NumProximity;
};

const SExpected kRobots[] = {
    {"foot-bot", 0.085036758, 0.146899733, 1.6, 0.02314, 0.14, 0.029112741, 15.0, 150.0, 13, 24},
    {"e-puck", 0.035, 0.086, 0.4, 0.00098, 0.053, 0.0205, 1.5, 1.5, 8, 8}};

CDifferentialDriveRobotEntity& RobotOf(CRobotWorld& world, const std::string& id = "r") {
  return world.Get<CDifferentialDriveRobotEntity>(id);
}

std::string WithDrive(const std::string& id, const std::string& attributes) {
  return "<e-puck id=\"" + id +
         "\"><body position=\"0,0,0\"/><controller config=\"c\"/><dynamics2d>"
         "<differential_steering " +
         attributes + "/></dynamics2d></e-puck>";
}

}  // namespace

TEST_CASE("robots: the frame of the perspective camera is an anchor", "[contract][robots]") {
  SRobotExperiment experiment;
  experiment.Arena =
      Robot("foot-bot", "r", "position=\"1,2,0\"") + Robot("eye-bot", "e", "position=\"0,0,2\"");
  CRobotWorld world(experiment);
  for (const char* robot : {"r", "e"}) {
    CAPTURE(robot);
    auto& body = world.Get<CComposableEntity>(robot).GetComponent<CEmbodiedEntity>("body");
    SAnchor& anchor = body.GetAnchor("perspective_camera");
    CHECK(anchor.Id == "perspective_camera");
    CHECK(&body.GetAnchor("perspective_camera") == &anchor);
    CHECK_THROWS_WITH(body.GetAnchor("camera"), Contains("has no anchor \"camera\""));
    CHECK(body.GetAnchors().count("perspective_camera") == 1);
  }
}

TEST_CASE("robots: bodies and wheels have the published measures", "[contract][robots]") {
  const SExpected expected = GENERATE(kRobots[0], kRobots[1]);
  CAPTURE(expected.Tag);
  SRobotExperiment experiment;
  experiment.Arena = Robot(expected.Tag, "r", "position=\"1,2,0\" orientation=\"90,0,0\"");
  CRobotWorld world(experiment);
  CDifferentialDriveRobotEntity& robot = RobotOf(world);
  CHECK(robot.GetTypeDescription() == expected.Tag);
  const SBodyDescription& body = *robot.GetEmbodiedEntity().GetBodyDescription();
  REQUIRE(body.Shapes.size() == 1);
  CHECK(body.Shapes[0].Kind == SShapeDescription::EKind::Cylinder);
  CHECK(body.Shapes[0].Radius == expected.Radius);
  CHECK(body.Shapes[0].Size.GetZ() == expected.Height);
  CHECK(body.Mass == expected.Mass);
  REQUIRE(body.PlanarInertia.has_value());
  // published with four digits
  CHECK_THAT(*body.PlanarInertia, WithinRel(expected.Inertia, 2e-4));
  REQUIRE(body.Drive.has_value());
  CHECK(body.Drive->InterwheelDistance == expected.Axis);
  CHECK(body.Drive->WheelRadius == expected.WheelRadius);
  CHECK(body.Drive->MaxForce == expected.MaxForce);
  CHECK(body.Drive->MaxTorque == expected.MaxTorque);
  CHECK(robot.GetWheeledEntity().GetNumWheels() == 2);
  CHECK(robot.GetWheeledEntity().GetWheelPosition(0) == CVector3(0.0, expected.Axis / 2.0, 0.0));
  CHECK(robot.GetWheeledEntity().GetWheelPosition(1) == CVector3(0.0, -expected.Axis / 2.0, 0.0));
  CHECK(robot.GetWheeledEntity().GetWheelRadius(0) == expected.WheelRadius);
  CHECK(robot.GetLEDEquippedEntity().GetNumLEDs() == expected.NumLEDs);
  CHECK(robot.GetProximitySensorEquippedEntity().GetNumSensors() == expected.NumProximity);
  CHECK(robot.GetEmbodiedEntity().GetOriginAnchor().Position == CVector3(1.0, 2.0, 0.0));
  CHECK(robot.GetEmbodiedEntity().IsMovable());
}

TEST_CASE("robots: LEDs are at the published positions", "[contract][robots]") {
  SRobotExperiment experiment;
  experiment.Arena =
      Robot("foot-bot", "fb", "position=\"0,0,0\"") + Robot("e-puck", "ep", "position=\"1,0,0\"");
  CRobotWorld world(experiment);
  const CLEDEquippedEntity& footBot = RobotOf(world, "fb").GetLEDEquippedEntity();
  for (int i = 0; i < 12; ++i) {
    const Real angle = (15.0 + 30.0 * i) * M_PI / 180.0;
    const CVector3 expected(0.090036758 * std::cos(angle), 0.090036758 * std::sin(angle), 0.085);
    CHECK_THAT(Distance(footBot.GetLEDOffset(i), expected), WithinAbs(0.0, 1e-16));
  }
  CHECK(footBot.GetLEDOffset(12) == CVector3(0.0, 0.0, 0.174249733));
  const CLEDEquippedEntity& ePuck = RobotOf(world, "ep").GetLEDEquippedEntity();
  for (int i = 0; i < 8; ++i) {
    const Real angle = (11.25 + 45.0 * i) * M_PI / 180.0;
    const CVector3 expected(0.042 * std::cos(angle), 0.042 * std::sin(angle), 0.086);
    CHECK_THAT(Distance(ePuck.GetLEDOffset(i), expected), WithinAbs(0.0, 1e-16));
  }
}

TEST_CASE("robots: robots with equal parameters share one description", "[contract][robots]") {
  SRobotExperiment experiment;
  experiment.Arena =
      Robot("e-puck", "a", "position=\"0,0,0\"") + Robot("e-puck", "b", "position=\"1,0,0\"") +
      WithDrive("c", "max_force=\"3\"") + WithDrive("d", "max_force=\"3\" max_torque=\"1.5\"") +
      WithDrive("e", "max_torque=\"0.5\"");
  CRobotWorld world(experiment);
  const auto description = [&world](const std::string& id) {
    return RobotOf(world, id).GetEmbodiedEntity().GetBodyDescription();
  };
  CHECK(description("a") == description("b"));
  CHECK(description("c") == description("d"));
  CHECK(description("a") != description("c"));
  CHECK(description("c")->Drive->MaxForce == 3.0);
  CHECK(description("c")->Drive->MaxTorque == 1.5);
  CHECK(description("e")->Drive->MaxForce == 1.5);
  CHECK(description("e")->Drive->MaxTorque == 0.5);
}

TEST_CASE("robots: programs create them by one call", "[contract][robots]") {
  SRobotExperiment experiment;
  experiment.Sensors = "<proximity implementation=\"default\"/>";
  CRobotWorld world(experiment);
  // no robot of the file uses the controller
  CHECK_THAT(TakeLogErr(), Contains("no robot has the controller \"c\""));
  const CQuaternion quarterTurn(CRadians::PI_OVER_TWO, CVector3::Z);
  auto made = std::make_unique<CFootBotEntity>("fb", "c", CVector3(1.0, 2.0, 0.0), quarterTurn);
  // the controller exists before the robot is added to the space
  CHECK(made->GetControllableEntity().GetController().GetId() == "fb");
  CFootBotEntity& footBot = world.Add(std::move(made));
  world.Add(std::make_unique<CEPuckEntity>("ep", "c"));
  world.Step();
  CHECK(&world.Get<CFootBotEntity>("fb") == &footBot);
  CHECK(footBot.GetEmbodiedEntity().GetOriginAnchor().Position == CVector3(1.0, 2.0, 0.0));
  CHECK(world.GetSpace().GetControllableEntities().size() == 2);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("fb");
  CHECK(world.GetSpace().GetControllableEntities().size() == 1);
  world.Step();
}

TEST_CASE("robots: every getter returns the component of its name", "[contract][robots]") {
  SRobotExperiment experiment;
  experiment.Arena =
      Robot("foot-bot", "r", "position=\"0,0,0\"") + Robot("e-puck", "e", "position=\"1,0,0\"");
  CRobotWorld world(experiment);
  auto& robot = world.Get<CFootBotEntity>("r");
  CHECK(&robot.GetComponent("body") == &robot.GetEmbodiedEntity());
  CHECK(&robot.GetComponent("wheels") == &robot.GetWheeledEntity());
  CHECK(&robot.GetComponent("leds") == &robot.GetLEDEquippedEntity());
  CHECK(&robot.GetComponent("proximity_sensors") == &robot.GetProximitySensorEquippedEntity());
  CHECK(&robot.GetComponent("light_sensors") == &robot.GetLightSensorEquippedEntity());
  CHECK(&robot.GetComponent("ground_sensors") == &robot.GetGroundSensorEquippedEntity());
  CHECK(&robot.GetComponent("rab") == &robot.GetRABEquippedEntity());
  CHECK(&robot.GetComponent("gripper") == &robot.GetGripperEquippedEntity());
  CHECK(&robot.GetComponent("turret") == &robot.GetTurretEntity());
  CHECK(&robot.GetComponent("distance_scanner") == &robot.GetDistanceScannerEquippedEntity());
  CHECK(&robot.GetComponent("omnidirectional_camera") ==
        &robot.GetOmnidirectionalCameraEquippedEntity());
  CHECK(&robot.GetComponent("perspective_camera") == &robot.GetPerspectiveCameraEquippedEntity());
  CHECK(&robot.GetComponent("battery") == &robot.GetBatterySensorEquippedEntity());
  CHECK(&robot.GetComponent("controller") == &robot.GetControllableEntity());
  CHECK(robot.GetEmbodiedEntity().GetAnchor("turret").OffsetPosition == CVector3());
  CHECK_THROWS_WITH(robot.GetComponent("quadrotor"), Contains("no component \"quadrotor\""));
  auto& ePuck = world.Get<CEPuckEntity>("e");
  CHECK(&ePuck.GetComponent("body") == &ePuck.GetEmbodiedEntity());
  CHECK(&ePuck.GetComponent("wheels") == &ePuck.GetWheeledEntity());
  CHECK(&ePuck.GetComponent("leds") == &ePuck.GetLEDEquippedEntity());
  CHECK(&ePuck.GetComponent("proximity_sensors") == &ePuck.GetProximitySensorEquippedEntity());
  CHECK(&ePuck.GetComponent("light_sensors") == &ePuck.GetLightSensorEquippedEntity());
  CHECK(&ePuck.GetComponent("ground_sensors") == &ePuck.GetGroundSensorEquippedEntity());
  CHECK(&ePuck.GetComponent("rab") == &ePuck.GetRABEquippedEntity());
  CHECK(&ePuck.GetComponent("battery") == &ePuck.GetBatterySensorEquippedEntity());
  CHECK(&ePuck.GetComponent("controller") == &ePuck.GetControllableEntity());
}

TEST_CASE("robots: values that a component cannot have are refused, and change nothing",
          "[contract][robots]") {
  SRobotExperiment experiment;
  experiment.Arena = Robot("foot-bot", "r", "position=\"0,0,0\"");
  CRobotWorld world(experiment);
  auto& robot = world.Get<CFootBotEntity>("r");
  auto& turret = robot.GetTurretEntity();
  turret.SetMode(CTurretEntity::MODE_POSITION_CONTROL);
  CHECK_THROWS_WITH(turret.SetMode(4), Contains("there is no mode 4, but modes 0 to 3"));
  CHECK(turret.GetMode() == CTurretEntity::MODE_POSITION_CONTROL);
  auto& scanner = robot.GetDistanceScannerEquippedEntity();
  CHECK_NOTHROW(scanner.SetMode(2));
  CHECK_THROWS_WITH(scanner.SetMode(3), Contains("there is no mode 3, but modes 0 to 2"));
  auto& camera = robot.GetPerspectiveCameraEquippedEntity();
  camera.SetImagePxSize(30, 20);
  for (const auto& [width, height] : {std::pair<SInt32, SInt32>{0, 20}, {30, 0}, {-1, 20}}) {
    CHECK_THROWS_WITH(camera.SetImagePxSize(width, height), Contains("at least 1 pixel"));
  }
  CHECK(camera.GetImagePxWidth() == 30);
  CHECK(camera.GetImagePxHeight() == 20);
}

TEST_CASE("robots: engines update a robot after moves only while a component follows its body",
          "[contract][robots]") {
  SRobotExperiment experiment;
  experiment.Arena = Robot("foot-bot", "r", "position=\"0,0,0\"");
  experiment.Media += "<range_and_bearing id=\"rab\"/>";
  CRobotWorld world(experiment);
  auto& robot = world.Get<CFootBotEntity>("r");
  const CEmbodiedEntity& body = robot.GetEmbodiedEntity();
  CHECK_FALSE(body.HasFollowers());
  const std::vector<CEntity*> followers = {
      &robot.GetLEDEquippedEntity(), &robot.GetRABEquippedEntity(),
      &robot.GetBatterySensorEquippedEntity(), &robot.GetDistanceScannerEquippedEntity(),
      &robot.GetComponent("odometer")};
  for (CEntity* follower : followers) {
    CAPTURE(follower->GetId());
    CHECK_FALSE(body.HasFollowers());
    follower->SetEnabled(true);
    CHECK(body.HasFollowers());
    // again: counts once
    follower->SetEnabled(true);
    follower->SetEnabled(false);
    CHECK_FALSE(body.HasFollowers());
    follower->SetEnabled(true);
    world.GetSimulator().Reset();
    CHECK_FALSE(body.HasFollowers());
  }
  followers[0]->SetEnabled(true);
  followers[1]->SetEnabled(true);
  robot.SetEnabled(false);
  CHECK_FALSE(body.HasFollowers());
  robot.SetEnabled(true);
  CHECK(body.HasFollowers());
  // each is enabled again
  CHECK(followers[0]->IsEnabled());
  CHECK(followers[1]->IsEnabled());
}

TEST_CASE("robots: the appearance shows the body and its front", "[contract][robots]") {
  const SExpected expected = GENERATE(kRobots[0], kRobots[1]);
  SRobotExperiment experiment;
  experiment.Arena = Robot(expected.Tag, "r", "position=\"0,0,0\"");
  CRobotWorld world(experiment);
  const SAppearance* appearance = RobotOf(world).GetAppearance();
  REQUIRE(appearance != nullptr);
  size_t numLEDs = 0;
  Real ahead = 0.0;
  for (const SVisualPart& part : appearance->Parts) {
    numLEDs += part.Kind == SVisualPart::EKind::LED ? 1 : 0;
    CHECK(part.LED < expected.NumLEDs);
    CHECK(part.Size.GetX() > 0.0);
    CHECK(RobotOf(world).GetEmbodiedEntity().GetAnchors().count(part.Anchor) == 1);
    if (part.Kind == SVisualPart::EKind::Box) {
      ahead += part.Position.GetX();
    }
  }
  CHECK(numLEDs == expected.NumLEDs);
  CHECK(ahead > 0.0);
}

TEST_CASE("robots: invalid experiments are refused with place and reason",
          "[contract][robots][errors]") {
  SRobotExperiment experiment;
  SECTION("invalid attributes of the foot-bot") {
    const SInvalidAttributes c = GENERATE(
        SInvalidAttributes{"rab_range=\"-1\"", "rab_range"},
        SInvalidAttributes{"rab_data_size=\"-1\"", "rab_data_size"},
        SInvalidAttributes{"omnidirectional_camera_aperture=\"90\"", "90 degrees"},
        SInvalidAttributes{"perspective_camera_aperture=\"0\"", "perspective_camera_aperture"},
        SInvalidAttributes{"perspective_camera_focal_length=\"0\"", "focal_length"},
        SInvalidAttributes{"perspective_camera_range=\"-2\"", "perspective_camera_range"},
        SInvalidAttributes{"perspective_camera_front=\"yes\"", "perspective_camera_front"});
    CAPTURE(c.Attributes);
    experiment.Arena = std::string("<foot-bot id=\"r\" ") + c.Attributes +
                       "><body position=\"0,0,0\"/><controller config=\"c\"/></foot-bot>";
    CHECK_THAT(LoadError(experiment),
               Contains(c.Reason) && Contains("test.argos:") && Contains("<foot-bot>"));
  }
  SECTION("invalid limits of the drive") {
    experiment.Arena = WithDrive("r", "max_force=\"0\"");
    CHECK_THAT(LoadError(experiment),
               Contains("max_force") && Contains("> 0") && Contains("got 0"));
    experiment.Arena = WithDrive("r", "max_torque=\"-3\"");
    CHECK_THAT(LoadError(experiment), Contains("max_torque") && Contains("got -3"));
  }
  SECTION("a missing body") {
    experiment.Arena = "<e-puck id=\"r\"><controller config=\"c\"/></e-puck>";
    CHECK_THAT(LoadError(experiment), Contains("body"));
  }
  SECTION("an unknown controller") {
    experiment.Arena =
        "<e-puck id=\"r\"><body position=\"0,0,0\"/><controller config=\"d\"/></e-puck>";
    CHECK_THAT(LoadError(experiment), Contains("\"d\"") && Contains("c"));
  }
}

TEST_CASE("robots: constructors refuse parameters out of range", "[contract][robots][errors]") {
  CRobotWorld world(SRobotExperiment{});
  CHECK_THROWS_WITH(CEPuckEntity("e", "", CVector3(), CQuaternion(), -0.5),
                    Contains("e-puck \"e\"") && Contains("rab_range"));
  CHECK_THROWS_WITH(
      CFootBotEntity("f", "", CVector3(), CQuaternion(), 3.0, 10, "", CRadians::PI_OVER_TWO),
      Contains("foot-bot \"f\"") && Contains("omnidirectional_camera_aperture"));
}

}  // namespace argos::robot_components_test
