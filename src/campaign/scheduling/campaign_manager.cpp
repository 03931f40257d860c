#include <argos3/campaign/scheduling/campaign_manager.h>

#include <argos3/campaign/execution/run_messages.h>
#include <argos3/campaign/store/failed_runs.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <limits>

namespace fs = std::filesystem;

namespace argos {

namespace {

// a worker whose runs are shorter gets the next one before it has finished the last: it does not
// wait for this process
constexpr Real kShortRun = 0.1;  // s
constexpr size_t kMaxRunsOfWorker = 2;
constexpr UInt32 kMaxDeaths = 5;  // deaths of workers without any result in between
constexpr UInt32 kMaxDeathsOfRun = 2;

std::string GetMachine() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::string FormatStart(Real secondsAgo) {
  const auto time = std::chrono::system_clock::now() -
                    std::chrono::duration_cast<std::chrono::system_clock::duration>(
                        std::chrono::duration<Real>(secondsAgo));
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

std::map<std::string, size_t> IndexCombinations(const SCampaign& campaign) {
  std::map<std::string, size_t> indices;
  for (size_t i = 0; i < campaign.Combinations.size(); ++i) {
    indices.emplace(campaign.Combinations[i].ComputeKey(), i);
  }
  return indices;
}

bool IsGood(ERunStatus status) {
  return status == ERunStatus::Done;
}

}  // namespace

bool IsRepeated(ERunStatus status) {
  return status != ERunStatus::Done && status != ERunStatus::RobotsStopped;
}

std::vector<SKnownRun> ListKnownRuns(const SCampaign& campaign, const CResultStore& store,
                                     EFailedRuns failed) {
  const std::map<std::string, size_t> indices = IndexCombinations(campaign);
  std::map<UInt32, size_t> indexOf;  // indexed by id in the store
  for (const SStoredCombination& stored : store.ListCombinations()) {
    const auto place = indices.find(stored.Key);
    if (place != indices.end()) {
      indexOf.emplace(stored.Id, place->second);
    }
  }
  std::map<std::pair<UInt32, UInt32>, Real> values;
  if (!campaign.Stopping.Metric.empty()) {
    for (const CResultStore::SValue& value : store.ReadMetric(campaign.Stopping.Metric)) {
      values[{value.Combination, value.Seed}] = value.Value;
    }
  }
  std::vector<SKnownRun> known;
  for (const SStoredRun& run : store.ListRuns()) {
    const auto index = indexOf.find(run.Combination);
    const bool isKnown = failed == EFailedRuns::Known || !IsRepeated(run.Result.Status);
    if (index != indexOf.end() && isKnown) {
      const auto value = values.find({run.Combination, run.Seed});
      known.push_back(
          {index->second, run.Seed,
           value == values.end() ? std::numeric_limits<Real>::quiet_NaN() : value->second});
    }
  }
  return known;
}

SRunSetup MakeRunSetup(const SCampaign& campaign) {
  SRunSetup setup;
  setup.ExperimentFile = fs::absolute(campaign.ExperimentFile).string();
  setup.ExperimentText = campaign.ExperimentSource;
  setup.Constants = campaign.Constants;
  setup.StartFolder = fs::current_path().string();
  setup.Threads = campaign.Threads;
  setup.Metrics = campaign.Metrics;
  setup.Limits = campaign.Limits;
  setup.Isolation = campaign.Isolation;
  setup.Kept = campaign.Kept;
  return setup;
}

CCampaignManager::CCampaignManager(const SCampaign& campaign, CResultStore& store, CRunPlan& plan,
                                   UInt64 known, const SOptions& options)
    : m_campaign(campaign),
      m_store(store),
      m_plan(plan),
      m_options(options),
      m_setup(MakeRunSetup(campaign)),
      m_runsFolder(
          fs::absolute(fs::path(campaign.ResultsFile).replace_extension(".runs")).string()),
      m_machine(GetMachine()),
      m_numKnown(known),
      m_watch(campaign) {
  m_setup.HasLiveViews = options.HasLiveViews;
  for (const SCombination& combination : campaign.Combinations) {
    m_idOf.push_back(store.GetCombinationId(combination.ComputeKey()));
  }
}

SCampaignEnd CCampaignManager::Run() {
  m_start = TClock::now();
  m_stops = std::make_unique<CStopSignalCount>();
  m_line = std::make_unique<CCampaignProgressLine>(m_options.IsQuiet);
  fs::create_directories(m_runsFolder);
  try {
    Loop();
  } catch (...) {
    m_workers.clear();
    Store();
    throw;
  }
  m_workers.clear();
  Store();
  m_store.ThrowIfRemoved();
  // a folder that is not empty stays
  rmdir(m_runsFolder.c_str());
  m_end.OpenRuns = m_plan.CountOpen();
  m_end.Signal = m_stops->GetSignal();
  m_line->Finish(GetProgress());
  WarnOfMissingMetrics(true);
  m_line.reset();
  m_stops.reset();
  return m_end;
}

void CCampaignManager::Loop() {
  m_workers.resize(m_options.Jobs);
  for (;;) {
    NoteStops();
    if (m_numStops > 1) {
      return;
    }
    Dispatch();
    if (IsIdle()) {
      return;
    }
    Wait();
    for (SWorker& worker : m_workers) {
      if (!worker.Runs.empty()) {
        Receive(worker);
      }
    }
    StoreIfDue();
    m_store.ThrowIfRemoved();
    WarnOfMissingMetrics(false);
    m_line->Update(GetProgress());
  }
}

void CCampaignManager::NoteStops() {
  const int count = m_stops->GetCount();
  if (count > 0 && m_numStops == 0) {
    m_line->Print("stopping: runs that have begun are finished; press Ctrl-C again to kill them");
  }
  m_numStops = count;
}

void CCampaignManager::WarnOfMissingMetrics(bool isEnd) {
  const std::string warning = m_watch.TakeWarning(isEnd);
  if (!warning.empty()) {
    m_line->Print("[WARNING] " + warning);
  }
}

// Of the first run that has ended by itself only. What runs print is seldom read, and an attribute
// that nothing uses may change all results.
void CCampaignManager::RepeatWarnings(const SRunResult& result) {
  size_t left = 10;
  for (const std::string& warning : result.Warnings) {
    if (left > 0 && warning.find("not used by anything") != std::string::npos) {
      m_line->Print(warning);
      --left;
    }
  }
}

// often all others will fail for the same reason
void CCampaignManager::WarnOfFirstFailure(const SPlannedRun& run, const SRunResult& result) {
  const std::string message = FindErrorMessage(result.Error.empty() ? result.Log : result.Error);
  m_line->Print(fmt::format("[WARNING] a run has failed: {}seed={}: {}{}; the others go on",
                            DescribeLevels(m_campaign, m_campaign.Combinations[run.Combination]),
                            run.Seed, ToText(result.Status),
                            message.empty() ? "" : ": " + message));
}

bool CCampaignManager::IsIdle() const {
  return std::ranges::all_of(m_workers, std::ranges::empty, &SWorker::Runs);
}

bool CCampaignManager::AreRunsShort() const {
  return m_numResults > 0 && m_totalTime / static_cast<Real>(m_numResults) < kShortRun;
}

void CCampaignManager::Dispatch() {
  if (m_numStops > 0) {
    return;
  }
  const size_t most = AreRunsShort() ? kMaxRunsOfWorker : 1;
  // idle workers first
  for (size_t count = 0; count < most; ++count) {
    for (SWorker& worker : m_workers) {
      if (worker.Runs.size() == count && !DispatchOne(worker)) {
        return;
      }
    }
  }
}

// @return false if there is no run now
bool CCampaignManager::DispatchOne(SWorker& worker) {
  const std::optional<SPlannedRun> run = m_plan.Next();
  if (!run) {
    return false;
  }
  ARGOS_ASSERT(run->Combination < m_idOf.size(), "a run of combination number "
                                                     << run->Combination << " of " << m_idOf.size()
                                                     << " is planned");
  SRunRequest request;
  request.Id = ++m_lastRequest;
  request.Seed = run->Seed;
  request.Settings = m_campaign.Combinations[run->Combination].Settings;
  request.Folder =
      fmt::format("{}/combination_{}_seed_{}", m_runsFolder, m_idOf[run->Combination], run->Seed);
  const std::string bytes = EncodeRequest(request);
  if (!worker.Runs.empty() && bytes.size() > CWorkerProcess::kMaxWaitingRequest) {
    m_plan.Return(*run);
    return false;
  }
  if (worker.Process == nullptr) {
    worker.Process = std::make_unique<CWorkerProcess>(m_setup);
  }
  ARGOS_ASSERT(worker.Runs.size() < kMaxRunsOfWorker, "a worker has too many runs");
  worker.Runs.emplace_back(request.Id, *run);
  // if it has died, receiving its results notices that
  worker.Process->Send(bytes);
  return true;
}

void CCampaignManager::Wait() {
  std::vector<pollfd> files;
  for (const SWorker& worker : m_workers) {
    if (!worker.Runs.empty()) {
      ARGOS_ASSERT(worker.Process != nullptr, "a run was given to a worker without a process");
      files.push_back({worker.Process->GetFile(), POLLIN, 0});
    }
  }
  constexpr int kPeriod = static_cast<int>(kStoringPeriod.count());
  m_stops->Poll(files, kPeriod);
}

void CCampaignManager::Receive(SWorker& worker) {
  ARGOS_ASSERT(worker.Process != nullptr, "a worker without a process has no results");
  std::vector<std::pair<UInt64, SRunResult>> results;
  const bool isAlive = worker.Process->Receive(results);
  for (auto& [id, result] : results) {
    if (worker.Runs.empty() || worker.Runs.front().first != id) {
      THROW_ARGOSEXCEPTION("a worker sent the result of a run that it was not asked for");
    }
    const SPlannedRun run = worker.Runs.front().second;
    worker.Runs.pop_front();
    m_numDeaths = 0;
    if (m_stops->GetCount() > 0 && result.Status == ERunStatus::Crashed &&
        result.Signal == SIGKILL) {
      // killed by what has stopped the campaign, such as a batch system, so not by its fault
      m_plan.Return(run);
      continue;
    }
    m_totalTime += result.TotalWallTime;
    ++m_numResults;
    Finish(run, std::move(result));
  }
  if (!isAlive) {
    ReplaceDead(worker);
  }
}

void CCampaignManager::ReplaceDead(SWorker& worker) {
  const std::string death = worker.Process->AwaitDeath();
  worker.Process.reset();
  std::deque<std::pair<UInt64, SPlannedRun>> runs;
  runs.swap(worker.Runs);
  m_line->Print("[WARNING] a worker process has died: " + death + "; another one replaces it");
  if (++m_numDeaths >= kMaxDeaths) {
    THROW_ARGOSEXCEPTION(m_numDeaths << " worker processes have died one after another, the last "
                                        "one by "
                                     << death
                                     << ": perhaps a library crashes while it is loaded, or the "
                                        "system is out of memory");
  }
  // the first one was executed
  for (size_t i = runs.size(); i-- > 1;) {
    m_plan.Return(runs[i].second);
  }
  if (runs.empty()) {
    return;
  }
  const SPlannedRun run = runs.front().second;
  if (++m_deathsOf[{run.Combination, run.Seed}] < kMaxDeathsOfRun) {
    m_plan.Return(run);
    return;
  }
  SRunResult result;
  result.Status = ERunStatus::Crashed;
  result.Log = fmt::format(
      "[FATAL] {} worker processes died while they executed this run, the "
      "last one by {}\n",
      kMaxDeathsOfRun, death);
  result.LogBytes = result.Log.size();
  Finish(run, std::move(result));
}

void CCampaignManager::Finish(const SPlannedRun& finished, SRunResult result) {
  for (auto& [run, stored] : m_plan.Finish(finished, std::move(result))) {
    if (m_unstored.empty()) {
      m_unstoredSince = TClock::now();
    }
    ++m_end.Runs;
    m_end.FailedRuns += IsGood(stored.Status) ? 0 : 1;
    m_watch.Note(stored);
    if (m_repeatsWarnings && stored.Status != ERunStatus::Crashed &&
        stored.Status != ERunStatus::TimedOut) {
      m_repeatsWarnings = false;
      RepeatWarnings(stored);
    }
    if (m_end.FailedRuns == 1 && !IsGood(stored.Status)) {
      WarnOfFirstFailure(run, stored);
    }
    SStoredRun& entry = m_unstored.emplace_back();
    ARGOS_ASSERT(run.Combination < m_idOf.size(), "a run of combination number "
                                                      << run.Combination << " of " << m_idOf.size()
                                                      << " has ended");
    entry.Combination = m_idOf[run.Combination];
    entry.Seed = run.Seed;
    entry.Started = FormatStart(stored.TotalWallTime);
    entry.Machine = m_machine;
    entry.Version = ARGOS_VERSION "-" ARGOS_RELEASE;
    entry.Result = std::move(stored);
  }
}

void CCampaignManager::StoreIfDue() {
  if (m_unstored.size() >= kStoringCount ||
      (!m_unstored.empty() && TClock::now() - m_unstoredSince >= kStoringPeriod)) {
    Store();
  }
}

void CCampaignManager::Store() {
  if (!m_unstored.empty()) {
    m_store.Add(m_unstored);
    m_unstored.clear();
  }
}

SCampaignProgress CCampaignManager::GetProgress() const {
  SCampaignProgress progress;
  progress.Combinations = m_campaign.Combinations.size();
  progress.CompleteCombinations = m_plan.CountCompleteCombinations();
  progress.KnownRuns = m_numKnown;
  progress.Runs = m_end.Runs;
  progress.FailedRuns = m_end.FailedRuns;
  progress.OpenRuns = m_plan.CountOpen();
  progress.WallSeconds = std::chrono::duration<Real>(TClock::now() - m_start).count();
  return progress;
}

}  // namespace argos
