#include <argos3/testing/determinism/crews.h>

#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_encoder_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_position_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_speed_actuator.h>
#include <argos3/testing/support/arena_text.h>

#include <cmath>

namespace argos {

namespace {

constexpr Real kSpeed = 8.0;  // cm/s
constexpr Real kPairSpacing = 1.2;  // m
constexpr Real kReach = 0.19;  // m, from a robot to a load within its reach
constexpr UInt32 kPhase = 15;  // steps between changes of the gripper's and the turret's order
constexpr Real kFlyerSpacing = 0.9;  // m

std::string Device(const std::string& tag, const std::string& implementation,
                   const std::string& noise, const std::string& attributes = "") {
  return "<" + tag + " implementation='" + implementation + "' " + attributes + ">" + noise + "</" +
         tag + ">\n";
}

std::string Noise(bool noisy) {
  return noisy ? "<noise model='gaussian' std_dev='0.02' />" : "";
}

}  // namespace

Real CRecorder::Read(Real reading) {
  m_read.Add(reading);
  return reading;
}

void CRecorder::Reset() {
  m_read = CDigest();
  m_step = 0;
}

void CHolder::Init(TConfigurationNode& /*params*/) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_gripper = GetActuator<CCI_FootBotGripperActuator>("footbot_gripper");
  m_turret = GetActuator<CCI_FootBotTurretActuator>("footbot_turret");
  m_encoder = GetSensor<CCI_FootBotTurretEncoderSensor>("footbot_turret_encoder");
}

void CHolder::ControlStep() {
  const Real rotation = Read(m_encoder->GetRotation().GetValue());
  const UInt32 phase = GetStep() / kPhase;
  const Real swing = std::sin(7.0 * rotation + phase);
  if (GetStep() % kPhase == 0) {
    if (phase % 4 == 3) {
      m_gripper->Unlock();
    } else {
      m_gripper->LockPositive();
    }
    switch (phase % 3) {
      case 0:
        m_turret->SetPassiveMode();
        break;
      case 1:
        m_turret->SetSpeedControlMode();
        m_turret->SetRotationSpeed(swing > 0.0 ? 1 : -1);
        break;
      default:
        m_turret->SetActiveWithRotation(CRadians(0.5 * swing));
        break;
    }
  }
  m_wheels->SetLinearVelocity(kSpeed * swing, kSpeed * std::cos(3.0 * rotation + phase));
  CountStep();
}

void CFlyer::Init(TConfigurationNode& /*params*/) {
  if (HasActuator("quadrotor_position")) {
    m_places = GetActuator<CCI_QuadRotorPositionActuator>("quadrotor_position");
  } else {
    m_speeds = GetActuator<CCI_QuadRotorSpeedActuator>("quadrotor_speed");
  }
  m_proximity = GetSensor<CCI_EyeBotProximitySensor>("eyebot_proximity");
  m_light = GetSensor<CCI_EyeBotLightSensor>("eyebot_light");
  m_pose = GetSensor<CCI_PositioningSensor>("positioning");
  auto* const camera =
      GetSensor<CCI_ColoredBlobPerspectiveCameraSensor>("colored_blob_perspective_camera");
  camera->Enable();
  m_camera = camera;
}

void CFlyer::ControlStep() {
  CVector3 way;
  for (const auto& reading : m_proximity->GetReadings()) {
    way -=
        CVector3(Read(reading.Value) * Cos(reading.Angle), reading.Value * Sin(reading.Angle), 0);
  }
  for (const auto& reading : m_light->GetReadings()) {
    way +=
        CVector3(Read(reading.Value) * Cos(reading.Angle), reading.Value * Sin(reading.Angle), 0);
  }
  for (const auto* blob : m_camera->GetReadings().BlobList) {
    way += CVector3(0.001 * Read(blob->X), 0.001 * Read(blob->Y), 0.01);
  }
  way.SetZ(way.GetZ() + 0.1 * (0.7 - Read(m_pose->GetReading().Position.GetZ())));
  const CRadians turn(0.1 * way.GetY());
  way *= 0.1;
  if (m_places != nullptr) {
    m_places->SetRelativePosition(way);
    m_places->SetRelativeYaw(turn);
  } else {
    m_speeds->SetLinearVelocity(way);
    m_speeds->SetRotationalSpeed(turn);
  }
  CountStep();
}

