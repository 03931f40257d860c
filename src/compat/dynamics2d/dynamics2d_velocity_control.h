#ifndef ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_VELOCITY_CONTROL_H
#define ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_VELOCITY_CONTROL_H

#include <argos3/core/simulator/physics_engine/drive_source.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/recorded_bodies.h>

namespace argos {

class CDynamics2DEngine;
struct SBodyDescription;

/**
 * Moves the body of a user's model at a velocity, with bounded force and torque.
 *
 * Attached to a body when the model is added to an engine, it becomes the planar drive of the
 * body's description, and what it orders is the command of that drive.
 */
class CDynamics2DVelocityControl {
 public:
  /**
   * @param maxForce   N, > 0.
   * @param maxTorque  N m, > 0.
   * @param node       null, or the element of the robot. Attributes max_force and max_torque have
   *                   precedence: of this element, or of its child
   *                   `<dynamics2d><velocity_control>`.
   */
  CDynamics2DVelocityControl(CDynamics2DEngine& engine, Real maxForce, Real maxTorque,
                             TConfigurationNode* node = nullptr);
  virtual ~CDynamics2DVelocityControl();
  CDynamics2DVelocityControl(const CDynamics2DVelocityControl&) = delete;
  CDynamics2DVelocityControl& operator=(const CDynamics2DVelocityControl&) = delete;

  virtual void AttachTo(cpBody* body);
  virtual void Detach();
  /** Orders rest. */
  virtual void Reset();

  /** The order: m/s, world frame. */
  CVector2 GetLinearVelocity() const { return {m_ptControlBody->v.x, m_ptControlBody->v.y}; }
  /** The body moves straight during a tick, whatever its yaw rate. */
  void SetLinearVelocity(const CVector2& velocity) {
    m_ptControlBody->v = {velocity.GetX(), velocity.GetY()};
  }
  /** The order: rad/s, counter-clockwise. */
  Real GetAngularVelocity() const { return m_ptControlBody->w; }
  void SetAngularVelocity(Real velocity) { m_ptControlBody->w = velocity; }

  /** N, and N m. */
  Real GetMaxForce() const { return m_fMaxForce; }
  Real GetMaxTorque() const { return m_fMaxTorque; }

  /** Its velocity is the order. */
  cpBody* GetControlBody() { return m_ptControlBody; }
  /** These are null while the control is detached. */
  cpBody* GetControlledBody() { return m_ptControlledBody; }
  cpConstraint* GetLinearConstraint() { return m_ptLinearConstraint; }
  cpConstraint* GetAngularConstraint() { return m_ptAngularConstraint; }

 protected:
  CDynamics2DVelocityControl(CDynamics2DEngine& engine, Real maxForce, Real maxTorque,
                             TConfigurationNode* node, const char* element);

  CDynamics2DEngine& m_cDyn2DEngine;
  cpBody* m_ptControlBody = &m_controlBody;
  cpBody* m_ptControlledBody = nullptr;
  cpConstraint* m_ptLinearConstraint = nullptr;
  cpConstraint* m_ptAngularConstraint = nullptr;
  Real m_fMaxForce;  // N
  Real m_fMaxTorque;  // N m

 private:
  friend class CModelDescriber;
  friend class CRecordedDynamics2DBody;

  /** Adds the drive to the description of the body. */
  virtual void Describe(SBodyDescription& description) const;
  /** What the drive of the body reads. */
  virtual CDriveSource GetSource() const { return CDriveSource(m_command); }
  /** Before a tick: computes what the drive reads from the order. @param tick s. */
  virtual void UpdateCommand(Real tick);

  cpBody m_controlBody;
  cpConstraint m_linearConstraint;
  cpConstraint m_angularConstraint;
  SDriveCommand m_command;
};

}  // namespace argos

#endif
