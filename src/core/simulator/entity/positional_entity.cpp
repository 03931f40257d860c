#include <argos3/core/simulator/entity/positional_entity.h>

#include <argos3/core/simulator/entity/pose_digest.h>
#include <argos3/core/simulator/geometry/pose_check.h>

namespace argos {

CPositionalEntity::CPositionalEntity(CComposableEntity* parent) : CEntity(parent) {}

CPositionalEntity::CPositionalEntity(CComposableEntity* parent, const std::string& id,
                                     const CVector3& position, const CQuaternion& orientation)
    : CEntity(parent, id),
      m_cPosition(position),
      m_cOrientation(CheckPose([&id] { return "entity \"" + id + '"'; }, position, orientation)),
      m_cInitPosition(position),
      m_cInitOrientation(m_cOrientation) {}

void CPositionalEntity::Init(TConfigurationNode& tree) {
  CEntity::Init(tree);
  GetNodeAttributeOrDefault(tree, "position", m_cInitPosition, CVector3());
  GetNodeAttributeOrDefault(tree, "orientation", m_cInitOrientation, CQuaternion());
  CheckPose([&tree] { return tree.GetLocation() + ": <" + tree.Value() + '>'; }, m_cInitPosition,
            m_cInitOrientation);
  m_cPosition = m_cInitPosition;
  m_cOrientation = m_cInitOrientation;
}

void CPositionalEntity::Reset() {
  CheckMayMove("Reset()");
  CEntity::Reset();
  m_cPosition = m_cInitPosition;
  m_cOrientation = m_cInitOrientation;
}

void CPositionalEntity::MoveTo(const CVector3& position, const CQuaternion& orientation) {
  CheckMayMove("MoveTo()");
  m_cOrientation =
      CheckPose([this] { return "MoveTo() of entity \"" + GetContext() + GetId() + '"'; }, position,
                orientation);
  m_cPosition = position;
}

void CPositionalEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  AddPose(digest, m_cPosition, m_cOrientation);
}

}  // namespace argos
