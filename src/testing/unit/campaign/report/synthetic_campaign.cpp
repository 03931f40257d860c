#include "synthetic_campaign.h"

#include <catch2/catch.hpp>

namespace argos {

CSyntheticCampaign::CSyntheticCampaign(
    const std::vector<std::pair<std::string, std::vector<std::string>>>& factors) {
  m_campaign.File = GetPath("campaign.xml");
  m_campaign.ExperimentFile = GetPath("experiment.argos");
  m_campaign.ExperimentText =
      "<argos-configuration><framework><experiment ticks_per_second=\"10\"/></framework>"
      "</argos-configuration>";
  m_campaign.ResultsFile = GetPath("campaign.sqlite");
  m_campaign.Stopping.Seeds = {1, 2, 3, 7};
  m_campaign.Combinations.emplace_back();
  for (const auto& [name, levels] : factors) {
    SFactor& factor = m_campaign.Factors.emplace_back();
    factor.Name = name;
    std::vector<SCombination> combinations;
    for (const SCombination& combination : m_campaign.Combinations) {
      for (const std::string& level : levels) {
        SCombination& extended = combinations.emplace_back(combination);
        extended.Values.push_back(level);
        extended.Settings.push_back({"//" + name + "/@value", level});
      }
    }
    for (const std::string& level : levels) {
      factor.Levels.push_back({level, {{"//" + name + "/@value", level}}});
    }
    m_campaign.Combinations = combinations;
  }
}

void CSyntheticCampaign::AddRuns(size_t combination, const std::string& metric,
                                 const std::vector<Real>& values, const std::string& unit) {
  for (size_t i = 0; i < values.size(); ++i) {
    SStoredRun run;
    run.Seed = static_cast<UInt32>(i + 1);
    run.Result.Status = ERunStatus::Done;
    run.Result.Metrics.push_back({metric, unit, values[i]});
    AddRun(combination, run);
  }
}

void CSyntheticCampaign::AddSeries(size_t combination, UInt32 seed, const SMetricSeries& series) {
  SStoredRun run;
  run.Seed = seed;
  run.Result.Status = ERunStatus::Done;
  run.Result.Series.push_back(series);
  AddRun(combination, run);
}

void CSyntheticCampaign::AddRun(size_t combination, SStoredRun run) {
  run.Started = "2026-01-31T12:00:00Z";
  m_runs.emplace_back(combination, std::move(run));
}

CReportData& CSyntheticCampaign::Open() {
  {
    CResultStore store(m_campaign.ResultsFile, CResultStore::EMode::Write);
    store.Register(m_campaign, false);
    std::vector<SStoredRun> runs;
    for (auto& [combination, run] : m_runs) {
      run.Combination =
          store.GetCombinationId(m_campaign.Combinations.at(combination).ComputeKey());
      runs.push_back(run);
    }
    store.Add(runs);
  }
  m_store = std::make_unique<CResultStore>(m_campaign.ResultsFile, CResultStore::EMode::ReadOnly);
  m_data = std::make_unique<CReportData>(m_campaign, *m_store);
  return *m_data;
}

}  // namespace argos
