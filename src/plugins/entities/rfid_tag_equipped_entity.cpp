#include <argos3/plugins/simulator/entities/rfid_tag_equipped_entity.h>

#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/mounted_entities_impl.h>

namespace argos {

void CRFIDTagEquippedEntity::Init(TConfigurationNode& tree) {
  InitInMedium(tree, "an RFID medium", "rfid_tag", "origin");
}

void CRFIDTagEquippedEntity::AddTag(const std::string& id, const CVector3& position,
                                    SAnchor& anchor, const CByteArray& data) {
  Mount(std::make_unique<CRFIDTagEntity>(this, id, CVector3(), data), position, CQuaternion(),
        anchor);
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CRFIDTagEquippedEntity)

}  // namespace argos
