#include <argos3/plugins/simulator/entities/wheeled_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <cmath>

namespace argos {

CWheeledEntity::CWheeledEntity(CComposableEntity* parent, size_t numWheels)
    : CWheeledEntity(parent, std::string(), numWheels) {}

CWheeledEntity::CWheeledEntity(CComposableEntity* parent, const std::string& id, size_t numWheels)
    : CEntity(parent, id), m_positions(numWheels), m_radiiAndVelocities(2 * numWheels) {
  if (numWheels == 0) {
    THROW_ARGOSEXCEPTION("wheels \"" << GetContext() << id
                                     << "\": needs at least one wheel, got 0");
  }
}

void CWheeledEntity::Reset() {
  std::fill_n(GetVelocities(), GetNumWheels(), 0.0);
  if (m_ordered != nullptr) {
    std::fill_n(m_ordered.get(), GetNumWheels(), 0.0);
  }
}

void CWheeledEntity::EnableDrift() {
  CRobotsCode::CheckOwn(*this, "EnableDrift()");
  if (m_ordered == nullptr) {
    m_ordered = std::make_unique<Real[]>(GetNumWheels());
    std::copy_n(GetVelocities(), GetNumWheels(), m_ordered.get());
  }
}

void CWheeledEntity::SetWheel(UInt32 index, const CVector3& position, Real radius) {
  CRobotsCode::CheckOwn(*this, "SetWheel()");
  CheckIndex(index);
  if (!IsIn(kPositive, radius)) {
    RequirePositive(radius, "wheels \"" + GetContext() + GetId() + "\"", "wheel radius (m)");
  }
  // the size stays the same later, so that pointers to the elements stay valid
  KeepForReset(m_radiiAndVelocities);
  KeepForReset(m_positions);
  m_radiiAndVelocities[index] = radius;
  m_positions[index] = position;
}

const CVector3& CWheeledEntity::GetWheelPosition(size_t index) const {
  CheckIndex(index);
  return m_positions[index];
}

Real CWheeledEntity::GetWheelRadius(size_t index) const {
  CheckIndex(index);
  return m_radiiAndVelocities[index];
}

Real CWheeledEntity::GetWheelVelocity(size_t index) const {
  CheckIndex(index);
  return GetWheelVelocities()[index];
}

void CWheeledEntity::RequireFinite(const Real* velocities) const {
  for (size_t i = 0; i < GetNumWheels(); ++i) {
    if (!std::isfinite(velocities[i])) {
      THROW_ARGOSEXCEPTION("wheels \"" << GetContext() << GetId() << "\": speed of wheel " << i
                                       << " must be finite, got " << velocities[i]);
    }
  }
}

void CWheeledEntity::SetVelocities(const Real* velocities) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetVelocities()");
  }
  RequireFinite(velocities);
  std::copy_n(velocities, GetNumWheels(), GetVelocities());
  if (m_ordered != nullptr) {
    std::copy_n(velocities, GetNumWheels(), m_ordered.get());
  }
}

void CWheeledEntity::SetDriftingVelocities(const Real* ordered, const Real* velocities) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetDriftingVelocities()");
  }
  ARGOS_ASSERT(m_ordered != nullptr, "SetDriftingVelocities() needs EnableDrift().");
  RequireFinite(ordered);
  RequireFinite(velocities);
  std::copy_n(velocities, GetNumWheels(), GetVelocities());
  std::copy_n(ordered, GetNumWheels(), m_ordered.get());
}

void CWheeledEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  for (size_t i = 0; i < GetNumWheels(); ++i) {
    digest.Add(GetWheelVelocities()[i]);
    if (m_ordered != nullptr && m_ordered[i] != GetWheelVelocities()[i]) {
      digest.Add(m_ordered[i]);
    }
  }
}

void CWheeledEntity::CheckIndex(size_t index) const {
  if (index >= GetNumWheels()) {
    THROW_ARGOSEXCEPTION("wheels \"" << GetContext() << GetId() << "\": no wheel " << index
                                     << "; they are numbered 0 to " << GetNumWheels() - 1);
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CWheeledEntity)

}  // namespace argos
