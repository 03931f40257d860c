#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GROUND_GROUND_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GROUND_GROUND_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_ground_sensor.h>
#include <argos3/plugins/robots/generic/simulator/floor_reader.h>
#include <argos3/plugins/robots/generic/simulator/inherited_noise.h>
#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>

namespace argos {

class CEmbodiedEntity;

/**
 * All ground sensors of any robot. A derived class may set the protected members itself in its
 * SetRobot() and Init().
 */
class CGroundRotZOnlySensor : public CPlainReadingsSensor<CCI_GroundSensor, CFloorReader>,
                              protected CInheritedNoise {
 public:
  CGroundRotZOnlySensor();

  void SetRobot(CComposableEntity& robot) override;
  void Init(TConfigurationNode& tree) override;
  void Update() override;

 protected:
  CEmbodiedEntity* m_pcEmbodiedEntity = nullptr;  // null if the robot has none
  CGroundSensorEquippedEntity*& m_pcGroundSensorEntity;
  CFloorEntity* m_pcFloorEntity = nullptr;  // current after Update(); null before there is a floor
  CSpace& m_cSpace;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/space/space.h>
#endif

#endif
