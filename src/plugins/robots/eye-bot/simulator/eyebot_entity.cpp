#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_appearance.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_measures.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_equipped_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_parameters.h>
#include <argos3/plugins/robots/generic/simulator/robot_components.h>
#include <argos3/plugins/robots/generic/simulator/robot_manual.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/new_component.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>

namespace argos {

namespace {

// prefix of the camera's attributes in experiment files
const char* const kCameraPrefix = "camera_";

std::shared_ptr<const SBodyDescription> MakeBody() {
  auto body = std::make_shared<SBodyDescription>();
  body->Shapes.push_back(SShapeDescription::Cylinder(eyebot::kBodyRadius, eyebot::kBodyHeight));
  body->Mass = eyebot::kMass;
  body->PlanarInertia = eyebot::kYawInertia;
  SPropellersDescription propellers;
  propellers.Position = {eyebot::kPositionProportional, eyebot::kPositionDerivative};
  propellers.Yaw = {eyebot::kYawProportional, eyebot::kYawDerivative};
  propellers.Velocity = {eyebot::kVelocityProportional, eyebot::kVelocityDerivative};
  propellers.YawRate = {eyebot::kYawRateProportional, eyebot::kYawRateDerivative};
  propellers.MaxForce = eyebot::kMaxForce;
  propellers.MaxTorque = eyebot::kMaxTorque;
  body->Propellers = propellers;
  return body;
}

std::shared_ptr<const CLEDEquippedEntity::SLayout> MakeLEDs() {
  auto leds = std::make_shared<CLEDEquippedEntity::SLayout>();
  const CRadians start = ToRadians(CDegrees(eyebot::kLEDRingStartAngle));
  for (const Real elevation : {eyebot::kLowerLEDRingElevation, eyebot::kUpperLEDRingElevation}) {
    leds->AddLEDRing(CVector3(0.0, 0.0, elevation), eyebot::kLEDRingRadius, start,
                     eyebot::kNumRingLEDs);
  }
  const CRadians angle = ToRadians(CDegrees(eyebot::kExtraLEDAngle));
  leds->AddLED(CVector3(eyebot::kExtraLEDRadius * Cos(angle), eyebot::kExtraLEDRadius * Sin(angle),
                        eyebot::kExtraLEDElevation));
  // the body is open below the lower ring: four arms, on whose ends and underside the LEDs are
  for (size_t i = 0; i < leds->Places.size(); ++i) {
    leds->Places[i].IsSeenFromBeneath =
        leds->Places[i].Offset.GetZ() <= eyebot::kLowerLEDRingElevation;
  }
  return leds;
}

std::shared_ptr<const CProximitySensorEquippedEntity::SLayout> MakeProximity() {
  auto sensors = std::make_shared<CProximitySensorEquippedEntity::SLayout>();
  const CRadians start = ToRadians(CDegrees(eyebot::kProximityStartAngle));
  sensors->AddSensorFan(CVector3(0.0, 0.0, eyebot::kProximityRingElevation),
                        eyebot::kProximityRingRadius, start, start + CRadians::TWO_PI,
                        eyebot::kProximityRange, eyebot::kNumProximitySensors);
  return sensors;
}

CEntity& MakeLightRing(CRobotEntity& robot) {
  // the light sensors are placed like the proximity sensors
  static const std::shared_ptr<const SRayLayout> layout = MakeProximity();
  return MakeLightSensors(robot, layout);
}

CEntity& MakeCamera(CRobotEntity& robot) {
  // straight down; the heading of the robot is up in the image
  const CQuaternion down(CRadians::PI_OVER_TWO, CVector3::Y);
  return MakePerspectiveCamera(robot, CVector3(), down);
}

CEntity& MakeRAB(CRobotEntity& robot) {
  return MakeRABComponent(robot, CVector3());
}

struct SEyeBotType : SRobotType {
  std::shared_ptr<const SBodyDescription> Body;
};

CEntity& MakeDistanceScanner(CRobotEntity& robot) {
  auto& scanner = robot.MakeOnDemand<CFootBotDistanceScannerEquippedEntity>("distance_scanner_0");
  scanner.SetMount({eyebot::kBodyRadius, eyebot::kDistanceScannerElevation});
  return scanner;
}

SEyeBotType MakeType() {
  SEyeBotType type;
  type.Body = MakeBody();
  type.LEDs = MakeLEDs();
  type.Proximity = MakeProximity();
  type.Appearance = MakeEyeBotAppearance();
  type.OnDemand.push_back({"battery", &MakeBattery});
  type.OnDemand.push_back({"distance_scanner", &MakeDistanceScanner});
  type.OnDemand.push_back({"light_sensors", &MakeLightRing});
  type.OnDemand.push_back({"perspective_camera", &MakeCamera});
  type.OnDemand.push_back({"rab", &MakeRAB});
  return type;
}

const SEyeBotType& EyeBotType() {
  static const SEyeBotType type = MakeType();
  return type;
}

std::string MakeManual() {
  SRobotManual manual;
  manual.Summary =
      R"(A flying robot, 50 cm across, with 24 proximity sensors of 3 m range, and 33 LEDs: a ring of 16 (0 to
15, counter-clockwise from 11.25 degrees in steps of 22.5), another above it (16 to 31), and one under the arm at 135
degrees (32). The lower ring and the LED under the arm are seen from below the robot, through its own body. The actuators
quadrotor_position and quadrotor_speed control its propellers; with neither, it hovers. The actuator ceiling_attachment
holds it to the ceiling; footbot_distance_scanner works on it, too. It
needs a physics engine in which robots fly, and stays within the limits of the arena: its base is between the lowest
height of the arena and 0.566 m below the highest.
)";
  manual.Tag = "eye-bot";
  manual.Id = "eb0";
  manual.Arena = "10,10,6";
  manual.ExampleAttributes = R"( camera_aperture="30")";
  manual.Attributes =
      R"(  camera_aperture                  degrees in (0,90), default 30: half angle of the view of the camera,
                                   which looks straight down.
  camera_focal_length              m, > 0, default 0.035.
  camera_range                     m, > 0, default 2: range of the camera.
  camera_front                     "true" (default) or "false": accepted, without effect.
)";
  return MakeRobotManual(manual);
}

}  // namespace

