#ifndef ARGOS3_TESTING_UNIT_CAMPAIGN_REPORT_SYNTHETIC_CAMPAIGN_H
#define ARGOS3_TESTING_UNIT_CAMPAIGN_REPORT_SYNTHETIC_CAMPAIGN_H

#include <argos3/campaign/report/report_data.h>
#include <argos3/testing/support/temporary_folder.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/** A campaign whose results are given by a test, in a temporary folder that is removed with it. */
class CSyntheticCampaign {
 public:
  /** A full design of factors with these levels. */
  explicit CSyntheticCampaign(
      const std::vector<std::pair<std::string, std::vector<std::string>>>& factors);
  CSyntheticCampaign(const CSyntheticCampaign&) = delete;
  CSyntheticCampaign& operator=(const CSyntheticCampaign&) = delete;

  SCampaign& GetCampaign() { return m_campaign; }
  std::string GetPath(const std::string& name) const { return m_folder.Path(name); }

  /** Stores runs with seeds 1, 2, ... of a combination, one for each value. */
  void AddRuns(size_t combination, const std::string& metric, const std::vector<Real>& values,
               const std::string& unit = "");
  void AddSeries(size_t combination, UInt32 seed, const SMetricSeries& series);
  /** @param run  its combination is set. */
  void AddRun(size_t combination, SStoredRun run);
  /** Stores what was added, once, and opens it. */
  CReportData& Open();
  const CResultStore& GetStore() const { return *m_store; }

 private:
  CTemporaryFolder m_folder;
  SCampaign m_campaign;
  std::vector<std::pair<size_t, SStoredRun>> m_runs;
  std::unique_ptr<CResultStore> m_store;
  std::unique_ptr<CReportData> m_data;
};

}  // namespace argos

#endif
