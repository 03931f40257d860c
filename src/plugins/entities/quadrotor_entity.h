#ifndef ARGOS3_PLUGINS_ENTITIES_QUADROTOR_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_QUADROTOR_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * What the propellers of a flying robot are to do: a target, and whether it is one of position or
 * of speed. Its robot's body says how it gets there (SPropellersDescription).
 */
class CQuadRotorEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  enum EControlMethod {
    NO_CONTROL, /**< nobody controls it: engines hold it as by SPEED_CONTROL */
    POSITION_CONTROL,
    SPEED_CONTROL
  };

  /** World frame. */
  struct SPositionControlData {
    CVector3 Position; /**< of the origin anchor, m */
    CRadians Yaw;
  };

  /** World axes. */
  struct SSpeedControlData {
    CVector3 Velocity; /**< m/s */
    CRadians RotSpeed; /**< about the vertical, rad/s, counter-clockwise */
  };

  explicit CQuadRotorEntity(CComposableEntity* parent);
  CQuadRotorEntity(CComposableEntity* parent, const std::string& id);

  /** Both targets become zero. */
  void Reset() override;
  /** Also of the method of control. */
  void MarkStart() override;
  void ReturnToStart() override;
  std::string GetTypeDescription() const override { return "quadrotor"; }

  EControlMethod GetControlMethod() const { return m_method; }
  void SetControlMethod(EControlMethod method) { m_method = method; }

  /**
   * Setters: for the next physics phase, and used only while the method is the one they are for.
   * @throws CARGoSException as Check() does; the target is then as before.
   */
  const SPositionControlData& GetPositionControlData() const { return m_position; }
  void SetPositionControlData(const SPositionControlData& data);
  const SSpeedControlData& GetSpeedControlData() const { return m_speed; }
  void SetSpeedControlData(const SSpeedControlData& data);

  /** @throws CARGoSException that names the robot if a number is not finite or beyond 1e9. */
  void Check(const SPositionControlData& data) const;
  void Check(const SSpeedControlData& data) const;

  void UpdateDigest(CDigest& digest) const override;

 private:
  void Check(const char* what, const CVector3& vector, const CRadians& angle) const;

  EControlMethod m_method = NO_CONTROL;
  EControlMethod m_methodAtStart = NO_CONTROL;
  SPositionControlData m_position;
  SSpeedControlData m_speed;
};

}  // namespace argos

#endif
