#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <cmath>

namespace argos {

CRABEquippedEntity::CRABEquippedEntity(CComposableEntity* parent) : CMediumMember(parent) {}

CRABEquippedEntity::CRABEquippedEntity(CComposableEntity* parent, const std::string& id,
                                       size_t messageSize, Real range, SAnchor& anchor,
                                       CEmbodiedEntity& body, const CVector3& offset,
                                       const CQuaternion& rotation)
    : CMediumMember(parent, id, CVector3()),
      m_unMsgSize(messageSize),
      m_psAnchor(&anchor),
      m_pcEntityBody(&body),
      m_cPosOffset(offset),
      m_cRotOffset(rotation),
      m_cData(messageSize) {
  SetRange(range);
  CRABEquippedEntity::Update();
}

CRABEquippedEntity::~CRABEquippedEntity() {
  ClearMedium();
}

void CRABEquippedEntity::Init(TConfigurationNode& tree) {
  CMediumMember::Init(tree);
  m_cPosOffset = GetInitPosition();
  m_cRotOffset = GetInitOrientation();
  m_pcEntityBody = &GetParent().GetComponent<CEmbodiedEntity>("body");
  std::string anchor;
  GetNodeAttribute(tree, "anchor", anchor);
  m_psAnchor = &m_pcEntityBody->GetAnchor(anchor);
  GetNodeAttribute(tree, "msg_size", m_unMsgSize);
  RequireCount(m_unMsgSize, 0, kMaxData, OwnerOf(tree), "attribute \"msg_size\" (bytes)");
  m_cData = CByteArray(m_unMsgSize);
  Real range = 0.0;
  GetNodeAttribute(tree, "range", range);
  SetRange(range);
  Update();
}

void CRABEquippedEntity::Reset() {
  ClearData();
  Update();
}

void CRABEquippedEntity::Update() {
  if (m_psAnchor == nullptr) {
    return;
  }
  const CQuaternion& orientation = m_psAnchor->Orientation;
  CVector3 position = m_cPosOffset;
  if (orientation.GetX() == 0.0 && orientation.GetY() == 0.0) {
    // keep heights exact: the occlusion test of a device exactly as high as a robot's top must not
    // depend on rounding
    const Real w = orientation.GetW();
    const Real z = orientation.GetZ();
    position.RotateZ(CVector2(w * w - z * z, 2.0 * w * z));
  } else {
    position.Rotate(orientation);
  }
  MoveTo(m_psAnchor->Position + position, orientation * m_cRotOffset);
}

void CRABEquippedEntity::SetEnabled(bool enabled) {
  if (EnablesLater(*this, enabled)) {
    return;
  }
  if (enabled != IsEnabled() && m_psAnchor != nullptr) {
    UseAnchor(*m_psAnchor, enabled);
    CountFollower(*this, enabled);
  }
  if (enabled) {
    // the position was not updated while the device was disabled
    Update();
  }
  CMediumMember::SetEnabled(enabled);
}

void CRABEquippedEntity::SetData(const CByteArray& data) {
  if (data.Size() != m_unMsgSize) {
    THROW_ARGOSEXCEPTION(Describe()
                         << ": messages have " << m_unMsgSize << " bytes, got " << data.Size());
  }
  if (CRobotsCode::MayRun() &&
      CRobotsCode::ChangesLater(*this, "SetData()", [this, data] { SetData(data); })) {
    return;
  }
  m_cData = data;
}

void CRABEquippedEntity::ClearData() {
  if (CRobotsCode::ChangesLater(*this, "ClearData()", [this] { ClearData(); })) {
    return;
  }
  m_cData.Zero();
}

void CRABEquippedEntity::SetRange(Real range) {
  CRobotsCode::CheckOwn(*this, "SetRange()");
  if (!(range >= 0.0 && range < HUGE_VAL)) {
    RequireNotNegative(range, Describe(), "range (m)");
  }
  KeepForReset(m_fRange);
  m_fRange = range;
}

void CRABEquippedEntity::UpdateDigest(CDigest& digest) const {
  CMediumMember::UpdateDigest(digest);
  digest.Add(m_fRange);
  for (size_t i = 0; i < m_cData.Size(); ++i) {
    digest.Add(m_cData.ToCArray()[i]);
  }
}

std::string CRABEquippedEntity::Describe() const {
  return "range and bearing \"" + GetContext() + GetId() + "\"";
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CRABEquippedEntity)

}  // namespace argos
