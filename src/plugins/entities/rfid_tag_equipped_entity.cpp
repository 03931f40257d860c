#include <argos3/plugins/simulator/entities/rfid_tag_equipped_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/read_medium.h>

namespace argos {

CRFIDTagEquippedEntity::CRFIDTagEquippedEntity(CComposableEntity* parent)
    : CRFIDTagEquippedEntity(parent, std::string()) {}

CRFIDTagEquippedEntity::CRFIDTagEquippedEntity(CComposableEntity* parent, const std::string& id)
    : CMountedEntities(parent, id) {}

void CRFIDTagEquippedEntity::Init(TConfigurationNode& tree) {
  CMountedEntities::Init(tree);
  SetMedium(ReadMedium<CRFIDTagEntity::CRegistry>(tree, CurrentSimulator(), "an RFID medium"));
  InitInstances(tree, "rfid_tag", "origin");
  Enable();
}

void CRFIDTagEquippedEntity::AddTag(const std::string& id, const CVector3& position,
                                    SAnchor& anchor, const CByteArray& data) {
  Mount(std::make_unique<CRFIDTagEntity>(this, id, CVector3(), data), position, CQuaternion(),
        anchor);
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CRFIDTagEquippedEntity)

}  // namespace argos
