#ifndef ARGOS3_PLUGINS_ENTITIES_BODY_MOTION_H
#define ARGOS3_PLUGINS_ENTITIES_BODY_MOTION_H

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/embodied_entity.h>

#include <cmath>

namespace argos {

/** The motion of a body since a stored pose. For the sources of components. */
class CBodyMotion {
 public:
  bool HasBody() const { return m_body != nullptr; }
  const CEmbodiedEntity& GetBody() const { return *m_body; }
  /** Stores the current pose. @param body must outlive this object. */
  void SetBody(const CEmbodiedEntity& body) {
    m_body = &body;
    Remember();
  }
  void Remember() {
    m_position = m_body->GetOriginAnchor().Position;
    m_orientation = m_body->GetOriginAnchor().Orientation;
  }
  /** Stores the body's initial pose. */
  void RememberStart() {
    m_position = m_body->GetInitPosition();
    m_orientation = m_body->GetInitOrientation();
  }

  /** Distance of the origin from the stored position, m. */
  Real ComputeDistance() const { return ComputeWay().Length(); }
  /** Displacement of the origin in the stored frame, m. */
  CVector3 ComputeStep() const {
    CVector3 step = ComputeWay();
    return step.Rotate(m_orientation.Inverse());
  }
  /** Rotation of the body in the stored frame. */
  CQuaternion ComputeTurn() const {
    return m_orientation.Inverse() * m_body->GetOriginAnchor().Orientation;
  }

 private:
  // world frame, m; perhaps through a side of a periodic arena
  CVector3 ComputeWay() const {
    return CurrentContext().Arena.Period.Shorten(m_body->GetOriginAnchor().Position - m_position);
  }

  const CEmbodiedEntity* m_body = nullptr;  // not owned
  CVector3 m_position;  // of the origin anchor, world frame, m
  CQuaternion m_orientation;
};

/** Half the angle of a turn about the vertical, from -pi/2 to pi/2. */
inline Real ComputeHalfAngle(const CQuaternion& turn) {
  return 0.5 * std::remainder(2.0 * std::atan2(turn.GetZ(), turn.GetW()), 2.0 * ARGOS_PI);
}

/**
 * The length of the arc of a body that turns and moves at constant speeds, m. Its chord has the
 * direction of the heading half-way, and is sin(a/2) / (a/2) times as long for a turn by a.
 * @param x, y  displacement in the frame of the beginning, m; what is across the chord is ignored.
 */
inline Real ComputeArcLength(Real x, Real y, Real halfAngle) {
  const Real sine = std::sin(halfAngle);
  const Real chord = x * std::cos(halfAngle) + y * sine;
  return halfAngle == 0.0 ? chord : chord * halfAngle / sine;
}

}  // namespace argos

#endif
