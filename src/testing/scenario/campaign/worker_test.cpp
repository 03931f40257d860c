// Runs in worker processes, without a database.

#include "../command_line/program_run.h"
#include "campaign_world.h"

#include <argos3/campaign/execution/run_messages.h>
#include <argos3/campaign/execution/worker_process.h>

#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <ext/stdio_sync_filebuf.h>
#include <poll.h>
#include <sys/stat.h>

#include <array>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <map>

namespace worker_test {

using namespace argos;
using Catch::Contains;

namespace {

constexpr int kPatience = 120'000;  // ms

SRunSetup MakeSetup(const CTestFolder& folder, const std::string& what, EIsolation isolation) {
  SRunSetup setup;
  setup.ExperimentFile = folder.Path("experiment.argos");
  setup.ExperimentText = MakeCampaignExperiment(what, 2);
  setup.StartFolder = folder.Path(".");
  setup.Isolation = isolation;
  return setup;
}

// replaces the attributes of the loop functions
void SetLoopFunctions(SRunSetup& setup, const std::string& attributes) {
  const std::string gain = "gain=\"1\"";
  setup.ExperimentText.replace(setup.ExperimentText.find(gain), gain.size(), attributes);
}

constexpr std::array kReductions = {
    SCollectedMetric::EReduction::Last, SCollectedMetric::EReduction::Mean,
    SCollectedMetric::EReduction::Sum, SCollectedMetric::EReduction::Min,
    SCollectedMetric::EReduction::Max};

void CollectReductions(SRunSetup& setup, const std::string& name) {
  for (const auto reduction : kReductions) {
    SCollectedMetric& metric = setup.Metrics.emplace_back();
    metric.Name = name;
    metric.Reduction = reduction;
  }
}

SCollectedMetric& CollectSeries(SRunSetup& setup, const std::string& name) {
  SCollectedMetric& series = setup.Metrics.emplace_back();
  series.Name = name;
  series.IsSeries = true;
  return series;
}

// of a metric whose reductions were collected first
void CheckReductions(const SRunResult& result,
                     const std::array<Real, kReductions.size()>& expected) {
  for (size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(i);
    CHECK(result.Metrics.at(i).Value == expected[i]);
  }
}

/*
 * What the driver of tests has redirected for its own purposes goes to the standard streams during
 * the lifetime of this object, and crashes have their default action, as in the program.
 */
class CProgramSurroundings {
 public:
  CProgramSurroundings()
      : m_outBuffer(LOG.GetStream().rdbuf(&m_out)), m_errBuffer(LOGERR.GetStream().rdbuf(&m_err)) {
    for (size_t i = 0; i < kSignals.size(); ++i) {
      struct sigaction action {};
      action.sa_handler = SIG_DFL;
      sigaction(kSignals[i], &action, &m_actions[i]);
    }
  }
  ~CProgramSurroundings() {
    LOG.GetStream().rdbuf(m_outBuffer);
    LOGERR.GetStream().rdbuf(m_errBuffer);
    for (size_t i = 0; i < kSignals.size(); ++i) {
      sigaction(kSignals[i], &m_actions[i], nullptr);
    }
  }
  CProgramSurroundings(const CProgramSurroundings&) = delete;
  CProgramSurroundings& operator=(const CProgramSurroundings&) = delete;

 private:
  static constexpr std::array<int, 6> kSignals = {SIGSEGV, SIGBUS,  SIGFPE,
                                                  SIGILL,  SIGABRT, SIGTERM};

