#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_PROXIMITY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_PROXIMITY_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/plugins/robots/generic/simulator/inherited_noise.h>
#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>
#include <argos3/plugins/robots/generic/simulator/proximity_rays.h>

namespace argos {

/**
 * Proximity sensors of any robot. A derived class may define another response, and may set the
 * protected members itself in its SetRobot() and Init().
 */
class CProximityDefaultSensor : public CPlainReadingsSensor<CCI_ProximitySensor, CProximityRays>,
                                protected CInheritedNoise {
 public:
  CProximityDefaultSensor();

  void Init(TConfigurationNode& tree) override;
  void Update() override;

  /**
   * Response of a sensor, before noise.
   * @param distance  from the start of the ray to the body that it hits, m, >= 0.
   * @return exp(-distance); clamped to [0,1] afterwards.
   */
  virtual Real CalculateReading(Real distance);

 protected:
  // References to what the rays use.
  CEmbodiedEntity*& m_pcEmbodiedEntity;
  CProximitySensorEquippedEntity*& m_pcProximityEntity;
  CControllableEntity*& m_pcControllableEntity;
  bool& m_bShowRays;
  CSpace& m_cSpace;
};

}  // namespace argos

#endif
