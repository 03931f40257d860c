#ifndef ARGOS3_PLUGINS_ENTITIES_PASSIVE_BODY_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_PASSIVE_BODY_ENTITY_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>

namespace argos {

class CRFIDTagEquippedEntity;

/** Base of boxes and cylinders: one solid without a controller, with optional LEDs. */
class CPassiveBodyEntity : public CComposableEntity {
 public:
  void UpdateComponents() override;

  /** Adds the LEDs to a medium, a CLEDMedium, so that cameras see them. */
  void EnableLEDs(CLEDEntity::CRegistry& medium);
  void DisableLEDs();
  /** @param offset from the centre of the base, in the frame of the body, m. */
  void AddLED(const CVector3& offset, const CColor& color = CColor::BLACK);

  CEmbodiedEntity& GetEmbodiedEntity() { return *m_body; }
  const CEmbodiedEntity& GetEmbodiedEntity() const { return *m_body; }
  CLEDEquippedEntity& GetLEDEquippedEntity() { return *m_leds; }
  const CLEDEquippedEntity& GetLEDEquippedEntity() const { return *m_leds; }

  /** The RFID tags on the body; created by the first call. */
  CRFIDTagEquippedEntity& GetRFIDTagEquippedEntity();

  /** Mass, kg; 0 if the experiment file has an immovable body. */
  Real GetMass() const { return m_mass; }
  /**
   * Changes the mass; a body that is in an engine is removed and added again, at rest.
   * @throws CARGoSException if the mass is not > 0.
   */
  void SetMass(Real mass);

  const SAppearance* GetAppearance() const override { return &m_appearance; }

 protected:
  CPassiveBodyEntity();
  CPassiveBodyEntity(const std::string& id, const CVector3& position,
                     const CQuaternion& orientation, bool movable, Real mass);

  /**
   * Reads `id`, `movable`, `mass` (if movable), `<body>`, `<leds>` and `<rfid_tags>`. Derived
   * classes read their size before and call Describe() afterwards.
   */
  void InitBody(TConfigurationNode& tree);
  /**
   * Updates the body's description for engines and visualizations; a body that is in an engine is
   * removed and added again.
   */
  void Describe();
  /** For a reset, before the description of the start is made: the pose and whether it moves. */
  void ReturnBodyToStart();
  virtual SShapeDescription MakeShape() const = 0;
  virtual SGroundFrictionDescription::EClass GetFrictionClass() const = 0;

 private:
  void MakeAppearance();

  CEmbodiedEntity* m_body = nullptr;  // a component
  CLEDEquippedEntity* m_leds = nullptr;  // a component
  CRFIDTagEquippedEntity* m_rfidTags = nullptr;  // a component; null until the first request
  static constexpr Real kDefaultMass = 1.0;  // kg

  Real m_mass = kDefaultMass;
  SAppearance m_appearance;
};

}  // namespace argos

#endif