SExperiment Holders(UInt32 pairs, bool noisy) {
  const std::string noise = Noise(noisy);
  const auto perRow = static_cast<UInt32>(std::ceil(std::sqrt(static_cast<Real>(pairs))));
  SExperiment experiment;
  experiment.Controllers =
      "<holder id='holder'><actuators>" +
      Device("differential_steering", noisy ? "dead_reckoning" : "default", "") +
      Device("footbot_gripper", "default", noise) + Device("footbot_turret", "default", noise) +
      "</actuators><sensors>" + Device("footbot_turret_encoder", "default", noise) +
      "</sensors><params/></holder>";
  experiment.Engines = "<dynamics2d id='engine'/>";
  const Real side = kPairSpacing * perRow + 2.0;
  experiment.ArenaSize = std::to_string(side) + "," + std::to_string(side) + ",2";
  const Real middle = 0.5 * kPairSpacing * (perRow - 1);
  const char* const robot = "<foot-bot id='";
  for (UInt32 i = 0; i < pairs; ++i) {
    const std::string number = std::to_string(i);
    const CVector3 load(kPairSpacing * (i % perRow) - middle,
                        kPairSpacing * static_cast<UInt32>(i / perRow) - middle, 0.0);
    const CVector3 arm(kReach, 0.0, 0.0);
    experiment.Arena += robot + ("left" + number) + "'><body " + PoseText(load - arm, 0.0) +
                        "/><controller config='holder'/></foot-bot>" + robot + "right" + number +
                        "'><body " + PoseText(load + arm, 180.0) +
                        "/><controller config='holder'/></foot-bot><cylinder id='load" + number +
                        "' radius='0.1' height='0.1' movable='true' mass='" +
                        std::to_string(0.1 + i % 3) + "'><body " + PoseText(load) + "/></cylinder>";
  }
  return experiment;
}

SExperiment Flyers(UInt32 robots, bool noisy) {
  const std::string noise = Noise(noisy);
  const std::string sensors =
      "<sensors>" + Device("eyebot_proximity", "default", noise) +
      Device("eyebot_light", "rot_z_only", noise) + Device("positioning", "default", noise) +
      Device("colored_blob_perspective_camera", "default", noise, "medium='leds'") +
      "</sensors><params/></flyer>";
  const auto perRow = static_cast<UInt32>(std::ceil(std::sqrt(static_cast<Real>(robots))));
  SExperiment experiment;
  experiment.Controllers = "<flyer id='places'><actuators>" +
                           Device("quadrotor_position", "default", noise) + "</actuators>" +
                           sensors + "<flyer id='speeds'><actuators>" +
                           Device("quadrotor_speed", "default", noise) + "</actuators>" + sensors;
  experiment.Engines = "<pointmass3d id='engine'/>";
  experiment.Media = "<led id='leds'/>";
  const Real side = kFlyerSpacing * perRow + 4.0;
  experiment.ArenaSize = std::to_string(side) + "," + std::to_string(side) + ",4";
  const Real middle = 0.5 * kFlyerSpacing * (perRow - 1);
  for (UInt32 i = 0; i < robots; ++i) {
    const CVector3 place(kFlyerSpacing * (i % perRow) - middle,
                         kFlyerSpacing * static_cast<UInt32>(i / perRow) - middle, 0.5);
    experiment.Arena +=
        "<eye-bot id='eb" + std::to_string(i) + "'><body " + PoseText(place, 37.0 * i) +
        "/><controller config='" + (i % 2 == 0 ? "places" : "speeds") + "'/></eye-bot>" +
        LightText("lamp" + std::to_string(i), place - CVector3(0.1, 0.05, 0.4), "red");
  }
  return experiment;
}

}  // namespace argos

using argos::CFlyer;
using argos::CHolder;
REGISTER_CONTROLLER(CHolder, "holder")
REGISTER_CONTROLLER(CFlyer, "flyer")
