// What the setters of entities change in a run is as before after a reset.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_equipped_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/cylinder_entity.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/joint_equipped_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/magnet_equipped_entity.h>
#include <argos3/plugins/simulator/entities/odometer_entity.h>
#include <argos3/plugins/simulator/entities/omnidirectional_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>
#include <argos3/plugins/simulator/entities/planar_drive_entity.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rfid_tag_equipped_entity.h>
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>
#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/plugins/simulator/media/led_medium.h>
#include <argos3/plugins/simulator/media/tag_medium.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace reset_setters_test {

using namespace argos;

namespace {

// A setter, as "CClass::SetSomething", and a value that shows whether it has been called.
struct SSetter {
  std::string Name;
  std::function<Real()> Get;
  std::function<void()> Set;
};

// Setters of which a reset undoes nothing, and why.
const std::map<std::string, std::string> kNotUndone = {
    {"CEntity::SetParent", "the structure of entities is not a value"},
    {"CEntity::SetIndex", "for the space"},
    {"CEntity::SetNode", "private: the element that the entity was initialised from"},
    {"CEntity::SetEnabledAtStart", "changes the start"},
    {"CComposableEntity::SetLazyComponents", "protected: for constructors"},
    {"CPositionalEntity::SetInitPosition", "changes the start"},
    {"CPositionalEntity::SetInitOrientation", "changes the start"},
    {"CEmbodiedEntity::SetInitPose", "changes the start"},
    {"CEmbodiedEntity::SetBodyDescription", "for the class of the entity, which describes itself"},
    {"CEmbodiedEntity::SetOriginPose", "for engines; Reset() restores the pose"},
    {"CEmbodiedEntity::SetLinkPose", "for engines; Reset() restores the poses"},
    {"CEmbodiedEntity::SetRootFollows", "for the class of the entity"},
    {"CControllableEntity::SetStopped", "for replays, which are not reset"},
    {"CControllableEntity::SetController", "a new controller is kept, as documented"},
    {"CControllableEntity::SetLateController", "for the space"},
    {"CControllableEntity::SetQuarantined", "for the space"},
    {"CFloorEntity::SetChanged", "not a value"},
    {"CLEDEntity::SetInitColor", "changes the start"},
    {"CLEDEquippedEntity::SetLayout", "for the class of the robot, once"},
    {"CDirectionalLEDEntity::SetInitColor", "changes the start"},
    {"CTagEntity::SetInitPayload", "changes the start"},
    {"CGripperEquippedEntity::SetInitOffset", "changes the start"},
    {"CGripperEquippedEntity::SetInitDirection", "changes the start"},
    {"CJointEquippedEntity::SetState", "for engines; Reset() restores the state"},
    {"CRABEquippedEntity::SetNumberInMedium", "for the medium"},
    {"CRFIDTagEntity::SetNumberInMedium", "for the medium"},
    {"CSimpleRadioEntity::SetNumberInMedium", "for the medium"},
    {"CMountedEntities::SetEach", "protected"},
    {"CSensorEquippedEntity::SetLayout", "for the class of the robot, once"},
    {"CFootBotDistanceScannerEquippedEntity::SetMount", "for the class of the robot, once"},
    {"CPiPuckDifferentialDriveEntity::SetTarget", "private"},
    {"CPiPuckDifferentialDriveEntity::SetTargetVelocityLeft", "Reset() stops the wheels"},
    {"CPiPuckDifferentialDriveEntity::SetTargetVelocityRight", "Reset() stops the wheels"},
    {"CPiPuckDifferentialDriveEntity::SetVelocityLeft", "a measurement"},
    {"CPiPuckDifferentialDriveEntity::SetVelocityRight", "a measurement"},
    {"CRobotEntity::SetDeviceParameters", "protected: for the class of the robot"},
};

SExperiment Experiment() {
  SExperiment experiment;
  experiment.Controllers =
      "<walker id='c'><actuators><differential_steering "
      "implementation='default'/></actuators><sensors><footbot_proximity "
      "implementation='default'/></sensors></walker>";
  experiment.Engines = "<dynamics2d id='flat'/><pointmass3d id='air'/>";
  experiment.Media =
      "<led id='leds'/><led id='others'/><directional_led id='directional_leds'/><tag id='tags'/>"
      "<tag id='more_tags'/><range_and_bearing id='rab'/><simple_radio id='radios'/><rfid "
      "id='rfid'/>";
  experiment.Arena =
      "<floor id='floor' source='loop_functions' pixels_per_meter='10'/>"
      "<light id='lamp' position='1,1,0.5' color='yellow' intensity='2' medium='leds'/>"
      "<box id='box' size='0.3,0.3,0.3' movable='true' mass='0.5'><body position='2,0,0'/>"
      "<leds medium='leds'><led offset='0.15,0,0.3' anchor='origin' color='green'/></leds></box>"
      "<cylinder id='can' radius='0.1' height='0.2' movable='true' mass='0.3'><body "
      "position='-2,0,0'/></cylinder>"
      "<eye-bot id='eb'><body position='3,3,1'/><controller config='idle'/></eye-bot>"
      "<foot-bot id='other'><body position='0,4,0'/><controller config='shining'/></foot-bot>"
      "<foot-bot id='fb' rab_range='1.5'><body position='0,-1,0'/><controller config='c'/>"
      "<battery discharge_model='time' delta='0.001'/>"
      "<directional_leds medium='directional_leds'><directional_led anchor='origin' "
      "observable_angle='60' color='red'/></directional_leds>"
      "<tags medium='tags'><tag anchor='origin' observable_angle='60' side_length='0.1' "
      "payload='one'/></tags>"
      "<magnets><magnet id='m' anchor='origin' offset='0,0,0' passive_field='1,0,0' "
      "active_field='0,2,0'/></magnets>"
      "<simple_radios><simple_radio id='wifi' medium='radios' range='2' "
      "position='0,0,0.1'/></simple_radios>"
      "<rfid_tags medium='rfid'><rfid_tag id='t' position='0,0,0.1' data='1,2'/></rfid_tags>"
      "</foot-bot>";
  experiment.Controllers +=
      "<walker_of_nothing id='idle'/><walker_of_nothing id='shining'><actuators><leds "
      "implementation='default' medium='leds'/></actuators></walker_of_nothing>";
  return experiment;
}

class CIdle : public CCI_Controller {};
REGISTER_CONTROLLER(CIdle, "walker_of_nothing")

Real Number(const CColor& color) {
  return color.GetRed() + 256.0 * color.GetGreen() + 65536.0 * color.GetBlue();
}

Real Number(const std::string& text) {
  return static_cast<Real>(std::hash<std::string>()(text) % 1000000);
}

// of the components of a robot
template <typename COMPONENT>
COMPONENT& Part(CTestWorld& world, const std::string& type, const std::string& robot = "fb") {
  return world.Get<CComposableEntity>(robot).GetComponent<COMPONENT>(type);
}

#define ARGOS_ENABLED(NAME, ENTITY)                      \
  {                                                      \
    NAME, [&e = ENTITY] { return Real(e.IsEnabled()); }, \
        [&e = ENTITY] { e.SetEnabled(!e.IsEnabled()); }  \
  }

void AddBasics(std::vector<SSetter>& list, CTestWorld& world) {
  auto& lamp = world.Get<CLightEntity>("lamp");
  auto& others = world.GetSimulator().GetMedium<CLEDMedium>("others");
  auto& floor = world.GetSpace().GetFloorEntity();
  auto& robot = world.Get<CFootBotEntity>("fb");
  list.insert(list.end(),
              {{"CPositionalEntity::SetPosition", [&] { return lamp.GetPosition().GetX(); },
                [&] { lamp.SetPosition(CVector3(-1, 0, 0)); }},
               {"CPositionalEntity::SetOrientation", [&] { return lamp.GetOrientation().GetZ(); },
                [&] { lamp.SetOrientation(CQuaternion(CRadians(1.0), CVector3::Z)); }},
               {"CLightEntity::SetIntensity", [&] { return lamp.GetIntensity(); },
                [&] { lamp.SetIntensity(9); }},
               {"CLightEntity::SetColor", [&] { return Number(lamp.GetColor()); },
                [&] { lamp.SetColor(CColor::BLUE); }},
               {"CLEDEntity::SetBodyOpenBeneath",
                [&] { return Real(lamp.GetBodyOpenBeneath() != nullptr); },
                [&] { lamp.SetBodyOpenBeneath(&robot.GetEmbodiedEntity()); }},
               {"CMediumMember::SetMedium", [&] { return Real(&lamp.GetMedium() == &others); },
                [&] { lamp.SetMedium(others); }},
               ARGOS_ENABLED("CMediumMember::SetEnabled", lamp),
               ARGOS_ENABLED("CEntity::SetEnabled", floor),
               {"CFloorEntity::SetImageSize",
                [&] { return Real(floor.GetImageWidth() + 2 * floor.GetImageHeight()); },
                [&] { floor.SetImageSize(3, 4); }}});
}

void AddBodies(std::vector<SSetter>& list, CTestWorld& world) {
  auto& box = world.Get<CBoxEntity>("box");
  auto& can = world.Get<CCylinderEntity>("can");
  auto& led = box.GetLEDEquippedEntity().GetLED(0);
  list.insert(
      list.end(),
      {{"CBoxEntity::Resize", [&] { return box.GetSize().GetX(); },
        [&] { box.Resize(CVector3(0.1, 0.1, 0.1)); }},
       {"CPassiveBodyEntity::SetMass", [&] { return box.GetMass(); }, [&] { box.SetMass(7); }},
       // the description is what engines read
       {"CPassiveBodyEntity::SetMass",
        [&] { return box.GetEmbodiedEntity().GetBodyDescription()->Mass; },
        [&] { box.SetMass(8); }},
       {"CCylinderEntity::Resize", [&] { return can.GetRadius() + 10 * can.GetHeight(); },
        [&] { can.Resize(0.05, 0.1); }},
       {"CEmbodiedEntity::SetMovable", [&] { return Real(can.GetEmbodiedEntity().IsMovable()); },
        [&] { can.GetEmbodiedEntity().SetMovable(false); }},
       {"CLEDEntity::SetColor", [&] { return Number(led.GetColor()); },
        [&] { led.SetColor(CColor::RED); }}});
}

void AddLights(std::vector<SSetter>& list, CTestWorld& world) {
  auto& leds = Part<CLEDEquippedEntity>(world, "leds");
  auto& boxLEDs = world.Get<CBoxEntity>("box").GetLEDEquippedEntity();
  auto& others = world.GetSimulator().GetMedium<CLEDMedium>("others");
  auto& beams = Part<CDirectionalLEDEquippedEntity>(world, "directional_leds");
  auto& tags = Part<CTagEquippedEntity>(world, "tags");
  auto& moreTags = world.GetSimulator().GetMedium<CTagMedium>("more_tags");
  list.insert(
      list.end(),
      {{"CLEDEquippedEntity::SetLEDOffset", [&] { return leds.GetLEDOffset(2).GetX(); },
        [&] { leds.SetLEDOffset(2, CVector3(0.3, 0.3, 0.3)); }},
       {"CLEDEquippedEntity::SetLEDOffset", [&] { return boxLEDs.GetLEDs()[0]->Offset.GetX(); },
        [&] { boxLEDs.SetLEDOffset(0, CVector3(0.1, 0, 0)); }},
       {"CLEDEquippedEntity::SetLEDColor", [&] { return Number(leds.GetLEDColor(1)); },
        [&] { leds.SetLEDColor(1, CColor::RED); }},
       {"CLEDEquippedEntity::SetAllLEDsColors", [&] { return Number(leds.GetLEDColor(4)); },
        [&] { leds.SetAllLEDsColors(CColor::WHITE); }},
       ARGOS_ENABLED("CLEDEquippedEntity::SetEnabled", leds),
       {"CLEDEquippedEntity::SetMedium",
        [&] { return Real(&boxLEDs.GetLED(0).GetMedium() == &others); },
        [&] { boxLEDs.SetMedium(others); }},
       {"CDirectionalLEDEntity::SetColor", [&] { return Number(beams.GetLED(0).GetColor()); },
        [&] { beams.GetLED(0).SetColor(CColor::BLUE); }},
       {"CDirectionalLEDEquippedEntity::SetLEDColor",
        [&] { return Number(beams.GetLED(0).GetColor()); },
        [&] { beams.SetLEDColor(0, CColor::GREEN); }},
       {"CDirectionalLEDEquippedEntity::SetLEDColors",
        [&] { return Number(beams.GetLED(0).GetColor()); },
        [&] { beams.SetLEDColors(CColor::WHITE); }},
       {"CDirectionalLEDEntity::SetObservableAngle",
        [&] { return beams.GetLED(0).GetObservableAngle().GetValue(); },
        [&] { beams.GetLED(0).SetObservableAngle(CRadians(0.2)); }},
       {"CTagEntity::SetPayload", [&] { return Number(tags.GetTag(0).GetPayload()); },
        [&] { tags.GetTag(0).SetPayload("two"); }},
       {"CTagEquippedEntity::SetTagPayload", [&] { return Number(tags.GetTag(0).GetPayload()); },
        [&] { tags.SetTagPayload(0, "three"); }},
       {"CTagEquippedEntity::SetTagPayloads", [&] { return Number(tags.GetTag(0).GetPayload()); },
        [&] { tags.SetTagPayloads("four"); }},
       {"CTagEntity::SetSideLength", [&] { return tags.GetTag(0).GetSideLength(); },
        [&] { tags.GetTag(0).SetSideLength(0.5); }},
       {"CTagEntity::SetObservableAngle",
        [&] { return tags.GetTag(0).GetObservableAngle().GetValue(); },
        [&] { tags.GetTag(0).SetObservableAngle(CRadians(0.2)); }},
       {"CMountedEntities::SetMedium",
        [&] { return Real(&tags.GetTag(0).GetMedium() == &moreTags); },
        [&] { tags.SetMedium(moreTags); }},
       ARGOS_ENABLED("CMountedEntities::SetEnabled", tags)});
}

void AddDevices(std::vector<SSetter>& list, CTestWorld& world) {
  auto& rab = Part<CRABEquippedEntity>(world, "rab");
  auto& radio = Part<CSimpleRadioEquippedEntity>(world, "simple_radios").GetRadio(0);
  auto& magnets = Part<CMagnetEquippedEntity>(world, "magnets");
  auto& magnet = magnets.GetMagnet(0);
  auto& tag = Part<CRFIDTagEquippedEntity>(world, "rfid_tags").GetInstances()[0].Entity;
  auto& battery = Part<CBatteryEquippedEntity>(world, "battery");
  auto& odometer = Part<COdometerEntity>(world, "odometer");
  auto& proximity = Part<CProximitySensorEquippedEntity>(world, "proximity_sensors");
  list.insert(
      list.end(),
      {{"CRABEquippedEntity::SetRange", [&] { return rab.GetRange(); }, [&] { rab.SetRange(0.1); }},
       {"CRABEquippedEntity::SetData", [&] { return Real(rab.GetData().ToCArray()[0]); },
        [&] { rab.SetData(CByteArray(rab.GetMsgSize(), 9)); }},
       ARGOS_ENABLED("CRABEquippedEntity::SetEnabled", rab),
       {"CSimpleRadioEntity::SetRange", [&] { return radio.GetRange(); },
        [&] { radio.SetRange(0.1); }},
       {"CMagnetEntity::SetPassiveField", [&] { return magnet.GetPassiveField().GetX(); },
        [&] { magnet.SetPassiveField(CVector3(5, 0, 0)); }},
       {"CMagnetEntity::SetActiveField", [&] { return magnet.GetActiveField().GetY(); },
        [&] { magnet.SetActiveField(CVector3(0, 5, 0)); }},
       {"CMagnetEntity::SetCurrent", [&] { return magnet.GetCurrent(); },
        [&] { magnet.SetCurrent(3); }},
       ARGOS_ENABLED("CMagnetEquippedEntity::SetEnabled", magnets),
       {"CRFIDTagEntity::SetData", [&] { return Real(tag.GetData().ToCArray()[0]); },
        [&] { tag.SetData(CByteArray(tag.GetMemorySize(), 9)); }},
       {"CBatteryEquippedEntity::SetFullCharge", [&] { return battery.GetFullCharge(); },
        [&] { battery.SetFullCharge(3); }},
       {"CBatteryEquippedEntity::SetAvailableCharge", [&] { return battery.GetAvailableCharge(); },
        [&] { battery.SetAvailableCharge(0.2); }},
       ARGOS_ENABLED("CBatteryEquippedEntity::SetEnabled", battery),
       ARGOS_ENABLED("COdometerEntity::SetEnabled", odometer),
       ARGOS_ENABLED("CSensorEquippedEntity::SetEnabled", proximity)});
}

void AddCameras(std::vector<SSetter>& list, CTestWorld& world) {
  auto& omni = Part<COmnidirectionalCameraEquippedEntity>(world, "omnidirectional_camera");
  auto& camera = Part<CPerspectiveCameraEquippedEntity>(world, "perspective_camera");
  auto& turret = world.Get<CFootBotEntity>("fb").GetEmbodiedEntity().GetAnchor("turret");
  list.insert(
      list.end(),
      {{"COmnidirectionalCameraEquippedEntity::SetOffset", [&] { return omni.GetOffset().GetX(); },
        [&] { omni.SetOffset(CVector3(1, 0, 0)); }},
       {"COmnidirectionalCameraEquippedEntity::SetAperture",
        [&] { return omni.GetAperture().GetValue(); }, [&] { omni.SetAperture(CRadians(0.3)); }},
       {"CPerspectiveCameraEquippedEntity::SetAperture",
        [&] { return camera.GetAperture().GetValue(); },
        [&] { camera.SetAperture(CRadians(0.3)); }},
       {"CPerspectiveCameraEquippedEntity::SetFocalLength", [&] { return camera.GetFocalLength(); },
        [&] { camera.SetFocalLength(0.1); }},
       {"CPerspectiveCameraEquippedEntity::SetRange", [&] { return camera.GetRange(); },
        [&] { camera.SetRange(0.2); }},
       {"CPerspectiveCameraEquippedEntity::SetImagePxSize",
        [&] { return Real(camera.GetImagePxWidth() + 10000 * camera.GetImagePxHeight()); },
        [&] { camera.SetImagePxSize(3, 4); }},
       {"CPerspectiveCameraEquippedEntity::SetAnchor",
        [&] { return Real(&camera.GetAnchor() == &turret); }, [&] { camera.SetAnchor(turret); }},
       {"CPerspectiveCameraEquippedEntity::SetMount",
        [&] { return camera.GetOffset().GetX() + camera.ComputeView().GetZ(); },
        [&] { camera.SetMount(CVector3(1, 0, 0), CQuaternion(CRadians(1), CVector3::Z)); }},
       {"CPerspectiveCameraEquippedEntity::SetPanTilt",
        [&] { return camera.GetPan().GetValue() + camera.ComputeView().GetY(); },
        [&] { camera.SetPanTilt(CRadians(0.4), CRadians(0.3)); }},
       ARGOS_ENABLED("CPerspectiveCameraEquippedEntity::SetEnabled", camera)});
}

void AddMotors(std::vector<SSetter>& list, CTestWorld& world) {
  auto& gripper = Part<CGripperEquippedEntity>(world, "gripper");
  auto& wheels = Part<CWheeledEntity>(world, "wheels");
  auto& turret = Part<CTurretEntity>(world, "turret");
  auto& scanner = Part<CFootBotDistanceScannerEquippedEntity>(world, "distance_scanner");
  auto& quadrotor = Part<CQuadRotorEntity>(world, "quadrotor", "eb");
  auto& can = world.Get<CCylinderEntity>("can").GetEmbodiedEntity();
  static const Real kSpeeds[2] = {0.1, 0.2};
  list.insert(
      list.end(),
      {{"CGripperEquippedEntity::SetOffset", [&] { return gripper.GetOffset().GetX(); },
        [&] { gripper.SetOffset(CVector3(1, 0, 0)); }},
       {"CGripperEquippedEntity::SetDirection", [&] { return gripper.GetDirection().GetX(); },
        [&] { gripper.SetDirection(CVector3(0, 1, 0)); }},
       {"CGripperEquippedEntity::SetLockState", [&] { return gripper.GetLockState(); },
        [&] { gripper.SetLockState(0.3); }},
       {"CGripperEquippedEntity::SetLockThreshold", [&] { return gripper.GetLockThreshold(); },
        [&] { gripper.SetLockThreshold(0.9); }},
       {"CGripperEquippedEntity::SetGrippedEntity", [&] { return Real(gripper.IsGripping()); },
        [&] { gripper.SetGrippedEntity(can); }},
       {"CWheeledEntity::SetWheel",
        [&] { return wheels.GetWheelRadius(0) + wheels.GetWheelPosition(0).GetX(); },
        [&] { wheels.SetWheel(0, CVector3(1, 2, 3), 0.5); }},
       {"CWheeledEntity::SetVelocities", [&] { return wheels.GetWheelVelocity(0); },
        [&] { wheels.SetVelocities(kSpeeds); }},
       {"CWheeledEntity::SetDriftingVelocities", [&] { return wheels.GetWheelVelocity(1); },
        [&] {
          wheels.EnableDrift();
          const Real faster[2] = {0.3, 0.4};
          wheels.SetDriftingVelocities(kSpeeds, faster);
        }},
       {"CTurretEntity::SetMode", [&] { return Real(turret.GetMode()); },
        [&] { turret.SetMode(CTurretEntity::MODE_PASSIVE); }},
       {"CTurretEntity::SetDesiredRotation", [&] { return turret.GetDesiredRotation().GetValue(); },
        [&] { turret.SetDesiredRotation(CRadians(1)); }},
       {"CTurretEntity::SetDesiredRotationSpeed", [&] { return turret.GetDesiredRotationSpeed(); },
        [&] { turret.SetDesiredRotationSpeed(1.0); }},
       {"CTurretEntity::SetRotation", [&] { return turret.GetRotation().GetValue(); },
        [&] { turret.SetRotation(CRadians(1)); }},
       {"CFootBotDistanceScannerEquippedEntity::SetMode", [&] { return Real(scanner.GetMode()); },
        [&] { scanner.SetMode(CFootBotDistanceScannerEquippedEntity::MODE_SPEED_CONTROL); }},
       {"CFootBotDistanceScannerEquippedEntity::SetRotation",
        [&] { return scanner.GetRotation().GetValue(); },
        [&] { scanner.SetRotation(CRadians(1)); }},
       {"CFootBotDistanceScannerEquippedEntity::SetRotationSpeed",
        [&] { return scanner.GetRotationSpeed(); }, [&] { scanner.SetRotationSpeed(2); }},
       ARGOS_ENABLED("CFootBotDistanceScannerEquippedEntity::SetEnabled", scanner),
       {"CQuadRotorEntity::SetControlMethod", [&] { return Real(quadrotor.GetControlMethod()); },
        [&] { quadrotor.SetControlMethod(CQuadRotorEntity::POSITION_CONTROL); }},
       {"CQuadRotorEntity::SetPositionControlData",
        [&] { return quadrotor.GetPositionControlData().Position.GetX(); },
        [&] {
          quadrotor.SetPositionControlData({CVector3(1, 1, 1), CRadians()});
        }},
       {"CQuadRotorEntity::SetSpeedControlData",
        [&] { return quadrotor.GetSpeedControlData().Velocity.GetX(); },
        [&] {
          quadrotor.SetSpeedControlData({CVector3(1, 1, 1), CRadians()});
        }},
       {"CQuadRotorEntity::SetAttached", [&] { return Real(quadrotor.IsAttached()); },
        [&] { quadrotor.SetAttached(true); }}});
}

// last: they disable many of the others
void AddRobots(std::vector<SSetter>& list, CTestWorld& world) {
  auto& robot = world.Get<CFootBotEntity>("fb");
  auto& can = world.Get<CCylinderEntity>("can");
  list.insert(list.end(), {ARGOS_ENABLED("CComposableEntity::SetEnabled", can),
                           ARGOS_ENABLED("CRobotEntity::SetEnabled", robot)});
}

#undef ARGOS_ENABLED

std::vector<SSetter> ListSetters(CTestWorld& world) {
  // components that are created when they are looked up
  const CSimulator::CScope scope(world.GetSimulator());
  std::vector<SSetter> list;
  AddBasics(list, world);
  AddBodies(list, world);
  AddLights(list, world);
  AddDevices(list, world);
  AddCameras(list, world);
  AddMotors(list, world);
  AddRobots(list, world);
  return list;
}

// tested by test cases of their own, because a foot-bot or an eye-bot does not have the entity
const std::set<std::string> kTestedElsewhere = {"CBatteryEquippedEntity::SetDischargeModel",
                                                "CPlanarDriveEntity::SetCommand",
                                                "CJointEquippedEntity::SetCommand"};

// the setters in a header of entities, of those classes only
void FindSetters(const std::filesystem::path& header, std::set<std::string>& setters) {
  static const std::regex kClass(
      "^class (C\\w*(Entity|Entities|MediumMember))( final)?( :.*)?( \\{)?$");
  static const std::regex kSetter("^  (virtual )?(void|bool) (Set\\w*|Resize)\\(.*");
  std::ifstream file(header);
  std::string owner;
  std::string line;
  std::smatch match;
  while (std::getline(file, line)) {
    if (std::regex_match(line, match, kClass) && line.back() != ';') {
      owner = match[1];
    } else if (line == "};") {
      owner.clear();
    } else if (!owner.empty() && std::regex_match(line, match, kSetter)) {
      setters.insert(owner + "::" + match[3].str());
    }
  }
}

std::set<std::string> FindAllSetters() {
  std::set<std::string> setters;
  for (const char* folder :
       {"src/core/simulator/entity", "src/plugins/entities", "src/plugins/robots"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(InSourceTree(folder))) {
      if (entry.path().extension() == ".h") {
        FindSetters(entry.path(), setters);
      }
    }
  }
  return setters;
}

}  // namespace

