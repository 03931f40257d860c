#include "odometer_default_sensor.h"

#include <argos3/core/simulator/entity/composable_entity.h>

namespace argos {

void COdometerDefaultSensor::SetRobot(CComposableEntity& c_entity) {
  m_pcBody = &(c_entity.GetComponent<CEmbodiedEntity>("body"));
}

void COdometerDefaultSensor::Init(TConfigurationNode& t_tree) {
  CCI_OdometerSensor::Init(t_tree);
  m_cLastPosition = m_pcBody->GetOriginAnchor().Position;
  Enable();
}

void COdometerDefaultSensor::Update() {
  m_fReading += Distance(m_pcBody->GetOriginAnchor().Position, m_cLastPosition);
  m_cLastPosition = m_pcBody->GetOriginAnchor().Position;
}

void COdometerDefaultSensor::Reset() {
  m_fReading = 0.0;
  m_cLastPosition = m_pcBody->GetOriginAnchor().Position;
}

REGISTER_SENSOR(COdometerDefaultSensor, "odometer", "default", "A researcher", "1.0",
                "The distance driven.", "The distance that the robot has moved, in m.", "Usable");

}  // namespace argos
