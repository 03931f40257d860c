#include <argos3/plugins/robots/generic/simulator/battery_default_sensor.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>

#include <algorithm>
#include <limits>

namespace argos {

namespace {

// fraction of the full charge: a smaller change in a tick counts as no change
constexpr Real kNoChange = 1e-6;
constexpr Real kForever = std::numeric_limits<Real>::infinity();

}  // namespace

void CBatteryDefaultSensor::FindParts(CComposableEntity& robot) {
  m_battery = &robot.GetComponent<CBatteryEquippedEntity>("battery");
  m_battery->Enable();
  m_sReading = SReading(GetCharge(), kForever);
}

void CBatteryDefaultSensor::Configure(TConfigurationNode& tree) {
  m_noise.Init(tree, *m_robot, {"available_charge"}, {ReadNoiseRange(tree, "noise_range")});
}

Real CBatteryDefaultSensor::GetCharge() const {
  return std::clamp(m_battery->GetAvailableCharge() / m_battery->GetFullCharge(), 0.0, 1.0);
}

void CBatteryDefaultSensor::Update() {
  const Real before = m_sReading.AvailableCharge;
  const Real now = std::clamp(m_noise.Apply(0, GetCharge()), 0.0, 1.0);
  m_sReading.AvailableCharge = now;
  if (now <= 0.0) {
    m_sReading.TimeLeft = 0.0;
  } else if (before - now <= kNoChange) {
    m_sReading.TimeLeft = kForever;
  } else {
    m_sReading.TimeLeft = before * m_robot->GetSimulator().GetTickLength() / (before - now);
  }
}

void CBatteryDefaultSensor::ResetReading() {
  m_sReading = SReading(GetCharge(), kForever);
}

REGISTER_SENSOR(
    CBatteryDefaultSensor, "battery", "default", "the authors of this project", "1.0",
    "The charge of a robot's battery.",
    R"(Reads the available charge as a fraction of the full charge, and the time left (s) until the battery is empty
at the rate of the last tick: with q0 the previous reading and q the new one, 0 if q <= 0; infinite if q >= q0 - 1e-6;
else q0 dt / (q0 - q), where dt is the length of a tick. The charge falls only if the robot has a <battery> element and
its controller has this sensor. A robot continues to work with an empty battery.
)" + RequiredSensorXML(R"(<battery implementation="default" />)") +
        R"(
with a battery in each robot (see the manuals of the robots):

  <arena size="10,10,2">
    <foot-bot id="fb0">
      <body position="0.4,2.3,0" />
      <controller config="c1" />
      <battery discharge_model="time" delta="1e-5" start_charge="1" full_charge="1" />
    </foot-bot>
  </arena>
)" + OptionalXML(R"(<battery implementation="default" noise_range="-0.01:0.02" />)") +
        R"(
  noise_range  "min:max", default "0:0": a number drawn evenly from it is added to the available
               charge in each tick, and the sum is clamped to [0,1].
)" + NoiseManual("available_charge", "the charge in the same way."),
    "Usable")

}  // namespace argos
