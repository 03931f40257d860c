#ifndef ARGOS3_PLUGINS_ENTITIES_GRIPPER_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_GRIPPER_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

class CEmbodiedEntity;

/**
 * The gripper of a robot: its lock state and the gripped body.
 *
 * A locked gripper that holds nothing grips the first grippable body (SBodyDescription::Grippable)
 * that overlaps a small disc around its offset; see SGripperDescription. An unlocked gripper
 * releases its body in the next physics phase. Engines do both.
 */
class CGripperEquippedEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  /** At the origin of the body, opening forward. */
  explicit CGripperEquippedEntity(CComposableEntity* parent);
  /**
   * @param offset          m, in the frame of the turret if the robot has one, else of the body.
   * @param direction       opening direction, same frame.
   * @param lock_threshold  the gripper is locked if the lock state exceeds this.
   */
  CGripperEquippedEntity(CComposableEntity* parent, const std::string& id, const CVector3& offset,
                         const CVector3& direction, Real lock_threshold = 0.5);

  /** Unlocks, releases the body, and restores the initial offset and direction. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "gripper"; }

  const CVector3& GetInitOffset() const { return m_initOffset; }
  void SetInitOffset(const CVector3& offset) {
    CRobotsCode::CheckOwn(*this, "SetInitOffset()");
    m_initOffset = offset;
  }
  const CVector3& GetOffset() const { return m_offset; }
  void SetOffset(const CVector3& offset) {
    CRobotsCode::CheckOwn(*this, "SetOffset()");
    m_offset = offset;
  }
  const CVector3& GetInitDirection() const { return m_initDirection; }
  void SetInitDirection(const CVector3& direction) {
    CRobotsCode::CheckOwn(*this, "SetInitDirection()");
    m_initDirection = direction;
  }
  const CVector3& GetDirection() const { return m_direction; }
  void SetDirection(const CVector3& direction) {
    CRobotsCode::CheckOwn(*this, "SetDirection()");
    m_direction = direction;
  }

  Real GetLockState() const { return m_lockState; }
  /** @param state usually in [0,1]; 0 is open. @throws CARGoSException if it is not finite. */
  void SetLockState(Real state);
  Real GetLockThreshold() const { return m_lockThreshold; }
  /** @throws CARGoSException if it is not finite. */
  void SetLockThreshold(Real threshold);
  bool IsLocked() const { return m_lockState > m_lockThreshold; }

  bool IsGripping() const { return m_gripped != nullptr; }
  /** @throws CARGoSException if it holds nothing. */
  CEmbodiedEntity& GetGrippedEntity();
  /** For engines. */
  void SetGrippedEntity(CEmbodiedEntity& entity) {
    CRobotsCode::CheckOwn(*this, "SetGrippedEntity()");
    m_gripped = &entity;
  }
  /** For engines; a call by other code releases the body in the next physics phase. */
  void ClearGrippedEntity() {
    CRobotsCode::CheckOwn(*this, "ClearGrippedEntity()");
    m_gripped = nullptr;
  }

  void UpdateDigest(CDigest& digest) const override;

 private:
  Real RequireFinite(const char* what, Real value) const;

  CVector3 m_initOffset, m_offset;  // m
  CVector3 m_initDirection, m_direction;
  Real m_lockState = 0.0;
  Real m_lockThreshold;
  CEmbodiedEntity* m_gripped = nullptr;  // null if it holds nothing; not owned
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/quaternion.h>
#endif

#endif
