#include <argos3/campaign/store/result_store.h>
#include <argos3/testing/unit/campaign/campaign_files.h>

#include <catch2/catch.hpp>

namespace store_merge_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

constexpr auto kWrite = CResultStore::EMode::Write;

SCampaign ReadOneFactor(const CTemporaryFolder& folder, const std::string& values) {
  return ReadTestCampaign(folder,
                          "<factors><factor name=\"robots\" path=\"//entity/@quantity\" "
                          "values=\"" +
                              values + "\"/></factors><runs seeds=\"3\"/>");
}

}  // namespace

TEST_CASE("merging: combinations by their values, equal runs once", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadOneFactor(folder, "5, 10");
  // other ids for the same combinations, and one more
  const SCampaign otherCampaign = ReadOneFactor(folder, "20, 10, 5");
  CResultStore store(folder.Path("own.sqlite"), kWrite);
  store.Register(campaign, false);
  const UInt32 five = store.GetCombinationId(campaign.Combinations[0].ComputeKey());
  const UInt32 ten = store.GetCombinationId(campaign.Combinations[1].ComputeKey());
  SStoredRun failed = MakeRun(ten, 1, 0.0);
  failed.Result.Status = ERunStatus::Failed;
  store.Add({MakeRun(five, 1, 1.0), failed});
  {
    CResultStore other(folder.Path("other.sqlite"), kWrite);
    other.Register(otherCampaign, false);
    const auto id = [&](size_t c) {
      return other.GetCombinationId(otherCampaign.Combinations[c].ComputeKey());
    };
    SStoredRun crashed = MakeRun(id(2), 1, 0.0);
    crashed.Result.Status = ERunStatus::Crashed;
    SStoredRun withMore = MakeRun(id(0), 3, 4.0);
    withMore.Result.Metrics.push_back({"distance", "m", 8.0});
    other.Add({crashed, MakeRun(id(2), 2, 2.0), MakeRun(id(1), 1, 3.0), withMore});
  }
  // 5/1 stays, 10/1 is replaced because it failed
  CHECK(store.Merge(folder.Path("other.sqlite")) == 3);
  CHECK(store.Merge(folder.Path("other.sqlite")) == 0);
  const auto values = store.ReadMetric("delivered");
  REQUIRE(values.size() == 4);
  CHECK(values[0].Combination == five);
  CHECK(values[0].Value == 1.0);
  CHECK(values[1].Seed == 2);
  CHECK(values[1].Value == 2.0);
  CHECK(values[2].Combination == ten);
  CHECK(values[2].Value == 3.0);
  CHECK(values[3].Value == 4.0);
  CHECK(store.ListMetrics() == std::vector<std::string>{"delivered", "distance"});
  CHECK(store.GetUnit("distance", false) == "m");
  CHECK(store.ReadSeries("spread").size() == 4);
  const auto run = store.FindRun(store.ListRuns()[3].Id);
  CHECK(run->Result.Digest == MakeRun(1, 1, 0).Result.Digest);
  CHECK(run->Result.WallTime == 2.5);
  CHECK(run->Result.CPUTime == 2.25);
  CHECK(run->Result.PeakMemory == UInt64{1} << 33);
  CHECK(run->Result.LogBytes == 13);
  CHECK(run->Result.Log == "line 1\nline 2");
  CHECK(run->Machine == "node1");
  REQUIRE(store.ListCombinations().size() == 3);
}

TEST_CASE("merging: into a new database", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadOneFactor(folder, "5, 10");
  {
    CResultStore other(folder.Path("other.sqlite"), kWrite);
    other.Register(campaign, false);
    other.Add({MakeRun(1, 1, 2.0)});
  }
  CResultStore store(folder.Path("own.sqlite"), kWrite);
  CHECK(store.Merge(folder.Path("other.sqlite")) == 1);
  CHECK(store.IsStored(campaign.Combinations[0].ComputeKey(), 1));
  CHECK(store.ListFactors() == std::vector<std::string>{"robots"});
  // what the campaign says of itself
  const CResultStore other(folder.Path("other.sqlite"), CResultStore::EMode::ReadOnly);
  for (const char* key : {"name", "file", "text", "experiment_file", "collect"}) {
    CAPTURE(key);
    CHECK_FALSE(other.GetText(key).empty());
    CHECK(store.GetText(key) == other.GetText(key));
  }
  CHECK(store.Register(campaign, false).empty());
  CHECK(store.ListRuns().size() == 1);
}

TEST_CASE("merging: other factors or experiments are refused", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadOneFactor(folder, "5, 10");
  SCampaign changed = campaign;
  changed.ExperimentText += " ";
  SCampaign renamed = campaign;
  renamed.Factors[0].Name = "swarm";
  CResultStore store(folder.Path("own.sqlite"), kWrite);
  store.Register(campaign, false);
  CResultStore(folder.Path("changed.sqlite"), kWrite).Register(changed, false);
  CResultStore(folder.Path("renamed.sqlite"), kWrite).Register(renamed, false);
  CHECK_THAT(CatchText([&] { store.Merge(folder.Path("changed.sqlite")); }),
             Contains("changed.sqlite\" has results of another experiment than \""));
  CHECK_THAT(CatchText([&] { store.Merge(folder.Path("renamed.sqlite")); }),
             Contains("renamed.sqlite\" has results of other factors than \""));
  CHECK_THAT(CatchText([&] { store.Merge(folder.Path("none.sqlite")); }),
             Contains("none.sqlite\" cannot be read: No such file"));
}

}  // namespace store_merge_test
