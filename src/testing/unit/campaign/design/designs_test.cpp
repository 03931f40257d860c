#include <argos3/campaign/design/campaign.h>
#include <argos3/testing/unit/campaign/campaign_files.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <set>

namespace designs_test {

using namespace argos;
using Catch::Matchers::Contains;
typedef std::vector<std::string> TTexts;

namespace {

constexpr const char* kRuns = "<runs seeds=\"2\"/>";

std::string Quantity(const std::string& values) {
  return "<factor name=\"robots\" path=\"//distribute/entity/@quantity\" " + values + "/>";
}
std::string Speed(const std::string& values) {
  return "<factor name=\"speed\" path=\"//lua_controller[@id='forage']/params/@speed\" " + values +
         "/>";
}
std::string Factors(const std::string& attributes, const std::string& factors) {
  return "<factors " + attributes + ">" + factors + "</factors>" + kRuns;
}

}  // namespace

TEST_CASE("full design: the last factor varies fastest", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign =
      ReadTestCampaign(folder, Factors("", Quantity("values=\"5, 10\"") + Speed("values=\"1:3\"")));
  REQUIRE(campaign.Combinations.size() == 6);
  CHECK(campaign.Combinations[0].Values == TTexts{"5", "1"});
  CHECK(campaign.Combinations[1].Values == TTexts{"5", "2"});
  CHECK(campaign.Combinations[3].Values == TTexts{"10", "1"});
  CHECK(campaign.Combinations[5].ComputeKey() ==
        "//distribute/entity/@quantity=10\n//lua_controller[@id='forage']/params/@speed=3\n");
}

TEST_CASE("full design: conditions exclude combinations", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign =
      ReadTestCampaign(folder, Factors("", Quantity("values=\"5, 20\"") + Speed("values=\"1:10\"") +
                                               "<exclude where=\"robots == 20 and speed &gt; 5\"/>"
                                               "<exclude where=\"robots &lt; 0\"/>"));
  CHECK(campaign.Combinations.size() == 15);
  CHECK(campaign.NumExcluded == 5);
  for (const SCombination& combination : campaign.Combinations) {
    CHECK((combination.Values[0] == "5" || std::stoi(combination.Values[1]) <= 5));
  }
  REQUIRE(campaign.Warnings.size() == 1);
  CHECK_THAT(campaign.Warnings[0],
             Contains("test.xml:2: <exclude>: \"robots < 0\" is true for no combination"));
}

TEST_CASE("paired design: n-th values together", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(
      folder,
      Factors("design=\"paired\"", Quantity("values=\"5, 10, 10\"") + Speed("values=\"3, 2, 1\"")));
  REQUIRE(campaign.Combinations.size() == 3);
  CHECK(campaign.Combinations[1].Values == TTexts{"10", "2"});
  CHECK(campaign.Combinations[2].Values == TTexts{"10", "1"});
  CHECK_THAT(ReadCampaignError(Factors("design=\"paired\"",
                                       Quantity("values=\"5, 10\"") + Speed("values=\"3, 2, 1\""))),
             Contains("equally many values: \"robots\" 2, \"speed\" 3"));
}

TEST_CASE("latin hypercube: each stratum once, levels balanced", "[campaign][design]") {
  const CTemporaryFolder folder;
  const std::string design =
      Factors("design=\"latin_hypercube\" samples=\"20\" seed=\"7\"",
              Quantity("values=\"5, 10, 20\"") + Speed("min=\"1\" max=\"11\""));
  const SCampaign campaign = ReadTestCampaign(folder, design);
  REQUIRE(campaign.Combinations.size() == 20);
  CHECK(campaign.Factors[1].Levels.size() == 20);
  std::set<int> strata;
  std::map<std::string, int> counts;
  for (const SCombination& combination : campaign.Combinations) {
    // 20 strata of width 0.5
    strata.insert(static_cast<int>((std::stod(combination.Values[1]) - 1.0) / 0.5));
    ++counts[combination.Values[0]];
  }
  CHECK(strata.size() == 20);
  CHECK(*strata.begin() == 0);
  CHECK(*strata.rbegin() == 19);
  CHECK(counts.size() == 3);
  for (const auto& [level, count] : counts) {
    CHECK((count == 6 || count == 7));
  }
  // the same file gives the same sample
  const SCampaign again = ReadTestCampaign(folder, design);
  for (size_t i = 0; i < 20; ++i) {
    CHECK(again.Combinations[i].ComputeKey() == campaign.Combinations[i].ComputeKey());
  }
}

TEST_CASE("latin hypercube: strata of a logarithmic range", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign =
      ReadTestCampaign(folder, Factors("design=\"latin_hypercube\" samples=\"3\"",
                                       Speed("min=\"1\" max=\"1000\" scale=\"log\"")));
  REQUIRE(campaign.Factors[0].Levels.size() == 3);
  for (int i = 0; i < 3; ++i) {
    const Real value = std::stod(campaign.Factors[0].Levels[i].Value);
    CHECK(value >= std::pow(10.0, i));
    CHECK(value <= std::pow(10.0, i + 1));
  }
}

TEST_CASE("latin hypercube: more samples than combinations are an error", "[campaign][design]") {
  CHECK_THAT(ReadCampaignError(Factors("design=\"latin_hypercube\" samples=\"5\"",
                                       Quantity("values=\"1,2\"") + Speed("values=\"1,2\""))),
             Contains("5 samples, but the values of the factors have only 4 combinations"));
}

TEST_CASE("latin hypercube: whole numbers may fill several strata", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(
      folder,
      Factors("design=\"latin_hypercube\" samples=\"12\"",
              Quantity("min=\"0.5\" max=\"3.5\" integer=\"true\"") + Speed("values=\"1:12\"")));
  // 12 strata of width 0.25: four of each number
  REQUIRE(campaign.Factors[0].Levels.size() == 3);
  std::map<std::string, int> counts;
  for (const SCombination& combination : campaign.Combinations) {
    ++counts[combination.Values[0]];
  }
  CHECK(counts == std::map<std::string, int>{{"1", 4}, {"2", 4}, {"3", 4}});
}

TEST_CASE("latin hypercube: all samples are different", "[campaign][design]") {
  const CTemporaryFolder folder;
  // of the balanced assignments of 3 x 3 levels to 9 samples, 13 % have each combination once
  const UInt32 seed = GENERATE(1, 2, 3, 4);
  const SCampaign campaign = ReadTestCampaign(
      folder,
      Factors("design=\"latin_hypercube\" samples=\"9\" seed=\"" + std::to_string(seed) + '"',
              Quantity("values=\"1:3\"") + Speed("values=\"1:3\"")));
  std::set<TTexts> known;
  for (const SCombination& combination : campaign.Combinations) {
    known.insert(combination.Values);
  }
  CHECK(known.size() == 9);
  CHECK_THAT(ReadCampaignError(Factors("design=\"latin_hypercube\" samples=\"100\"",
                                       Quantity("values=\"1:10\"") + Speed("values=\"1:10\""))),
             Contains("100 samples of 100 combinations are too many to be different ones"));
}

TEST_CASE("levels: several settings, and expressions of factors", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, Factors("", R"(
        <factor name="space">
          <level value="small"><set path="arena/@size" value="2,2,1"/>
            <set path="arena/@center" value="0,0,{density}"/></level>
          <level value="large"/>
        </factor>
        <factor name="density" values="0.25, 2">
          <set path="//entity/@quantity" value="{40*density}"/>
          <set path="//experiment/@length" value="{space == 'small' and 1 or 100}"/>
        </factor>)"));
  REQUIRE(campaign.Combinations.size() == 4);
  CHECK(campaign.Combinations[0].ComputeKey() ==
        "arena/@size=2,2,1\narena/@center=0,0,0.25\n//entity/@quantity=10\n"
        "//experiment/@length=1\n");
  CHECK(campaign.Combinations[3].ComputeKey() ==
        "//entity/@quantity=80\n//experiment/@length=100\n");
  CHECK(campaign.Combinations[3].Values == TTexts{"large", "2"});
}

TEST_CASE("values may be expressions of the factors before", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(
      folder, Factors("", Quantity("values=\"5, 10\"") + Speed("values=\"{robots * 2}, 1\"")));
  REQUIRE(campaign.Combinations.size() == 4);
  CHECK(campaign.Combinations[2].Values == TTexts{"10", "20"});
  CHECK(campaign.Combinations[2].Settings[1].Value == "20");
  CHECK_THAT(ReadCampaignError(Factors("", Quantity("values=\"{speed}\"") + Speed("values=\"1\""))),
             Contains("test.xml:2: <factor>: the expression \"speed\": \"speed\" is not known"));
}

TEST_CASE("values: an expression that fails in all combinations is reported once",
          "[campaign][design]") {
  const std::string text =
      ReadCampaignError(Factors("", Quantity("values=\"{x}, {y}\"") + Speed("values=\"1, 2\"")));
  CHECK_THAT(text, Contains("test.xml:2: <factor>: the expression \"x\": \"x\" is not known"));
  CHECK_THAT(text, !Contains("errors in the campaign") && !Contains("\"y\""));
}

TEST_CASE("values: a line break is one character of the key", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, Factors("", Speed("values=\"1&#10;2, 3\"")));
  REQUIRE(campaign.Combinations.size() == 2);
  CHECK(campaign.Combinations[0].Values == TTexts{"1\n2"});
  CHECK(campaign.Combinations[0].ComputeKey() ==
        "//lua_controller[@id='forage']/params/@speed=1&#10;2\n");
}

TEST_CASE("equal combinations are an error", "[campaign][design]") {
  CHECK_THAT(ReadCampaignError(Factors("", Quantity("values=\"5, {2 + 3}\""))),
             Contains("two combinations give the experiment the same values: (robots=5) and "
                      "(robots=5)"));
  CHECK_THAT(
      ReadCampaignError(Factors("", Quantity("values=\"5\"") + "<exclude where=\"robots == 5\"/>")),
      Contains("every combination is excluded"));
}

TEST_CASE("without factors there is one combination", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, kRuns);
  REQUIRE(campaign.Combinations.size() == 1);
  CHECK(campaign.Combinations[0].ComputeKey().empty());
}

}  // namespace designs_test
