#ifndef ARGOS3_CAMPAIGN_SCHEDULING_CAMPAIGN_MANAGER_H
#define ARGOS3_CAMPAIGN_SCHEDULING_CAMPAIGN_MANAGER_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/execution/run_request.h>
#include <argos3/campaign/execution/worker_process.h>
#include <argos3/campaign/scheduling/campaign_progress.h>
#include <argos3/campaign/scheduling/metric_watch.h>
#include <argos3/campaign/scheduling/run_plan.h>
#include <argos3/campaign/scheduling/stop_signals.h>
#include <argos3/campaign/store/result_store.h>

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace argos {

/** How the runs of a plan have ended. */
struct SCampaignEnd {
  UInt64 Runs = 0; /**< stored now */
  UInt64 FailedRuns = 0; /**< number of them that were not done */
  UInt64 OpenRuns = 0; /**< runs without result, because the campaign was stopped */
  int Signal = 0; /**< signal that has stopped it; 0: none */
};

/** Whether runs that have failed need not be executed again. */
enum class EFailedRuns { Known, Repeated };

/** True for what `retry` repeats: all but done, and robots_stopped. */
bool IsRepeated(ERunStatus status);

/** @return the known runs of a campaign: in the store, of the newest generation. */
std::vector<SKnownRun> ListKnownRuns(const SCampaign& campaign, const CResultStore& store,
                                     EFailedRuns failed = EFailedRuns::Known);

/** @return the setup of a campaign's runs. */
SRunSetup MakeRunSetup(const SCampaign& campaign);

/**
 * Executes a plan with worker processes, and stores the results.
 *
 * One thread, which must be the only one of the process, and one loop: it sends requests, receives
 * results and stores them, at most kStoringPeriod or kStoringCount runs after they have arrived.
 * The first SIGINT or SIGTERM ends the giving out of runs: those that are executed now are finished
 * and stored. A second one kills them.
 *
 * A worker that dies, as it may when the system runs out of memory, is replaced and its runs are
 * given out again; a run that was executed by two workers when they died is stored as crashed.
 */
class CCampaignManager {
 public:
  struct SOptions {
    UInt32 Jobs = 1; /**< worker processes */
    bool IsQuiet = false; /**< no progress */
    bool HasLiveViews = false; /**< of the runs */
  };
  static constexpr std::chrono::milliseconds kStoringPeriod{200};
  static constexpr size_t kStoringCount = 64;

  /**
   * @param known  number of runs in the store, for the progress.
   * The other arguments must outlive this object.
   */
  CCampaignManager(const SCampaign& campaign, CResultStore& store, CRunPlan& plan, UInt64 known,
                   const SOptions& options);

  /** @throws CARGoSException if workers cannot start, or results cannot be stored. */
  SCampaignEnd Run();

 private:
  using TClock = std::chrono::steady_clock;
  struct SWorker {
    std::unique_ptr<CWorkerProcess> Process;
    std::deque<std::pair<UInt64, SPlannedRun>> Runs;  // given out, with ids of requests, in order
  };

  void Loop();
  void Dispatch();
  bool DispatchOne(SWorker& worker);
  void Wait();
  void Receive(SWorker& worker);
  void ReplaceDead(SWorker& worker);
  void Finish(const SPlannedRun& run, SRunResult result);
  bool IsIdle() const;
  bool AreRunsShort() const;
  void Store();
  void StoreIfDue();
  void NoteStops();
  void WarnOfMissingMetrics(bool isEnd);
  void RepeatWarnings(const SRunResult& result);
  void WarnOfFirstFailure(const SPlannedRun& run, const SRunResult& result);
  SCampaignProgress GetProgress() const;

  const SCampaign& m_campaign;
  CResultStore& m_store;
  CRunPlan& m_plan;
  SOptions m_options;
  SRunSetup m_setup;
  std::string m_runsFolder;
  std::vector<UInt32> m_idOf;  // (combinations) in the store
  std::string m_machine;
  UInt64 m_numKnown;

  TClock::time_point m_start;
  std::vector<SWorker> m_workers;
  UInt64 m_lastRequest = 0;
  UInt32 m_numDeaths = 0;  // deaths of workers since the last result
  std::map<std::pair<size_t, UInt32>, UInt32> m_deathsOf;  // combination and seed
  std::vector<SStoredRun> m_unstored;
  TClock::time_point m_unstoredSince;
  bool m_repeatsWarnings = true;
  SCampaignEnd m_end;
  UInt64 m_numResults = 0;
  Real m_totalTime = 0.0;  // time of the runs, s
  int m_numStops = 0;
  std::unique_ptr<CStopSignalCount> m_stops;
  std::unique_ptr<CCampaignProgressLine> m_line;
  CMetricWatch m_watch;
};

}  // namespace argos

#endif
