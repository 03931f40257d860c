#ifndef MICROPHONE_MEDIUM_SENSOR_H
#define MICROPHONE_MEDIUM_SENSOR_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/sensor.h>

#include "ci_microphone_sensor.h"
#include "sound_medium.h"

namespace argos {

class CMicrophoneMediumSensor : public CCI_MicrophoneSensor, public CSimulatedSensor {
 public:
  CMicrophoneMediumSensor() : m_pcMedium(NULL), m_pcBody(NULL) {}
  virtual ~CMicrophoneMediumSensor() {}
  virtual void SetRobot(CComposableEntity& c_entity);
  virtual void Init(TConfigurationNode& t_tree);
  virtual void Update();
  virtual void Reset();

 private:
  CSoundMedium* m_pcMedium;
  CEmbodiedEntity* m_pcBody;
};

}  // namespace argos

#endif