TEST_CASE("reset: every setter of an entity is in the table of this test", "[determinism][reset]") {
  CTestWorld world(Experiment());
  std::set<std::string> known = kTestedElsewhere;
  for (const SSetter& setter : ListSetters(world)) {
    known.insert(setter.Name);
  }
  for (const auto& [name, reason] : kNotUndone) {
    known.insert(name);
  }
  const std::set<std::string> found = FindAllSetters();
  REQUIRE(found.size() > 80);
  for (const std::string& name : found) {
    CAPTURE(name);
    // a new setter: a row for it, and KeepForReset() in it unless Reset() restores the value
    CHECK(known.count(name) == 1);
  }
  for (const std::string& name : known) {
    CAPTURE(name);
    CHECK(found.count(name) == 1);
  }
}

TEST_CASE("reset: what setters have changed in a run is as before", "[determinism][reset]") {
  CTestWorld world(Experiment());
  std::vector<SSetter> setters = ListSetters(world);
  world.GetSimulator().Reset();
  std::vector<Real> before;
  for (const SSetter& setter : setters) {
    before.push_back(setter.Get());
  }
  const UInt64 digest = world.ComputeDigest();
  world.Step(5);
  const UInt64 later = world.ComputeDigest();
  world.GetSimulator().Reset();
  for (int run = 0; run < 2; ++run) {
    world.Step(2);
    for (const SSetter& setter : setters) {
      CAPTURE(setter.Name);
      const Real present = setter.Get();
      setter.Set();
      CHECK(setter.Get() != present);
    }
    world.Step(2);
    world.GetSimulator().Reset();
    for (size_t i = 0; i < setters.size(); ++i) {
      CAPTURE(setters[i].Name);
      CHECK(setters[i].Get() == before[i]);
    }
    CHECK(world.ComputeDigest() == digest);
  }
  world.Step(5);
  CHECK(world.ComputeDigest() == later);
}

