#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_FLIGHT_WORLD_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_FLIGHT_WORLD_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_position_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_speed_actuator.h>
#include <argos3/testing/support/closed_form/pd_loop.h>
#include <argos3/testing/support/experiment.h>

#include <string>

namespace argos {

/** Parameters of a world of eye-bots; the defaults run. */
struct SFlightExperiment {
  std::string Actuator = "quadrotor_position"; /**< of the controller "pilot"; empty: none */
  std::string MoreActuators = ""; /**< elements */
  std::string Engines = "<pointmass3d id='e'/>";
  std::string Arena; /**< children of `<arena>` */
  std::string ArenaSize = "40,40,40";
  UInt32 TicksPerSecond = 10;
  UInt32 Threads = 0;

  SExperiment ToExperiment() const;
};

/** XML of an eye-bot with the controller "pilot". @param yaw degrees. */
std::string EyeBotXml(const std::string& id, const CVector3& position, Real yaw = 0.0);

/** Runs such an experiment; its simulator is current for the calling thread during its lifetime. */
class CFlightWorld : public CTestWorld {
 public:
  explicit CFlightWorld(const SFlightExperiment& experiment);

  CEmbodiedEntity& Body(const std::string& id = "r");
  CVector3 Position(const std::string& id = "r") { return Body(id).GetOriginAnchor().Position; }
  /** Heading, rad, in (-pi, pi]. */
  Real Yaw(const std::string& id = "r");
  CCI_QuadRotorPositionActuator& Places(const std::string& id = "r");
  CCI_QuadRotorSpeedActuator& Speeds(const std::string& id = "r");

 private:
  CSimulator::CScope m_scope;
};

/** The published controllers of the eye-bot, implemented a second time for comparison. */
testing::SPDLoop EyeBotPlace();
testing::SPDLoop EyeBotYaw();
testing::SPDLoop EyeBotVelocity();
testing::SPDLoop EyeBotYawRate();

}  // namespace argos

#endif
