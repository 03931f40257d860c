#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_ENTITY_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/appearance.h>

#include <string>

namespace argos {

class CControllableEntity;
class CDirectionalLEDEquippedEntity;
class CEmbodiedEntity;
class CPiPuckDifferentialDriveEntity;
class CSimpleRadioEquippedEntity;

/**
 * The Pi-Puck: an e-puck with a Raspberry Pi, a camera, range sensors and directional LEDs.
 *
 * Source: A. G. Millard et al., "The Pi-puck extension board: a Raspberry Pi interface for the
 * e-puck robot platform", IROS 2017; numbers in pipuck_measures.h.
 */
class CPiPuckEntity : public CComposableEntity {
 public:
  ENABLE_VTABLE();

  CPiPuckEntity();

  /**
   * Reads `id`, `wifi_medium`, `led_medium`, `<body>`, `<controller>`, and the limits of the drive
   * as other robots with wheels.
   * @throws CARGoSException if a medium is unknown or the controller cannot be created.
   */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "pipuck"; }
  void UpdateComponents() override;
  const SAppearance* GetAppearance() const override;

  CControllableEntity& GetControllableEntity() { return *m_controllable; }
  CEmbodiedEntity& GetEmbodiedEntity() { return *m_body; }
  const CEmbodiedEntity& GetEmbodiedEntity() const { return *m_body; }
  CPiPuckDifferentialDriveEntity& GetDifferentialDriveEntity() { return *m_drive; }
  const CPiPuckDifferentialDriveEntity& GetDifferentialDriveEntity() const { return *m_drive; }
  CDirectionalLEDEquippedEntity& GetDirectionalLEDEquippedEntity() { return *m_leds; }
  const CDirectionalLEDEquippedEntity& GetDirectionalLEDEquippedEntity() const { return *m_leds; }
  CSimpleRadioEquippedEntity& GetSimpleRadioEquippedEntity() { return *m_radios; }
  const CSimpleRadioEquippedEntity& GetSimpleRadioEquippedEntity() const { return *m_radios; }

 private:
  void AddAnchors();
  void AddLEDs();
  void InitDrive(TConfigurationNode& tree);

  // components
  CEmbodiedEntity* m_body = nullptr;
  CPiPuckDifferentialDriveEntity* m_drive = nullptr;
  CSimpleRadioEquippedEntity* m_radios = nullptr;
  CDirectionalLEDEquippedEntity* m_leds = nullptr;
  CControllableEntity* m_controllable = nullptr;
};

}  // namespace argos

#endif
