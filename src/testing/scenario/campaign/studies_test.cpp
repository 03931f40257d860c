// The studies of the thesis in studies/: their campaigns are executed with tiny runs.

#include "../command_line/program_run.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace studies_test {

using namespace argos;
using Catch::Contains;

namespace {

// experiments/ has the library of the controller
void SetPluginPath() {
  setenv("ARGOS_PLUGIN_PATH",
         (InBuildTree("lib/argos3") + ":" + InBuildTree("experiments")).c_str(), 1);
}

void ReplaceOnce(std::string& text, const std::string& old, const std::string& by) {
  CAPTURE(old);
  const size_t place = text.find(old);
  REQUIRE(place != std::string::npos);
  text.replace(place, old.size(), by);
}

std::string ReadSource(const CTestFolder& folder, const std::string& path) {
  std::filesystem::copy_file(InSourceTree(path), folder.Path("source"),
                             std::filesystem::copy_options::overwrite_existing);
  return folder.Read("source");
}

// what verdicts.py prints about runs.csv
std::string Judge(const CTestFolder& folder, const std::string& runs) {
  const std::string command = "python3 " + InSourceTree("studies/efficiency/verdicts.py") + ' ' +
                              folder.Path(runs) + " > " + folder.Path("verdicts.md");
  REQUIRE(std::system(command.c_str()) == 0);
  return folder.Read("verdicts.md");
}

std::string MakeHeader() {
  return "engine,engines,threads,robots,seed,status,ticks,loop_wall_time,speedup,resident_memory,"
         "other_load,version\n";
}

// runs of a minute of a setting, with these wall times in s
std::string MakeRows(const std::string& setting, const std::vector<Real>& times, Real u) {
  std::string rows;
  for (size_t i = 0; i < times.size(); ++i) {
    rows += fmt::format("{},{},done,600,{},{},900,0.01,3.0.0-1\n", setting, i + 1, times[i], u);
  }
  return rows;
}

}  // namespace

TEST_CASE("studies: the forms of the study of efficiency have the runs that its page names",
          "[campaign][studies]") {
  SetPluginPath();
  const CTestFolder folder;
  const auto [form, runs] = GENERATE(table<std::string, std::string>(
      {{"short", "96 runs"}, {"reduced", "728 runs"}, {"full", "8400 runs"}}));
  const std::string file = InSourceTree("studies/efficiency/" + form + ".xml");
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", file, "--dry-run"});
  INFO(run.Err);
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
  CHECK_THAT(run.Out, Contains(runs));
}

TEST_CASE("studies: the short form of the study of efficiency runs", "[campaign][studies]") {
  SetPluginPath();
  const CTestFolder folder;
  std::string campaign = ReadSource(folder, "studies/efficiency/short.xml");
  ReplaceOnce(campaign, "experiment=\"", "experiment=\"" + InSourceTree("studies/efficiency/"));
  ReplaceOnce(campaign, "values=\"1, 10, 100, 1000\"", "values=\"1, 10\"");
  ReplaceOnce(campaign, "@length\" value=\"10\"", "@length\" value=\"1\"");
  ReplaceOnce(campaign, "seeds=\"2\"", "seeds=\"1\"");
  folder.Write("tiny.xml", campaign);
  const SProgramRun run = folder.RunProgram("argos3-campaign", {"run", "tiny.xml"});
  INFO(run.Out << run.Err);
  REQUIRE(run.Status == 0);
  CHECK_THAT(run.Err, Contains("24/24 runs (100 %)"));
  REQUIRE(folder.RunProgram("argos3-campaign", {"export", "tiny.xml", "--csv", "."}).Status == 0);
  const std::string verdicts = Judge(folder, "runs.csv");
  INFO(verdicts);
  CHECK_THAT(verdicts, Contains("Runs have 10 ticks instead of 600"));
  CHECK_THAT(verdicts, Contains("| E3 |") && Contains("N = 10: w(P = 2) / w(P = 0) = "));
  // one run of each setting
  CHECK_THAT(verdicts, Contains("P = 2: u = ") && Contains("[-inf, inf] | **undecided** | more"));
  CHECK_THAT(verdicts, Contains("| E14 | dynamics2d, N = 10^5 | about 800 MB | - | **not run** |"));
}

