#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PHEROMONE_PHEROMONE_MEDIUM_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PHEROMONE_PHEROMONE_MEDIUM_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

#include <vector>

namespace argos {

class CControllableEntity;
class CEmbodiedEntity;
class CPheromoneMedium;

/** Reads the concentrations that a medium has under the robot. */
class CPheromoneMediumSensor : public CSimulatedSensor, public CCI_PheromoneSensor {
 public:
  /** @throws CARGoSException unless the robot has "body" and "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `medium`, `layers`, `<point>` and `<noise>`. @throws CARGoSException. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** All readings 0; noise starts over. */
  void Reset() override;

 private:
  CControllableEntity* m_robot = nullptr;
  CEmbodiedEntity* m_body = nullptr;  // of the robot
  CPheromoneMedium* m_medium = nullptr;
  std::vector<size_t> m_layers;  // of the medium, (m_vecInterfaces)
  std::vector<CVector3> m_points;  // in the robot's frame, m
  CDeviceNoise m_noise;  // on "value"
};

}  // namespace argos

#endif
