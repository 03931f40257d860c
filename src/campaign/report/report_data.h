#ifndef ARGOS3_CAMPAIGN_REPORT_REPORT_DATA_H
#define ARGOS3_CAMPAIGN_REPORT_REPORT_DATA_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/store/result_store.h>

#include <map>
#include <string>
#include <vector>

namespace argos {

/** A metric of a run that is done. */
struct SRunValue {
  size_t Combination; /**< index in SCampaign::Combinations */
  UInt32 Seed;
  Real Value; /**< NaN: the run has not recorded it */
};

/** A time series of a run that is done. */
struct SRunSeries {
  size_t Combination;
  UInt32 Seed;
  SMetricSeries Series;
};

/**
 * What a report is made of: the runs of the newest generation, of the combinations that the
 * campaign file has. Reads on demand; both arguments must outlive it.
 */
class CReportData {
 public:
  CReportData(const SCampaign& campaign, const CResultStore& store);

  const SCampaign& GetCampaign() const { return m_campaign; }
  const CResultStore& GetStore() const { return m_store; }
  /** Without metrics, series and logs. */
  const std::vector<SStoredRun>& GetRuns() const { return m_runs; }
  /** The index of a run's combination in SCampaign::Combinations. */
  size_t GetCombination(const SStoredRun& run) const { return m_indexOf.at(run.Combination); }
  /** Runs of combinations that the campaign file does not have any more; they are left out. */
  size_t GetNumLeftOut() const { return m_numLeftOut; }

  /** @throws CARGoSException if there is no such factor, with similar names. */
  size_t FindFactor(const std::string& name) const;
  /** The different values of a factor: numbers in ascending order, others as in the file. */
  const std::vector<std::string>& GetLevels(size_t factor) const { return m_levels.at(factor); }
  /** The index of a combination's value in GetLevels(). */
  size_t GetLevel(size_t combination, size_t factor) const;
  /** "robots = 5, speed = 2"; empty without factors. @param without  factors that are left out. */
  std::string DescribeCombination(size_t combination,
                                  const std::vector<size_t>& without = {}) const;

  /**
   * The values of a metric, by combination and seed.
   * @throws CARGoSException if no run has recorded it, with similar names.
   */
  std::vector<SRunValue> ReadMetric(const std::string& name) const;
  /** @throws CARGoSException as ReadMetric(). */
  std::vector<SRunSeries> ReadSeries(const std::string& name) const;

 private:
  void ReadRuns();
  void FindLevels();

  const SCampaign& m_campaign;
  const CResultStore& m_store;
  std::map<UInt32, size_t> m_indexOf;  // combinations by id in the store
  std::vector<SStoredRun> m_runs;
  size_t m_numLeftOut = 0;
  std::vector<std::vector<std::string>> m_levels;  // (factors, levels)
};

/** @return true if all texts are numbers, which @p numbers then has. */
bool ParseLevels(const std::vector<std::string>& levels, std::vector<Real>& numbers);

}  // namespace argos

#endif
