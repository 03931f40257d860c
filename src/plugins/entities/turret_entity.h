#ifndef ARGOS3_PLUGINS_ENTITIES_TURRET_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_TURRET_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/math/angles.h>

namespace argos {

struct SAnchor;

/**
 * The turret of a robot: control mode, targets and rotation.
 *
 * Its frame is the anchor given to the constructor, at the origin of the body: objects fixed to
 * that anchor turn with it, in every engine. Engines read mode and targets here and write the
 * rotation; STurretDescription has further data for engines.
 */
class CTurretEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  enum EMode : UInt8 {
    MODE_OFF, /**< keeps its angle on the body; turns freely while its gripper holds a body */
    MODE_PASSIVE, /**< the same */
    MODE_SPEED_CONTROL, /**< turns at the desired speed */
    MODE_POSITION_CONTROL /**< turns towards the desired rotation */
  };

  /**
   * @param anchor  the turret's frame, of the robot's body.
   * @param gains   of MODE_POSITION_CONTROL, from an error in rad to a speed in rad/s: 1/s, and
   *   dimensionless.
   */
  CTurretEntity(CComposableEntity* parent, const std::string& id, SAnchor& anchor,
                const SControlGains& gains);

  /** Sets MODE_OFF, rotation 0 and all targets 0. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "turret"; }

  const SAnchor& GetAnchor() const { return m_anchor; }
  EMode GetMode() const { return m_mode; }
  /** @throws CARGoSException if it is no EMode. */
  void SetMode(UInt8 mode);
  /** @return true if the motor drives the turret. */
  bool IsDriven() const { return m_mode == MODE_SPEED_CONTROL || m_mode == MODE_POSITION_CONTROL; }
  const CRadians& GetDesiredRotation() const { return m_desiredRotation; }
  /** For MODE_POSITION_CONTROL; takes the shorter way. @throws CARGoSException if not finite. */
  void SetDesiredRotation(const CRadians& rotation);
  /** In rad/s. */
  Real GetDesiredRotationSpeed() const { return m_desiredSpeed; }
  /** For MODE_SPEED_CONTROL, rad/s, counter-clockwise. @throws CARGoSException if not finite. */
  void SetDesiredRotationSpeed(Real speed);
  /** What the motor commanded in the last tick, rad/s. */
  Real GetRotationSpeed() const { return m_speed; }

  /** Angle on the body, in (-pi, pi], counter-clockwise from straight ahead. */
  const CRadians& GetRotation() const { return m_rotation; }
  /** For engines: sets the angle; the anchor follows when the body's anchors are computed. */
  void SetRotation(const CRadians& rotation);
  /**
   * For engines, once a tick: speed that the motor commands in this tick, rad/s; 0 if not driven.
   *
   * In MODE_POSITION_CONTROL: Proportional e + Derivative (e - e') / tick, with the error e =
   * desired - actual rotation in (-pi, pi], and e' the error of the last tick (e in the first tick
   * of the mode).
   * @param tickLength  s.
   */
  Real AdvanceControl(Real tickLength) { return m_speed = ComputeControl(tickLength); }
  /** For engines without their own turret model, once a tick: turns it at the commanded speed. */
  void Advance(Real tickLength) {
    SetRotation(m_rotation + CRadians(AdvanceControl(tickLength) * tickLength));
  }

  void UpdateDigest(CDigest& digest) const override;

 private:
  Real ComputeControl(Real tickLength);

  SAnchor& m_anchor;
  SControlGains m_gains;
  EMode m_mode = MODE_OFF;
  CRadians m_rotation;
  CRadians m_desiredRotation;
  Real m_desiredSpeed = 0.0;  // rad/s
  Real m_speed = 0.0;  // rad/s, commanded in the last tick
  CRadians m_lastError;  // error of position control in the last tick
  bool m_hasLastError = false;
};

}  // namespace argos

#endif
