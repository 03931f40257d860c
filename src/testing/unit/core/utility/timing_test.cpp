#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/core/utility/rate.h>
#include <argos3/core/utility/signal_processing.h>
#include <argos3/core/utility/string_utilities.h>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

namespace timing_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

std::string FileName(const std::string& what) {
  return "timing_test_" + what + "." + std::to_string(getpid());
}

std::vector<std::string> Lines(const std::string& name) {
  std::ifstream file(name);
  std::stringstream content;
  content << file.rdbuf();
  std::vector<std::string> lines;
  Tokenize(content.str(), lines, "\n");
  return lines;
}

}  // namespace

// rate

TEST_CASE("rate: a round lasts as long as the rate requires", "[core][rate]") {
  CRate rate(100.0);
  CHECK(rate.GetRate() == 100.0);
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 5; ++i) {
    rate.Sleep();
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  // never too early, except for the time between the constructor and the start of this clock
  CHECK(elapsed.count() >= 0.049);
  rate.SetRate(1000.0);
  CHECK(rate.GetRate() == 1000.0);
}

TEST_CASE("rate: the elapsed time counts from the start of the round", "[core][rate]") {
  CRate rate(1000.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(rate.ElapsedUS() >= 20000);
  CHECK(rate.ElapsedS() >= 0.02);
  // the round is over already: Sleep() returns at once and starts a new round
  rate.Sleep();
  CHECK(rate.ElapsedS() < 0.02);
}

TEST_CASE("rate: it must be positive", "[core][rate]") {
  CHECK_THROWS_WITH(CRate(0.0), Contains("The rate is 0 rounds per second, expected a number > 0"));
  CRate rate(1.0);
  CHECK_THROWS_AS(rate.SetRate(-1.0), CARGoSException);
  CHECK_THROWS_AS(rate.SetRate(std::numeric_limits<Real>::infinity()), CARGoSException);
  CHECK(rate.GetRate() == 1.0);
}

// signals

TEST_CASE("stats: mean and sample variance", "[core][signal]") {
  CStats stats;
  CHECK(stats.GetMean() == 0.0);
  CHECK(stats.GetVariance() == 0.0);
  stats.Append(7.0);
  CHECK(stats.GetMean() == 7.0);
  CHECK(stats.GetStdDev() == 0.0);
  CStats several;
  for (const Real value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) {
    several.Append(value);
  }
  // mean 40 / 8 = 5, squares of differences 9 + 1 + 1 + 1 + 0 + 0 + 4 + 16 = 32; a few roundings
  CHECK_THAT(several.GetMean(), WithinAbs(5.0, 1e-14));
  CHECK_THAT(several.GetVariance(), WithinAbs(32.0 / 7.0, 1e-13));
  CHECK_THAT(several.GetStdDev(), WithinAbs(std::sqrt(32.0 / 7.0), 1e-13));
}

TEST_CASE("stats: the variance is accurate for a large mean", "[core][signal]") {
  CStats stats;
  for (const Real value : {1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16}) {
    stats.Append(value);
  }
  // squares of differences from 1e9 + 10: 36 + 9 + 9 + 36 = 90; roundings at 1e9 are 1e-7 each
  CHECK_THAT(stats.GetVariance(), WithinAbs(30.0, 1e-5));
}

TEST_CASE("low-pass filter: output follows its recurrence", "[core][signal]") {
  CRCLowPassFilter filter(0.75);
  CHECK(filter.Filter(8.0) == 8.0);
  // 0 + 0.75 * 8 = 6, 2 + 0.75 * (6 - 2) = 5: all exact in binary
  CHECK(filter.Filter(0.0) == 6.0);
  CHECK(filter.Filter(2.0) == 5.0);
  filter.Reset();
  CHECK(filter.Filter(1.0) == 1.0);
}

// profiler

TEST_CASE("profiler: the report has the wall time, the phases and the threads",
          "[core][profiler]") {
  const std::string name = FileName("report");
  CProfiler profiler(name, "human_readable");
  profiler.Start();
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::thread([&profiler] { profiler.CollectThreadResourceUsage(); }).join();
  profiler.AddPhase("act", 0.25, 2);
  profiler.AddPhase("idle", 0.0, 0);
  profiler.Stop();
  CHECK(profiler.GetWallTime() >= 0.010);
  profiler.Flush();
  const std::vector<std::string> lines = Lines(name);
  REQUIRE(lines.size() == 11);
  CHECK(lines[0] == fmt::format("wall time (s)                 {:.6f}", profiler.GetWallTime()));
  CHECK_THAT(lines[8], Catch::StartsWith("phase \"act\": 0.250000 s, "));
  CHECK_THAT(lines[8], Catch::EndsWith(", 2 times, 125000.000000 us each"));
  CHECK_THAT(lines[9], Catch::StartsWith("phase \"idle\": 0.000000 s, "));
  CHECK_THAT(lines[9], Catch::EndsWith(", 0 times, 0.000000 us each"));
  CHECK_THAT(lines[10], Contains("thread 0: "));
  std::remove(name.c_str());
}

TEST_CASE("profiler: each run adds a line to the table", "[core][profiler]") {
  const std::string name = FileName("table");
  std::remove(name.c_str());
  for (int run = 0; run < 2; ++run) {
    CProfiler profiler(name, "table", false);
    profiler.Start();
    profiler.AddPhase("act", 0.5, 1);
    profiler.Stop();
    profiler.Flush();
  }
  std::vector<std::string> lines = Lines(name);
  REQUIRE(lines.size() == 3);
  for (const std::string& line : lines) {
    std::vector<std::string> fields;
    Tokenize(line, fields, "\t");
    CHECK(fields.size() == 9);
  }
  CHECK_THAT(lines[0], Catch::StartsWith("wall_s\tuser_s"));
  CHECK_THAT(lines[0], Catch::EndsWith("\tact_s"));
  CHECK_THAT(lines[1], Catch::EndsWith("\t0.500000"));
  // truncating starts a new table
  CProfiler(name, "table", true).Flush();
  CHECK(Lines(name).size() == 2);
  std::remove(name.c_str());
}

TEST_CASE("profiler: errors are reported before the run", "[core][profiler]") {
  CHECK_THROWS_WITH(CProfiler("x", "csv"),
                    Contains("format \"csv\", expected \"human_readable\" or \"table\""));
  CHECK_THROWS_WITH(CProfiler("/no/such/folder/x", "table"),
                    Contains("cannot write the file \"/no/such/folder/x\": there is no folder"));
}

}  // namespace timing_test
