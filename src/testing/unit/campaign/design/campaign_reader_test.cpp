#include <argos3/campaign/design/campaign.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/testing/unit/campaign/campaign_files.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace campaign_reader_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

constexpr const char* kFactors = R"(<factors>
  <factor name="robots" path="//distribute/entity/@quantity" values="5, 10"/>
  <factor name="speed" path="//lua_controller[@id='forage']/params/@speed" values="1, 2"/>
</factors>
)";

// one element after <factors> and <runs>
std::string ErrorWith(const std::string& element) {
  return ReadCampaignError(std::string(kFactors) + "<runs seeds=\"2\"/>\n" + element);
}

std::string ErrorOfRuns(const std::string& attributes) {
  return ReadCampaignError("<runs " + attributes + "/>");
}

std::string ErrorOfFactor(const std::string& factor) {
  return ReadCampaignError("<runs seeds=\"2\"/><factors>\n" + factor + "\n</factors>");
}

}  // namespace

TEST_CASE("campaign reader: the built-in metrics of the simulator are known",
          "[campaign][design]") {
  const std::vector<std::string>& known = ListBuiltInMetrics();
  CHECK(std::set<std::string>(known.begin(), known.end()).size() == known.size());
  const std::vector<std::string> registered = CMetrics::ListBuiltIns();
  REQUIRE_FALSE(registered.empty());
  for (const std::string& name : registered) {
    CAPTURE(name);
    CHECK(std::find(known.begin(), known.end(), name) != known.end());
  }
}

TEST_CASE("campaign file: everything in it is read", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, std::string(kFactors) + R"(
    <set path="//experiment/@length" value="60"/>
    <runs until="delivered" level="0.9" relative="0.1" min="5" max="50" first="100"/>
    <limits wall="60.5" memory="2 GiB" output="500 kB"/>
    <execution isolation="thread" threads="2" keep="all" jobs="3"/>
    <collect>
      <metric name="delivered" of="max"/>
      <metric name="spread" series="true" every="10"/>
      <builtin name="collisions"/>
      <file name="trips" pattern="foraging.csv" time="time" value="trips"/>
    </collect>
    <figures><boxplot y="delivered" x="robots" group="speed" title="Food"/>
      <series y="spread" group="robots"/>
      <means y="delivered" x="speed" where="robots == 5" xscale="log" reference="2.5"
        reference_label="goal"/></figures>
    <tests><compare metric="delivered" factor="robots" paired="true"/></tests>
    <slurm tasks="4" partition="batch" time="01:00:00" memory_per_task="4G">
      <option value="--account=swarm"/></slurm>)");
  CHECK(campaign.ExperimentFile == folder.Path("test.argos"));
  CHECK(campaign.ResultsFile == folder.Path("test.sqlite"));
  CHECK_THAT(campaign.ExperimentText, Contains("length=\"60\""));
  REQUIRE(campaign.Constants.size() == 1);
  CHECK(campaign.Constants[0].Value == "60");
  CHECK(campaign.Stopping.Metric == "delivered");
  CHECK(campaign.Stopping.Level == 0.9);
  CHECK(campaign.Stopping.Relative == 0.1);
  CHECK(campaign.Stopping.MinRuns == 5);
  CHECK(campaign.Stopping.MaxRuns == 50);
  CHECK(campaign.Stopping.FirstSeed == 100);
  CHECK(campaign.Limits.WallTime == 60.5);
  CHECK(campaign.Limits.Memory == UInt64{2} << 30);
  CHECK(campaign.Limits.Output == 500000);
  CHECK(campaign.Isolation == EIsolation::SharedProcess);
  CHECK(campaign.Threads == 2);
  CHECK(campaign.Jobs == 3);
  CHECK(campaign.Kept == EKeptFiles::All);
  REQUIRE(campaign.Metrics.size() == 4);
  CHECK(campaign.Metrics[0].Reduction == SCollectedMetric::EReduction::Max);
  CHECK(campaign.Metrics[1].IsSeries);
  CHECK(campaign.Metrics[1].Every == 10);
  CHECK(campaign.Metrics[2].Source == SCollectedMetric::ESource::BuiltIn);
  CHECK(campaign.Metrics[3].IsSeries);
  CHECK(campaign.Metrics[3].ValueColumn == "trips");
  REQUIRE(campaign.Figures.size() == 3);
  CHECK(campaign.Figures[0].Kind == "boxplot");
  CHECK(campaign.Figures[0].Attributes.size() == 4);
  CHECK(campaign.Figures[0].Line == 17);
  CHECK(campaign.Figures[2].Attributes.size() == 6);
  REQUIRE(campaign.Comparisons.size() == 1);
  CHECK(campaign.Comparisons[0].IsPaired);
  CHECK(campaign.Slurm.Tasks == 4);
  CHECK(campaign.Slurm.MemoryPerTask == "4G");
  CHECK(campaign.Slurm.Options == std::vector<std::string>{"--account=swarm"});
}