CEyeBotEntity::CEyeBotEntity(const std::string& id, const CVector3& position,
                             const CQuaternion& orientation)
    : CRobotEntity(EyeBotType(), id, position, orientation) {
  GetEmbodiedEntity().SetBodyDescription(EyeBotType().Body);
  m_quadrotor = NewComponent<CQuadRotorEntity>(*this, "quadrotor_0");
  AddController();
}

CEyeBotEntity::CEyeBotEntity() : CEyeBotEntity("", CVector3(), CQuaternion()) {}

CEyeBotEntity::CEyeBotEntity(const std::string& id, const std::string& controllerId,
                             const CVector3& position, const CQuaternion& orientation,
                             Real rabRange, size_t rabDataSize, const std::string& batteryModel,
                             const CRadians& perspcamAperture, Real perspcamFocalLength,
                             Real perspcamRange)
    : CEyeBotEntity(id, position, orientation) {
  const std::string owner = "eye-bot \"" + id + "\"";
  SDeviceParameters parameters = EyeBotType().Parameters;
  parameters.RAB = {rabRange, rabDataSize};
  parameters.RAB.Check(owner);
  parameters.PerspectiveCamera.Aperture = perspcamAperture;
  parameters.PerspectiveCamera.FocalLength = perspcamFocalLength;
  parameters.PerspectiveCamera.Range = perspcamRange;
  parameters.PerspectiveCamera.Check(owner, kCameraPrefix);
  parameters.Battery.Model = batteryModel;
  parameters.Battery.Check(owner);
  SetDeviceParameters(parameters);
  InitController(controllerId);
}

void CEyeBotEntity::Init(TConfigurationNode& tree) {
  InitParts(tree);
  SDeviceParameters parameters = EyeBotType().Parameters;
  parameters.RAB.Read(tree);
  parameters.PerspectiveCamera.Read(tree, kCameraPrefix);
  parameters.Battery.Read(tree);
  SetDeviceParameters(parameters);
  InitController(tree);
}

CBatteryEquippedEntity& CEyeBotEntity::GetBatterySensorEquippedEntity() {
  return GetOrCreate<CBatteryEquippedEntity>("battery");
}

CFootBotDistanceScannerEquippedEntity& CEyeBotEntity::GetDistanceScannerEquippedEntity() {
  return GetOrCreate<CFootBotDistanceScannerEquippedEntity>("distance_scanner");
}

CLightSensorEquippedEntity& CEyeBotEntity::GetLightSensorEquippedEntity() {
  return GetOrCreate<CLightSensorEquippedEntity>("light_sensors");
}

CPerspectiveCameraEquippedEntity& CEyeBotEntity::GetPerspectiveCameraEquippedEntity() {
  return GetOrCreate<CPerspectiveCameraEquippedEntity>("perspective_camera");
}

CRABEquippedEntity& CEyeBotEntity::GetRABEquippedEntity() {
  return GetOrCreate<CRABEquippedEntity>("rab");
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CEyeBotEntity)

REGISTER_ENTITY(CEyeBotEntity, "eye-bot", "the authors of this project", "1.0",
                "The eye-bot of the Swarmanoid project, which flies.", MakeManual(), "Usable")

}  // namespace argos