TEST_CASE("reset: what setters change before the run begins is the start", "[determinism][reset]") {
  CTestWorld world(Experiment());
  auto& lamp = world.Get<CLightEntity>("lamp");
  lamp.SetIntensity(3.0);
  // as the end of loading does, after the loop functions' Init()
  world.GetSpace().MarkStart();
  lamp.SetIntensity(4.0);
  world.GetSimulator().Reset();
  CHECK(lamp.GetIntensity() == 3.0);
}

TEST_CASE("reset: a new controller does not make what was set in the run the start",
          "[determinism][reset]") {
  CTestWorld world(Experiment());
  const CSimulator::CScope scope(world.GetSimulator());
  auto& rab = Part<CRABEquippedEntity>(world, "rab");
  auto& leds = world.Get<CFootBotEntity>("fb").GetLEDEquippedEntity();
  REQUIRE_FALSE(leds.GetLED(0).HasMedium());
  rab.SetRange(0.1);
  world.Get<CFootBotEntity>("fb").GetControllableEntity().SetController("shining");
  REQUIRE(leds.GetLED(0).HasMedium());
  world.GetSimulator().Reset();
  CHECK(rab.GetRange() == 1.5);
  // what the devices of the controller have set up is kept with it
  CHECK(leds.GetLED(0).HasMedium());
  CHECK(leds.IsEnabled());
}