TEST_CASE("campaign file: defaults", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, "<runs seeds=\"3\" first=\"7\"/>");
  CHECK(campaign.Stopping.Seeds == std::vector<UInt32>{7, 8, 9});
  CHECK(campaign.Isolation == EIsolation::OwnProcess);
  CHECK(campaign.Kept == EKeptFiles::Failed);
  CHECK(campaign.Metrics.empty());
  CHECK(campaign.Jobs == 0);
  CHECK(campaign.ExperimentText == kCampaignExperiment);
  // also with constants, so that lines in messages are right
  CHECK(ReadTestCampaign(folder,
                         "<set path=\"//experiment/@length\" value=\"6\"/><runs seeds=\"1\"/>")
            .ExperimentSource == kCampaignExperiment);
  CHECK(ReadTestCampaign(folder, "<runs seeds=\"3, 5\"/>").Stopping.Seeds ==
        std::vector<UInt32>{3, 5});
}

TEST_CASE("campaign file: the seed of a run is that of <runs> only", "[campaign][design]") {
  const std::string path =
      GENERATE("//experiment/@random_seed", "framework/experiment/@random_seed",
               "//framework/*/@random_seed");
  const std::string refused = "\"" + path + "\" is the seed of a run, which <runs> sets";
  CHECK_THAT(ErrorOfFactor("<factor name=\"s\" path=\"" + path + "\" values=\"11, 12\"/>"),
             Contains("test.xml:3: <factor>: " + refused));
  CHECK_THAT(ErrorOfFactor("<factor name=\"s\"><level value=\"a\">\n<set path=\"" + path +
                           "\" value=\"1\"/></level><level value=\"b\"/></factor>"),
             Contains("test.xml:4: <set>: " + refused));
  CHECK_THAT(ErrorWith("<set path=\"" + path + "\" value=\"7\"/>"),
             Contains("test.xml:7: <set>: " + refused));
}

TEST_CASE("campaign file: runs have no visualization that could be set", "[campaign][design]") {
  const CTemporaryFolder folder;
  const auto read = [&folder](const std::string& path) {
    const std::string file =
        WriteCampaign(folder, "<runs seeds=\"1\"/>\n<set path=\"" + path + "\" value=\"2\"/>");
    std::string experiment = kCampaignExperiment;
    experiment.insert(experiment.find("</argos-configuration>"),
                      "<visualization><offscreen every=\"1\"/></visualization>");
    folder.Write("test.argos", experiment);
    return CatchText([&file] { ReadCampaign(file); });
  };
  CHECK_THAT(read("//offscreen/@every"),
             Contains("test.xml:3: <set>: \"//offscreen/@every\" is of the visualization"));
  CHECK(read("//experiment/@length").empty());
  // elsewhere, too
  CHECK(read("//*/@every").empty());
}

