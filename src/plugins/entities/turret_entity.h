#ifndef ARGOS3_PLUGINS_ENTITIES_TURRET_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_TURRET_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/utility/math/angles.h>

namespace argos {

struct SAnchor;

/**
 * The turret of a robot: how its motor is to turn it, and where it points.
 *
 * Its frame is the anchor that it is made with, at the origin of the body: whatever is fixed to
 * that anchor turns with it, in every engine. Engines know no robots: they read the mode and
 * targets here, and write the rotation; see STurretDescription for what they need besides.
 */
class CTurretEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  enum EMode {
    MODE_OFF, /**< stays as it is on the body; turns freely while a gripper on it holds something */
    MODE_PASSIVE, /**< the same */
    MODE_SPEED_CONTROL, /**< turns at the desired speed */
    MODE_POSITION_CONTROL /**< turns towards the desired rotation */
  };

  /**
   * @param anchor  the frame that turns, of the robot's body.
   * @param gains   of MODE_POSITION_CONTROL, from an error in rad to a speed in rad/s: per s, and
   *                without unit.
   */
  CTurretEntity(CComposableEntity* parent, const std::string& id, SAnchor& anchor,
                const SControlGains& gains);

  /** Off, straight ahead, all targets zero. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "turret"; }

  const SAnchor& GetAnchor() const { return m_anchor; }
  EMode GetMode() const { return m_mode; }
  void SetMode(EMode mode);
  /** Is its motor to turn it? */
  bool IsDriven() const { return m_mode == MODE_SPEED_CONTROL || m_mode == MODE_POSITION_CONTROL; }
  const CRadians& GetDesiredRotation() const { return m_desiredRotation; }
  /** For MODE_POSITION_CONTROL; the short way round. @throws CARGoSException if not finite. */
  void SetDesiredRotation(const CRadians& rotation);
  /** Per s. */
  const CRadians& GetDesiredRotationSpeed() const { return m_desiredSpeed; }
  /** For MODE_SPEED_CONTROL; per s, counter-clockwise. @throws CARGoSException if not finite. */
  void SetDesiredRotationSpeed(const CRadians& speed);

  /** Of the turret on the body, in (-pi, pi], counter-clockwise from straight ahead. */
  const CRadians& GetRotation() const { return m_rotation; }
  /** For engines: where it points now; the anchor follows when the body's anchors are computed. */
  void SetRotation(const CRadians& rotation);
  /**
   * For engines, once a tick: how fast the motor is to turn the turret on the body in this tick,
   * rad/s; 0 if it is not driven.
   *
   * In MODE_POSITION_CONTROL: Proportional e + Derivative (e - e') / tick, with the error e =
   * desired
   * - actual rotation in (-pi, pi] and e' that of the last tick (e in the first tick of the mode).
   * @param tickLength  s.
   */
  Real AdvanceControl(Real tickLength);
  /** For engines without turrets of their own, once a tick: turns it as the motor is to. */
  void Advance(Real tickLength) {
    SetRotation(m_rotation + CRadians(AdvanceControl(tickLength) * tickLength));
  }

  void UpdateDigest(CDigest& digest) const override;

 private:
  SAnchor& m_anchor;
  SControlGains m_gains;
  EMode m_mode = MODE_OFF;
  CRadians m_rotation;
  CRadians m_desiredRotation;
  CRadians m_desiredSpeed;  // per s
  CRadians m_lastError;  // of position control, if it was on in the last tick
  bool m_hasLastError = false;
};

}  // namespace argos

#endif