  __gnu_cxx::stdio_sync_filebuf<char> m_out{stdout};
  __gnu_cxx::stdio_sync_filebuf<char> m_err{stderr};
  std::streambuf* m_outBuffer;
  std::streambuf* m_errBuffer;
  std::array<struct sigaction, kSignals.size()> m_actions{};
};

/* Executes runs with these seeds, and returns their results in the same order. */
std::vector<SRunResult> Execute(const CTestFolder& folder, const SRunSetup& setup,
                                const std::vector<UInt32>& seeds) {
  std::signal(SIGPIPE, SIG_IGN);
  const CProgramSurroundings surroundings;
  CWorkerProcess worker(setup);
  std::vector<std::pair<UInt64, SRunResult>> results;
  for (const UInt32 seed : seeds) {
    SRunRequest request;
    request.Id = 1000 + seed;
    request.Seed = seed;
    request.Folder = folder.Path("run" + std::to_string(seed));
    worker.Send(EncodeRequest(request));
  }
  while (results.size() < seeds.size()) {
    pollfd file{worker.GetFile(), POLLIN, 0};
    REQUIRE(poll(&file, 1, kPatience) == 1);
    REQUIRE(worker.Receive(results));
  }
  std::vector<SRunResult> ordered;
  for (size_t i = 0; i < seeds.size(); ++i) {
    CHECK(results[i].first == 1000 + seeds[i]);
    ordered.push_back(results[i].second);
  }
  return ordered;
}

void CheckIsDone(const SRunResult& result) {
  INFO(result.Log);
  CHECK(result.Status == ERunStatus::Done);
  CHECK(result.ExitStatus == 0);
  CHECK(result.Signal == 0);
  CHECK(result.Ticks == 10);
  CHECK(result.Robots == 2);
  CHECK(result.Metrics.size() == 2);
}

}  // namespace

TEST_CASE("worker: a run equals that of the program", "[campaign][execution]") {
  const EIsolation isolation = GENERATE(EIsolation::OwnProcess, EIsolation::SharedProcess);
  const CTestFolder folder;
  const SRunSetup setup = MakeSetup(folder, "", isolation);
  folder.Write("experiment.argos", setup.ExperimentText);
  const std::vector<SRunResult> results = Execute(folder, setup, {5, 6, 5});
  for (const SRunResult& result : results) {
    CheckIsDone(result);
    CHECK(result.StartUpTime > 0.0);
    CHECK(result.WallTime > 0.0);
    CHECK(result.CPUTime > 0.0);
    CHECK(result.TotalWallTime >= result.StartUpTime + result.WallTime);
    // a process with the simulator's libraries
    CHECK(result.PeakMemory > 5'000'000);
    CHECK_THAT(result.Log, Contains("Using random seed = "));
    CHECK(result.LogBytes == result.Log.size());
  }
  CHECK(results[0].Digest == results[2].Digest);
  CHECK(results[0].Digest != results[1].Digest);
  const SProgramRun program =
      folder.Run({"-zc", "experiment.argos", "--seed", "5", "--threads", "0", "--digest"});
  char digest[17];
  std::snprintf(digest, sizeof(digest), "%016llx",
                static_cast<unsigned long long>(results[0].Digest));
  CHECK_THAT(program.Out, Contains(std::string("digest: ") + digest));
  CHECK(results[0].Metrics[0].Name == "level");
  CHECK(results[0].Metrics[0].Unit == "m");
  CHECK(results[0].Metrics[0].Value != results[1].Metrics[0].Value);
  CHECK(results[0].Metrics[1].Value == 10.0);
}

TEST_CASE("worker: the run that fails is known, and no other one is touched",
          "[campaign][execution]") {
  const EIsolation isolation = GENERATE(EIsolation::OwnProcess, EIsolation::SharedProcess);
  const auto [what, status, text] = GENERATE(table<std::string, ERunStatus, std::string>(
      {{"crash", ERunStatus::Crashed, "robot \"fb1\", controller \"c\": ControlStep() in tick 3"},
       {"hang", ERunStatus::TimedOut, "limit of wall time"},
       {"eat", ERunStatus::OutOfMemory, "not enough memory"},
       {"exit", ERunStatus::Failed, "exit status 7"},
       {"throw", ERunStatus::Failed, "robot \"fb1\""}}));
  CAPTURE(what, static_cast<int>(isolation));
  if (what == "eat" && !kCanLimitMemory) {
    WARN("skipped: a sanitizer leaves no room for a limit of memory");
    return;
  }
  const CTestFolder folder;
  SRunSetup setup = MakeSetup(folder, what, isolation);
  setup.Limits.WallTime = 5.0;
  if (what == "eat") {
    setup.Limits.Memory = UInt64(1) << 29;
  }
  const std::vector<SRunResult> results = Execute(folder, setup, {1, 2, 3});
  CheckIsDone(results[0]);
  INFO(results[1].Log);
  CHECK(results[1].Status == status);
  CHECK_THAT(results[1].Log, Contains(text));
  CHECK(results[1].Signal == (what == "crash" ? SIGSEGV : what == "hang" ? SIGKILL : 0));
  CheckIsDone(results[2]);
  const std::vector<SRunResult> alone = Execute(folder, setup, {3});
  CHECK(alone[0].Digest == results[2].Digest);
}

TEST_CASE("worker: a run whose code forks has one result", "[campaign][execution]") {
  const EIsolation isolation = GENERATE(EIsolation::OwnProcess, EIsolation::SharedProcess);
  // the result is that of the process that the worker has started, though its fork ends before
  const std::string what = GENERATE(as<std::string>{}, "fork", "fork_fails");
  CAPTURE(static_cast<int>(isolation), what);
  const CTestFolder folder;
  const std::vector<SRunResult> results =
      Execute(folder, MakeSetup(folder, what, isolation), {1, 2, 3, 4});
  const std::vector<SRunResult> plain =
      Execute(folder, MakeSetup(folder, "", isolation), {1, 2, 3, 4});
  for (size_t i = 0; i < results.size(); ++i) {
    CAPTURE(i);
    CheckIsDone(results[i]);
    CHECK(results[i].Digest == plain[i].Digest);
    CHECK(results[i].Metrics.at(0).Value == plain[i].Metrics.at(0).Value);
  }
}

TEST_CASE("worker: the death of a run is noticed, though a fork of it lives",
          "[campaign][execution]") {
  const EIsolation isolation = GENERATE(EIsolation::OwnProcess, EIsolation::SharedProcess);
  const CTestFolder folder;
  const auto start = std::chrono::steady_clock::now();
  const std::vector<SRunResult> results =
      Execute(folder, MakeSetup(folder, "fork_and_exit", isolation), {1, 2, 3});
  // the fork sleeps for a minute
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(30));
  CheckIsDone(results[0]);
  CHECK(results[1].Status == ERunStatus::Failed);
  CHECK(results[1].ExitStatus == 7);
  CheckIsDone(results[2]);
}

