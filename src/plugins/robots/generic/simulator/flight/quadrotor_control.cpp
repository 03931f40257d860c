#include <argos3/plugins/robots/generic/simulator/quadrotor_control.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>

namespace argos {

CQuadRotorControl::~CQuadRotorControl() {
  if (m_quadrotor != nullptr) {
    m_quadrotor->SetControlMethod(CQuadRotorEntity::NO_CONTROL);
  }
}

void CQuadRotorControl::Acquire(CComposableEntity& robot, CQuadRotorEntity::EControlMethod method,
                                const std::string& device) {
  auto& quadrotor = robot.GetComponent<CQuadRotorEntity>("quadrotor");
  if (quadrotor.GetControlMethod() != CQuadRotorEntity::NO_CONTROL) {
    THROW_ARGOSEXCEPTION("actuator \"" << device << "\": the propellers of robot \""
                                       << robot.GetId()
                                       << "\" already have an actuator; list \"quadrotor_position\""
                                          " or \"quadrotor_speed\", not both");
  }
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  m_quadrotor = &quadrotor;
  m_quadrotor->SetControlMethod(method);
}

CRadians CQuadRotorControl::ComputeYaw() const {
  const SAnchor& origin = m_body->GetOriginAnchor();
  return CRadians(MakePlanarPose(origin.Position, origin.Orientation).ComputeYaw());
}

CVector3 ApplyNoise(CDeviceNoise& noise, size_t quantity, const CVector3& vector) {
  if (!noise.IsOn()) {
    return vector;
  }
  CVector3 noisy;
  for (UInt32 axis = 0; axis < 3; ++axis) {
    noisy[axis] = noise.Apply(quantity, vector[axis]);
  }
  return noisy;
}

}  // namespace argos
