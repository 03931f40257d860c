#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>

namespace argos {

const std::vector<Real>& CCI_ProximitySensor::GetReadings() const {
  return m_tReadings;
}

}  // namespace argos
