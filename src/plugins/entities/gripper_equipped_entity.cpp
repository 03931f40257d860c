#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/component_operations.h>

#include <cmath>

namespace argos {

namespace {

constexpr Real kDefaultThreshold = 0.5;  // value of ARGoS 3

}  // namespace

CGripperEquippedEntity::CGripperEquippedEntity(CComposableEntity* parent)
    : CGripperEquippedEntity(parent, std::string(), CVector3(), CVector3::X, kDefaultThreshold) {}

CGripperEquippedEntity::CGripperEquippedEntity(CComposableEntity* parent, const std::string& id,
                                               const CVector3& offset, const CVector3& direction,
                                               Real lockThreshold)
    : CEntity(parent, id),
      m_initOffset(offset),
      m_offset(offset),
      m_initDirection(direction),
      m_direction(direction),
      m_lockThreshold(RequireFinite("lock threshold", lockThreshold)) {
  CEntity::SetEnabled(false);  // engines do the gripping; there is nothing to update
}

void CGripperEquippedEntity::Reset() {
  m_offset = m_initOffset;
  m_direction = m_initDirection;
  m_lockState = 0.0;
  ClearGrippedEntity();
}

void CGripperEquippedEntity::SetLockState(Real state) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetLockState()");
  }
  m_lockState = RequireFinite("lock state", state);
}

void CGripperEquippedEntity::SetLockThreshold(Real threshold) {
  CRobotsCode::CheckOwn(*this, "SetLockThreshold()");
  RequireFinite("lock threshold", threshold);
  KeepForReset(m_lockThreshold);
  m_lockThreshold = threshold;
}

CEmbodiedEntity& CGripperEquippedEntity::GetGrippedEntity() {
  if (m_gripped == nullptr) {
    THROW_ARGOSEXCEPTION("gripper \"" << GetContext() << GetId()
                                      << "\" holds nothing: call IsGripping() first");
  }
  return *m_gripped;
}

Real CGripperEquippedEntity::RequireFinite(const char* what, Real value) const {
  if (!std::isfinite(value)) {
    THROW_ARGOSEXCEPTION("gripper \"" << GetContext() << GetId() << "\": the " << what
                                      << " must be a finite number, got " << value);
  }
  return value;
}

void CGripperEquippedEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  digest.Add(m_lockState);
  // the index of the entity, because its address differs between runs
  digest.Add(m_gripped != nullptr ? static_cast<SInt64>(m_gripped->GetIndex()) : SInt64(-1));
}

REGISTER_SPACE_OPERATIONS_TOLD_TO_ENGINES(CGripperEquippedEntity)

}  // namespace argos