TEST_CASE("campaign file: a <set> of the number of threads counts", "[campaign][design]") {
  const CTemporaryFolder folder;
  const std::string set = "<set path=\"//system/@threads\" value=\"3\"/>";
  CHECK(ReadTestCampaign(folder, "<runs seeds=\"1\"/>" + set).Threads == 3);
  CHECK_THAT(ErrorWith(set + "\n<execution threads=\"2\"/>"),
             Contains("is set twice, also by <execution threads=\"2\">"));
  CHECK_THAT(ErrorWith("<set path=\"//system/@threads\" value=\"many\"/>"),
             Contains("\"many\" is no number of threads"));
  const SCampaign campaign = ReadTestCampaign(folder, R"(<runs seeds="1"/><factors>
    <factor name="threads" path="/argos-configuration/framework/system/@threads" values="0, 2"/>
    <factor name="speed" path="//lua_controller[1]/params/@speed" values="1, 2"/></factors>)");
  CHECK(campaign.Factors[0].SetsThreads);
  CHECK_FALSE(campaign.Factors[1].SetsThreads);
}

TEST_CASE("campaign file: all errors at once, with lines", "[campaign][design]") {
  const std::string text = ReadCampaignError(R"(<factors>
  <factor name="1robots" path="//entity/@quantity" values="1"/>
  <factor name="speed" path="//lua_controllers/params/@speed" values="1"/>
</factors>
<runs seeds="x"/>
<limits memory="2 GiBi"/>
<exekution/>)");
  CHECK_THAT(text, Contains("5 errors in the campaign:"));
  CHECK_THAT(text, Contains("test.xml:3: <factor>: attribute \"name\": \"1robots\" is not a name"));
  CHECK_THAT(text, Contains("test.xml:4: <factor>: ") &&
                       Contains("nothing matches the step "
                                "\"lua_controllers\"") &&
                       Contains("did you mean \"lua_controller\""));
  CHECK_THAT(text, Contains("test.xml:6: <runs>: attribute \"seeds\": \"x\" is not a seed"));
  CHECK_THAT(text, Contains("test.xml:7: <limits>: attribute \"memory\": expected a size, such as "
                            "\"2 GiB\", \"500 MB\" or \"1048576\" (bytes), found \"2 GiBi\""));
  CHECK_THAT(text, Contains("test.xml:8: <exekution>: there is no such element in "
                            "<argos-campaign>; did you mean \"execution\"?"));
}

TEST_CASE("campaign file: files", "[campaign][design]") {
  const CTemporaryFolder folder;
  const auto read = [&](const std::string& name) {
    return CatchText([&] { ReadCampaign(folder.Path(name)); });
  };
  CHECK_THAT(read("none.xml"), Contains("none.xml\" cannot be read: No such file"));
  folder.Write("broken.xml", "<argos-campaign>\n<runs></argos-campaign>");
  CHECK_THAT(read("broken.xml"), Contains("broken.xml:2"));
  folder.Write("other.xml", "<argos-configuration/>");
  CHECK_THAT(read("other.xml"), Contains("expected <argos-campaign>; is it a campaign file?"));
  folder.Write("missing.xml",
               "<argos-campaign experiment=\"x.argos\"><runs seeds=\"1\"/>"
               "</argos-campaign>");
  CHECK_THAT(read("missing.xml"), Contains("missing.xml:1: <argos-campaign>: attribute "
                                           "\"experiment\": ") &&
                                      Contains("x.argos\" cannot be read: No such file"));
  folder.Write("x.argos", "<argos-configuration>\n<a></argos-configuration>");
  CHECK_THAT(read("missing.xml"), Contains("x.argos:2"));
  folder.Write("x.argos", "<argos-campaign/>");
  CHECK_THAT(read("missing.xml"),
             Contains("x.argos:1: the root element is <argos-campaign>, expected "
                      "<argos-configuration>; is it an experiment?"));
  folder.Write("nothing.xml", "<argos-campaign><runs seeds=\"1\"/></argos-campaign>");
  CHECK_THAT(read("nothing.xml"), Contains("experiment"));
}

