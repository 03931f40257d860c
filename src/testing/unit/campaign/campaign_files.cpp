#include <argos3/testing/unit/campaign/campaign_files.h>

namespace argos {

const char* const kCampaignExperiment = R"(<?xml version="1.0" ?>
<argos-configuration>
  <framework>
    <system threads="0" />
    <experiment length="10" ticks_per_second="10" random_seed="1" />
  </framework>
  <controllers>
    <lua_controller id="forage"><params script="forage.lua" speed="5" /></lua_controller>
    <lua_controller id="guard"><params script="guard.lua" speed="2" /></lua_controller>
  </controllers>
  <arena size="4, 4, 1" center="0,0,0.5">
    <distribute>
      <entity quantity="10" max_trials="100"><e-puck id="robot" /></entity>
    </distribute>
  </arena>
</argos-configuration>
)";

std::string WriteCampaign(const CTemporaryFolder& folder, const std::string& contents) {
  folder.Write("test.argos", kCampaignExperiment);
  return folder.Write("test.xml", "<argos-campaign experiment=\"test.argos\">\n" + contents +
                                      "\n</argos-campaign>\n");
}

SCampaign ReadTestCampaign(const CTemporaryFolder& folder, const std::string& contents) {
  return ReadCampaign(WriteCampaign(folder, contents));
}

std::string ReadCampaignError(const std::string& contents) {
  const CTemporaryFolder folder;
  return CatchText([&] { ReadTestCampaign(folder, contents); });
}

SStoredRun MakeRun(UInt32 combination, UInt32 seed, Real delivered) {
  SStoredRun run;
  run.Combination = combination;
  run.Seed = seed;
  run.Started = "2026-01-31T12:00:00Z";
  run.Machine = "node1";
  run.Version = "3.0.0-1";
  run.Result.Status = ERunStatus::Done;
  run.Result.StartUpTime = 0.125;
  run.Result.WallTime = 2.5;
  run.Result.CPUTime = 2.25;
  run.Result.TotalWallTime = 3.0;
  run.Result.PeakMemory = UInt64{1} << 33;
  run.Result.Ticks = 100;
  run.Result.Robots = 10;
  run.Result.Digest = 0xfedcba9876543210ULL;
  run.Result.Log = "line 1\nline 2";
  run.Result.LogBytes = 13;
  run.Result.Metrics = {{"delivered", "", delivered}};
  run.Result.Series = {{"spread", "m", {0, 10, 20}, {1.0, 0.1 * seed, delivered}}};
  return run;
}

}  // namespace argos
