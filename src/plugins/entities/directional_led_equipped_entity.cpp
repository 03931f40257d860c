#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/read_medium.h>

namespace argos {

CDirectionalLEDEquippedEntity::CDirectionalLEDEquippedEntity(CComposableEntity* parent)
    : CDirectionalLEDEquippedEntity(parent, std::string()) {}

CDirectionalLEDEquippedEntity::CDirectionalLEDEquippedEntity(CComposableEntity* parent,
                                                             const std::string& id)
    : CMountedEntities(parent, id) {}

void CDirectionalLEDEquippedEntity::Init(TConfigurationNode& tree) {
  CMountedEntities::Init(tree);
  SetMedium(ReadMedium<CDirectionalLEDEntity::CRegistry>(tree, CurrentSimulator(),
                                                         "a medium of directional LEDs"));
  InitInstances(tree, "directional_led");
  Enable();
}

void CDirectionalLEDEquippedEntity::AddLED(const CVector3& position, const CQuaternion& orientation,
                                           SAnchor& anchor, const CRadians& observableAngle,
                                           const CColor& color) {
  Mount(std::make_unique<CDirectionalLEDEntity>(this,
                                                "directional_led_" + std::to_string(GetNumLEDs()),
                                                CVector3(), CQuaternion(), observableAngle, color),
        position, orientation, anchor);
}

CDirectionalLEDEntity& CDirectionalLEDEquippedEntity::GetLED(UInt32 index) {
  return GetEntity(index, "LED");
}

void CDirectionalLEDEquippedEntity::SetLEDColor(UInt32 index, const CColor& color) {
  GetLED(index).SetColor(color);
}

void CDirectionalLEDEquippedEntity::SetAllLEDsColors(const CColor& color) {
  for (const SInstance& instance : GetInstances()) {
    instance.Entity.SetColor(color);
  }
}

void CDirectionalLEDEquippedEntity::SetAllLEDsColors(const std::vector<CColor>& colors) {
  if (colors.size() != GetNumLEDs()) {
    THROW_ARGOSEXCEPTION("directional LEDs \"" << GetContext() << GetId() << "\": got "
                                               << colors.size() << " colors for " << GetNumLEDs()
                                               << " LEDs");
  }
  for (size_t i = 0; i < colors.size(); ++i) {
    GetInstances()[i].Entity.SetColor(colors[i]);
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CDirectionalLEDEquippedEntity)

}  // namespace argos
