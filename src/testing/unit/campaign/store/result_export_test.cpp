#include <argos3/campaign/store/result_export.h>
#include <argos3/campaign/store/result_schema.h>
#include <argos3/testing/unit/campaign/campaign_files.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <sstream>

namespace result_export_test {

using namespace argos;
using Catch::Matchers::Contains;
typedef std::vector<std::string> TTexts;

namespace {

/** A store with two done runs and one that crashed. */
struct SExported {
  CTemporaryFolder Folder;
  std::unique_ptr<CResultStore> Store;

  SExported() {
    const SCampaign campaign = ReadTestCampaign(Folder, R"(<factors>
      <factor name="robots" path="//entity/@quantity" values="5"/>
      <factor name="size" path="arena/@size" values="2,2,1; 4,4,1"/></factors>
      <runs seeds="3"/>)");
    Store = std::make_unique<CResultStore>(campaign.ResultsFile, CResultStore::EMode::Write);
    Store->Register(campaign, false);
    SStoredRun crashed = MakeRun(2, 2, 0.0);
    crashed.Result.Status = ERunStatus::Crashed;
    crashed.Result.Signal = 11;
    crashed.Result.Metrics.clear();
    crashed.Result.Series.clear();
    SStoredRun second = MakeRun(2, 1, 0.1);
    second.Machine = "a \"b\", \xff";
    second.Version = "1\x01\n\xC3\xA9\\";
    second.Result.Metrics.push_back({"distance", "m", std::nan("")});
    Store->Add({MakeRun(1, 1, 3.0), second, crashed});
  }
};

TTexts Lines(const std::string& text) {
  TTexts lines;
  std::istringstream stream(text);
  std::string line;
  while (std::getline(stream, line)) {
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

TEST_CASE("columns of results: factors keep their names", "[campaign][store]") {
  TTexts titles;
  for (const SResultColumn& column : ListResultColumns({"robots", "Seed"}, {"wall", "speed"})) {
    titles.push_back(column.Title);
  }
  CHECK(titles == TTexts{"id",          "combination", "robots",      "Seed",    "run_seed",
                         "status",      "attempt",     "exit_status", "signal",  "start_up",
                         "wall",        "cpu",         "total_wall",  "memory",  "ticks",
                         "run_robots",  "digest",      "machine",     "version", "started",
                         "metric_wall", "speed"});
}

TEST_CASE("CSV export: a row for each run", "[campaign][store]") {
  SExported exported;
  ExportCSV(*exported.Store, exported.Folder.Path("out/csv"));
  const TTexts lines = Lines(exported.Folder.Read("out/csv/runs.csv"));
  REQUIRE(lines.size() == 8);
  CHECK_THAT(lines[0], Contains("# argos3 ") && Contains(" campaign"));
  CHECK(lines[1] == "# campaign: " + exported.Folder.Path("test.xml"));
  CHECK(lines[2] == "# experiment: " + exported.Folder.Path("test.argos"));
  CHECK(lines[3] ==
        "# units: start_up [s], wall [s], cpu [s], total_wall [s], memory [bytes], "
        "distance [m]");
  CHECK(lines[4] ==
        "id,combination,robots,size,seed,status,attempt,exit_status,signal,start_up,"
        "wall,cpu,total_wall,memory,ticks,run_robots,digest,machine,version,started,"
        "delivered,distance");
  CHECK(lines[5] ==
        "1,1,5,\"2,2,1\",1,done,1,0,0,0.125,2.5,2.25,3,8589934592,100,10,"
        "fedcba9876543210,node1,3.0.0-1,2026-01-31T12:00:00Z,3,");
  CHECK_THAT(lines[6], Contains(",\"a \"\"b\"\", \xff\",") && Contains(",0.1,"));
  CHECK_THAT(lines[7], Contains(",2,crashed,1,0,11,") && Contains("Z,,"));
}

TEST_CASE("CSV export: series in long form", "[campaign][store]") {
  SExported exported;
  ExportCSV(*exported.Store, exported.Folder.Path("csv"));
  const TTexts lines = Lines(exported.Folder.Read("csv/series_spread.csv"));
  REQUIRE(lines.size() == 11);
  CHECK(lines[3] == "# units: value [m]");
  CHECK(lines[4] == "robots,size,seed,tick,value");
  CHECK(lines[5] == "5,\"2,2,1\",1,0,1");
  CHECK(lines[10] == "5,\"4,4,1\",1,20,0.1");
}

TEST_CASE("JSON export: one object", "[campaign][store]") {
  SExported exported;
  const std::string file = exported.Folder.Path("out.json");
  ExportJSON(*exported.Store, file);
  const std::string text = exported.Folder.Read("out.json");
  CHECK_THAT(text, Contains("\"factors\": [\"robots\", \"size\"]"));
  CHECK_THAT(text, Contains("\"metrics\": {\"delivered\": \"\", \"distance\": \"m\"}"));
  CHECK_THAT(text, Contains("\"factors\": {\"robots\": 5, \"size\": \"2,2,1\"}, \"seed\": 1, "
                            "\"status\": \"done\""));
  CHECK_THAT(text, Contains("\"machine\": \"a \\\"b\\\", \\ufffd\""));
  CHECK_THAT(text, Contains("\"version\": \"1\\u0001\\n\xC3\xA9\\\\\""));
  CHECK_THAT(text, Contains("\"metrics\": {\"delivered\": 0.1, \"distance\": null}"));
  CHECK_THAT(text, Contains("{\"name\": \"spread\", \"unit\": \"m\", \"combination\": 2, \"seed\": "
                            "1, \"ticks\": [0, 10, 20], \"values\": [1, 0.1, 0.1]}"));
  CHECK(text.substr(text.size() - 3) == "]}\n");
}

TEST_CASE("export: a place that cannot be written", "[campaign][store]") {
  SExported exported;
  exported.Folder.Write("file", "");
  CHECK_THAT(CatchText([&] { ExportCSV(*exported.Store, exported.Folder.Path("file/csv")); }),
             Contains("file/csv\" cannot be created: Not a directory"));
  CHECK_THAT(CatchText([&] { ExportJSON(*exported.Store, exported.Folder.Path("none/a.json")); }),
             Contains("none/a.json") && Contains("No such file"));
}

}  // namespace result_export_test
