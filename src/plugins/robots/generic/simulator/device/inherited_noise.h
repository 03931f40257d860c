#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_INHERITED_NOISE_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_INHERITED_NOISE_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

/**
 * The attribute `noise_level` as classes derived from a sensor know it from ARGoS 3, by members of
 * the same names: a number drawn from the range is added to each reading.
 *
 * A sensor that is not derived from leaves its level to CDeviceNoise, whose stream depends on
 * nothing but the seed and the robot's id.
 */
class CInheritedNoise {
 protected:
  /** @throws CARGoSException if the level is < 0. */
  void InitNoise(TConfigurationNode& device) {
    m_cNoiseRange = ReadNoiseLevel(device);
    m_bAddNoise = m_cNoiseRange.GetMax() > 0.0;
    if (m_bAddNoise) {
      m_pcRNG = CRandom::CreateRNG("argos");
    }
  }
  Real DrawNoise() { return m_pcRNG->Uniform(m_cNoiseRange); }

  bool m_bAddNoise = false;
  CRange<Real> m_cNoiseRange{0.0, 0.0};
  CRandom::CRNG* m_pcRNG = nullptr;  // not owned; set if m_bAddNoise is
};

}  // namespace argos

#endif
