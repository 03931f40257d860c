#ifndef ARGOS3_PLUGINS_ENTITIES_DIRECTIONAL_LED_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_DIRECTIONAL_LED_EQUIPPED_ENTITY_H

#include <argos3/plugins/simulator/entities/directional_led_entity.h>
#include <argos3/plugins/simulator/entities/mounted_entities.h>

#include <string>
#include <vector>

namespace argos {

/** A directional LED and its place. */
template <>
struct SMountedInstance<CDirectionalLEDEntity> {
  CDirectionalLEDEntity& LED;
  CVector3 PositionOffset; /**< offset in the anchor's frame, m */
  CQuaternion OrientationOffset; /**< offset in the anchor's frame */
  SAnchor& Anchor;

  typedef std::vector<SMountedInstance> TVector;

  CDirectionalLEDEntity& GetEntity() const { return LED; }
  const CVector3& GetPositionOffset() const { return PositionOffset; }
};

/** The directional LEDs on a body. Starts disabled. */
class CDirectionalLEDEquippedEntity : public CMountedEntities<CDirectionalLEDEntity> {
 public:
  ENABLE_VTABLE();

  using CMountedEntities::CMountedEntities;

  /**
   * Reads `medium` and the children `<directional_led position="x,y,z" orientation="z,y,x"
   * anchor="..." observable_angle="..." color="..." />`, and enables the LEDs. The parent must have
   * a "body" with these anchors.
   * @throws CARGoSException with the known names if a medium or an anchor is unknown.
   */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "directional_leds"; }

  /**
   * Adds an LED that shines along the z axis of its frame.
   * @param id                     unique among the LEDs of this entity.
   * @param position, orientation  of the LED's frame in the anchor's frame, m.
   * @param observableAngle        half angle of the visibility cone, in (0, PI].
   */
  void AddLED(const std::string& id, const CVector3& position, const CQuaternion& orientation,
              SAnchor& anchor, const CRadians& observableAngle, const CColor& color);
  /** The same with the id directional_led_0, directional_led_1, ... */
  void AddLED(const CVector3& position, const CQuaternion& orientation, SAnchor& anchor,
              const CRadians& observableAngle, const CColor& color = CColor::BLACK);

  size_t GetNumLEDs() const { return GetInstances().size(); }
  /** These throw CARGoSException if the index is out of range. */
  CDirectionalLEDEntity& GetLED(UInt32 index);
  const CDirectionalLEDEntity& GetLED(UInt32 index) const { return GetEntity(index, "LED"); }
  void SetLEDColor(UInt32 index, const CColor& color);
  void SetLEDColors(const CColor& color);
  /** @throws CARGoSException if the numbers of colours and of LEDs differ. */
  void SetLEDColors(const std::vector<CColor>& colors);
};

}  // namespace argos

#endif
