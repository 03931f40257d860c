// Numbers with which no engine can compute are refused with their range.

#include "experiment_text.h"

#include <argos3/program/query_plugins.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <catch2/catch.hpp>

#include <vector>

namespace ranges_test {

using namespace argos;
using Catch::Contains;

namespace {

const std::vector<std::string> kEngines = {
    "<dynamics2d id=\"e\"/>", "<kinematics2d id=\"e\"/>",
    "<dynamics3d id=\"e\"><floor/><gravity g=\"9.81\"/></dynamics3d>"};

std::string ErrorOfBox(const std::string& engine, const std::string& size,
                       const std::string& mass) {
  SExperimentText experiment;
  experiment.Engines = "<physics_engines>" + engine + "</physics_engines>";
  experiment.Box = "<box id=\"b\" size=\"" + size + "\" movable=\"true\" mass=\"" + mass +
                   "\"><body position=\"1,0,0\"/></box>";
  return RunError(experiment);
}

}  // namespace

TEST_CASE("ranges: masses and sizes without use are errors with file, line and range",
          "[bad_input][ranges]") {
  const std::string engine = GENERATE(from_range(kEngines));
  CAPTURE(engine);
  const std::string line = At(SExperimentText::kArenaLine);
  for (const char* const mass : {"1e39", "1e20", "2e9", "1e-7", "1e-300", "1e308"}) {
    CAPTURE(mass);
    CHECK_THAT(ErrorOfBox(engine, "0.2,0.2,0.2", mass), Contains(line) && Contains("\"mass\""));
  }
  CHECK_THAT(ErrorOfBox(engine, "0.2,0.2,0.2", "2e9"),
             Contains("must be a number from 1e-06 to 1e+09 kg, got 2e+09"));
  for (const char* const size : {"1e-300,1,1", "1,1e-6,1", "1,1,1e300", "1e6,1,1"}) {
    CAPTURE(size);
    CHECK_THAT(ErrorOfBox(engine, size, "1"), Contains(line) && Contains("\"size\""));
  }
}

TEST_CASE("ranges: bodies at the limits of all ranges have finite poses", "[bad_input][ranges]") {
  const std::string engine = GENERATE(from_range(kEngines));
  const std::string mass = GENERATE(as<std::string>{}, "1e-6", "1e9");
  const std::string size =
      GENERATE(as<std::string>{}, "1e-5,1e-5,1e-5", "0.2,1e-5,0.2", "0.3,0.3,0.3");
  CAPTURE(engine, mass, size);
  CHECK(ErrorOfBox(engine, size, mass).empty());
}

TEST_CASE("ranges: fields and gravity beyond use are errors", "[bad_input][ranges]") {
  SExperimentText experiment;
  experiment.Engines =
      "<physics_engines><dynamics3d id=\"e\"><gravity g=\"1e5\"/></dynamics3d></physics_engines>";
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kEnginesLine)) && Contains("from -10000 to 10000 m/s^2"));
  experiment = SExperimentText();
  experiment.Engines = "<physics_engines><dynamics3d id=\"e\"/></physics_engines>";
  experiment.Box =
      "<prototype id=\"p\" movable=\"true\"><body position=\"1,0,0\"/><links ref=\"a\"><link "
      "id=\"a\" geometry=\"box\" size=\"0.1,0.1,0.1\" mass=\"1\"/></links><devices><magnets>"
      "<magnet offset=\"0,0,0\" anchor=\"a\" passive_field=\"0,0,1e308\"/></magnets></devices>"
      "</prototype>";
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kArenaLine)) && Contains("passive_field"));
}