TEST_CASE("worker: the peak of memory is that of the run", "[campaign][execution]") {
  if (!kCanLimitMemory) {
    WARN("skipped: a sanitizer keeps memory that was freed");
    return;
  }
  const EIsolation isolation = GENERATE(EIsolation::OwnProcess, EIsolation::SharedProcess);
  const CTestFolder folder;
  const std::vector<SRunResult> results =
      Execute(folder, MakeSetup(folder, "touch", isolation), {1, 2, 3});
  // 64 MiB in the second run; runs without it differ by less
  constexpr UInt64 kHalf = 32 << 20;
  CHECK(results[1].PeakMemory > results[0].PeakMemory + kHalf);
  CHECK(results[1].PeakMemory > results[2].PeakMemory + kHalf);
}

TEST_CASE("worker: helper threads and static objects see the run's simulator",
          "[campaign][execution]") {
  const EIsolation isolation = GENERATE(EIsolation::OwnProcess, EIsolation::SharedProcess);
  const CTestFolder folder;
  SRunSetup setup = MakeSetup(folder, "", isolation);
  SetLoopFunctions(setup, "uses_threads=\"true\"");
  for (const SRunResult& result : Execute(folder, setup, {1, 2})) {
    INFO(result.Log);
    REQUIRE(result.Status == ERunStatus::Done);
    std::map<std::string, Real> metrics;
    for (const SMetricValue& metric : result.Metrics) {
      metrics[metric.Name] = metric.Value;
    }
    CHECK(metrics.at("ticks") == 10.0);
    CHECK(metrics.at("thread") == 10.0);
    CHECK(metrics.at("static") == 10.0);
  }
}

