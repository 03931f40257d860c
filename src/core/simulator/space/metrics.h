#ifndef ARGOS3_CORE_SIMULATOR_SPACE_METRICS_H
#define ARGOS3_CORE_SIMULATOR_SPACE_METRICS_H

#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <vector>

namespace argos {

/**
 * The metrics of a run: named numbers that loop functions compute, such as the number of objects
 * retrieved. Outputs write them, once a tick.
 *
 * An extension of the space: space.GetExtension<CMetrics>(). For the main thread, between the
 * phases of a tick.
 */
class CMetrics : public CSpaceExtension {
 public:
  struct SMetric {
    std::string Name;
    std::string Unit; /**< empty for numbers without a unit */
    Real Value; /**< NaN: none since the start or the last Reset() */
  };

  /**
   * Sets the value that a metric has from now on; creates the metric at the first call.
   * @param name  letters, digits and '_', beginning with a letter.
   * @param unit  such as "m"; empty: as in the call that created the metric.
   * @throws CARGoSException if the name is none, or if the unit has changed.
   */
  void Set(const std::string& name, Real value, const std::string& unit = "");

  /** In order of creation; metrics are never removed. */
  const std::vector<SMetric>& GetAll() const { return m_metrics; }

  /** Forgets the values; called by CSimulator::Reset(), before the Reset() of loop functions. */
  void ForgetValues();

 private:
  std::vector<SMetric> m_metrics;
};

}  // namespace argos

#endif
