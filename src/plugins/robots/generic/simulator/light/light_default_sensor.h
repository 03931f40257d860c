#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_LIGHT_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_LIGHT_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

namespace argos {

class CLightEntity;
class CLights;
class CLightSensorEquippedEntity;

/**
 * Light sensors of any robot. A derived class may read lights in its own way.
 *
 * A sensor sees a light of intensity > 0 unless another body lies between the two, or the light is
 * behind the plane through the sensor that is normal to its direction: the robot's own body is then
 * in the way.
 */
class CLightDefaultSensor : public CSimulatedSensor, public CCI_LightSensor {
 public:
  /** @throws CARGoSException if the robot has no "light_sensors", "body" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `show_rays`, `noise_level`, and `<noise on="reading">` children. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

  /**
   * What a light that is seen adds to a reading, before noise.
   * @param distance   from the sensor to the light, m, >= 0.
   * @param intensity  of the light, > 0.
   * @return (intensity / distance)^2; the sum over lights is clamped to [0,1].
   */
  virtual Real CalculateReading(Real distance, Real intensity);

 private:
  struct SEyes;  // some of the sensors, in the world

  void AddLights(SEyes& eyes);
  void FindFacing(const CLightEntity& light, SEyes& eyes) const;
  void FindBlocked(const CVector3& light, SEyes& eyes) const;
  void Show(const CVector3& light, const SEyes& eyes) const;

  CLightSensorEquippedEntity* m_sensors = nullptr;  // of the robot
  CRayCaster m_caster;
  const CLights* m_lights = nullptr;  // of the space
  CDeviceNoise m_noise;
  bool m_showRays = false;
};

}  // namespace argos

#endif
