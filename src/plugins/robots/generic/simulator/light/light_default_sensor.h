#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_LIGHT_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_LIGHT_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>
#include <argos3/plugins/robots/generic/simulator/inherited_noise.h>
#include <argos3/plugins/robots/generic/simulator/noisy_sensor.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

namespace argos {

class CLightEntity;
class CLightOccluders;
class CLights;
class CLightSensorEquippedEntity;
struct SLightEyes;

/**
 * Light sensors of any robot. A derived class may define another response, and may set the
 * protected members itself in its SetRobot() and Init().
 *
 * A light of intensity > 0 is visible to a sensor unless another body is between the two, or the
 * light is behind the plane through the sensor that is normal to its direction: the robot's own
 * body is then assumed to occlude it.
 */
class CLightDefaultSensor : public CNoisySensor<CCI_LightSensor>, protected CInheritedNoise {
 public:
  CLightDefaultSensor();

  void Update() override;

  /**
   * Contribution of a visible light to a reading, before noise.
   * @param distance   from the sensor to the light, m, >= 0.
   * @param intensity  of the light, > 0.
   * @return (intensity / distance)^2; the sum over lights is clamped to [0,1].
   */
  virtual Real CalculateReading(Real distance, Real intensity);

  bool IsShowRays() const { return m_bShowRays; }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_bShowRays = show; }

 private:
  struct SScratch;

  void FindParts(CComposableEntity& robot) override;
  /** Also reads `show_rays`, `noise_level`. */
  void Configure(TConfigurationNode& tree) override;
  void ResetReading() override;
  void AddLights(SLightEyes& eyes);
  void FindOccluders(const SLightEyes& eyes, SScratch& scratch) const;
  void Occlude(SLightEyes& eyes, CLightOccluders& occluders) const;
  void OccludeAndShow(SLightEyes& eyes, CLightOccluders& occluders) const;

  CRayCaster m_caster;
  const CLights* m_lights;  // all lights of the space
  bool m_isPlain = false;  // its class defines no other response

 protected:
  // the first two refer to what the rays use
  CEmbodiedEntity*& m_pcEmbodiedEntity;
  CControllableEntity*& m_pcControllableEntity;
  CLightSensorEquippedEntity* m_pcLightEntity = nullptr;
  bool m_bShowRays = false;
  CSpace& m_cSpace;
};

}  // namespace argos

#endif
