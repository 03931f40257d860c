#include <argos3/plugins/simulator/entities/tag_entity.h>

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/observable.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

CTagEntity::CTagEntity(CComposableEntity* parent) : CMediumMember(parent) {}

CTagEntity::CTagEntity(CComposableEntity* parent, const std::string& id, const CVector3& position,
                       const CQuaternion& orientation, const CRadians& observableAngle,
                       Real sideLength, const std::string& payload)
    : CMediumMember(parent, id, position, orientation), m_payload(payload), m_initPayload(payload) {
  SetObservableAngle(observableAngle);
  SetSideLength(sideLength);
}

CTagEntity::~CTagEntity() {
  ClearMedium();
}

void CTagEntity::Init(TConfigurationNode& tree) {
  CMediumMember::Init(tree);
  m_cone = CObservableCone(ReadObservableAngle(tree));
  ReadPositive(tree, "side_length", "m", m_sideLength);
  GetNodeAttributeOrDefault(tree, "payload", m_initPayload, std::string());
  m_payload = m_initPayload;
}

void CTagEntity::Reset() {
  CMediumMember::Reset();
  m_payload = m_initPayload;
}

void CTagEntity::SetSideLength(Real sideLength) {
  CRobotsCode::CheckShared(*this, "SetSideLength()");
  RequirePositive(sideLength, "tag \"" + GetContext() + GetId() + "\"", "side length (m)");
  KeepForReset(m_sideLength);
  m_sideLength = sideLength;
}

std::array<CVector3, 4> CTagEntity::ComputeCorners() const {
  const Real half = 0.5 * m_sideLength;
  std::array<CVector3, 4> corners = {CVector3(half, half, 0.0), CVector3(-half, half, 0.0),
                                     CVector3(-half, -half, 0.0), CVector3(half, -half, 0.0)};
  for (CVector3& corner : corners) {
    corner.Rotate(GetOrientation());
    corner += GetPosition();
  }
  return corners;
}

void CTagEntity::SetObservableAngle(const CRadians& angle) {
  CRobotsCode::CheckShared(*this, "SetObservableAngle()");
  RequireObservableAngle(angle, "tag \"" + GetContext() + GetId() + "\"");
  KeepForReset(m_cone);
  m_cone = CObservableCone(angle);
}

void CTagEntity::UpdateDigest(CDigest& digest) const {
  CMediumMember::UpdateDigest(digest);
  digest.Add(m_payload);
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CTagEntity)

}  // namespace argos