TEST_CASE("campaign file: wrong factors", "[campaign][design]") {
  const auto [factor, message] = GENERATE(table<std::string, std::string>({
      {"<factor name='a' path='//entity/@quantity'/>",
       "test.xml:3: <factor>: expected one of: values=\"...\", min="},
      {"<factor name='a' path='//entity/@quantity' values='1' min='1' max='2' steps='2'/>",
       "expected one of: values"},
      {"<factor name='end' path='//entity/@quantity' values='1'/>", "\"end\" is a word of Lua"},
      {"<factor name='a' path='//entity/@quantity' values='1,1'/>",
       "the value \"1\" is given twice"},
      {"<factor name='a' path='//entity/@quantity' values=''/>", "attribute \"values\" is empty"},
      {"<factor name='a' path='//entity/@quantity' values='1,,2'/>",
       "attribute \"values\": \"1,,2\": a value is empty"},
      {"<factor name='a' path='//entity/@quantity' min='1' max='2'/>",
       "min and max need steps=\"...\""},
      {"<factor name='a' path='//entity/@quantity' min='2' max='1' steps='3'/>",
       "expected min < max, found min=\"2\" and max=\"1\""},
      {"<factor name='a' path='//entity/@quantity' min='0' max='1' steps='3' scale='log'/>",
       "scale=\"log\" needs min > 0"},
      {"<factor name='a' path='//entity/@quantity' min='0' max='1' steps='3' scale='lag'/>",
       "expected one of \"linear\", \"log\", found \"lag\"; did you mean \"log\"?"},
      {"<factor name='a' path='//entity/@quantity' min='0' max='1' steps='1'/>",
       "attribute \"steps\": expected a whole number from 2 to 100000, found 1"},
      {"<factor name='a' path='//entity/@quantity' min='0' max='1' steps='2' random='2'/>",
       "expected either steps or random, found both"},
      {"<factor name='a' path='//entity/@quantity' min='0' max='inf' steps='2'/>",
       "attribute \"max\": found \"inf\""},
      {"<factor name='a' path='//entity/@quantity' min='1.2' max='1.8' steps='2' integer='true'/>",
       "needs a whole number from min to max, found min=\"1.2\" and max=\"1.8\""},
      {"<factor name='a' path='//entity/@quantity' min='x' max='1' steps='2'/>", "found \"x\""},
      {"<factor name='a' path='//entity/@quantity' values='1' stops='2'/>",
       "attribute \"stops\" is not used by anything"},
      {"<factor name='a' path='//entity/@quantity' values='{1 +}'/>",
       "<factor>: the expression \"1 +\": unexpected symbol"},
      {"<factor name='a' values='1,2'/>", "the factor \"a\" changes nothing"},
      {"<factor name='a'><level value='1'><sat path='' value=''/></level></factor>",
       "<sat>: there is no such element in <level>; did you mean \"set\"?"},
      {"<factor name='a' values='1'><lavel/></factor>", "in <factor>; did you mean \"level\"?"},
      {"<factor name='a' path='//entity/@quantity' values='1'/>"
       "<factor name='A' path='//experiment/@length' values='1'/>",
       "the name \"A\" is given twice, first at "},
      {"<exclude where='robots == 1'/>", "\"robots\" is not known here"},
      {"<exclude where='1'/>", "expected a condition"},
      {"<factor name='a' path='//entity/quantity' values='1'/>", "does not end with \"@\""},
      {"<factor name='a' path='arena/distribute/box/@x' values='1'/>", "nothing matches the step"},
      {"<factor name='a' path='controllers/lua_controller/params/@speed' values='1'/>",
       "matches 2 elements"},
      {"<factor name='a' path='//entity/@quantity' min='0' max='1' random='100001'/>",
       "from 1 to 100000"},
      {"<factor name='a' path='//entity/@quantity' values='x{'/>",
       "attribute \"values\": \"x{\": '{' without '}'"},
  }));
  CAPTURE(factor);
  CHECK_THAT(ErrorOfFactor(factor), Contains(message) && Contains("test.xml:"));
}

