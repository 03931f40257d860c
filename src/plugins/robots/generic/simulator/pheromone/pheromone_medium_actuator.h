#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PHEROMONE_PHEROMONE_MEDIUM_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PHEROMONE_PHEROMONE_MEDIUM_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_actuator.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/simulator/media/pheromone_medium.h>

#include <memory>
#include <vector>

namespace argos {

class CEmbodiedEntity;

/** Lays substances of a medium under the robot. */
class CPheromoneMediumActuator : public CSimulatedActuator, public CCI_PheromoneActuator {
 public:
  /** @throws CARGoSException unless the robot has "body" and "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `medium`, `layers`, `offset` and `<noise>`. @throws CARGoSException. */
  void Init(TConfigurationNode& tree) override;
  /** @throws CARGoSException that names the robot, if a rate is not a number >= 0. */
  void Update() override;
  /** Nothing is laid; noise starts over. */
  void Reset() override;

 private:
  CControllableEntity* m_robot = nullptr;
  CEmbodiedEntity* m_body = nullptr;  // of the robot
  std::unique_ptr<CPheromoneMedium::CUser> m_user;
  std::vector<size_t> m_layers;  // of the medium, (m_vecInterfaces)
  CVector3 m_offset;  // in the robot's frame, m
  CDeviceNoise m_noise;  // on "rate"
};

}  // namespace argos

#endif
