#include <argos3/core/simulator/query_plugins.h>

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/datatypes/color.h>

#include <catch2/catch.hpp>

#include <map>
#include <string>

namespace query_plugins_test {

using namespace argos;
using Catch::Contains;
using Catch::StartsWith;

namespace {

class CQueryTestMedium : public CMedium {
 public:
  void Update() override {}
};
REGISTER_MEDIUM(CQueryTestMedium, "query_test_one", "A. Author", "1.5", "The first of two.",
                "All about the first.\n", "Usable")
REGISTER_MEDIUM(CQueryTestMedium, "query_test_two", "B. Author", "2.5", "The second of two.",
                "All about the second.\n", "Experimental")

// counts how often each value of an attribute is read, as "mode=fast"
class CQueryTestChoices : public CMedium {
 public:
  static std::map<std::string, int> Values;

  void Init(TConfigurationNode& tree) override {
    CMedium::Init(tree);
    const auto mode = Read<std::string>(tree, "mode");
    const bool isLimited = Read<bool>(tree, "is_limited");
    const bool isRed = Read<CColor>(tree, "tint") == CColor::RED;
    for (const std::string& value :
         {"mode=" + mode, std::string(isLimited ? "limited" : "unlimited"),
          std::string(isRed ? "tint=red" : "tint=other")}) {
      ++Values[value];
    }
    if (isLimited) {
      Read<Real>(tree, "query_limit");
    }
    if (mode != "fast" && mode != "slow") {
      THROW_ARGOSEXCEPTION("unknown mode \"" << mode << "\"; known: fast, slow");
    }
    if (mode == "slow") {
      Read<Real>(tree, "query_delay");
    }
  }
  void Update() override {}

