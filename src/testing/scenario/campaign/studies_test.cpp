// The studies of the thesis in studies/: their campaigns are executed with tiny runs.

#include "../command_line/program_run.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

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

// a run of a minute with N robots
std::string MakeRow(const std::string& setting, const std::string& w, const std::string& u) {
  return setting + ",1,done,600," + w + ',' + u + ",900,3.0.0-1\n";
}

}  // namespace

TEST_CASE("studies: the forms of the study of efficiency have the runs that its page names",
          "[campaign][studies]") {
  SetPluginPath();
  const CTestFolder folder;
  const auto [form, runs] = GENERATE(table<std::string, std::string>(
      {{"short", "96 runs"}, {"reduced", "500 runs"}, {"large", "4 runs"}, {"full", "8400 runs"}}));
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
  CHECK_THAT(verdicts, Contains("P = 2: u = "));
  CHECK_THAT(verdicts, Contains("| E14 | dynamics2d, N = 10^5 | about 800 MB | - | **not run** |"));
}

TEST_CASE("studies: verdicts compare with the printed values", "[campaign][studies]") {
  const CTestFolder folder;
  folder.Write(
      "runs.csv",
      "# argos3 campaign\n"
      "engine,engines,threads,robots,seed,status,ticks,loop_wall_time,speedup,"
      "resident_memory,version\n" +
          MakeRow("dynamics2d,1,0,1000", "7", "1") + MakeRow("dynamics2d,1,0,1000", "7.4", "1") +
          MakeRow("dynamics2d,1,16,1", "1", "1.6") + MakeRow("dynamics2d,1,0,100000", "100", "1") +
          MakeRow("dynamics2d,1,16,100000", "55", "2") +
          MakeRow("dynamics2d,16,0,100000", "100", "1") +
          MakeRow("dynamics2d,16,16,1000", "1", "3") +
          MakeRow("dynamics2d,16,16,10000", "72", "3") +
          MakeRow("dynamics2d,16,16,100000", "100", "3") +
          "dynamics2d,1,16,10000,1,crashed,600,,,,3.0.0-1\n");
  const std::string verdicts = Judge(folder, "runs.csv");
  INFO(verdicts);
  CHECK_THAT(verdicts, Contains("means of 1 to 2 runs"));
  CHECK_THAT(verdicts, Contains("w(P = 0) / w(P = 16) = 1.82 | **reproduced**"));
  CHECK_THAT(verdicts, Contains("P = 16: u = 1.60 | **differs**"));
  CHECK_THAT(verdicts, Contains("w = 7.20 s = 0.120 T | **not slower** | 2.00 times as fast"));
  CHECK_THAT(verdicts, Contains("w = 72.0 s = 1.20 T | **differs** | 2.00 times as slow"));
  CHECK_THAT(verdicts, Contains("w grows as N^1.00 | **not slower, linear** | 6.00 times as fast"));
  CHECK_THAT(verdicts,
             Contains("| E8 |") && Contains("**not run** | no results of dynamics2d, A2, P = 16"));
  CHECK_THAT(verdicts, Contains("900 MB | **differs** | 1.12 of the thesis' memory"));

  folder.Write("other.csv", "run,tick\n1,2\n");
  CHECK(std::system(("python3 " + InSourceTree("studies/efficiency/verdicts.py") + ' ' +
                     folder.Path("other.csv") + " 2> " + folder.Path("error"))
                        .c_str()) != 0);
  CHECK_THAT(folder.Read("error"), Contains("these are no results of this study"));
}

TEST_CASE("studies: the processors that one robot keeps busy are compared on both sides",
          "[campaign][studies]") {
  const auto [threads, u, verdict] = GENERATE(table<std::string, std::string, std::string>(
      {{"2", "1.05", "u = 1.05 | **reproduced**"},
       {"2", "0.07", "u = 0.0700 | **differs**"},
       {"2", "1.2", "u = 1.20 | **differs**"},
       {"16", "1.35", "u = 1.35 | **reproduced**"},
       {"16", "1", "u = 1.00 | **better** | threads that wait use no processor"},
       {"16", "0.07", "u = 0.0700 | **differs**"}}));
  const CTestFolder folder;
  folder.Write("runs.csv",
               "engine,engines,threads,robots,seed,status,ticks,loop_wall_time,speedup,"
               "resident_memory,version\n" +
                   MakeRow("dynamics2d,1," + threads + ",1", "1", u));
  CHECK_THAT(Judge(folder, "runs.csv"), Contains("| P = " + threads + ": " + verdict));
}

TEST_CASE("studies: what is beyond a printed value is not taken for it", "[campaign][studies]") {
  const CTestFolder folder;
  folder.Write("runs.csv",
               "engine,engines,threads,robots,seed,status,ticks,loop_wall_time,speedup,"
               "resident_memory,version\n" +
                   MakeRow("dynamics2d,1,0,100000", "100", "1") +
                   MakeRow("dynamics2d,1,16,100000", "10", "9") +
                   MakeRow("dynamics2d,1,16,1000", "1", "14") +
                   MakeRow("kinematics2d,1,16,10000", "900", "1") +
                   MakeRow("kinematics2d,16,16,10000", "300", "1"));
  const std::string verdicts = Judge(folder, "runs.csv");
  INFO(verdicts);
  CHECK_THAT(verdicts, Contains("w(P = 0) / w(P = 16) = 10.0 | **better**"));
  CHECK_THAT(verdicts, Contains("u from 9.00 to 14.0, at N = 1000 | **better** | another maximum"));
  // the order of the thesis, five times as slow
  CHECK_THAT(verdicts,
             Contains("900 s (A1), 300 s (A16) | **differs; reproduced** | 5.00 times as"));
}

}  // namespace studies_test
