#ifndef ARGOS3_PLUGINS_ENTITIES_QUADROTOR_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_QUADROTOR_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * Target of the propellers of a flying robot, in position or in speed. SPropellersDescription of
 * the robot's body defines how the robot reaches it.
 */
class CQuadRotorEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  enum EControlMethod {
    NO_CONTROL, /**< no target was set: engines apply SPEED_CONTROL */
    POSITION_CONTROL,
    SPEED_CONTROL
  };

  /** World frame. */
  struct SPositionControlData {
    CVector3 Position; /**< position of the origin anchor, m */
    CRadians Yaw;
  };

  /** World axes. */
  struct SSpeedControlData {
    CVector3 Velocity; /**< m/s */
    CRadians RotSpeed; /**< about the vertical, rad/s, counter-clockwise */
  };

  explicit CQuadRotorEntity(CComposableEntity* parent);
  CQuadRotorEntity(CComposableEntity* parent, const std::string& id);

  /** Sets both targets to zero, and detaches the robot. */
  void Reset() override;
  /** Includes the control method. */
  void MarkStart() override;
  void ReturnToStart() override;
  std::string GetTypeDescription() const override { return "quadrotor"; }

  EControlMethod GetControlMethod() const { return m_method; }
  void SetControlMethod(EControlMethod method) {
    CRobotsCode::CheckOwn(*this, "SetControlMethod()");
    m_method = method;
  }

  /**
   * The setters take effect in the next physics phase, while their control method is selected.
   * @throws CARGoSException like Check(); the target is then unchanged.
   */
  const SPositionControlData& GetPositionControlData() const { return m_position; }
  void SetPositionControlData(const SPositionControlData& data);
  const SSpeedControlData& GetSpeedControlData() const { return m_speed; }
  void SetSpeedControlData(const SSpeedControlData& data);

  /**
   * True: the robot holds on to the ceiling. Engines keep its pose then, at rest; the targets have
   * no effect. Detached, it continues from rest.
   */
  bool IsAttached() const { return m_isAttached; }
  void SetAttached(bool attached) {
    CRobotsCode::CheckOwn(*this, "SetAttached()");
    m_isAttached = attached;
  }

  /** @throws CARGoSException that names the robot if a value is not finite or above 1e9. */
  void Check(const SPositionControlData& data) const;
  void Check(const SSpeedControlData& data) const;

  void UpdateDigest(CDigest& digest) const override;

 private:
  void Check(const char* what, const CVector3& vector, const CRadians& angle) const;

  EControlMethod m_method = NO_CONTROL;
  EControlMethod m_methodAtStart = NO_CONTROL;
  SPositionControlData m_position;
  SSpeedControlData m_speed;
  bool m_isAttached = false;
};

}  // namespace argos

#endif
