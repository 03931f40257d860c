#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>

#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_base_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_appearance.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_equipped_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_parameters.h>
#include <argos3/plugins/robots/generic/simulator/robot_components.h>
#include <argos3/plugins/robots/generic/simulator/robot_manual.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/odometer_entity.h>
#include <argos3/plugins/simulator/entities/omnidirectional_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>

namespace argos {

namespace {

SBodyDescription MakeBody() {
  SBodyDescription body = DescribeWheeledCylinder(
      footbot::kBodyRadius, footbot::kBodyHeight, footbot::kMass, footbot::kPlanarInertia,
      {footbot::kInterwheelDistance, footbot::kWheelRadius, footbot::kMaxDriveForce,
       footbot::kMaxDriveTorque});
  body.Turret = STurretDescription{footbot::kTurretMass, footbot::kTurretInertia,
                                   footbot::kMaxTurretTorque, footbot::kFreeTurretTorque};
  SGripperDescription gripper;
  gripper.Offset.Set(footbot::kGripperReach, 0.0, footbot::kGripperElevation);
  body.Gripper = gripper;
  body.Grippable = true;
  return body;
}

std::shared_ptr<const CLEDEquippedEntity::SLayout> MakeLEDs() {
  auto leds = std::make_shared<CLEDEquippedEntity::SLayout>();
  leds->AddLEDRing(CVector3(0.0, 0.0, footbot::kLEDRingElevation), footbot::kLEDRingRadius,
                   ToRadians(CDegrees(footbot::kLEDRingStartAngle)), footbot::kNumRingLEDs);
  leds->AddLED(CVector3(0.0, 0.0, footbot::kBeaconElevation));
  return leds;
}

std::shared_ptr<const CProximitySensorEquippedEntity::SLayout> MakeProximity() {
  auto sensors = std::make_shared<CProximitySensorEquippedEntity::SLayout>();
  const CRadians start = ToRadians(CDegrees(footbot::kProximityStartAngle));
  sensors->AddSensorFan(CVector3(0.0, 0.0, footbot::kProximityRingElevation),
                        footbot::kProximityRingRadius, start, start + CRadians::TWO_PI,
                        footbot::kProximityRange, footbot::kNumProximitySensors);
  return sensors;
}

CEntity& MakeLightRing(CRobotEntity& robot) {
  // the light sensors are placed like the proximity sensors
  static const std::shared_ptr<const SRayLayout> layout = MakeProximity();
  return MakeLightSensors(robot, layout);
}

std::shared_ptr<const SGroundSensorLayout> MakeGroundLayout() {
  constexpr Real kMetersPerCentimeter = 0.01;
  auto sensors = std::make_shared<SGroundSensorLayout>();
  for (UInt32 i = 0; i < CCI_FootBotMotorGroundSensor::kNumSensors; ++i) {
    sensors->AddSensor(CCI_FootBotMotorGroundSensor::GetOffset(i) * kMetersPerCentimeter,
                       SGroundSensorPlace::TYPE_GRAYSCALE);
  }
  for (UInt32 i = 0; i < CCI_FootBotBaseGroundSensor::kNumSensors; ++i) {
    sensors->AddSensor(CCI_FootBotBaseGroundSensor::GetOffset(i) * kMetersPerCentimeter,
                       SGroundSensorPlace::TYPE_BLACK_WHITE);
  }
  return sensors;
}

CEntity& MakeMotorAndBaseGroundSensors(CRobotEntity& robot) {
  static const std::shared_ptr<const SGroundSensorLayout> layout = MakeGroundLayout();
  return MakeGroundSensors(robot, layout);
}

CEntity& MakeFrontCamera(CRobotEntity& robot) {
  // straight up; the rear of the robot is up in the image
  const CQuaternion up(-CRadians::PI_OVER_TWO, CVector3::Y);
  const bool front = robot.GetDeviceParameters().PerspectiveCamera.Front;
  return MakePerspectiveCamera(
      robot, CVector3(footbot::kPerspectiveCameraReach, 0.0, footbot::kPerspectiveCameraElevation),
      front ? CQuaternion() : up);
}

CEntity& MakeTopCamera(CRobotEntity& robot) {
  return MakeOmnidirectionalCamera(robot,
                                   CVector3(0.0, 0.0, footbot::kOmnidirectionalCameraElevation));
}

CEntity& MakeRAB(CRobotEntity& robot) {
  return MakeRABComponent(robot, CVector3(0.0, 0.0, footbot::kRABElevation));
}

CEntity& MakeOdometer(CRobotEntity& robot) {
  return robot.MakeOnDemand<COdometerEntity>("odometer_0");
}

CEntity& MakeDistanceScanner(CRobotEntity& robot) {
  return robot.MakeOnDemand<CFootBotDistanceScannerEquippedEntity>("distance_scanner_0");
}

CEntity& MakeTurret(CRobotEntity& robot) {
  return robot.MakeOnDemand<CFootBotTurretEntity>("turret_0",
                                                  robot.GetEmbodiedEntity().GetAnchor("turret"));
}

CEntity& MakeGripper(CRobotEntity& robot) {
  // the gripper is mounted on the turret, which rotates while the gripper holds a body
  robot.GetComponent("turret");
  const SGripperDescription& gripper = *robot.GetEmbodiedEntity().GetBodyDescription()->Gripper;
  return robot.MakeOnDemand<CGripperEquippedEntity>("gripper_0", gripper.Offset, gripper.Direction);
}

SRobotType MakeType() {
  SRobotType type;
  type.LEDAnchor = "turret";
  type.LEDs = MakeLEDs();
  type.Proximity = MakeProximity();
  type.Appearance = MakeFootBotAppearance();
  type.OnDemand.push_back({"battery", &MakeBattery});
  type.OnDemand.push_back({"distance_scanner", &MakeDistanceScanner});
  type.OnDemand.push_back({"gripper", &MakeGripper});
  type.OnDemand.push_back({"ground_sensors", &MakeMotorAndBaseGroundSensors});
  type.OnDemand.push_back({"light_sensors", &MakeLightRing});
  type.OnDemand.push_back({"omnidirectional_camera", MakeTopCamera});
  type.OnDemand.push_back({"perspective_camera", MakeFrontCamera});
  type.OnDemand.push_back({"rab", &MakeRAB});
  type.OnDemand.push_back({"odometer", &MakeOdometer});
  type.OnDemand.push_back({"turret", &MakeTurret});
  return type;
}

const SDifferentialDriveRobotType& FootBotType() {
  static const SDifferentialDriveRobotType type(MakeType(), MakeBody());
  return type;
}

std::string MakeManual() {
  SRobotManual manual;
  manual.Summary =
      R"(A round robot, 17 cm across, with differential steering, 24 proximity sensors, and 13 LEDs: 12 in a
ring (0 to 11, counter-clockwise from 15 degrees) and a beacon on top (12).
)" + DriveManual(footbot::kMaxDriveForce, footbot::kMaxDriveTorque);
  manual.Tag = "foot-bot";
  manual.Id = "fb0";
  manual.Arena = "10,10,2";
  manual.ExampleAttributes = R"( omnidirectional_camera_aperture="70")";
  manual.Attributes =
      R"(  omnidirectional_camera_aperture  degrees in (0,90), default 70: half angle from the downward
                                   vertical.
  perspective_camera_front         "true" (default): the camera looks ahead; "false": it looks up.
  perspective_camera_aperture      degrees in (0,90), default 30: half angle of the view.
  perspective_camera_focal_length  m, > 0, default 0.035.
  perspective_camera_range         m, > 0, default 2: range of the camera.
)";
  return MakeRobotManual(manual);
}

}  // namespace

