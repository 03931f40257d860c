#include <argos3/testing/contract/physics_engines/flight_world.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/testing/support/robot_world.h>

namespace argos {

SExperiment SFlightExperiment::ToExperiment() const {
  SExperiment experiment;
  experiment.Threads = Threads;
  experiment.TicksPerSecond = TicksPerSecond;
  // an unused controller would be reported by a warning
  if (Arena.find("config='pilot'") != std::string::npos) {
    const std::string device =
        Actuator.empty() ? "" : "<" + Actuator + " implementation='default'/>";
    experiment.Controllers = "<robot_world_controller id='pilot'><actuators>" + device +
                             MoreActuators + "</actuators><sensors/></robot_world_controller>";
  }
  experiment.Engines = Engines;
  experiment.ArenaSize = ArenaSize;
  experiment.Arena = Arena;
  return experiment;
}

std::string EyeBotXml(const std::string& id, const CVector3& position, Real yaw) {
  return "<eye-bot id='" + id + "'><body position='" + ToText(position) + "' orientation='" +
         ToText(yaw) + ",0,0'/><controller config='pilot'/></eye-bot>";
}

CFlightWorld::CFlightWorld(const SFlightExperiment& experiment)
    : CTestWorld(experiment.ToExperiment()), m_scope(GetSimulator()) {}

CEmbodiedEntity& CFlightWorld::Body(const std::string& id) {
  return Get<CComposableEntity>(id).GetComponent<CEmbodiedEntity>("body");
}

Real CFlightWorld::Yaw(const std::string& id) {
  CRadians z;
  CRadians y;
  CRadians x;
  Body(id).GetOriginAnchor().Orientation.ToEulerAngles(z, y, x);
  return z.GetValue();
}

CCI_QuadRotorPositionActuator& CFlightWorld::Places(const std::string& id) {
  auto& robot = Get<CComposableEntity>(id).GetComponent<CControllableEntity>("controller");
  return *robot.GetController().GetActuator<CCI_QuadRotorPositionActuator>("quadrotor_position");
}

CCI_QuadRotorSpeedActuator& CFlightWorld::Speeds(const std::string& id) {
  auto& robot = Get<CComposableEntity>(id).GetComponent<CControllableEntity>("controller");
  return *robot.GetController().GetActuator<CCI_QuadRotorSpeedActuator>("quadrotor_speed");
}

testing::SPDLoop EyeBotPlace() {
  testing::SPDLoop loop;
  loop.Inertia = 1.0;
  loop.Proportional = 20.0;
  loop.Derivative = 10.0;
  return loop;
}

testing::SPDLoop EyeBotYaw() {
  testing::SPDLoop loop;
  loop.Inertia = 0.01;
  loop.Proportional = 0.5;
  loop.Derivative = 0.1;
  loop.IsAngle = true;
  return loop;
}

testing::SPDLoop EyeBotVelocity() {
  testing::SPDLoop loop;
  loop.Inertia = 1.0;
  loop.Proportional = 20.0;
  return loop;
}

testing::SPDLoop EyeBotYawRate() {
  return EyeBotYaw();
}

}  // namespace argos
