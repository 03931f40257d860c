#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>

#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_appearance.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_measures.h>
#include <argos3/plugins/robots/generic/simulator/device_parameters.h>
#include <argos3/plugins/robots/generic/simulator/robot_components.h>
#include <argos3/plugins/robots/generic/simulator/robot_manual.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>

namespace argos {

namespace {

SBodyDescription MakeBody() {
  return DescribeWheeledCylinder(epuck::kBodyRadius, epuck::kBodyHeight, epuck::kMass,
                                 epuck::kPlanarInertia,
                                 {epuck::kInterwheelDistance, epuck::kWheelRadius,
                                  epuck::kMaxDriveForce, epuck::kMaxDriveTorque});
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

CEntity& MakeLightRing(CRobotEntity& robot) {
  static const std::shared_ptr<const SRayLayout> layout = MakeLightLayout();
  return MakeLightSensors(robot, layout);
}

std::shared_ptr<const SGroundSensorLayout> MakeGroundLayout() {
  auto sensors = std::make_shared<SGroundSensorLayout>();
  for (const Real y : epuck::kGroundSensorYs) {
    sensors->AddSensor(CVector2(epuck::kGroundSensorX, y), SGroundSensorPlace::TYPE_GRAYSCALE);
  }
  return sensors;
}

CEntity& MakeFrontGroundSensors(CRobotEntity& robot) {
  static const std::shared_ptr<const SGroundSensorLayout> layout = MakeGroundLayout();
  return MakeGroundSensors(robot, layout);
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
  type.OnDemand.push_back({"ground_sensors", &MakeFrontGroundSensors});
  type.OnDemand.push_back({"light_sensors", &MakeLightRing});
  type.Parameters.RAB = {epuck::kRABRange, epuck::kRABDataSize};
  type.OnDemand.push_back({"rab", &MakeRAB});
  return type;
}

const SDifferentialDriveRobotType& EPuckType() {
  static const SDifferentialDriveRobotType type(MakeType(), MakeBody());
  return type;
}

std::string MakeManual() {
  SRobotManual manual;
  manual.Summary =
      R"(A round robot, 7 cm across, with differential steering, eight proximity sensors, and eight LEDs in a
ring, counter-clockwise from 11.25 degrees in steps of 45.
)" + DriveManual(epuck::kMaxDriveForce, epuck::kMaxDriveTorque);
  manual.Tag = "e-puck";
  manual.Id = "ep0";
  manual.Arena = "10,10,2";
  manual.RAB = {epuck::kRABRange, epuck::kRABDataSize};
  return MakeRobotManual(manual);
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
  return GetOrCreate<CRABEquippedEntity>("rab");
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
  return GetOrCreate<CBatteryEquippedEntity>("battery");
}

CGroundSensorEquippedEntity& CEPuckEntity::GetGroundSensorEquippedEntity() {
  return GetOrCreate<CGroundSensorEquippedEntity>("ground_sensors");
}

CLightSensorEquippedEntity& CEPuckEntity::GetLightSensorEquippedEntity() {
  return GetOrCreate<CLightSensorEquippedEntity>("light_sensors");
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CEPuckEntity)

REGISTER_ENTITY(CEPuckEntity, "e-puck", "the authors of this project", "1.0",
                "The e-puck, a small robot for education.", MakeManual(), "Usable")

}  // namespace argos
