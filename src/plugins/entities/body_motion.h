#ifndef ARGOS3_PLUGINS_ENTITIES_BODY_MOTION_H
#define ARGOS3_PLUGINS_ENTITIES_BODY_MOTION_H

#include <argos3/core/simulator/entity/embodied_entity.h>

namespace argos {

/** How a body has moved since a pose that is remembered. For the sources of components. */
class CBodyMotion {
 public:
  bool HasBody() const { return m_body != nullptr; }
  /** Remembers the pose that the body has now. @param body must outlive this. */
  void SetBody(const CEmbodiedEntity& body) {
    m_body = &body;
    Remember();
  }
  void Remember() {
    m_position = m_body->GetOriginAnchor().Position;
    m_orientation = m_body->GetOriginAnchor().Orientation;
  }
  /** Remembers the pose that the body starts with. */
  void RememberStart() {
    m_position = m_body->GetInitPosition();
    m_orientation = m_body->GetInitOrientation();
  }

  /** Of the origin, m. */
  Real ComputeDistance() const { return Distance(m_body->GetOriginAnchor().Position, m_position); }
  /** Where the origin is now, in the frame remembered, m. */
  CVector3 ComputeStep() const {
    CVector3 step = m_body->GetOriginAnchor().Position - m_position;
    return step.Rotate(m_orientation.Inverse());
  }
  /** How the body is turned now, in the frame remembered. */
  CQuaternion ComputeTurn() const {
    return m_orientation.Inverse() * m_body->GetOriginAnchor().Orientation;
  }

 private:
  const CEmbodiedEntity* m_body = nullptr;  // not owned
  CVector3 m_position;  // of the origin anchor, world frame, m
  CQuaternion m_orientation;
};

}  // namespace argos

#endif