TEST_CASE("campaign file: a factor without a path serves the expressions of others",
          "[campaign][design]") {
  const auto [design, other] = GENERATE(table<std::string, std::string>({
      {"full", "path='//entity/@quantity' values='{a}'"},
      {"full", "values='1,2'><set path='//entity/@quantity' value='{a + 2 * b}'/"},
      {"full", "><level value='x'><set path='//entity/@quantity' value='{a}'/></level"},
      {"latin_hypercube' samples='2",
       "path='//experiment/@length' min='1' max='2'><set path='//entity/@quantity' value='{a}'/"},
  }));
  const bool isClosed = other.find('>') != std::string::npos;
  const std::string text = "<runs seeds='1'/><factors design='" + design +
                           "'><factor name='a' values='1,2'/><factor name='b' " + other +
                           (isClosed ? "></factor></factors>" : "/></factors>");
  CAPTURE(text);
  const CTemporaryFolder folder;
  for (const SCombination& combination : ReadTestCampaign(folder, text).Combinations) {
    const SSetting& quantity = combination.Settings.back();
    CHECK(quantity.Path == "//entity/@quantity");
    // b is a text in one of them
    const Real expected =
        std::stod(combination.Values[0]) +
        (other.find("2 * b") == std::string::npos ? 0.0 : 2.0 * std::stod(combination.Values[1]));
    CHECK(std::stod(quantity.Value) == expected);
  }
}

TEST_CASE("campaign file: limits that are not given keep their defaults", "[campaign][design]") {
  const CTemporaryFolder folder;
  const SRunLimits defaults;
  const SRunLimits memory =
      ReadTestCampaign(folder, "<runs seeds='1'/><limits memory='1.5 kB'/>").Limits;
  CHECK(memory.Memory == 1500);
  CHECK(memory.Output == defaults.Output);
  const SRunLimits output =
      ReadTestCampaign(folder, "<runs seeds='1'/><limits output='1000000 TB'/>").Limits;
  CHECK(output.Memory == 0);
  CHECK(output.Output == 1000000000000000000ULL);
}

TEST_CASE("campaign file: the last seed is 4294967295", "[campaign][design]") {
  const CTemporaryFolder folder;
  CHECK(ReadTestCampaign(folder, "<runs seeds='2' first='4294967294'/>").Stopping.Seeds ==
        std::vector<UInt32>{4294967294, 4294967295});
  const SStopping stopping =
      ReadTestCampaign(folder, "<runs until='x' width='1' max='10' first='4294967286'/>").Stopping;
  CHECK(stopping.FirstSeed + (stopping.MaxRuns - 1) == 4294967295);
}

TEST_CASE("campaign file: metrics of plug-ins, and a number and a series of one name",
          "[campaign][design]") {
  const CTemporaryFolder folder;
  const std::vector<SCollectedMetric> metrics =
      ReadTestCampaign(folder, R"(<runs seeds="1"/><collect>
        <builtin name="purity" library="./libpurity.so"/>
        <metric name="spread" of="max"/><metric name="spread" series="true"/></collect>)")
          .Metrics;
  REQUIRE(metrics.size() == 3);
  CHECK(metrics[0].Library == "./libpurity.so");
  CHECK_FALSE(metrics[1].IsSeries);
  CHECK(metrics[2].IsSeries);
}

TEST_CASE("campaign file: too many combinations", "[campaign][design]") {
  CHECK_THAT(ErrorOfFactor("<factor name='a' path='//entity/@quantity' values='1:2000'/>"
                           "<factor name='b' path='//experiment/@length' values='1:2000'/>"),
             Contains("the factors have more than 1000000 combinations"));
}

