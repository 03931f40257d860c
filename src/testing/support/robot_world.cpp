#include <argos3/testing/support/robot_world.h>

namespace argos {

SExperiment SRobotExperiment::ToExperiment() const {
  SExperiment experiment;
  experiment.Seed = Seed;
  // an unused controller would be reported by a warning
  const bool isUsed = Arena.find("config=\"c\"") != std::string::npos;
  const bool hasDevices = !Sensors.empty() || !Actuators.empty();
  if (isUsed || hasDevices) {
    experiment.Controllers = "<robot_world_controller id=\"c\"><actuators>" + Actuators +
                             "</actuators><sensors>" + Sensors +
                             "</sensors><params/></robot_world_controller>";
  }
  experiment.Engines = Engine;
  experiment.Media = Media;
  experiment.LoopFunctions = LoopFunctions;
  experiment.Arena = Arena;
  return experiment;
}

CRobotWorld::CRobotWorld(const SRobotExperiment& experiment)
    : CTestWorld(experiment.ToExperiment()), m_scope(GetSimulator()) {}

CControllableEntity& CRobotWorld::GetRobot(const std::string& id) {
  return Get<CComposableEntity>(id).GetComponent<CControllableEntity>("controller");
}

std::string Robot(const std::string& tag, const std::string& id, const std::string& pose) {
  return "<" + tag + " id=\"" + id + "\"><body " + pose + "/><controller config=\"c\"/></" + tag +
         ">";
}

std::string LoadError(const SRobotExperiment& experiment) {
  return LoadError(experiment.ToExperiment());
}

}  // namespace argos

using argos::CRobotWorldController;
REGISTER_CONTROLLER(CRobotWorldController, "robot_world_controller")
