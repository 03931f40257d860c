#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>

#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/mounted_entities_impl.h>

namespace argos {

void CDirectionalLEDEquippedEntity::Init(TConfigurationNode& tree) {
  InitInMedium(tree, "a medium of directional LEDs", "directional_led");
}

void CDirectionalLEDEquippedEntity::AddLED(const std::string& id, const CVector3& position,
                                           const CQuaternion& orientation, SAnchor& anchor,
                                           const CRadians& observableAngle, const CColor& color) {
  Mount(std::make_unique<CDirectionalLEDEntity>(this, id, CVector3(), CQuaternion(),
                                                observableAngle, color),
        position, orientation, anchor);
}

void CDirectionalLEDEquippedEntity::AddLED(const CVector3& position, const CQuaternion& orientation,
                                           SAnchor& anchor, const CRadians& observableAngle,
                                           const CColor& color) {
  AddLED("directional_led_" + std::to_string(GetNumLEDs()), position, orientation, anchor,
         observableAngle, color);
}

CDirectionalLEDEntity& CDirectionalLEDEquippedEntity::GetLED(UInt32 index) {
  return GetEntity(index, "LED");
}

void CDirectionalLEDEquippedEntity::SetLEDColor(UInt32 index, const CColor& color) {
  GetLED(index).SetColor(color);
}

void CDirectionalLEDEquippedEntity::SetLEDColors(const CColor& color) {
  for (const SInstance& instance : GetInstances()) {
    instance.GetEntity().SetColor(color);
  }
}

void CDirectionalLEDEquippedEntity::SetLEDColors(const std::vector<CColor>& colors) {
  SetEach(colors, "directional LEDs", "colors",
          [](CDirectionalLEDEntity& led, const CColor& color) { led.SetColor(color); });
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CDirectionalLEDEquippedEntity)

}  // namespace argos
