#include "microphone_medium_sensor.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/simulator.h>

namespace argos {

void CMicrophoneMediumSensor::SetRobot(CComposableEntity& c_entity) {
  m_pcBody = &(c_entity.GetComponent<CEmbodiedEntity>("body"));
}

void CMicrophoneMediumSensor::Init(TConfigurationNode& t_tree) {
  CCI_MicrophoneSensor::Init(t_tree);
  std::string strMedium;
  GetNodeAttribute(t_tree, "medium", strMedium);
  m_pcMedium = &(CSimulator::GetInstance().GetMedium<CSoundMedium>(strMedium));
  Enable();
}

void CMicrophoneMediumSensor::Update() {
  m_fLoudness = m_pcMedium->GetLoudnessAt(m_pcBody->GetOriginAnchor().Position);
}

void CMicrophoneMediumSensor::Reset() {
  m_fLoudness = 0.0;
}

REGISTER_SENSOR(CMicrophoneMediumSensor, "microphone", "medium", "A researcher", "1.0",
                "Hears speakers.", "The loudness at the robot.", "Usable");

}  // namespace argos
