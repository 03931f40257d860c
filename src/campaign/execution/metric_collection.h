#ifndef ARGOS3_CAMPAIGN_EXECUTION_METRIC_COLLECTION_H
#define ARGOS3_CAMPAIGN_EXECUTION_METRIC_COLLECTION_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/design/reductions.h>
#include <argos3/campaign/execution/run_result.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace argos {

class CRunOutput;
class CSimulator;

/**
 * @return true if a metric is collected as one number of a run. A series of the same name then has
 *   no number of its own; other series have their last value.
 */
bool IsCollectedAsNumber(const std::vector<SCollectedMetric>& metrics, const std::string& name);

/** Collects the metrics of a run, but not those in files. */
class CMetricCollection {
 public:
  /** @param metrics  must outlive this object; empty: the last values of all that the run sets. */
  explicit CMetricCollection(const std::vector<SCollectedMetric>& metrics);

  /**
   * Call it when the experiment is loaded: built-in metrics are computed from now on.
   * @throws CARGoSException if the experiment has not what one is computed from.
   */
  void Begin(CSimulator& simulator);
  /**
   * @return an output that collects the values of each tick, to be added to the experiment; null if
   *   none are needed, because the last values are read after the run. Outlived by this.
   */
  std::unique_ptr<CRunOutput> MakeOutput();
  /** Call it after the main loop. @param result  metrics and series are added. */
  void Finish(CSimulator& simulator, SRunResult& result);

 private:
  class COutput;

  struct SState {
    Real Pending = 0.0; /**< belongs to the last tick: PostExperiment() may replace it */
    std::string Unit;
    SObservedValues Values;
    SMetricSeries Series;
  };

  // the values of the present tick, which count when the tick is over
  void Keep(CSimulator& simulator);
  void TakePending();

  const std::vector<SCollectedMetric>& m_metrics;
  std::vector<SState> m_states;  // (metrics)
  std::optional<UInt32> m_pendingTick;
  bool m_isObserver = false;
};

}  // namespace argos

#endif
