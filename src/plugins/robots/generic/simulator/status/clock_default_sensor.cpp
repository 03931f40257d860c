#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

namespace {

/** The clock of the experiment, with optional noise. */
class CClockDefaultSensor : public CSimulatedSensor, public CCI_ClockSensor {
 public:
  /** @throws CARGoSException if the robot has no "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  const CControllableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;
};

}  // namespace

void CClockDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
}

void CClockDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_ClockSensor::Init(tree);
  m_noise.Init(tree, *m_robot, {"time"});
  Enable();
}

void CClockDefaultSensor::Update() {
  m_sReading.Tick = m_robot->GetSpace().GetSimulationClock();
  m_sReading.Time = m_noise.Apply(0, m_sReading.Tick * m_robot->GetSimulator().GetTickLength());
}

void CClockDefaultSensor::Reset() {
  m_sReading = SReading();
  m_noise.Reset();
}

REGISTER_SENSOR(
    CClockDefaultSensor, "clock", "default", "the authors of this project", "1.0",
    "The time of the experiment.",
    R"(Reads the number of the tick, which is 1 in the first step of the controller, and the simulated time in
seconds: the number of the tick times the length of a tick.
)" + RequiredSensorXML(R"(<clock implementation="default" />)") +
        OptionalXML(R"(<clock implementation="default">
    <noise on="time" model="gaussian" std_dev="0" bias="0.001" relative="true" />
  </clock>)") +
        NoiseManual("time",
                    "the time (s), not to the tick. With the noise of the example, the clock gains "
                    "1 ms per second."),
    "Usable")

}  // namespace argos