TEST_CASE("worker: output is read to its end, and dropped beyond its limit",
          "[campaign][execution]") {
  const EIsolation isolation = GENERATE(EIsolation::OwnProcess, EIsolation::SharedProcess);
  const CTestFolder folder;
  SRunSetup setup = MakeSetup(folder, "print", isolation);
  setup.Limits.Output = 1 << 20;
  const std::vector<SRunResult> results = Execute(folder, setup, {1, 2, 3});
  CheckIsDone(results[1]);
  CHECK(results[1].LogBytes > 64 << 20);
  CHECK(results[1].Log.size() < (17 << 10));
  CHECK_THAT(results[1].Log, Contains("bytes beyond the limit of 1048576 were dropped") &&
                                 Contains("end of the flood\n"));
  CheckIsDone(results[2]);
  CHECK(results[2].LogBytes < 4096);
}

TEST_CASE("worker: reductions, series and columns of files", "[campaign][execution]") {
  const CTestFolder folder;
  SRunSetup setup = MakeSetup(folder, "", EIsolation::OwnProcess);
  CollectReductions(setup, "ticks");
  // its number is that of the metric above
  CollectSeries(setup, "ticks").Every = 4;
  SCollectedMetric dispersion;
  dispersion.Name = "dispersion";
  dispersion.Source = SCollectedMetric::ESource::BuiltIn;
  setup.Metrics.push_back(dispersion);
  SCollectedMetric column;
  column.Name = "column";
  column.Source = SCollectedMetric::ESource::File;
  column.Pattern = "*.csv";
  column.TimeColumn = "tick";
  column.ValueColumn = "twice";
  setup.Metrics.push_back(column);
  const SRunResult result = Execute(folder, setup, {1}).at(0);
  INFO(result.Log);
  REQUIRE(result.Status == ERunStatus::Done);
  REQUIRE(result.Metrics.size() == 7);
  // of 1, 2, ..., 10
  CheckReductions(result, {10.0, 5.5, 55.0, 1.0, 10.0});
  // each robot starts 1 m from the centroid, and moves at most 0.1 m
  CHECK_THAT(result.Metrics[5].Value, Catch::WithinAbs(1.0, 0.1));
  CHECK(result.Metrics[5].Unit == "m");
  CHECK(result.Metrics[6].Value == 20.0);
  REQUIRE(result.Series.size() == 2);
  CHECK(result.Series[0].Ticks == std::vector<UInt32>{4, 8});
  CHECK(result.Series[0].Values == std::vector<Real>{4.0, 8.0});
  CHECK(result.Series[1].Ticks.size() == 10);
  CHECK(result.Series[1].Values[2] == 6.0);
  CHECK_FALSE(std::filesystem::exists(folder.Path("run1")));
}

TEST_CASE("worker: results of PostExperiment() replace the values of the last tick",
          "[campaign][execution]") {
  const CTestFolder folder;
  SRunSetup setup = MakeSetup(folder, "", EIsolation::OwnProcess);
  SetLoopFunctions(setup, "result=\"1000\"");
  CollectReductions(setup, "ticks");
  CollectSeries(setup, "ticks");
  const SRunResult result = Execute(folder, setup, {1}).at(0);
  INFO(result.Log);
  REQUIRE(result.Status == ERunStatus::Done);
  // of 1, 2, ..., 9, and 1000 in place of 10
  CheckReductions(result, {1000.0, 104.5, 1045.0, 1.0, 1000.0});
  REQUIRE(result.Series.size() == 1);
  CHECK(result.Series[0].Values == std::vector<Real>{1, 2, 3, 4, 5, 6, 7, 8, 9, 1000});
}

