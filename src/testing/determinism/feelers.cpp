#include <argos3/testing/determinism/feelers.h>

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_base_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ground_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/testing/support/arena_text.h>

#include <cmath>

namespace argos {

namespace {

constexpr Real kSpeed = 10.0;  // cm/s
constexpr Real kSpacing = 0.4;  // m, between robots

std::string Device(const std::string& tag, const std::string& implementation,
                   const std::string& noise) {
  return "<" + tag + " implementation='" + implementation + "'>" + noise + "</" + tag + ">\n";
}

std::string Controller(bool noisy) {
  const std::string noise = noisy ? "<noise model='gaussian' std_dev='0.02' />" : "";
  const auto device = [&noise](const std::string& tag) { return Device(tag, "default", noise); };
  const auto planar = [&noise](const std::string& tag) { return Device(tag, "rot_z_only", noise); };
  return "<feeler id='feeler'><actuators>" +
         Device("differential_steering", noisy ? "dead_reckoning" : "default", "") +
         device("footbot_distance_scanner") + "</actuators><sensors>" + device("altitude") +
         device("battery") + device("clock") + device("differential_steering") +
         device("footbot_encoder") + device("footbot_proximity") + device("light") +
         device("positioning") + device("proximity") + planar("footbot_base_ground") +
         planar("footbot_distance_scanner") + planar("footbot_light") +
         planar("footbot_motor_ground") + planar("ground") + "</sensors><params/></feeler>";
}

}  // namespace

template <typename SENSOR, typename READ>
void CFeeler::Watch(const std::string& tag, READ read) {
  m_senses.push_back([this, read, sensor = GetSensor<SENSOR>(tag)] { read(*this, *sensor); });
}

template <typename SENSOR>
void CFeeler::WatchNumbers(const std::string& tag) {
  Watch<SENSOR>(tag, [](CFeeler& robot, const SENSOR& sensor) {
    for (const Real reading : sensor.GetReadings()) {
      robot.AddReading(reading);
    }
  });
}

template <typename SENSOR>
void CFeeler::WatchValues(const std::string& tag) {
  Watch<SENSOR>(tag, [](CFeeler& robot, const SENSOR& sensor) {
    for (const auto& reading : sensor.GetReadings()) {
      robot.AddReading(reading.Value);
    }
  });
}

void CFeeler::Init(TConfigurationNode& /*params*/) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_scanner = GetActuator<CCI_FootBotDistanceScannerActuator>("footbot_distance_scanner");
  WatchNumbers<CCI_ProximitySensor>("proximity");
  WatchNumbers<CCI_LightSensor>("light");
  WatchNumbers<CCI_GroundSensor>("ground");
  WatchValues<CCI_FootBotProximitySensor>("footbot_proximity");
  WatchValues<CCI_FootBotLightSensor>("footbot_light");
  WatchValues<CCI_FootBotMotorGroundSensor>("footbot_motor_ground");
  WatchValues<CCI_FootBotBaseGroundSensor>("footbot_base_ground");
  Watch<CCI_AltitudeSensor>("altitude", [](CFeeler& robot, const CCI_AltitudeSensor& sensor) {
    robot.AddReading(sensor.GetReading());
  });
  Watch<CCI_BatterySensor>("battery", [](CFeeler& robot, const CCI_BatterySensor& sensor) {
    robot.AddReading(sensor.GetReading().AvailableCharge);
    robot.m_readingsDigest.Add(sensor.GetReading().TimeLeft);
  });
  Watch<CCI_ClockSensor>("clock", [](CFeeler& robot, const CCI_ClockSensor& sensor) {
    robot.AddReading(sensor.GetReading().Time);
  });
  Watch<CCI_DifferentialSteeringSensor>(
      "differential_steering", [](CFeeler& robot, const CCI_DifferentialSteeringSensor& sensor) {
        robot.AddReading(sensor.GetReading().VelocityLeftWheel);
      });
  Watch<CCI_FootBotEncoderSensor>("footbot_encoder",
                                  [](CFeeler& robot, const CCI_FootBotEncoderSensor& sensor) {
                                    robot.AddReading(sensor.GetReading().CoveredDistanceRightWheel);
                                  });
  Watch<CCI_PositioningSensor>("positioning",
                               [](CFeeler& robot, const CCI_PositioningSensor& sensor) {
                                 robot.AddReading(sensor.GetReading().Position.GetX());
                                 robot.AddReading(sensor.GetReading().Orientation.GetZ());
                               });
  Watch<CCI_FootBotDistanceScannerSensor>(
      "footbot_distance_scanner", [](CFeeler& robot, CCI_FootBotDistanceScannerSensor& sensor) {
        for (const auto& [angle, distance] : sensor.GetReadingsMap()) {
          robot.AddReading(angle.GetValue() * distance);
        }
      });
}

void CFeeler::AddReading(Real reading) {
  m_readingsDigest.Add(reading);
  m_sum += reading;
}

void CFeeler::ControlStep() {
  m_sum = 0.0;
  for (const auto& sense : m_senses) {
    sense();
  }
  const Real turn = 0.5 * kSpeed * std::sin(m_sum);
  m_wheels->SetLinearVelocity(0.5 * kSpeed - turn, 0.5 * kSpeed + turn);
  m_scanner->SetRPM(30.0);
}

SExperiment Feelers(UInt32 robots, bool noisy) {
  const auto perRow = static_cast<UInt32>(std::ceil(std::sqrt(static_cast<Real>(robots))));
  SExperiment experiment;
  experiment.Controllers = Controller(noisy);
  experiment.LoopFunctions = "<loop_functions label='striped_floor' />";
  experiment.Engines = "<dynamics2d id='engine' />";
  experiment.Media = "<led id='leds' />";
  const Real middle = 0.5 * kSpacing * (perRow - 1);
  experiment.Arena = "<floor id='floor' source='loop_functions' pixels_per_meter='10' />";
  for (UInt32 i = 0; i < robots; ++i) {
    const CVector3 place(kSpacing * (i % perRow) - middle,
                         kSpacing * static_cast<UInt32>(i / perRow) - middle, 0.0);
    experiment.Arena += "<foot-bot id='fb" + std::to_string(i) + "'><body " +
                        PoseText(place, 37.0 * i) +
                        "/><controller config='feeler'/><battery discharge_model='time_motion'/>"
                        "</foot-bot>";
    experiment.Arena += PillarText("p" + std::to_string(i), place.GetX() + 0.5 * kSpacing,
                                   place.GetY() + 0.5 * kSpacing, 0.03, 0.3);
  }
  experiment.Arena += LightText("a", CVector3(middle + 0.5, 0.0, 0.4), "yellow") +
                      LightText("b", CVector3(-middle, middle, 0.7), "white");
  return experiment;
}

}  // namespace argos

using argos::CFeeler;
REGISTER_CONTROLLER(CFeeler, "feeler")
