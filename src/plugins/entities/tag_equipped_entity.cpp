#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/read_medium.h>

namespace argos {

CTagEquippedEntity::CTagEquippedEntity(CComposableEntity* parent)
    : CTagEquippedEntity(parent, std::string()) {}

CTagEquippedEntity::CTagEquippedEntity(CComposableEntity* parent, const std::string& id)
    : CMountedEntities(parent, id) {}

void CTagEquippedEntity::Init(TConfigurationNode& tree) {
  CMountedEntities::Init(tree);
  SetMedium(ReadMedium<CTagEntity::CRegistry>(tree, CurrentSimulator(), "a tag medium"));
  InitInstances(tree, "tag");
  Enable();
}

void CTagEquippedEntity::AddTag(const CVector3& position, const CQuaternion& orientation,
                                SAnchor& anchor, const CRadians& observableAngle, Real sideLength,
                                const std::string& payload) {
  Mount(std::make_unique<CTagEntity>(this, "tag_" + std::to_string(GetNumTags()), CVector3(),
                                     CQuaternion(), observableAngle, sideLength, payload),
        position, orientation, anchor);
}

CTagEntity& CTagEquippedEntity::GetTag(UInt32 index) {
  return GetEntity(index, "tag");
}

void CTagEquippedEntity::SetTagPayload(UInt32 index, const std::string& payload) {
  GetTag(index).SetPayload(payload);
}

void CTagEquippedEntity::SetAllTagPayloads(const std::string& payload) {
  for (const SInstance& instance : GetInstances()) {
    instance.Entity.SetPayload(payload);
  }
}

void CTagEquippedEntity::SetAllTagPayloads(const std::vector<std::string>& payloads) {
  if (payloads.size() != GetNumTags()) {
    THROW_ARGOSEXCEPTION("tags \"" << GetContext() << GetId() << "\": got " << payloads.size()
                                   << " payloads for " << GetNumTags() << " tags");
  }
  for (size_t i = 0; i < payloads.size(); ++i) {
    GetInstances()[i].Entity.SetPayload(payloads[i]);
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CTagEquippedEntity)

}  // namespace argos
