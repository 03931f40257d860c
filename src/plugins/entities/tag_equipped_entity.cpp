#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>

#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/mounted_entities_impl.h>

namespace argos {

void CTagEquippedEntity::Init(TConfigurationNode& tree) {
  InitInMedium(tree, "a tag medium", "tag");
}

void CTagEquippedEntity::AddTag(const std::string& id, const CVector3& position,
                                const CQuaternion& orientation, SAnchor& anchor,
                                const CRadians& observableAngle, Real sideLength,
                                const std::string& payload) {
  Mount(std::make_unique<CTagEntity>(this, id, CVector3(), CQuaternion(), observableAngle,
                                     sideLength, payload),
        position, orientation, anchor);
}

void CTagEquippedEntity::AddTag(const CVector3& position, const CQuaternion& orientation,
                                SAnchor& anchor, const CRadians& observableAngle, Real sideLength,
                                const std::string& payload) {
  AddTag("tag_" + std::to_string(GetNumTags()), position, orientation, anchor, observableAngle,
         sideLength, payload);
}

CTagEntity& CTagEquippedEntity::GetTag(UInt32 index) {
  return GetEntity(index, "tag");
}

void CTagEquippedEntity::SetTagPayload(UInt32 index, const std::string& payload) {
  GetTag(index).SetPayload(payload);
}

void CTagEquippedEntity::SetTagPayloads(const std::string& payload) {
  for (const SInstance& instance : GetInstances()) {
    instance.GetEntity().SetPayload(payload);
  }
}

void CTagEquippedEntity::SetTagPayloads(const std::vector<std::string>& payloads) {
  SetEach(payloads, "tags", "payloads",
          [](CTagEntity& tag, const std::string& payload) { tag.SetPayload(payload); });
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CTagEquippedEntity)

}  // namespace argos
