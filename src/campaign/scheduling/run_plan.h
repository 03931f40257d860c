#ifndef ARGOS3_CAMPAIGN_SCHEDULING_RUN_PLAN_H
#define ARGOS3_CAMPAIGN_SCHEDULING_RUN_PLAN_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/execution/run_result.h>
#include <argos3/campaign/statistics/sequential_mean.h>

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace argos {

/** A run that is to be executed. */
struct SPlannedRun {
  size_t Combination = 0; /**< index in SCampaign::Combinations */
  UInt32 Seed = 0;
};

/** A run that need not be executed again. */
struct SKnownRun {
  size_t Combination = 0;
  UInt32 Seed = 0;
  Real Value = 0.0; /**< metric of the stopping rule; NaN: the run has failed */
};

using TFinishedRun = std::pair<SPlannedRun, SRunResult>;

/**
 * Which runs are executed, in which order.
 *
 * A repetition of all combinations comes before the next repetition, so that a campaign that is
 * stopped has about as many runs of each.
 */
class CRunPlan {
 public:
  virtual ~CRunPlan() = default;

  /** @return nothing if there is none now: sometimes only results tell whether more are needed. */
  virtual std::optional<SPlannedRun> Next() = 0;
  /** Takes back a run without result: it comes next. */
  virtual void Return(const SPlannedRun& run) = 0;
  /** Takes a result. @return the runs that are to be stored now. */
  virtual std::vector<TFinishedRun> Finish(const SPlannedRun& run, SRunResult result) = 0;
  /** Runs that have no result yet; an estimate, if results decide. */
  virtual UInt64 CountOpen() const = 0;
  /** Combinations without an open run. */
  virtual size_t CountCompleteCombinations() const = 0;

  /** The seeds or the stopping rule of the campaign, without the runs that are known. */
  static std::unique_ptr<CRunPlan> Create(const SCampaign& campaign,
                                          const std::vector<SKnownRun>& known);
};

/** A list of runs. */
class CRunListPlan : public CRunPlan {
 public:
  /** @param numCombinations  of the campaign. */
  CRunListPlan(std::vector<SPlannedRun> runs, size_t numCombinations);

  std::optional<SPlannedRun> Next() override;
  void Return(const SPlannedRun& run) override { m_runs.push_front(run); }
  std::vector<TFinishedRun> Finish(const SPlannedRun& run, SRunResult result) override;
  UInt64 CountOpen() const override { return m_numOpen; }
  size_t CountCompleteCombinations() const override { return m_numComplete; }

 private:
  std::deque<SPlannedRun> m_runs;
  std::vector<UInt64> m_openOf;  // (combinations)
  UInt64 m_numOpen;
  size_t m_numComplete = 0;
};

/**
 * Runs until the mean of a metric is known well enough, for each combination on its own.
 *
 * The rule takes runs by their seeds, and runs beyond the last that it takes are not stored, so
 * that results do not depend on the number of workers or on which run ends first.
 */
class CSequentialRunPlan : public CRunPlan {
 public:
  CSequentialRunPlan(const SCampaign& campaign, const std::vector<SKnownRun>& known);

  std::optional<SPlannedRun> Next() override;
  void Return(const SPlannedRun& run) override { m_returned.push_back(run); }
  std::vector<TFinishedRun> Finish(const SPlannedRun& run, SRunResult result) override;
  UInt64 CountOpen() const override;
  size_t CountCompleteCombinations() const override;

 private:
  struct SState {
    explicit SState(const SStoppingRule& rule) : Mean(rule) {}

    bool IsOpen() const { return Mean.GetDecision() == EStopDecision::Continue; }

    CSequentialMean Mean;
    std::vector<bool> IsKnown;  // (positions) in the store, or given out
    size_t Next = 0;  // position, not known
    std::map<size_t, TFinishedRun> Waiting;  // results behind a gap, by position
  };

  static SStoppingRule MakeRule(const SStopping& stopping);
  void SkipKnown(SState& state) const;
  Real FindValue(const SRunResult& result) const;

  SStopping m_stopping;
  std::vector<SState> m_states;  // (combinations)
  std::vector<SPlannedRun> m_returned;
};

}  // namespace argos

#endif
