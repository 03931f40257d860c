#include <argos3/plugins/simulator/entities/rfid_tag_equipped_entity.h>

#include <argos3/core/simulator/current.h>
#include <argos3/plugins/simulator/entities/read_medium.h>

namespace argos {

CRFIDTagEquippedEntity::CRFIDTagEquippedEntity(CComposableEntity* parent)
    : CRFIDTagEquippedEntity(parent, std::string()) {}

CRFIDTagEquippedEntity::CRFIDTagEquippedEntity(CComposableEntity* parent, const std::string& id)
    : CMountedEntities(parent, id) {}

void CRFIDTagEquippedEntity::Init(TConfigurationNode& tree) {
  CMountedEntities::Init(tree);
  SetMedium(ReadMedium<CRFIDTagEntity::CRegistry>(tree, CurrentSimulator(), "an RFID medium"));
  auto& body = GetParent().GetComponent<CEmbodiedEntity>("body");
  TConfigurationNodeIterator child("rfid_tag");
  for (child = child.begin(&tree); child != child.end(); ++child) {
    auto tag = std::make_unique<CRFIDTagEntity>(this);
    tag->Init(*child);
    std::string anchor;
    GetNodeAttributeOrDefault<std::string>(*child, "anchor", anchor, "origin");
    // what the file gives as the pose is the mount
    const CVector3 position = tag->GetPosition();
    const CQuaternion orientation = tag->GetOrientation();
    Mount(std::move(tag), position, orientation, body.GetAnchor(anchor));
  }
  Enable();
}

void CRFIDTagEquippedEntity::AddTag(const std::string& id, const CVector3& position,
                                    SAnchor& anchor, const CByteArray& data) {
  Mount(std::make_unique<CRFIDTagEntity>(this, id, CVector3(), data), position, CQuaternion(),
        anchor);
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CRFIDTagEquippedEntity)

}  // namespace argos
