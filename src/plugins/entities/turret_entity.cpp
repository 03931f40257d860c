#include <argos3/plugins/simulator/entities/turret_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/component_operations.h>

#include <cmath>

namespace argos {

namespace {

void RequireFinite(const CEntity& turret, const char* what, Real value) {
  if (!std::isfinite(value)) {
    THROW_ARGOSEXCEPTION("turret \"" << turret.GetContext() << turret.GetId() << "\": the " << what
                                     << " must be a finite number, got " << value);
  }
}

CRadians Normalized(CRadians angle) {
  angle.SignedNormalize();
  return angle;
}

}  // namespace

CTurretEntity::CTurretEntity(CComposableEntity* parent, const std::string& id, SAnchor& anchor,
                             const SControlGains& gains)
    : CEntity(parent, id), m_anchor(anchor), m_gains(gains) {
  CEntity::SetEnabled(false);  // engines turn it; there is nothing to update
}

void CTurretEntity::Reset() {
  SetMode(MODE_OFF);
  m_desiredRotation = CRadians::ZERO;
  m_desiredSpeed = 0.0;
  m_speed = 0.0;
  SetRotation(CRadians::ZERO);
  m_anchor.FollowOrigin();
}

void CTurretEntity::SetMode(UInt8 mode) {
  if (mode > MODE_POSITION_CONTROL) {
    THROW_ARGOSEXCEPTION("turret \"" << GetContext() << GetId() << "\": there is no mode "
                                     << static_cast<int>(mode) << ", but modes 0 to 3");
  }
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetMode()");
  }
  m_mode = static_cast<EMode>(mode);
  m_hasLastError = m_hasLastError && mode == MODE_POSITION_CONTROL;
}

void CTurretEntity::SetDesiredRotation(const CRadians& rotation) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetDesiredRotation()");
  }
  RequireFinite(*this, "desired rotation (rad)", rotation.GetValue());
  m_desiredRotation = Normalized(rotation);
}

void CTurretEntity::SetDesiredRotationSpeed(Real speed) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetDesiredRotationSpeed()");
  }
  RequireFinite(*this, "desired speed (rad/s)", speed);
  m_desiredSpeed = speed;
}

void CTurretEntity::SetRotation(const CRadians& rotation) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetRotation()");
  }
  m_rotation = Normalized(rotation);
  m_anchor.OffsetOrientation = CQuaternion(m_rotation, CVector3::Z);
}

Real CTurretEntity::ComputeControl(Real tickLength) {
  switch (m_mode) {
    case MODE_SPEED_CONTROL:
      return m_desiredSpeed;
    case MODE_POSITION_CONTROL: {
      const CRadians error = Normalized(m_desiredRotation - m_rotation);
      const CRadians change = m_hasLastError ? Normalized(error - m_lastError) : CRadians::ZERO;
      m_lastError = error;
      m_hasLastError = true;
      return m_gains.Proportional * error.GetValue() +
             m_gains.Derivative * change.GetValue() / tickLength;
    }
    default:
      return 0.0;
  }
}

void CTurretEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  digest.Add(m_mode);
  digest.Add(m_rotation.GetValue());
  digest.Add(m_desiredRotation.GetValue());
  digest.Add(m_desiredSpeed);
}

REGISTER_SPACE_OPERATIONS_TOLD_TO_ENGINES(CTurretEntity)

}  // namespace argos
