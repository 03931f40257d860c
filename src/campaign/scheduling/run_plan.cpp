#include <argos3/campaign/scheduling/run_plan.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace argos {

namespace {

constexpr Real kMissing = std::numeric_limits<Real>::quiet_NaN();

// the rule would refuse values that are not measures of anything
constexpr Real kMaxMeasure = 1e100;

Real ToMeasure(Real value) {
  return std::abs(value) <= kMaxMeasure ? value : kMissing;
}

}  // namespace

std::unique_ptr<CRunPlan> CRunPlan::Create(const SCampaign& campaign,
                                           const std::vector<SKnownRun>& known) {
  if (!campaign.Stopping.Metric.empty()) {
    return std::make_unique<CSequentialRunPlan>(campaign, known);
  }
  std::set<std::pair<size_t, UInt32>> present;
  for (const SKnownRun& run : known) {
    present.emplace(run.Combination, run.Seed);
  }
  std::vector<SPlannedRun> runs;
  for (const UInt32 seed : campaign.Stopping.Seeds) {
    for (size_t i = 0; i < campaign.Combinations.size(); ++i) {
      if (present.count({i, seed}) == 0) {
        runs.push_back({i, seed});
      }
    }
  }
  return std::make_unique<CRunListPlan>(std::move(runs), campaign.Combinations.size());
}

// a list

CRunListPlan::CRunListPlan(std::vector<SPlannedRun> runs, size_t numCombinations)
    : m_runs(runs.begin(), runs.end()), m_openOf(numCombinations), m_numOpen(runs.size()) {
  for (const SPlannedRun& run : m_runs) {
    ++m_openOf.at(run.Combination);
  }
  m_numComplete = static_cast<size_t>(std::count(m_openOf.begin(), m_openOf.end(), UInt64(0)));
}

std::optional<SPlannedRun> CRunListPlan::Next() {
  if (m_runs.empty()) {
    return std::nullopt;
  }
  const SPlannedRun run = m_runs.front();
  m_runs.pop_front();
  return run;
}

std::vector<TFinishedRun> CRunListPlan::Finish(const SPlannedRun& run, SRunResult result) {
  ARGOS_ASSERT(
      m_numOpen > 0 && run.Combination < m_openOf.size() && m_openOf[run.Combination] > 0,
      "a run of combination number " << run.Combination << " that was not planned has ended");
  --m_numOpen;
  m_numComplete += --m_openOf[run.Combination] == 0 ? 1 : 0;
  std::vector<TFinishedRun> stored;
  stored.emplace_back(run, std::move(result));
  return stored;
}

CSequentialRunPlan::CSequentialRunPlan(const SCampaign& campaign,
                                       const std::vector<SKnownRun>& known)
    : m_stopping(campaign.Stopping),
      m_states(campaign.Combinations.size(), SState(MakeRule(campaign.Stopping))) {
  for (SState& state : m_states) {
    state.IsKnown.resize(m_stopping.MaxRuns);
  }
  for (const SKnownRun& run : known) {
    SState& state = m_states.at(run.Combination);
    const size_t position = run.Seed - size_t(m_stopping.FirstSeed);
    // seeds of another rule may be in the store
    if (run.Seed >= m_stopping.FirstSeed && position < m_stopping.MaxRuns) {
      state.IsKnown[position] = true;
      state.Mean.Insert(position, ToMeasure(run.Value));
    }
  }
  for (SState& state : m_states) {
    SkipKnown(state);
  }
}

SStoppingRule CSequentialRunPlan::MakeRule(const SStopping& stopping) {
  SStoppingRule rule;
  rule.Precision = stopping.Width > 0.0 ? EMeanPrecision::Absolute : EMeanPrecision::Relative;
  rule.HalfWidth = stopping.Width > 0.0 ? stopping.Width / 2.0 : stopping.Relative;
  rule.Level = stopping.Level;
  rule.MinCount = stopping.MinRuns;
  rule.MaxPositions = stopping.MaxRuns;
  return rule;
}

void CSequentialRunPlan::SkipKnown(SState& state) const {
  while (state.Next < state.IsKnown.size() && state.IsKnown[state.Next]) {
    ++state.Next;
  }
}

std::optional<SPlannedRun> CSequentialRunPlan::Next() {
  while (!m_returned.empty()) {
    const SPlannedRun run = m_returned.back();
    m_returned.pop_back();
    if (m_states[run.Combination].IsOpen()) {
      return run;
    }
  }
  SState* best = nullptr;
  for (SState& state : m_states) {
    const bool isWanted = state.IsOpen() && state.Next < state.Mean.EstimateNumPositions();
    if (isWanted && (best == nullptr || state.Next < best->Next)) {
      best = &state;
    }
  }
  if (best == nullptr) {
    return std::nullopt;
  }
  SPlannedRun run;
  run.Combination = static_cast<size_t>(best - m_states.data());
  run.Seed = m_stopping.FirstSeed + static_cast<UInt32>(best->Next);
  ARGOS_ASSERT(best->Next < best->IsKnown.size(),
               "seed number " << best->Next << " is beyond the limit of runs");
  best->IsKnown[best->Next] = true;
  SkipKnown(*best);
  return run;
}

Real CSequentialRunPlan::FindValue(const SRunResult& result) const {
  if (result.Status == ERunStatus::Done || result.Status == ERunStatus::RobotsStopped) {
    for (const SMetricValue& metric : result.Metrics) {
      if (metric.Name == m_stopping.Metric) {
        return ToMeasure(metric.Value);
      }
    }
  }
  return kMissing;
}

std::vector<TFinishedRun> CSequentialRunPlan::Finish(const SPlannedRun& run, SRunResult result) {
  ARGOS_ASSERT(run.Combination < m_states.size() && run.Seed >= m_stopping.FirstSeed,
               "a run of combination number " << run.Combination << " with seed " << run.Seed
                                              << " that was not planned has ended");
  SState& state = m_states[run.Combination];
  state.Waiting.emplace(run.Seed - size_t(m_stopping.FirstSeed),
                        TFinishedRun(run, std::move(result)));
  std::vector<TFinishedRun> stored;
  while (state.IsOpen()) {
    const auto next = state.Waiting.find(state.Mean.GetNumPositions());
    if (next == state.Waiting.end()) {
      return stored;
    }
    state.Mean.Insert(next->first, FindValue(next->second.second));
    stored.push_back(std::move(next->second));
    state.Waiting.erase(next);
  }
  state.Waiting.clear();
  return stored;
}

UInt64 CSequentialRunPlan::CountOpen() const {
  UInt64 open = 0;
  for (const SState& state : m_states) {
    open += state.Mean.EstimateNumPositions() - state.Mean.GetNumPositions();
  }
  return open;
}

size_t CSequentialRunPlan::CountCompleteCombinations() const {
  return static_cast<size_t>(std::ranges::count(m_states, false, &SState::IsOpen));
}

}  // namespace argos