 private:
  template <typename T>
  static T Read(TConfigurationNode& tree, const char* name) {
    T value;
    GetNodeAttribute(tree, name, value);
    return value;
  }
};
std::map<std::string, int> CQueryTestChoices::Values;
REGISTER_MEDIUM(CQueryTestChoices, "query_choices", "C. Author", "1.0", "It has choices.",
                "EXAMPLES\n\n"
                "  <query_choices id=\"first\" mode=\"fast\" tint=\"red\" "
                "is_limited=\"false\" />\n\n"
                "  <query_choices id=\"second\" mode=\"fast\" tint=\"red\" "
                "is_limited=\"false\" />\n",
                "Usable")

}  // namespace

TEST_CASE("query: a list has a header, and two lines for each plug-in", "[core][query]") {
  const std::string text = DescribePlugins("media");
  CHECK_THAT(text, StartsWith("AVAILABLE MEDIA\n\n"));
  CHECK_THAT(text, Contains("   [ query_test_one ]\n      The first of two.\n\n"
                            "   [ query_test_two ]\n      The second of two.\n\n"));
}

TEST_CASE("query: all prints the lists in their order", "[core][query]") {
  const std::string text = DescribePlugins("all");
  size_t previous = 0;
  for (const char* header :
       {"AVAILABLE ACTUATORS\n", "AVAILABLE SENSORS\n", "AVAILABLE PHYSICS ENGINES\n",
        "AVAILABLE MEDIA\n", "AVAILABLE VISUALIZATIONS AND OTHER OUTPUTS\n", "AVAILABLE ENTITIES\n",
        "AVAILABLE CONTROLLERS\n", "AVAILABLE LOOP FUNCTIONS\n"}) {
    CAPTURE(header);
    const size_t position = text.find(header);
    REQUIRE(position != std::string::npos);
    CHECK(position >= previous);
    previous = position;
  }
  CHECK(DescribePlugins("sensors") + DescribePlugins("physics_engines") ==
        text.substr(text.find("AVAILABLE SENSORS"),
                    text.find("AVAILABLE MEDIA") - text.find("AVAILABLE SENSORS")));
}

TEST_CASE("query: a word finds every plug-in whose label contains it", "[core][query]") {
  const std::string text = DescribePlugins("query_test");
  const std::string library = CFactory<CMedium>::GetTypes().at("query_test_one").Library;
  CHECK_THAT(text, StartsWith("[ query_test_one ]\nThe first of two.\n\n"
                              "A medium by A. Author, version 1.5.\n\n"));
  CHECK_THAT(text,
             Contains(library) && Contains("\nIN EXPERIMENT FILES\n\nAll about the first.\n"));
  CHECK_THAT(text, Contains(std::string(78, '=') +
                            "\n[ query_test_two ]\nThe second of two.\n\n"
                            "A medium by B. Author, version 2.5, status: Experimental.\n"));
}

TEST_CASE("query: a whole name precedes parts of names, which are named", "[core][query]") {
  const CPluginKind kind("query_test_names", "", "NAMES", [] {
    return std::vector<SPluginText>{
        {"query_whole", "undefined", "undefined", "undefined", "undefined", "undefined"},
        {"query_whole_two", "undefined", "undefined", "undefined", "undefined", "undefined"}};
  });
  const std::string text = DescribePlugins("query_whole");
  CHECK_THAT(text, StartsWith("[ query_whole ]\n(no description)\n") &&
                       Contains("See also: query_whole_two\n") && !Contains("undefined"));
}

TEST_CASE("query: plug-ins of a plug-in are listed below it, in all and in searches",
          "[core][query]") {
  const CPluginKind kind("query_test_parts", "query_test_one", "PARTS OF QUERY TEST ONE", [] {
    return std::vector<SPluginText>{
        {"query_part", "C. Author", "0.5", "A part.", "All.\n", "Usable"}};
  });
  const std::string list = "PARTS OF QUERY TEST ONE\n\n   [ query_part ]\n      A part.\n\n";
  CHECK(DescribePlugins("query_test_parts") == list);
  CHECK_THAT(DescribePlugins("all"), Contains(list));
  CHECK_THAT(DescribePlugins("query_test_one"), Contains("All about the first.\n\n" + list));
  CHECK_THAT(DescribePlugins("query_test_two"), !Contains("PARTS"));
  CHECK_THAT(DescribePlugins("query_part"),
             Contains("[ query_part ]\nA part.\n\nA part of query_test_one by C. Author"));
}

TEST_CASE("query: elements of experiment files that are no plug-ins", "[core][query]") {
  CHECK_THAT(DescribePlugins("elements"), StartsWith("AVAILABLE OTHER ELEMENTS") &&
                                              Contains("[ experiment ]") && Contains("[ arena ]"));
  const CElementText element("query_element", "D. Author", "An element.", "All about it.\n");
  CHECK_THAT(
      DescribePlugins("query_element"),
      StartsWith("[ query_element ]\nAn element.\n\nAn element by D. Author, version 1.0.\n") &&
          Contains("IN EXPERIMENT FILES\n\nAll about it.\n"));
}

TEST_CASE("query: the search is case-sensitive", "[core][query]") {
  CHECK_THAT(DescribePlugins("Query_test"), StartsWith("Nothing found"));
}

TEST_CASE("query: a search without results names near labels", "[core][query]") {
  const SPluginAnswer answer = AnswerQuery("query_tset_one");
  CHECK_THAT(answer.Text, StartsWith("Nothing found") && Contains("query_test_one"));
  CHECK_FALSE(answer.IsFound);
  CHECK(AnswerQuery("query_test_one").IsFound);
  CHECK_THAT(DescribePlugins("sensor_s"), Contains("sensors"));
}

TEST_CASE("query: what is read is found by loading samples, with the values that may decide",
          "[core][query]") {
  CQueryTestChoices::Values.clear();
  CHECK_THAT(DescribePlugins("query_limit"), Contains("media/query_choices"));
  std::map<std::string, int>& values = CQueryTestChoices::Values;
  CHECK(values["mode=slow"] > 0);
  CHECK(values["mode=slow"] < 5);
  CHECK(values["limited"] > 0);
  CHECK(values["tint=red"] > 0);
  CHECK(values["tint=other"] == 0);
  CHECK_THAT(DescribePlugins("query_delay"), Contains("media/query_choices"));
}

TEST_CASE("query: controllers in Lua are documented", "[core][query]") {
  CHECK_THAT(DescribePlugins("controllers"),
             Contains("[ lua_controller ]\n      A controller written in Lua."));
  CHECK_THAT(DescribePlugins("lua_controller"),
             Contains("script") && Contains("on_error") && Contains("max_instructions"));
}

TEST_CASE("query: the core's floor is documented", "[core][query]") {
  CHECK_THAT(DescribePlugins("floor"), Contains("[ floor ]") && Contains("pixels_per_meter"));
}

}  // namespace query_plugins_test