TEST_CASE("ranges: numbers above 1e12 are errors, except in users' parameters",
          "[bad_input][ranges]") {
  SExperimentText experiment;
  experiment.ArenaAttributes = "size=\"4,4,1\" center=\"1e13,0,0\"";
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kArenaLine)) &&
                                        Contains("attribute \"center\": found \"1e13,0,0\"") &&
                                        Contains("from -1e+12 to 1e+12"));
  CConfigurationDocument document;
  document.Parse("<a><params x='1e300'/>\n<b x='1e300'/></a>", "x.argos");
  Real value = 0.0;
  GetNodeAttribute(GetNode(document.GetRoot(), "params"), "x", value);
  CHECK(value == 1e300);
  CHECK_THROWS_WITH(GetNodeAttribute(GetNode(document.GetRoot(), "b"), "x", value),
                    Contains("x.argos:2: <b>: attribute \"x\": found \"1e300\""));
}

TEST_CASE("ranges: sizes of data and numbers of entities are limited", "[bad_input][ranges]") {
  SExperimentText experiment;
  experiment.Robot =
      "<e-puck id=\"e\" rab_data_size=\"10000000\"><body/><controller "
      "config=\"c\"/></e-puck>";
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kArenaLine)) &&
                 Contains("rab_data_size (bytes) must be an integer from 0 to 65535"));
  const auto distribute = [](const std::string& attributes) {
    return "<distribute><position method=\"uniform\" min=\"-20,-20,0\" max=\"20,20,0\"/>"
           "<orientation method=\"uniform\" min=\"0,0,0\" max=\"360,0,0\"/><entity " +
           attributes +
           "><e-puck id=\"e\"><controller config=\"c\"/></e-puck></entity></distribute>";
  };
  experiment.ArenaAttributes = "size=\"40,40,1\"";
  experiment.Robot = distribute("quantity=\"100000000\" max_trials=\"100\"");
  CHECK_THAT(LoadError(experiment), Contains("\"quantity\" must be an integer from 0 to 10000000"));
  // 1,640 m^2 for discs of 0.0039 m^2
  experiment.Robot = distribute("quantity=\"1000000\" max_trials=\"100\"");
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kArenaLine)) &&
                 Contains("there is no room for 1000000 bodies of at least 0.003"));
  experiment.Robot = distribute("quantity=\"1\" max_trials=\"1000000000000\"");
  CHECK_THAT(LoadError(experiment), Contains("\"max_trials\" must be an integer"));
}

TEST_CASE("ranges: the descriptions of plug-ins state them", "[bad_input][ranges]") {
  CHECK_THAT(DescribePlugins("box"), Contains("each from 1e-5 to 1e5") &&
                                         Contains("kg, from 1e-6 to 1e9") &&
                                         Contains("RANGES, where none is stated"));
}

TEST_CASE("ranges: walls that cannot be made are errors with file, line and reason",
          "[bad_input][ranges]") {
  const auto [walls, message] = GENERATE(table<std::string, std::string>(
      {{"thickness='1' height='1' points='0,0'", "at least two points"},
       {"thickness='0.1' height='1' points='0,0 1,b'", "1,b"},
       {"thickness='0.1' height='1' points='0,0 1,1 1,1'", "the point 1,1 comes twice in a row"},
       {"thickness='0.1' points='0,0 1,1'", "\"height\""},
       {"thickness='-1' height='1' points='0,0 1,1'", "\"thickness\" must be positive, got -1"},
       {"thickness='3' height='1'", "do not fit into the arena"},
       {"height='1' image='no.png' meters_per_pixel='1'", "there is no map \"no.png\"; looked for"},
       {"height='1' image='no.png' svg='a.svg'", "\"image\" and \"svg\" cannot be given together"},
       {"height='1' image='no.png' meters_per_pixel='1' threshold='2'", "at most 1, got 2"}}));
  CAPTURE(walls);
  SExperimentText experiment;
  experiment.Box = "<walls id='w' " + walls + "/>";
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kArenaLine) + " <walls>") && Contains(message));
  experiment = SExperimentText();
  experiment.ArenaAttributes = "size=\"4,4,1\" walls=\"0,1\"";
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kArenaLine) + " <arena>: attribute \"walls\""));
}

}  // namespace ranges_test