TEST_CASE("campaign file: no attribute is set twice", "[campaign][design]") {
  const std::string base = "<runs seeds=\"1\"/>\n";
  const std::string quantity = "<factor name='a' path='//entity/@quantity' values='1,2'/>\n";
  CHECK_THAT(ReadCampaignError(base + "<factors>" + quantity +
                               "<factor name='b' path='arena/distribute/entity/@quantity' "
                               "values='1,2'/></factors>"),
             Contains("test.xml:4: <factor>: \"arena/distribute/entity/@quantity\" is set twice, "
                      "also through \"//entity/@quantity\" by the factor \"a\", at ") &&
                 Contains("test.xml:3: <factor>"));
  CHECK_THAT(ReadCampaignError(base + "<factors>" + quantity +
                               "</factors><set path='//entity/@quantity' value='3'/>"),
             Contains("is set twice, also by a <set> of the campaign, at"));
  CHECK_THAT(ReadCampaignError(base + "<set path='//@length' value='3'/>"), Contains("test.xml:3"));
  CHECK_THAT(ReadCampaignError(base + "<set path='//experiment/@length' value='3'/>"
                                      "<set path='*/experiment/@length' value='3'/>"),
             Contains("is set twice"));
  CHECK_THAT(ErrorOfFactor("<factor name='a'><level value='1'>"
                           "<set path='//experiment/@length' value='1'/>\n"
                           "<set path='*/experiment/@length' value='2'/></level></factor>"),
             Contains("test.xml:4: <set>: \"*/experiment/@length\" is set twice, also through "
                      "\"//experiment/@length\" at "));
  // levels of one factor exclude each other; attributes of two elements differ
  CHECK(ErrorOfFactor("<factor name='a'><level value='1'>"
                      "<set path='//experiment/@length' value='1'/></level>\n<level value='2'>"
                      "<set path='*/experiment/@length' value='2'/></level></factor>") == "");
  CHECK(ErrorOfFactor("<factor name='a' path=\"//lua_controller[@id='guard']/params/@speed\" "
                      "values='1'/><factor name='b' "
                      "path=\"//lua_controller[@id='forage']/params/@speed\" values='1'/>") == "");
}

TEST_CASE("campaign file: a constant without match", "[campaign][design]") {
  CHECK_THAT(ErrorWith("<set path=\"//experimant/@length\" value=\"1\"/>"),
             Contains("test.xml:7: <set>: ") && Contains("did you mean \"experiment\""));
}

TEST_CASE("campaign file: wrong runs", "[campaign][design]") {
  const auto [attributes, message] = GENERATE(table<std::string, std::string>({
      {"", "expected either seeds=\"...\" or until=\"METRIC\""},
      {"seeds='3' until='x'", "expected either seeds"},
      {"seeds='0'", "expected a number of seeds from 1 to 1000000, or a list, found 0"},
      {"seeds='1000001'", "expected a number of seeds from 1 to 1000000, or a list"},
      {"seeds='1,2' first='3'", "attribute \"first\" belongs to a number of seeds"},
      {"seeds='1,1'", "the seed 1 is given twice"},
      {"seeds='10' first='4294967287'", "exceed 4294967295"},
      {"until='x' relative='0.1' max='10' first='4294967287'", "exceed 4294967295"},
      {"until='x'", "needs either relative"},
      {"until='x' relative='0.1' width='1'", "needs either relative"},
      {"until='x' relative='-1'", "expected a number greater than 0, found -1"},
      {"until='x' relative='0.1' level='95'", "expected a number between 0 and 1"},
      {"until='x' relative='0.1' min='1'", "expected a whole number of at least 2, found 1"},
      {"until='x' relative='0.1' min='9' max='8'", "expected min <= max"},
      {"until='a b' relative='0.1'", "\"a b\" is not a name"},
      {"seeds='3' relative='0.1'", "attribute \"relative\" is not used by anything"},
  }));
  CAPTURE(attributes);
  CHECK_THAT(ErrorOfRuns(attributes), Contains("test.xml:2: <runs>: ") && Contains(message));
}

