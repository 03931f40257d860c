#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_gripping.h>

#include <argos3/core/utility/configuration/argos_exception.h>

#include <cmath>

namespace argos {

namespace {

cpShape* RequireShape(const char* what, cpShape* shape) {
  if (shape == nullptr) {
    THROW_ARGOSEXCEPTION(what << ": the shape is a null pointer");
  }
  return shape;
}

}  // namespace

CDynamics2DGripper::CDynamics2DGripper(CDynamics2DEngine& /*engine*/,
                                       CGripperEquippedEntity& entity, cpShape* shape)
    : m_cGripperEntity(entity), m_ptGripperShape(RequireShape("CDynamics2DGripper", shape)) {
  shape->Gripper = this;
}

Real CDynamics2DGripper::GetExtension() const {
  return std::hypot(m_ptGripperShape->Offset.x, m_ptGripperShape->Offset.y);
}

void CDynamics2DGripper::SetGrippee(CDynamics2DGrippable* grippee) {
  if (grippee == m_grippee) {
    return;
  }
  if (m_grippee != nullptr) {
    m_grippee->Remove(*this);
  }
  m_grippee = grippee;
  if (m_grippee != nullptr) {
    m_grippee->Attach(*this);
  }
}

CDynamics2DGrippable::CDynamics2DGrippable(CEmbodiedEntity& entity, cpShape* shape)
    : m_cEmbodiedEntity(entity), m_ptShape(RequireShape("CDynamics2DGrippable", shape)) {
  shape->Grippable = this;
}

CDynamics2DGrippable::~CDynamics2DGrippable() {
  while (!m_grippers.empty()) {
    m_grippers.front()->SetGrippee(nullptr);
  }
}

void CDynamics2DGrippable::ReleaseAll() {
  for (CDynamics2DGripper* gripper : m_grippers) {
    gripper->Release();
  }
}

}  // namespace argos
