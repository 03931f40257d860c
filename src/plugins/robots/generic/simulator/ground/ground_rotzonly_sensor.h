#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GROUND_GROUND_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GROUND_GROUND_ROTZONLY_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ground_sensor.h>
#include <argos3/plugins/robots/generic/simulator/floor_reader.h>

namespace argos {

/** All ground sensors of any robot. */
class CGroundRotZOnlySensor : public CSimulatedSensor, public CCI_GroundSensor {
 public:
  /** @throws CARGoSException if the robot has no "ground_sensors". */
  void SetRobot(CComposableEntity& robot) override;
  /** See CFloorReader::Init(). */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  CFloorReader m_floor;
};

}  // namespace argos

#endif
