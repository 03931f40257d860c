#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_POSITIONAL_ENTITY_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_POSITIONAL_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** An entity with a pose but no physics. Positions in m, world frame. */
class CPositionalEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  explicit CPositionalEntity(CComposableEntity* parent);
  CPositionalEntity(CComposableEntity* parent, const std::string& id,
                    const CVector3& position = CVector3(),
                    const CQuaternion& orientation = CQuaternion());

  /** Reads `position` and `orientation` (both optional). */
  void Init(TConfigurationNode& tree) override;
  /** Back to the initial pose. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "position"; }

  const CVector3& GetPosition() const { return m_cPosition; }
  void SetPosition(const CVector3& position) {
    CheckMayMove("SetPosition()");
    m_cPosition = position;
  }
  const CQuaternion& GetOrientation() const { return m_cOrientation; }
  void SetOrientation(const CQuaternion orientation) {
    CheckMayMove("SetOrientation()");
    m_cOrientation = orientation;
  }
  const CVector3& GetInitPosition() const { return m_cInitPosition; }
  void SetInitPosition(const CVector3& position) { m_cInitPosition = position; }
  const CQuaternion& GetInitOrientation() const { return m_cInitOrientation; }
  void SetInitOrientation(const CQuaternion orientation) { m_cInitOrientation = orientation; }

  virtual void MoveTo(const CVector3& position, const CQuaternion& orientation);
  /** The same without checks, for parts that follow their body in each tick. */
  void Follow(const CVector3& position, const CQuaternion& orientation) {
    m_cPosition = position;
    m_cOrientation = orientation;
  }

  void UpdateDigest(CDigest& digest) const override;

 protected:
  /** @throws CARGoSException in robots' code: cameras and media read poses. */
  void CheckMayMove(const char* call) const {
    if (CRobotsCode::MayRun()) {
      CRobotsCode::CheckShared(*this, call);
    }
  }

  CVector3 m_cPosition;
  CQuaternion m_cOrientation;
  CVector3 m_cInitPosition;
  CQuaternion m_cInitOrientation;
};

}  // namespace argos

#endif