TEST_CASE("reset: the discharge model of the start is back", "[determinism][reset]") {
  CTestWorld world(Experiment());
  const CSimulator::CScope scope(world.GetSimulator());
  auto& battery = Part<CBatteryEquippedEntity>(world, "battery");
  battery.Enable();
  battery.SetDischargeModel("");
  world.Step(3);
  CHECK(battery.GetAvailableCharge() == 1.0);
  battery.SetDischargeModel("time_motion");
  world.GetSimulator().Reset();
  CHECK(battery.GetAvailableCharge() == 1.0);
  battery.Enable();
  world.Step(3);
  // delta per tick
  CHECK_THAT(battery.GetAvailableCharge(), Catch::WithinAbs(1.0 - 3 * 0.001, 1e-12));
}

TEST_CASE("reset: commands of planar drives and joints are those of the start",
          "[determinism][reset]") {
  CPlanarDriveEntity drive(nullptr);
  drive.SetCommand({1.0, 2.0, 3.0});
  drive.Reset();
  CHECK(drive.GetCommand().Ahead == 0.0);
  auto articulation = std::make_shared<SArticulation>();
  articulation->Joints.emplace_back();
  CJointEquippedEntity joints(nullptr, "joints", articulation);
  joints.SetCommand(0, {CJointEquippedEntity::EMode::Velocity, 1.0, 2.0});
  joints.SetState(0, 3.0, 4.0);
  joints.Reset();
  CHECK(joints.GetJoint(0).Command == CJointEquippedEntity::SCommand());
  CHECK(joints.GetJoint(0).Position == 0.0);
}

}  // namespace reset_setters_test