TEST_CASE("worker: reductions are those of the values at the ends of all ticks",
          "[campaign][execution]") {
  const CTestFolder folder;
  SRunSetup setup = MakeSetup(folder, "", EIsolation::OwnProcess);
  // recorded in ticks 4 and 8 of 10, with their numbers: no value in ticks 1 to 3, which do not
  // count, 4 at the ends of ticks 4 to 7, 8 at those of 8 to 10
  SetLoopFunctions(setup, "event_every=\"4\"");
  CollectReductions(setup, "event");
  CollectSeries(setup, "event");
  SCollectedMetric& absent = setup.Metrics.emplace_back();
  absent.Name = "absent";
  absent.Reduction = SCollectedMetric::EReduction::Sum;
  const SRunResult result = Execute(folder, setup, {1}).at(0);
  INFO(result.Log);
  REQUIRE(result.Status == ERunStatus::Done);
  CheckReductions(result, {8.0, 40.0 / 7.0, 40.0, 4.0, 8.0});
  // a series has all ticks, from the first
  REQUIRE(result.Series.size() == 1);
  CHECK(result.Series[0].Ticks == std::vector<UInt32>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  CHECK(std::isnan(result.Series[0].Values[2]));
  CHECK(result.Series[0].Values[6] == 4.0);
  CHECK(result.Metrics.size() == 6);
  CHECK(std::isnan(result.Metrics.at(5).Value));
}

TEST_CASE("worker: a run may print gigabytes", "[campaign][execution]") {
  const CTestFolder folder;
  SRunSetup setup = MakeSetup(folder, "flood", EIsolation::OwnProcess);
  setup.Limits.Output = 1 << 20;
  const std::vector<SRunResult> results = Execute(folder, setup, {2});
  CheckIsDone(results[0]);
  CHECK(results[0].LogBytes > UInt64(4) << 30);
  CHECK(results[0].Log.size() < (17 << 10));
}

TEST_CASE("worker: a missing file or column fails the run", "[campaign][execution]") {
  const auto [pattern, value, text] = GENERATE(table<std::string, std::string, std::string>(
      {{"absent.csv", "twice", "has written no file \"absent.csv\""},
       {"table.csv", "twise", "has no column \"twise\"; did you mean \"twice\"?"}}));
  const CTestFolder folder;
  SRunSetup setup = MakeSetup(folder, "", EIsolation::OwnProcess);
  SCollectedMetric column;
  column.Name = "column";
  column.Source = SCollectedMetric::ESource::File;
  column.Pattern = pattern;
  column.ValueColumn = value;
  setup.Metrics.push_back(column);
  const SRunResult result = Execute(folder, setup, {1}).at(0);
  CHECK(result.Status == ERunStatus::Failed);
  CHECK_THAT(result.Log, Contains(text));
}

TEST_CASE("worker: files of runs are kept as asked for", "[campaign][execution]") {
  const CTestFolder folder;
  SRunSetup setup = MakeSetup(folder, "throw", EIsolation::OwnProcess);
  const auto [kept, good, failed] =
      GENERATE(table<EKeptFiles, bool, bool>({{EKeptFiles::None, false, false},
                                              {EKeptFiles::Failed, false, true},
                                              {EKeptFiles::All, true, true}}));
  setup.Kept = kept;
  Execute(folder, setup, {1, 2});
  CHECK(std::filesystem::exists(folder.Path("run1/table.csv")) == good);
  CHECK(std::filesystem::exists(folder.Path("run2/table.csv")) == failed);
}

TEST_CASE("worker: a closed request pipe aborts the run", "[campaign][execution]") {
  const CTestFolder folder;
  const SRunSetup setup = MakeSetup(folder, "hang", EIsolation::OwnProcess);
  const auto start = std::chrono::steady_clock::now();
  {
    CWorkerProcess worker(setup);
    SRunRequest request;
    request.Seed = 2;
    request.Folder = folder.Path("run2");
    worker.Send(EncodeRequest(request));
    // the folder appears when the run begins
    while (!std::filesystem::exists(request.Folder)) {
      REQUIRE(std::chrono::steady_clock::now() - start < std::chrono::milliseconds(kPatience));
      poll(nullptr, 0, 1);
    }
  }
  // the run would hang for ever
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
  CHECK_FALSE(std::filesystem::exists(folder.Path("run2")));
}

}  // namespace worker_test
