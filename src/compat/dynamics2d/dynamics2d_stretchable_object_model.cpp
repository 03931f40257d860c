#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_stretchable_object_model.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

void CDynamics2DStretchableObjectModel::SetLinearFriction(Real /*maxBias*/, Real maxForce) {
  m_friction = RequireNotNegative(maxForce, "SetLinearFriction()", "the greatest force (N)");
}

void CDynamics2DStretchableObjectModel::SetAngularFriction(Real /*maxBias*/, Real maxForce) {
  m_angularFriction =
      RequireNotNegative(maxForce, "SetAngularFriction()", "the greatest torque (N m)");
}

void CDynamics2DStretchableObjectModel::Describe(SBodyDescription& description) const {
  if (m_fMass > 0.0) {
    description.Mass = m_fMass;
  }
  description.GroundFriction = SGroundFrictionDescription{SGroundFrictionDescription::EClass::Box,
                                                          m_friction, m_angularFriction};
}

}  // namespace argos