TEST_CASE("campaign file: <runs> once", "[campaign][design]") {
  CHECK_THAT(ReadCampaignError(kFactors), Contains("the element <runs seeds=\"...\"/> is missing"));
  CHECK_THAT(
      ErrorWith("<runs seeds=\"2\"/>"),
      Contains("test.xml:7: <runs>: it is given twice, first at ") && Contains("test.xml:6"));
}

TEST_CASE("campaign file: wrong elements", "[campaign][design]") {
  const auto [element, message] = GENERATE(table<std::string, std::string>({
      {"<limits wall='-1'/>", "attribute \"wall\": expected a number greater than 0, found -1"},
      {"<limits memory='0'/>", "expected a size"},
      {"<limits memory='two'/>", "expected a size"},
      {"<limits memory='1.2.3 MB'/>", "expected a size"},
      {"<limits memory='0.5'/>", "expected a size"},
      {"<limits output='2000001 TB'/>", "expected a size"},
      {"<execution isolation='fork'/>", "expected one of \"process\", \"thread\", found \"fork\""},
      {"<execution jobs='0'/>",
       "attribute \"jobs\": expected a whole number of at least 1, found 0"},
      {"<execution jobs='5000'/>", "expected a whole number from 1 to 4096, found 5000"},
      {"<execution keep='al'/>", "did you mean \"all\"?"},
      {"<execution thread='2'/>", "did you mean"},
      {"<collect><metric name='a-b'/></collect>", "\"a-b\" is not a name"},
      {"<collect><metric name='a'/><metric name='A'/></collect>", "\"A\" is given twice"},
      {"<collect><metric name='a' every='2'/></collect>", "belongs to series=\"true\""},
      {"<collect><metric name='a' series='true' of='max'/></collect>", "excludes series"},
      {"<collect><metric name='a' of='median'/></collect>", "expected one of \"last\", \"mean\""},
      {"<collect><metric name='a' series='true' every='0'/></collect>", "at least 1, found 0"},
      {"<collect><builtin name='colisions'/></collect>", "did you mean \"collisions\"?"},
      {"<collect><file name='a' value='x'/></collect>", "pattern"},
      {"<collect><matric name='a'/></collect>", "in <collect>; did you mean \"metric\"?"},
      {"<figures><boxplot y='a' x='robot'/></figures>",
       "attribute \"x\": there is no factor \"robot\"; did you mean \"robots\"?"},
      {"<figures><boxplot x='robots'/></figures>", "\"y\""},
      {"<figures><series y='a'/></figures>", "the series \"a\" is not collected"},
      {"<figures><means y='a' x='robots' where='robot == 5'/></figures>",
       "<means>: attribute \"where\": "},
      {"<figures><boxplot y='a' x='robots' where='robots == 6'/></figures>",
       "attribute \"where\": \"robots == 6\" is true for no combination"},
      {"<figures><means y='a' x='robots' where='robots'/></figures>", "attribute \"where\": "},
      {"<figures><boxplot y='a' x='robots' xscale='log'/></figures>",
       "attribute \"xscale\" is not used by anything"},
      {"<figures><means y='a' x='robots' xscale='lg'/></figures>",
       "attribute \"xscale\": expected one of \"linear\", \"log\""},
      {"<figures><means y='a' x='robots' reference='high'/></figures>", "reference"},
      {"<figures><means y='a' x='robots' bars='sd'/></figures>",
       "attribute \"bars\": expected one of \"interval\", \"deviation\""},
      {"<figures><means y='a' x='robots' scale='sqrt'/></figures>",
       "attribute \"scale\": expected one of \"linear\", \"log\""},
      {"<figures><means y='a' x='robots' reference='inf'/></figures>",
       "attribute \"reference\": found \"inf\""},
      {"<figures><means y='a' x='robots' width='99'/></figures>",
       "attribute \"width\": expected a number of pixels from 100 to 4000, found 99"},
      {"<figures><means y='a' x='robots' height='4001'/></figures>",
       "attribute \"height\": expected a number of pixels from 100 to 4000, found 4001"},
      {"<collect><metric name='a' series='true'/></collect>"
       "<figures><series y='a' band='sd'/></figures>",
       "attribute \"band\": expected one of \"quartiles\", \"interval\""},
      {"<collect><metric name='a' series='true'/></collect>"
       "<figures><series y='a' ended='keep'/></figures>",
       "attribute \"ended\": expected one of \"survivors\", \"hold\", \"drop\""},
      {"<figures><pie y='a'/></figures>", "in <figures>"},
      {"<figures><boxplot y='a' x='robots' colour='red'/></figures>",
       "attribute \"colour\" is not used by anything"},
      {"<collect><metric name='a'/></collect><figures><boxplot y='b' x='robots'/></figures>",
       "the metric \"b\" is not collected: <collect> does not name it"},
      {"<collect><metric name='a'/></collect><figures><series y='a'/></figures>",
       "\"a\" is collected as one number of a run, not as a series"},
      {"<collect><metric name='able' series='true'/></collect>"
       "<tests><compare metric='abl' factor='robots'/></tests>",
       "the metric \"abl\" is not collected: <collect> does not name it; did you mean \"able\"?"},
      {"<collect><metric name='a' series='true'/></collect>"
       "<figures><difference y='a' group='robots' scale='log'/></figures>",
       "attribute \"scale\" is not used by anything"},
      {"<tests><compare metric='a' factor='x'/></tests>", "there is no factor \"x\""},
      {"<slurm tasks='0'/>", "at least 1, found 0"},
      {"<slurm tasks='2' partitions='x'/>", "did you mean \"partition\"?"},
      {"some text", "the text 'some text' inside it is not used by anything"},
  }));
  CAPTURE(element);
  CHECK_THAT(ErrorWith(element), Contains(message) && Contains("test.xml:"));
}