CFootBotEntity::CFootBotEntity()
    : CDifferentialDriveRobotEntity(FootBotType(), "", CVector3(), CQuaternion()) {}

CFootBotEntity::CFootBotEntity(const std::string& id, const std::string& controllerId,
                               const CVector3& position, const CQuaternion& orientation,
                               Real rabRange, size_t rabDataSize, const std::string& batteryModel,
                               const CRadians& omnicamAperture, bool perspcamFront,
                               const CRadians& perspcamAperture, Real perspcamFocalLength,
                               Real perspcamRange)
    : CDifferentialDriveRobotEntity(FootBotType(), id, position, orientation) {
  const std::string owner = "foot-bot \"" + id + "\"";
  SDeviceParameters parameters;
  parameters.RAB = {rabRange, rabDataSize};
  parameters.RAB.Check(owner);
  parameters.OmnidirectionalCamera = {omnicamAperture};
  parameters.OmnidirectionalCamera.Check(owner);
  parameters.PerspectiveCamera = {perspcamFront, perspcamAperture, perspcamFocalLength,
                                  perspcamRange};
  parameters.PerspectiveCamera.Check(owner);
  parameters.Battery.Model = batteryModel;
  parameters.Battery.Check(owner);
  SetDeviceParameters(parameters);
  InitController(controllerId);
}

CRABEquippedEntity& CFootBotEntity::GetRABEquippedEntity() {
  return GetOrCreate<CRABEquippedEntity>("rab");
}

void CFootBotEntity::Init(TConfigurationNode& tree) {
  InitParts(tree);
  SDeviceParameters parameters;
  parameters.RAB.Read(tree);
  parameters.OmnidirectionalCamera.Read(tree);
  parameters.PerspectiveCamera.Read(tree);
  parameters.Battery.Read(tree);
  SetDeviceParameters(parameters);
  InitController(tree);
}

CBatteryEquippedEntity& CFootBotEntity::GetBatterySensorEquippedEntity() {
  return GetOrCreate<CBatteryEquippedEntity>("battery");
}

CFootBotDistanceScannerEquippedEntity& CFootBotEntity::GetDistanceScannerEquippedEntity() {
  return GetOrCreate<CFootBotDistanceScannerEquippedEntity>("distance_scanner");
}

CGripperEquippedEntity& CFootBotEntity::GetGripperEquippedEntity() {
  return GetOrCreate<CGripperEquippedEntity>("gripper");
}

CFootBotTurretEntity& CFootBotEntity::GetTurretEntity() {
  return GetOrCreate<CFootBotTurretEntity>("turret");
}

CGroundSensorEquippedEntity& CFootBotEntity::GetGroundSensorEquippedEntity() {
  return GetOrCreate<CGroundSensorEquippedEntity>("ground_sensors");
}

CLightSensorEquippedEntity& CFootBotEntity::GetLightSensorEquippedEntity() {
  return GetOrCreate<CLightSensorEquippedEntity>("light_sensors");
}

COmnidirectionalCameraEquippedEntity& CFootBotEntity::GetOmnidirectionalCameraEquippedEntity() {
  return GetOrCreate<COmnidirectionalCameraEquippedEntity>("omnidirectional_camera");
}

CPerspectiveCameraEquippedEntity& CFootBotEntity::GetPerspectiveCameraEquippedEntity() {
  return GetOrCreate<CPerspectiveCameraEquippedEntity>("perspective_camera");
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CFootBotEntity)

REGISTER_ENTITY(CFootBotEntity, "foot-bot", "the authors of this project", "1.0",
                "The foot-bot of the Swarmanoid project.", MakeManual(), "Usable")

}  // namespace argos
