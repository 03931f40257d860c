#ifndef ARGOS3_TESTING_DETERMINISM_FEELERS_H
#define ARGOS3_TESTING_DETERMINISM_FEELERS_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/testing/support/experiment.h>

#include <functional>
#include <string>
#include <vector>

namespace argos {

class CCI_DifferentialSteeringActuator;
class CCI_FootBotDistanceScannerActuator;

/**
 * "feeler": drives by the sum of all readings of a foot-bot: light,
 * ground, proximity, motion, charge.
 */
class CFeeler : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override { m_readingsDigest = CDigest(); }

  /** Digest of every reading since the start. */
  UInt64 GetReadingsDigest() const { return m_readingsDigest.GetValue(); }

 private:
  void AddReading(Real reading);
  // registers a call of read(*this, sensor) for each step
  template <typename SENSOR, typename READ>
  void Watch(const std::string& tag, READ read);
  template <typename SENSOR>
  void WatchNumbers(const std::string& tag);
  template <typename SENSOR>
  void WatchValues(const std::string& tag);

  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_FootBotDistanceScannerActuator* m_scanner = nullptr;
  std::vector<std::function<void()>> m_senses;
  CDigest m_readingsDigest;
  Real m_sum = 0.0;
};

/**
 * Foot-bots among pillars, under lights, on a painted floor; with all kinds of noise if @p noisy.
 */
SExperiment Feelers(UInt32 robots, bool noisy);

}  // namespace argos

#endif