TEST_CASE("campaign file: figures, tests and stopping rules take the last value of a series",
          "[campaign][design]") {
  // the value is stored with each run, as CMetricCollection does
  const std::string collect = "<collect><metric name='a' series='true'/></collect>";
  CHECK(ErrorWith(collect + "<figures><boxplot y='a' x='robots'/><means y='a' x='robots'/>"
                            "<series y='a' scale='log' xscale='log'/></figures>"
                            "<tests><compare metric='a' factor='robots'/></tests>") == "");
  CHECK(ReadCampaignError("<runs until='a' relative='0.1'/>" + collect) == "");
}

TEST_CASE("campaign file: the metric of the stopping rule is collected", "[campaign][design]") {
  CHECK_THAT(ReadCampaignError("<runs until='delivred' relative='0.1'/>"
                               "<collect><metric name='delivered'/></collect>"),
             Contains("test.xml:2: <runs>: attribute \"until\": the metric \"delivred\" is not "
                      "collected") &&
                 Contains("did you mean \"delivered\"?"));
}

TEST_CASE("campaign file: a comparison needs two levels", "[campaign][design]") {
  CHECK_THAT(ReadCampaignError("<runs seeds='1'/><factors><factor name='a' "
                               "path='//entity/@quantity' values='1'/></factors>"
                               "<tests><compare metric='m' factor='a'/></tests>"),
             Contains("\"a\" has one value only"));
}

TEST_CASE("campaign file: what fails to be read has no consequences", "[campaign][design]") {
  const std::string text = ReadCampaignError(
      "<runs seeds='1'/><factors><factor name='a' path='//entity/@quantity' values=''/>"
      "<exclude where='a == 1'/></factors><figures><boxplot y='m' x='a'/>"
      "<series y='m' where='a == 1'/></figures><collect><metric name='m' "
      "series='true'/></collect>");
  CHECK_THAT(text, Contains("attribute \"values\" is empty"));
  CHECK_THAT(text, !Contains("errors in the campaign"));
}

}  // namespace campaign_reader_test
