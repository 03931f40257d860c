#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_RAYS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_RAYS_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>

#include <algorithm>
#include <memory>

namespace argos {

class CComposableEntity;
class CControllableEntity;
class CSpace;

/**
 * Casts the rays of a robot's proximity sensors: what all proximity sensors have in common.
 *
 * All rays share one query for the solids around the robot. Rays look through the robot's own body;
 * one that starts inside another body meets it at distance 0.
 */
class CProximityRays {
 public:
  /**
   * Finds and enables the robot's "proximity_sensors".
   * @throws CARGoSException if it has none, or no "body" or "controller".
   */
  void SetRobot(CComposableEntity& robot);
  /** Reads `show_rays` and `noise_level`. @throws CARGoSException if the latter is < 0. */
  void Init(TConfigurationNode& tree);
  /** Noise starts over. */
  void Reset();

  size_t GetNumRays() const { return m_sensors->GetNumSensors(); }
  /** @throws CARGoSException that names @p device if the robot does not have so many rays. */
  void RequireNumRays(size_t num, const std::string& device) const;

  /**
   * Casts all rays.
   * @param calculate  Real(Real D): what the sensor reads at distance D (m) from the ray's start;
   *                   not called for rays that meet nothing, which read 0.
   * @param store      void(size_t ray, Real reading): with noise, in [0,1].
   */
  template <typename CALCULATE, typename STORE>
  void Read(CALCULATE&& calculate, STORE&& store) {
    const size_t num = GetNumRays();
    for (size_t first = 0; first < num; first += kBatch) {
      const size_t count = std::min(kBatch, num - first);
      Real distances[kBatch];  // m; < 0: no hit
      Cast(first, count, distances);
      for (size_t i = 0; i < count; ++i) {
        Real reading = distances[i] < 0.0 ? 0.0 : calculate(distances[i]);
        if (m_noise != nullptr) {
          reading += m_noise->Uniform(-m_noiseLevel, m_noiseLevel);
        }
        store(first + i, std::clamp(reading, 0.0, 1.0));
      }
    }
  }

 private:
  typedef CProximitySensorEquippedEntity::SLayout TLayout;
  static constexpr size_t kBatch = 32;  // rays cast with one query

  void Cast(size_t first, size_t count, Real* distances);
  void CastUpright(const TLayout& layout, size_t first, size_t count, Real* fractions) const;
  void CastOneByOne(const TLayout& layout, size_t first, size_t count, Real* fractions) const;
  bool AreBodiesOutsideIndex() const;
  CRay3 MakeRay(const TLayout& layout, size_t ray) const;
  void Show(const TLayout& layout, size_t first, size_t count, const Real* fractions);
  void MakeNoise();

  CProximitySensorEquippedEntity* m_sensors = nullptr;  // of the robot
  const TLayout* m_layout = nullptr;  // the one for which m_anchor holds
  const SAnchor* m_anchor = nullptr;  // of the first ray
  CEmbodiedEntity* m_body = nullptr;  // of the robot
  CControllableEntity* m_robot = nullptr;
  CSpace* m_space = nullptr;
  bool m_showRays = false;
  Real m_noiseLevel = 0.0;
  std::unique_ptr<CRandomStream> m_noise;  // only with noise
};

}  // namespace argos

#endif
