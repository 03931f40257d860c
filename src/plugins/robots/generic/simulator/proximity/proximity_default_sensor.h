#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_PROXIMITY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_PROXIMITY_DEFAULT_SENSOR_H

#include <argos3/core/simulator/entity/array_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/plugins/robots/generic/simulator/proximity_rays.h>

namespace argos {

/** Proximity sensors of any robot. A derived class may define another response. */
class CProximityDefaultSensor : public CArraySensor, public CCI_ProximitySensor {
 public:
  void SetRobot(CComposableEntity& robot) override;
  /** See CProximityRays::Init(). */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;
  SArray GetReadingsArray() const override { return ArrayOf(m_tReadings); }

  /**
   * Response of a sensor, before noise.
   * @param distance  from the start of the ray to the body that it hits, m, >= 0.
   * @return exp(-distance); clamped to [0,1] afterwards.
   */
  virtual Real CalculateReading(Real distance);

 private:
  CProximityRays m_rays;
};

}  // namespace argos

#endif
