#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/noisy_sensor.h>

namespace argos {

namespace {

/** The clock of the experiment, with optional noise. */
class CClockDefaultSensor : public CNoisySensor<CCI_ClockSensor> {
 public:
  void Update() override {
    m_sReading.Tick = m_robot->GetSpace().GetSimulationClock();
    m_sReading.Time = m_noise.Apply(0, m_sReading.Tick * m_robot->GetSimulator().GetTickLength());
  }

 private:
  void Configure(TConfigurationNode& tree) override { m_noise.Init(tree, *m_robot, {"time"}); }
  void ResetReading() override { m_sReading = SReading(); }
};

}  // namespace

REGISTER_SENSOR(
    CClockDefaultSensor, "clock", "default", "the authors of this project", "1.0",
    "The time of the experiment.",
    R"(Reads the number of the tick, which is 1 in the first step of the controller, and the simulated time in
seconds: the number of the tick times the length of a tick.
)" + RequiredSensorXML(R"(<clock implementation="default" />)") +
        OptionalNoiseXML("clock",
                         R"(on="time" model="gaussian" std_dev="0" bias="0.001" relative="true")") +
        NoiseManual("time",
                    "the time (s), not to the tick. With the noise of the example, the clock gains "
                    "1 ms per second."),
    "Usable")

}  // namespace argos
