#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/noisy_sensor.h>
#include <argos3/plugins/robots/generic/simulator/units.h>
#include <argos3/plugins/simulator/entities/odometer_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

namespace argos {

namespace {

enum EWheel : size_t { LEFT, RIGHT };

/** The distances that the wheels of a foot-bot rolled; see COdometerEntity. */
class CFootBotEncoderDefaultSensor : public CNoisySensor<CCI_FootBotEncoderSensor> {
 public:
  void Update() override {
    const auto read = [this](EWheel wheel) {
      return m_noise.Apply(wheel, kCentimetersPerMeter * m_odometer->GetRolledDistance(wheel));
    };
    m_sReading.CoveredDistanceLeftWheel = read(LEFT);
    m_sReading.CoveredDistanceRightWheel = read(RIGHT);
  }

 private:
  void FindParts(CComposableEntity& robot) override {
    auto& odometer = robot.GetComponent<COdometerEntity>("odometer");
    odometer.Enable();
    m_odometer = &odometer;
    const auto& wheels = robot.GetComponent<CWheeledEntity>("wheels");
    m_sReading.WheelAxisLength = kCentimetersPerMeter * Distance(wheels.GetWheelPosition(LEFT),
                                                                 wheels.GetWheelPosition(RIGHT));
  }
  void Configure(TConfigurationNode& tree) override {
    m_noise.Init(tree, *m_robot, {"distance_left", "distance_right"});
  }
  void ResetReading() override { m_sReading = SReading(0.0, 0.0, m_sReading.WheelAxisLength); }

  const COdometerEntity* m_odometer = nullptr;
};

}  // namespace

REGISTER_SENSOR(
    CFootBotEncoderDefaultSensor, "footbot_encoder", "default", "the authors of this project",
    "1.0", "The distances that the wheels of the foot-bot rolled.",
    R"(Reads the distance that each wheel rolled over the ground in the last tick, in cm, positive ahead, computed from
the actual motion of the body: for a robot that pushes against a wall, or is pushed, it differs from the speeds set by
the controller (which differential_steering reads). The sensor assumes constant speeds along the heading, sideways and
about the vertical during a tick; sideways sliding rotates no wheel, and neither does a move by command. This is exact on
the arcs of the drive, for less than half a turn in a tick. The drift of differential_steering (dead_reckoning) is not
part of it: the encoder reads what the motors turned. Also reads the distance between the wheels, in cm.
)" + RequiredSensorXML(R"(<footbot_encoder implementation="default" />)") +
        OptionalNoiseXML("footbot_encoder",
                         R"(on="distance_left" model="gaussian" std_dev="0.01" relative="true")") +
        NoiseManual("distance_left|distance_right", "the distances (cm) in each tick."),
    "Usable")

}  // namespace argos
