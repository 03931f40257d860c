#include <argos3/testing/benchmark/shove.h>

#include <argos3/testing/benchmark/pen.h>
#include <argos3/testing/support/experiment.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace argos::testing {

void CShover::Init(TConfigurationNode& params) {
  m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  m_proximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
  m_random = CRandom::CreateRNG("argos");
  bool grips = false;
  GetNodeAttributeOrDefault(params, "grips", grips, grips);
  if (grips) {
    GetActuator<CCI_FootBotGripperActuator>("footbot_gripper")->LockPositive();
  }
}

void CShover::ControlStep() {
  constexpr Real kSpeed = 12.0;  // cm/s
  constexpr Real kOften = 0.1;  // where it touches something, a tick
  constexpr Real kSeldom = 0.01;
  if (m_turnsLeft > 0) {
    --m_turnsLeft;
  } else if (m_random->Uniform(CRange<Real>(0.0, 1.0)) < (IsTouching() ? kOften : kSeldom)) {
    m_turnsLeft = m_random->Uniform(CRange<UInt32>(5, 16));
  }
  m_wheels->SetLinearVelocity(m_turnsLeft > 0 ? -0.5 * kSpeed : kSpeed,
                              m_turnsLeft > 0 ? 0.5 * kSpeed : kSpeed);
}

bool CShover::IsTouching() const {
  const auto& readings = m_proximity->GetReadings();
  return std::any_of(readings.begin(), readings.end(),
                     [](const auto& reading) { return reading.Value > 0.9; });
}

std::string MakeShove(UInt32 robots, UInt32 gripping, UInt32 threads, const std::string& engine,
                      const std::string& attributes) {
  constexpr Real kRadius = 0.085;  // m
  constexpr Real kShare = 0.2;
  const Real half =
      0.5 * kRadius * std::sqrt(static_cast<Real>(robots) * std::numbers::pi / kShare);
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Controllers =
      "<shover id='shover'><actuators><differential_steering implementation='default'/></actuators>"
      "<sensors><footbot_proximity implementation='default'/></sensors></shover>"
      "<shover id='gripper'><actuators><differential_steering implementation='default'/>"
      "<footbot_gripper implementation='default'/></actuators>"
      "<sensors><footbot_proximity implementation='default'/></sensors>"
      "<params grips='true'/></shover>";
  experiment.Engines = "<" + engine + " id='engine' " + attributes + "/>";
  CPen pen(half);
  const UInt32 objects = robots / 4;
  pen.Distribute(0.2, objects / 2,
                 "<cylinder id='c' radius='0.1' height='0.1' movable='true' mass='0.2'/>");
  pen.Distribute(0.2, objects - objects / 2,
                 "<box id='b' size='0.3,0.2,0.1' movable='true' mass='0.3'/>");
  pen.Distribute(0.1, robots - gripping,
                 "<foot-bot id='r'><controller config='shover'/></foot-bot>");
  if (gripping > 0) {
    pen.Distribute(0.1, gripping, "<foot-bot id='g'><controller config='gripper'/></foot-bot>");
  }
  experiment.ArenaSize = pen.GetArenaSize();
  experiment.Arena = pen.GetText();
  return experiment.ToXml();
}

REGISTER_CONTROLLER(CShover, "shover")

}  // namespace argos::testing
