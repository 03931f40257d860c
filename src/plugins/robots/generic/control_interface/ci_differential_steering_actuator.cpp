#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

namespace argos {

CCI_DifferentialSteeringActuator::CCI_DifferentialSteeringActuator()
    : m_fCurrentVelocity{0.0, 0.0} {}

}  // namespace argos
