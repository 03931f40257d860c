#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_PROXIMITY_RAYS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_PROXIMITY_PROXIMITY_RAYS_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/memory/load_ahead.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/robots/generic/simulator/ray_caster.h>
#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos {

/**
 * Casts the rays of a robot's proximity sensors, for all types of proximity sensors.
 *
 * All rays share one query of the index. Rays ignore the robot's own body; a ray that starts inside
 * another body hits it at distance 0.
 */
class CProximityRays {
 public:
  static constexpr const char* kKind = "proximity sensors";

  /**
   * Finds and enables the robot's "proximity_sensors".
   * @throws CARGoSException if it has none, or no "body" or "controller".
   */
  void SetRobot(CComposableEntity& robot);
  /**
   * Reads `show_rays`, `noise_level`, and `<noise on="reading">` children.
   * @throws CARGoSException if the level is < 0.
   */
  void Init(TConfigurationNode& tree);
  /** Before Init(): the sensor reads `noise_level` itself. */
  void LeaveNoiseLevel() { m_readsNoiseLevel = false; }
  /** Restarts the noise. */
  void Reset() { m_noise.Reset(); }

  /**
   * For sensors that read 0 of bodies farther than @p range (m) from the start of a ray: these are
   * not searched for unless the rays are shown.
   */
  void SetRange(Real range) { m_range = range; }

  size_t GetNumSensors() const { return m_sensors->GetNumSensors(); }
  /** See CSimulatedSensor::ListMemory(). */
  void ListMemory(std::vector<SMemory>& memory) const {
    memory.push_back({m_sensors->GetLayoutAddress(), sizeof(void*)});
  }

  /** For sensors whose derived classes find the robot's parts themselves. */
  CRayCaster& GetCaster() { return m_caster; }
  CProximitySensorEquippedEntity*& AccessSensors() { return m_sensors; }
  bool& AccessShowRays() { return m_showRays; }
  bool IsShowRays() const { return m_showRays; }
  /** @param show  true: visualizations show the sensor's rays, from the next tick on. */
  void SetShowRays(bool show) { m_showRays = show; }

  /**
   * Casts all rays.
   * @param calculate  Real(Real D): the reading for a hit at distance D (m) from the ray's start.
   * Rays without a hit read 0.
   * @param store      void(size_t ray, Real reading): the reading includes noise, in [0,1].
   */
  template <typename CALCULATE, typename STORE>
  void Read(CALCULATE&& calculate, STORE&& store) {
    Read(
        calculate, [](Real reading) { return reading; }, store);
  }
  /** @param addNoise  Real(Real reading): the reading of each ray with further noise. */
  template <typename CALCULATE, typename ADD_NOISE, typename STORE>
  void Read(CALCULATE&& calculate, ADD_NOISE&& addNoise, STORE&& store) {
    const size_t num = GetNumSensors();
    for (size_t first = 0; first < num; first += CRayCaster::kMaxRays) {
      const size_t count = std::min(CRayCaster::kMaxRays, num - first);
      Real fractions[CRayCaster::kMaxRays];
      Cast(first, count, fractions);
      const Real* const lengths = m_sensors->GetLayout().Lengths.data() + first;
      const auto read = [&](size_t i) {
        return fractions[i] <= 1.0 ? calculate(fractions[i] * lengths[i]) : 0.0;
      };
      // the usual case apart, whose loop is short
      if (!m_noise.IsOn()) {
        for (size_t i = 0; i < count; ++i) {
          store(first + i, std::clamp(addNoise(read(i)), 0.0, 1.0));
        }
      } else {
        for (size_t i = 0; i < count; ++i) {
          store(first + i, std::clamp(addNoise(m_noise.Apply(0, read(i))), 0.0, 1.0));
        }
      }
    }
  }

 private:
  /** @param fractions  (count) as CRayCaster::Cast() gives them. */
  void Cast(size_t first, size_t count, Real* fractions);
  /** Of the parts of all rays that are within the range. */
  SRayBounds ComputeBounds(const SRayLayout& layout) const;

  CProximitySensorEquippedEntity* m_sensors = nullptr;
  const SAnchor* m_anchor =
      nullptr;  // holds the first ray, and is kept by it; null until the first tick
  CRayCaster m_caster;
  CDeviceNoise m_noise;
  Real m_range = HUGE_VAL;  // m
  bool m_readsNoiseLevel = true;
  bool m_showRays = false;
};

}  // namespace argos

#endif
