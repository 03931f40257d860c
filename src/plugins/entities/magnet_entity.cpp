#include <argos3/plugins/simulator/entities/magnet_entity.h>

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <cmath>

namespace argos {

CMagnetEntity::CMagnetEntity(CComposableEntity* parent) : CEntity(parent) {}

CMagnetEntity::CMagnetEntity(CComposableEntity* parent, const std::string& id,
                             const CVector3& passiveField, const CVector3& activeField)
    : CEntity(parent, id), m_passiveField(passiveField), m_activeField(activeField) {}

void CMagnetEntity::Init(TConfigurationNode& tree) {
  CEntity::Init(tree);
  GetNodeAttribute(tree, "passive_field", m_passiveField);
  RequireEachIn(kField, m_passiveField, OwnerOf(tree), "attribute \"passive_field\"");
  GetNodeAttributeOrDefault(tree, "active_field", m_activeField, CVector3());
  RequireEachIn(kField, m_activeField, OwnerOf(tree), "attribute \"active_field\"");
}

void CMagnetEntity::Reset() {
  CEntity::Reset();
  m_current = 0.0;
}

void CMagnetEntity::SetCurrent(Real current) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetCurrent()");
  }
  if (!std::isfinite(current)) {
    THROW_ARGOSEXCEPTION("magnet \"" << GetContext() << GetId()
                                     << "\": the current must be finite, got " << current);
  }
  m_current = current;
}

void CMagnetEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  for (UInt32 axis = 0; axis < 3; ++axis) {
    digest.Add(GetField()[axis]);
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CMagnetEntity)

}  // namespace argos
