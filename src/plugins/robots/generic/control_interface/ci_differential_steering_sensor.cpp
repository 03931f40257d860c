#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>

namespace argos {

const CCI_DifferentialSteeringSensor::SReading& CCI_DifferentialSteeringSensor::GetReading() const {
  return m_sReading;
}

}  // namespace argos
