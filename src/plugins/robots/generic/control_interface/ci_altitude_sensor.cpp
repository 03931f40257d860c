#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>

namespace argos {

void CCI_AltitudeSensor::ListNumbers(CNumberList& list) const {
  list.Add("height", "m", m_fReading);
}

}  // namespace argos
