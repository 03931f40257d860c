#ifndef ARGOS3_CAMPAIGN_SCHEDULING_METRIC_WATCH_H
#define ARGOS3_CAMPAIGN_SCHEDULING_METRIC_WATCH_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/execution/run_result.h>

#include <set>
#include <string>

namespace argos {

/**
 * Notices metrics that a campaign collects, or that its stopping rule needs, but that no run
 * records, for example because a name is misspelt.
 */
class CMetricWatch {
 public:
  /** Runs after which a metric without any value is reported. */
  static constexpr UInt64 kPatience = 10;

  explicit CMetricWatch(const SCampaign& campaign);

  /** Takes a run into account, unless it has failed. */
  void Note(const SRunResult& result);
  /** @return a warning, once, if it is due; at the end, or else after kPatience runs; else "". */
  std::string TakeWarning(bool isEnd);

 private:
  std::set<std::string> m_missing;  // no run has recorded them yet
  std::string m_experimentFile;
  UInt64 m_numRuns = 0;
};

}  // namespace argos

#endif
