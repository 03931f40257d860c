#include <argos3/campaign/scheduling/metric_watch.h>

#include <argos3/campaign/store/failed_runs.h>
#include <argos3/core/utility/text/lists.h>

#include <fmt/format.h>

#include <cmath>

namespace argos {

CMetricWatch::CMetricWatch(const SCampaign& campaign) : m_experimentFile(campaign.ExperimentFile) {
  for (const SCollectedMetric& metric : campaign.Metrics) {
    // those of files fail the run if they are missing, those that are built in never are
    if (metric.Source == SCollectedMetric::ESource::Metric) {
      m_missing.insert(metric.Name);
    }
  }
  if (!campaign.Stopping.Metric.empty()) {
    m_missing.insert(campaign.Stopping.Metric);
  }
}

void CMetricWatch::Note(const SRunResult& result) {
  if (result.Status != ERunStatus::Done && result.Status != ERunStatus::RobotsStopped) {
    return;
  }
  ++m_numRuns;
  for (const SMetricValue& metric : result.Metrics) {
    if (!std::isnan(metric.Value)) {
      m_missing.erase(metric.Name);
    }
  }
}

std::string CMetricWatch::TakeWarning(bool isEnd) {
  if (m_missing.empty() || m_numRuns < (isEnd ? 1 : kPatience)) {
    return "";
  }
  std::string names;
  for (const std::string& name : m_missing) {
    AppendQuoted(names, name);
  }
  m_missing.clear();
  return fmt::format(
      "{} run{} done, and none has recorded {}: check the name; `argos3 -zc {} --csv FOLDER` "
      "writes all metrics to FOLDER/metrics.csv",
      m_numRuns, m_numRuns == 1 ? " is" : "s are", names, QuoteForShell(m_experimentFile));
}

}  // namespace argos
