#ifndef ARGOS3_PLUGINS_ENTITIES_LIGHT_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_LIGHT_ENTITY_H

#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/plugins/simulator/entities/led_entity.h>

namespace argos {

/**
 * A lamp: light sensors read its intensity, cameras see it as an LED. It has no body.
 */
class CLightEntity : public CLEDEntity {
 public:
  ENABLE_VTABLE();

  CLightEntity();
  /**
   * A lamp without a medium: only light sensors detect it until SetMedium() and Enable().
   * @param position m, world frame. @param intensity see SetIntensity().
   */
  CLightEntity(const std::string& id, const CVector3& position, const CColor& color,
               Real intensity);

  /** Reads `intensity`, `medium`, and the attributes of CLEDEntity::Init(). */
  void Init(TConfigurationNode& tree) override;
  std::string GetTypeDescription() const override { return "light"; }

  Real GetIntensity() const { return m_intensity; }
  /**
   * @param intensity  the distance at which a light sensor of the generic model reads 1, m; light
   *   sensors ignore lamps with 0 or less.
   * @throws CARGoSException if it is not finite.
   */
  void SetIntensity(Real intensity);
  void SetColor(const CColor& color) override;

  const SAppearance* GetAppearance() const override { return &m_appearance; }
  void UpdateDigest(CDigest& digest) const override;

 private:
  void MakeAppearance();

  Real m_intensity = 1.0;
  SAppearance m_appearance;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#endif

#endif
