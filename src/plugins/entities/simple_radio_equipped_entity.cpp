#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/read_medium.h>

namespace argos {

void CSimpleRadioEquippedEntity::Init(TConfigurationNode& tree) {
  CMountedEntities::Init(tree);
  InitInstances(tree, "simple_radio", "origin",
                [this](CSimpleRadioEntity& radio, TConfigurationNode& child) {
                  RequireNewId(radio.GetId());
                  radio.SetMedium(ReadMedium<CSimpleRadioEntity::CRegistry>(
                      child, CurrentSimulator(), "a simple radio medium"));
                });
  Enable();
}

void CSimpleRadioEquippedEntity::AddRadio(const std::string& id, const CVector3& position,
                                          SAnchor& anchor, CSimpleRadioEntity::CRegistry& medium,
                                          Real range) {
  RequireNewId(id);
  auto radio = std::make_unique<CSimpleRadioEntity>(this, id, range);
  radio->SetMedium(medium);
  Mount(std::move(radio), position, CQuaternion(), anchor);
}

void CSimpleRadioEquippedEntity::RequireNewId(const std::string& id) const {
  for (const SInstance& instance : GetInstances()) {
    if (instance.GetEntity().GetId() == id) {
      THROW_ARGOSEXCEPTION("radios \"" << GetContext() << GetId()
                                       << "\": there is already a radio with id \"" << id
                                       << "\"; ids must be unique");
    }
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CSimpleRadioEquippedEntity)

}  // namespace argos
