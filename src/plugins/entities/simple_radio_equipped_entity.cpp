#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>

#include <argos3/core/simulator/current.h>
#include <argos3/plugins/simulator/entities/read_medium.h>

namespace argos {

CSimpleRadioEquippedEntity::CSimpleRadioEquippedEntity(CComposableEntity* parent)
    : CSimpleRadioEquippedEntity(parent, std::string()) {}

CSimpleRadioEquippedEntity::CSimpleRadioEquippedEntity(CComposableEntity* parent,
                                                       const std::string& id)
    : CMountedEntities(parent, id) {}

void CSimpleRadioEquippedEntity::Init(TConfigurationNode& tree) {
  CMountedEntities::Init(tree);
  auto& body = GetParent().GetComponent<CEmbodiedEntity>("body");
  TConfigurationNodeIterator child("simple_radio");
  for (child = child.begin(&tree); child != child.end(); ++child) {
    auto radio = std::make_unique<CSimpleRadioEntity>(this);
    radio->Init(*child);
    RequireNewId(radio->GetId());
    std::string anchor;
    GetNodeAttributeOrDefault<std::string>(*child, "anchor", anchor, "origin");
    radio->SetMedium(ReadMedium<CSimpleRadioEntity::CRegistry>(*child, CurrentSimulator(),
                                                               "a simple radio medium"));
    // what the file gives as the pose is the mount
    const CVector3 position = radio->GetPosition();
    const CQuaternion orientation = radio->GetOrientation();
    Mount(std::move(radio), position, orientation, body.GetAnchor(anchor));
  }
  Enable();
}

void CSimpleRadioEquippedEntity::AddRadio(const std::string& id, const CVector3& position,
                                          SAnchor& anchor, Real range) {
  RequireNewId(id);
  Mount(std::make_unique<CSimpleRadioEntity>(this, id, range), position, CQuaternion(), anchor);
}

void CSimpleRadioEquippedEntity::RequireNewId(const std::string& id) const {
  for (const SInstance& instance : GetInstances()) {
    if (instance.Entity.GetId() == id) {
      THROW_ARGOSEXCEPTION("radios \"" << GetContext() << GetId()
                                       << "\": there is already a radio with id \"" << id
                                       << "\"; ids must be unique");
    }
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CSimpleRadioEquippedEntity)

}  // namespace argos
