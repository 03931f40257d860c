#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>

#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_appearance.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_measures.h>
#include <argos3/plugins/robots/generic/simulator/battery_mount.h>
#include <argos3/plugins/robots/generic/simulator/camera_mounts.h>
#include <argos3/plugins/robots/generic/simulator/device_parameters.h>
#include <argos3/plugins/robots/generic/simulator/rab_component.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/new_component.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>

namespace argos {

namespace {

// of the attributes of the camera in experiment files
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

CEntity& MakeLightSensors(CRobotEntity& robot) {
  // at the places of the proximity sensors
  static const std::shared_ptr<const SRayLayout> layout = MakeProximity();
  auto& sensors = robot.MakeOnDemand<CLightSensorEquippedEntity>("light_0");
  sensors.SetLayout(layout, {&robot.GetEmbodiedEntity().GetOriginAnchor()});
  return sensors;
}

CEntity& MakeCamera(CRobotEntity& robot) {
  // straight down, what is ahead of the robot is up in the image
  const CQuaternion down(CRadians::PI_OVER_TWO, CVector3::Y);
  return MakePerspectiveCamera(robot, CVector3(), down);
}

CEntity& MakeRAB(CRobotEntity& robot) {
  return MakeRABComponent(robot, CVector3());
}

struct SEyeBotType : SRobotType {
  std::shared_ptr<const SBodyDescription> Body;
};

SEyeBotType MakeType() {
  SEyeBotType type;
  type.Body = MakeBody();
  type.LEDs = MakeLEDs();
  type.Proximity = MakeProximity();
  type.Appearance = MakeEyeBotAppearance();
  type.OnDemand.push_back({"battery", &MakeBattery});
  type.OnDemand.push_back({"light_sensors", &MakeLightSensors});
  type.OnDemand.push_back({"perspective_camera", &MakeCamera});
  type.OnDemand.push_back({"rab", &MakeRAB});
  return type;
}

const SEyeBotType& EyeBotType() {
  static const SEyeBotType type = MakeType();
  return type;
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
  return Demand<CBatteryEquippedEntity>("battery");
}

CLightSensorEquippedEntity& CEyeBotEntity::GetLightSensorEquippedEntity() {
  return Demand<CLightSensorEquippedEntity>("light_sensors");
}

CPerspectiveCameraEquippedEntity& CEyeBotEntity::GetPerspectiveCameraEquippedEntity() {
  return Demand<CPerspectiveCameraEquippedEntity>("perspective_camera");
}

CRABEquippedEntity& CEyeBotEntity::GetRABEquippedEntity() {
  return Demand<CRABEquippedEntity>("rab");
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CEyeBotEntity)

REGISTER_ENTITY(
    CEyeBotEntity, "eye-bot", "the authors of this project", "1.0",
    "The eye-bot of the Swarmanoid project, which flies.",
    R"(A flying robot, 50 cm across, with 24 proximity sensors that see 3 m far, and 33 LEDs: a ring of 16 (0 to
15, counter-clockwise from 11.25 degrees in steps of 22.5), another above it (16 to 31), and one under the arm at 135
degrees (32). Its propellers are driven by quadrotor_position or quadrotor_speed; with neither, it hovers. It needs a
physics engine in which robots fly, such as pointmass3d, and stays within the limits of the arena: its base from the
lowest height of the arena to 0.566 m below the highest.

REQUIRED XML

  <arena size="10,10,6">
    <eye-bot id="eb0">
      <body position="0.4,2.3,0" orientation="45,0,0" />
      <controller config="c1" />
    </eye-bot>
  </arena>

ATTRIBUTES

  id                 text, required: unique among the entities of the arena.
  body@position      "x,y,z", m, default "0,0,0": the centre of the base, in the world frame.
  body@orientation   "z,y,x", degrees, default "0,0,0": the robot looks along its x axis.
  controller@config  text, required: the id of a child of <controllers>.

OPTIONAL XML

  <arena size="10,10,6">
    <eye-bot id="eb0" rab_range="3" rab_data_size="10" camera_aperture="30">
      <body position="0.4,2.3,0" />
      <controller config="c1">
        <params speed="10" />
      </controller>
      <battery discharge_model="time" delta="1e-5" start_charge="1" full_charge="1" />
    </eye-bot>
  </arena>

  controller/params    replaces the <params> of the controller for this robot.
  rab_range            m, >= 0, default 3: how far messages of this robot reach.
  rab_data_size        integer >= 0, default 10: bytes of a message.
  camera_aperture      degrees in (0,90), default 30: half angle of the view of the camera, which
                       looks straight down.
  camera_focal_length  m, > 0, default 0.035.
  camera_range         m, > 0, default 2: how far the camera sees.
  camera_front         "true" (default) or "false": accepted, without effect.
  directional_leds, tags, magnets, simple_radios, rfid_tags
                       children: what else the robot carries. The media
                       "directional_led", "tag" and "simple_radio", the actuator
                       "magnets" and the entity "rfid_tag" explain them.
  battery              the robot's battery; without it the charge never falls. It runs down only if the
                       controller has the sensor "battery".
  battery@discharge_model  "time" (default), "motion" or "time_motion", or a model of a user.
  battery@start_charge     in [0, full_charge], default 1: also after a reset.
  battery@full_charge      > 0, default 1.
  battery@delta            of "time": >= 0, default 1e-5: charge taken in each tick.
  battery@pos_delta        of "motion": >= 0, default 1e-3: per m that the robot moves.
  battery@orient_delta     of "motion": >= 0, default 1e-3: per rad that it turns.
  battery@time_factor, battery@pos_factor, battery@orient_factor
                           the same three of "time_motion", which takes their sum.
)",
    "Usable")

}  // namespace argos
