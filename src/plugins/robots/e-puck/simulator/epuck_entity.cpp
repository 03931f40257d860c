#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>

#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_appearance.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_measures.h>
#include <argos3/plugins/robots/generic/simulator/battery_mount.h>
#include <argos3/plugins/robots/generic/simulator/device_parameters.h>
#include <argos3/plugins/robots/generic/simulator/rab_component.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/ground_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>

namespace argos {

namespace {

SBodyDescription MakeBody() {
  SBodyDescription body;
  body.Shapes.push_back(SShapeDescription::Cylinder(epuck::kBodyRadius, epuck::kBodyHeight));
  body.Mass = epuck::kMass;
  body.PlanarInertia = epuck::kPlanarInertia;
  body.Drive = SDifferentialDriveDescription{epuck::kInterwheelDistance, epuck::kWheelRadius,
                                             epuck::kMaxDriveForce, epuck::kMaxDriveTorque};
  return body;
}

std::shared_ptr<const CLEDEquippedEntity::SLayout> MakeLEDs() {
  auto leds = std::make_shared<CLEDEquippedEntity::SLayout>();
  leds->AddLEDRing(CVector3(0.0, 0.0, epuck::kLEDRingElevation), epuck::kLEDRingRadius,
                   ToRadians(CDegrees(epuck::kLEDRingStartAngle)), epuck::kNumLEDs);
  return leds;
}

std::shared_ptr<const CProximitySensorEquippedEntity::SLayout> MakeProximity() {
  auto sensors = std::make_shared<CProximitySensorEquippedEntity::SLayout>();
  for (UInt32 i = 0; i < CCI_EPuckProximitySensor::kNumSensors; ++i) {
    const CRadians angle = CCI_EPuckProximitySensor::GetAngle(i);
    const CVector3 outward(Cos(angle), Sin(angle), 0.0);
    sensors->AddSensor(
        outward * epuck::kProximityRadius + CVector3(0.0, 0.0, epuck::kProximityElevation), outward,
        epuck::kProximityRange);
  }
  return sensors;
}

std::shared_ptr<const SRayLayout> MakeLightLayout() {
  auto sensors = std::make_shared<SRayLayout>();
  const CRadians start = ToRadians(CDegrees(epuck::kLightRingStartAngle));
  sensors->AddSensorFan(CVector3(0.0, 0.0, epuck::kProximityElevation), epuck::kProximityRadius,
                        start, start + CRadians::TWO_PI, epuck::kProximityRange,
                        epuck::kNumLightSensors);
  return sensors;
}

CEntity& MakeLightSensors(CRobotEntity& robot) {
  static const std::shared_ptr<const SRayLayout> layout = MakeLightLayout();
  auto& sensors = robot.MakeOnDemand<CLightSensorEquippedEntity>("light_0");
  sensors.SetLayout(layout, {&robot.GetEmbodiedEntity().GetOriginAnchor()});
  return sensors;
}

std::shared_ptr<const SGroundSensorLayout> MakeGroundLayout() {
  auto sensors = std::make_shared<SGroundSensorLayout>();
  for (const Real y : epuck::kGroundSensorYs) {
    sensors->AddSensor(CVector2(epuck::kGroundSensorX, y), SGroundSensorPlace::TYPE_GRAYSCALE);
  }
  return sensors;
}

CEntity& MakeGroundSensors(CRobotEntity& robot) {
  static const std::shared_ptr<const SGroundSensorLayout> layout = MakeGroundLayout();
  auto& sensors = robot.MakeOnDemand<CGroundSensorEquippedEntity>("ground_0");
  sensors.SetLayout(layout, {&robot.GetEmbodiedEntity().GetOriginAnchor()});
  return sensors;
}

CEntity& MakeRAB(CRobotEntity& robot) {
  return MakeRABComponent(robot, CVector3(0.0, 0.0, epuck::kRABElevation));
}

SRobotType MakeType() {
  SRobotType type;
  type.LEDs = MakeLEDs();
  type.Proximity = MakeProximity();
  type.Appearance = MakeEPuckAppearance();
  type.OnDemand.push_back({"battery", &MakeBattery});
  type.OnDemand.push_back({"ground_sensors", &MakeGroundSensors});
  type.OnDemand.push_back({"light_sensors", &MakeLightSensors});
  type.Parameters.RAB = {epuck::kRABRange, epuck::kRABDataSize};
  type.OnDemand.push_back({"rab", &MakeRAB});
  return type;
}

const SDifferentialDriveRobotType& EPuckType() {
  static const SDifferentialDriveRobotType type(MakeType(), MakeBody());
  return type;
}

}  // namespace

CEPuckEntity::CEPuckEntity()
    : CDifferentialDriveRobotEntity(EPuckType(), "", CVector3(), CQuaternion()) {}

CEPuckEntity::CEPuckEntity(const std::string& id, const std::string& controllerId,
                           const CVector3& position, const CQuaternion& orientation, Real rabRange,
                           size_t rabDataSize, const std::string& batteryModel)
    : CDifferentialDriveRobotEntity(EPuckType(), id, position, orientation) {
  SDeviceParameters parameters = EPuckType().Parameters;
  parameters.RAB = {rabRange, rabDataSize};
  parameters.RAB.Check("e-puck \"" + id + "\"");
  parameters.Battery.Model = batteryModel;
  parameters.Battery.Check("e-puck \"" + id + "\"");
  SetDeviceParameters(parameters);
  InitController(controllerId);
}

CRABEquippedEntity& CEPuckEntity::GetRABEquippedEntity() {
  return Demand<CRABEquippedEntity>("rab");
}

void CEPuckEntity::Init(TConfigurationNode& tree) {
  InitParts(tree);
  SDeviceParameters parameters = EPuckType().Parameters;
  parameters.RAB.Read(tree);
  parameters.Battery.Read(tree);
  SetDeviceParameters(parameters);
  InitController(tree);
}

CBatteryEquippedEntity& CEPuckEntity::GetBatterySensorEquippedEntity() {
  return Demand<CBatteryEquippedEntity>("battery");
}

CGroundSensorEquippedEntity& CEPuckEntity::GetGroundSensorEquippedEntity() {
  return Demand<CGroundSensorEquippedEntity>("ground_sensors");
}

CLightSensorEquippedEntity& CEPuckEntity::GetLightSensorEquippedEntity() {
  return Demand<CLightSensorEquippedEntity>("light_sensors");
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CEPuckEntity)

REGISTER_ENTITY(
    CEPuckEntity, "e-puck", "the authors of this project", "1.0",
    "The e-puck, a small robot for education.",
    R"(A round robot, 7 cm across, with differential steering, eight proximity sensors, and eight LEDs in a
ring, counter-clockwise from 11.25 degrees in steps of 45.

REQUIRED XML

  <arena size="10,10,2">
    <e-puck id="ep0">
      <body position="0.4,2.3,0" orientation="45,0,0" />
      <controller config="c1" />
    </e-puck>
  </arena>

ATTRIBUTES

  id                 text, required: unique among the entities of the arena.
  body@position      "x,y,z", m, default "0,0,0": the centre of the base, in the world frame.
  body@orientation   "z,y,x", degrees, default "0,0,0": the robot looks along its x axis.
  controller@config  text, required: the id of a child of <controllers>.

OPTIONAL XML

  <arena size="10,10,2">
    <e-puck id="ep0" rab_range="0.8" rab_data_size="2">
      <body position="0.4,2.3,0" />
      <controller config="c1">
        <params speed="10" />
      </controller>
      <dynamics2d>
        <differential_steering max_force="1.5" max_torque="1.5" />
      </dynamics2d>
      <battery discharge_model="time" delta="1e-5" start_charge="1" full_charge="1" />
    </e-puck>
  </arena>

  controller/params                 replaces the <params> of the controller for this robot.
  differential_steering@max_force   N, > 0, default 1.5: the most the wheels push; of the dynamics2d
                                    engine.
  differential_steering@max_torque  N m, > 0, default 1.5: the most they turn the robot.
  rab_range                         m, >= 0, default 0.8: how far messages of this robot reach.
  rab_data_size                     integer >= 0, default 2: bytes of a message.
  battery                           the robot's battery; without it the charge never falls. It runs down only
                                    if the controller has the sensor "battery".
  battery@discharge_model           "time" (default), "motion" or "time_motion", or a model of a user.
  battery@start_charge              in [0, full_charge], default 1: also after a reset.
  battery@full_charge               > 0, default 1.
  battery@delta                     of "time": >= 0, default 1e-5: charge taken in each tick.
  battery@pos_delta                 of "motion": >= 0, default 1e-3: per m that the robot moves.
  battery@orient_delta              of "motion": >= 0, default 1e-3: per rad that it turns.
  battery@time_factor, battery@pos_factor, battery@orient_factor
                                    the same three of "time_motion", which takes their sum.
  directional_leds, tags, magnets, simple_radios, rfid_tags
                                    children: what else the robot carries. The media
                                    "directional_led", "tag" and "simple_radio", the actuator
                                    "magnets" and the entity "rfid_tag" explain them.
)",
    "Usable")

}  // namespace argos
