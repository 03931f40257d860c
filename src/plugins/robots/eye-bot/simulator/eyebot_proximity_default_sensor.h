#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_PROXIMITY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_PROXIMITY_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/prefetch.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/simulator/proximity_rays.h>

namespace argos {

/** The eye-bot's proximity sensors, with the response of the real ones. */
class CEyeBotProximityDefaultSensor : public CSimulatedSensor, public CCI_EyeBotProximitySensor {
 public:
  /** @throws CARGoSException unless the robot has 24 proximity sensors. */
  void SetRobot(CComposableEntity& robot) override;
  /** See CProximityRays::Init(). */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void PrefetchUpdate() const override {
    m_rays.PrefetchRead();
    PrefetchElements(m_tReadings);
  }
  void Reset() override;

  /**
   * What a sensor reads, before noise; see ComputeSwarmanoidProximity().
   * @param distance  from the start of its ray to what it met, m, >= 0.
   */
  virtual Real CalculateReading(Real distance);

 private:
  CProximityRays m_rays;
};

}  // namespace argos

#endif
