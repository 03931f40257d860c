#include <argos3/plugins/simulator/entities/quadrotor_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>

#include <cmath>

namespace argos {

namespace {

// m, m/s, rad, rad/s; larger than any arena, and its square times any gain is finite
constexpr Real kMaxDistance = 1e9;

void Add(CDigest& digest, const CVector3& vector, const CRadians& angle) {
  for (UInt32 axis = 0; axis < 3; ++axis) {
    digest.Add(vector[axis]);
  }
  digest.Add(angle.GetValue());
}

}  // namespace

CQuadRotorEntity::CQuadRotorEntity(CComposableEntity* parent)
    : CQuadRotorEntity(parent, std::string()) {}

CQuadRotorEntity::CQuadRotorEntity(CComposableEntity* parent, const std::string& id)
    : CEntity(parent, id) {}

void CQuadRotorEntity::Reset() {
  m_position = SPositionControlData();
  m_speed = SSpeedControlData();
  m_isAttached = false;
}

void CQuadRotorEntity::MarkStart() {
  CEntity::MarkStart();
  m_methodAtStart = m_method;
}

void CQuadRotorEntity::ReturnToStart() {
  CEntity::ReturnToStart();
  m_method = m_methodAtStart;
}

void CQuadRotorEntity::SetPositionControlData(const SPositionControlData& data) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetPositionControlData()");
  }
  Check(data);
  m_position = data;
}

void CQuadRotorEntity::SetSpeedControlData(const SSpeedControlData& data) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetSpeedControlData()");
  }
  Check(data);
  m_speed = data;
}

void CQuadRotorEntity::Check(const SPositionControlData& data) const {
  Check("position (m) and yaw", data.Position, data.Yaw);
}

void CQuadRotorEntity::Check(const SSpeedControlData& data) const {
  Check("velocity (m/s) and yaw rate (per s)", data.Velocity, data.RotSpeed);
}

void CQuadRotorEntity::Check(const char* what, const CVector3& vector,
                             const CRadians& angle) const {
  // written so that NaN fails too
  const Real largest = std::abs(vector.GetX()) + std::abs(vector.GetY()) + std::abs(vector.GetZ()) +
                       angle.GetAbsoluteValue();
  if (!(largest <= kMaxDistance)) {
    THROW_ARGOSEXCEPTION("quadrotor \"" << GetContext() << GetId() << "\": a target " << what
                                        << " must be finite and below " << kMaxDistance << ", got ("
                                        << vector << ") and " << angle.GetValue() << " rad");
  }
}

void CQuadRotorEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  digest.Add(m_method);
  Add(digest, m_position.Position, m_position.Yaw);
  Add(digest, m_speed.Velocity, m_speed.RotSpeed);
  // otherwise it is not hashed, so that digests of other runs are those of versions without it
  if (m_isAttached) {
    digest.Add(m_isAttached);
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CQuadRotorEntity)

}  // namespace argos
