#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_ANGULAR_LIGHT_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_LIGHT_ANGULAR_LIGHT_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>

#include <algorithm>
#include <string>

namespace argos {

class CComposableEntity;
class CLightEntity;
class CLightSensorEquippedEntity;
class CLights;

/**
 * Computes the light on a ring of sensors around a robot: the model of `footbot_light` and
 * `eyebot_light`.
 *
 * A light of intensity I > 0 is visible along the segment from the robot's origin, the centre of
 * its base, unless a body other than the robot's own intersects the segment. With D = length of the
 * segment / I and delta = the angle between the azimuth of the light and the sensor, it adds
 *
 *     g(D) max(0, 1 - 2 delta / PI),   g(D) = exp(-2 D) for D <= 2.5, else 0
 *
 * to the reading. A light exactly above or below has no azimuth; it adds the mean over all
 * azimuths, g(D) / 4, to every sensor.
 *
 * Source: the foot-bot's sensor as published with ARGoS 3.
 */
class CAngularLight {
 public:
  static constexpr const char* kKind = "light sensors";

  /**
   * Finds and enables the robot's "light_sensors".
   * @throws CARGoSException if it has none, or no "body" or "controller".
   */
  void SetRobot(CComposableEntity& robot);
  /** Reads `show_rays`, `noise_level`, and `<noise on="reading">` children. */
  void Init(TConfigurationNode& tree);
  /** Restarts the noise. */
  void Reset() { m_noise.Reset(); }

  size_t GetNumSensors() const;

  bool IsShowRays() const { return m_showRays; }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_showRays = show; }

  /** @param readings  each with an Angle, and a Value that is written, in [0,1]. */
  template <typename READINGS>
  void Read(READINGS& readings) {
    for (auto& reading : readings) {
      reading.Value = 0.0;
    }
    const size_t numLights = GetNumLights();
    for (size_t light = 0; light < numLights; ++light) {
      SBeam beam;
      if (ComputeBeam(light, beam)) {
        for (auto& reading : readings) {
          reading.Value += ComputeShare(beam, reading.Angle);
        }
      }
    }
    for (auto& reading : readings) {
      reading.Value = std::clamp(m_noise.Apply(0, reading.Value), 0.0, 1.0);
    }
  }

 private:
  struct SBeam {
    Real Strength = 0.0;  // g(D)
    CRadians Azimuth;  // robot's frame
    bool HasAzimuth = false;
  };

  size_t GetNumLights() const;
  // returns false if the light is not visible
  bool ComputeBeam(size_t light, SBeam& beam);
  static Real ComputeShare(const SBeam& beam, const CRadians& sensor);

  CLightSensorEquippedEntity* m_sensors = nullptr;
  CRayCaster m_caster;
  const CLights* m_lights = nullptr;  // all lights of the space
  CDeviceNoise m_noise;
  bool m_showRays = false;
};

}  // namespace argos

#endif
