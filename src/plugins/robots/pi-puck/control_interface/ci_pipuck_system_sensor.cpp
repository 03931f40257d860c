#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_system_sensor.h>

namespace argos {

void CCI_PiPuckSystemSensor::ListNumbers(CNumberList& list) const {
  list.Add("time", "s", m_fTime);
  list.Add("temperature", "", m_fTemperature);
}

}  // namespace argos