TEST_CASE("studies: verdicts compare whole intervals with the printed values",
          "[campaign][studies]") {
  const CTestFolder folder;
  folder.Write("runs.csv",
               "# argos3 campaign\n" + MakeHeader() +
                   MakeRows("dynamics2d,1,0,1000", {7.0, 7.1, 7.2, 7.3, 7.4, 7.6}, 1.0) +
                   MakeRows("dynamics2d,1,0,100000", {100, 101, 102, 103, 104, 105, 106}, 1.0) +
                   MakeRows("dynamics2d,1,16,100000", {50, 51, 52, 53, 54, 55, 500}, 2.0) +
                   MakeRows("dynamics2d,16,16,1000", {1.0, 1.01, 1.02, 1.03, 1.04, 1.05}, 3.0) +
                   MakeRows("dynamics2d,16,16,10000", {70, 71, 72, 73, 74, 75}, 3.0) +
                   MakeRows("dynamics2d,16,16,100000", {500, 520, 540, 610, 620, 630}, 3.0) +
                   "dynamics2d,1,16,10000,1,crashed,600,,,,,3.0.0-1\n");
  const std::string verdicts = Judge(folder, "runs.csv");
  INFO(verdicts);
  // an outlier is reported, and decides nothing
  CHECK_THAT(verdicts, Contains("| E1 |") && Contains("] | **reproduced**"));
  CHECK_THAT(verdicts,
             Contains(" 1 took more than 1.5 times the median of their setting (dynamics2d, "
                      "A1, P = 16, N = 100000: 9.43 times)"));
  CHECK_THAT(verdicts,
             Contains("w = 7.25 [7.00, 7.60] s = 0.121 T | **reproduced** | 1.99 times less"));
  CHECK_THAT(verdicts,
             Contains("w = 72.5 [70.0, 75.0] s = 1.21 T | **not reproduced** | 2.01 times "
                      "more"));
  // the interval reaches over the printed time
  CHECK_THAT(verdicts, Contains("[500, 630] s = 9.58 T | **undecided** | more runs are needed"));
  CHECK_THAT(verdicts,
             Contains("| E8 |") && Contains("**not run** | no results of dynamics2d, A2, P = 16"));
  CHECK_THAT(verdicts,
             Contains("memory = 900 [900, 900] MB | **not reproduced** | 1.12 times more"));

  folder.Write("other.csv", "run,tick\n1,2\n");
  CHECK(std::system(("python3 " + InSourceTree("studies/efficiency/verdicts.py") + ' ' +
                     folder.Path("other.csv") + " 2> " + folder.Path("error"))
                        .c_str()) != 0);
  CHECK_THAT(folder.Read("error"), Contains("these are no results of this study"));
}

TEST_CASE("studies: the processors that one robot keeps busy are compared on both sides",
          "[campaign][studies]") {
  const auto [threads, u, verdict] = GENERATE(table<std::string, Real, std::string>(
      {{"2", 1.05, "u = 1.05 [1.05, 1.05] | **reproduced**"},
       {"2", 0.07, "u = 0.0700 [0.0700, 0.0700] | **not reproduced**"},
       {"2", 1.2, "u = 1.20 [1.20, 1.20] | **not reproduced**"},
       {"16", 1.35, "u = 1.35 [1.35, 1.35] | **reproduced**"},
       {"16", 1.0,
        "u = 1.00 [1.00, 1.00] | **not reproduced** | threads that wait use no processor"},
       {"16", 0.07, "u = 0.0700 [0.0700, 0.0700] | **not reproduced** |  |"}}));
  const CTestFolder folder;
  folder.Write("runs.csv",
               MakeHeader() + MakeRows("dynamics2d,1," + threads + ",1", {1, 1, 1, 1, 1, 1}, u));
  CHECK_THAT(Judge(folder, "runs.csv"), Contains(" P = " + threads + ": " + verdict));
}

TEST_CASE("studies: what is beyond a printed value is not taken for it", "[campaign][studies]") {
  const CTestFolder folder;
  const std::vector<Real> around = {0.97, 0.98, 0.99, 1.01, 1.02, 1.03};
  const auto scale = [&around](Real time) {
    std::vector<Real> times;
    for (const Real factor : around) {
      times.push_back(factor * time);
    }
    return times;
  };
  folder.Write("runs.csv", MakeHeader() + MakeRows("dynamics2d,1,0,100000", scale(100), 1) +
                               MakeRows("dynamics2d,1,16,100000", scale(10), 9) +
                               MakeRows("dynamics2d,1,16,1", scale(0.1), 1) +
                               MakeRows("dynamics2d,1,0,1", scale(0.1), 1) +
                               MakeRows("dynamics2d,1,16,1000", scale(1), 14) +
                               MakeRows("kinematics2d,1,16,10000", scale(900), 1) +
                               MakeRows("kinematics2d,16,16,10000", scale(300), 1));
  const std::string verdicts = Judge(folder, "runs.csv");
  INFO(verdicts);
  CHECK_THAT(verdicts,
             Contains("w(P = 0) / w(P = 16) = 10.0 [9.61, 10.4] | **not reproduced** | better"));
  CHECK_THAT(
      verdicts,
      Contains("maximum of u, at N = 1000 = 14.0 [14.0, 14.0] | **not reproduced** | better"));
  // equal within 5 %: more runs would not help
  CHECK_THAT(verdicts, Contains("N = 1: w(P = 16) / w(P = 0) = 1.00") &&
                           Contains("**not reproduced** | no difference of 5 %"));
  // the order of the thesis, five times as slow
  CHECK_THAT(verdicts, Contains("s = 5.00 T | **not reproduced** | 5.00 times more") &&
                           Contains("w(A1) / w(A16) = 3.00 [2.88, 3.12] | **reproduced**"));
}

}  // namespace studies_test
