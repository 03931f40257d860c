#ifndef ODOMETER_DEFAULT_SENSOR_H
#define ODOMETER_DEFAULT_SENSOR_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <sensor/ci_odometer_sensor.h>

namespace argos {

class COdometerDefaultSensor : public CSimulatedSensor, public CCI_OdometerSensor {
 public:
  COdometerDefaultSensor() : m_pcBody(NULL) {}
  virtual ~COdometerDefaultSensor() {}
  virtual void SetRobot(CComposableEntity& c_entity);
  virtual void Init(TConfigurationNode& t_tree);
  virtual void Update();
  virtual void Reset();

 private:
  CEmbodiedEntity* m_pcBody;
  CVector3 m_cLastPosition;
};

}  // namespace argos

#endif
