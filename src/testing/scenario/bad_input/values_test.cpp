// Values that are malformed or out of range.

#include "experiment_text.h"

#include <catch2/catch.hpp>

namespace values_test {

using namespace argos;
using Catch::Contains;

namespace {

std::string Framework(const std::string& experimentAttributes, const std::string& more = "") {
  return "<framework><experiment " + experimentAttributes + "/>" + more + "</framework>";
}

}  // namespace

TEST_CASE("bad input: text that is not well-formed XML", "[bad_input]") {
  const std::string error =
      LoadErrorOfXml("<argos-configuration>\n<framework>\n</argos-configuration>\n");
  CHECK_THAT(error, Contains("test.argos:3") && Contains("<framework> of line 2 is still open"));
  CHECK_THAT(LoadErrorOfXml(""), Contains("test.argos"));
  CHECK_THAT(LoadErrorOfXml("not xml at all"), Contains("test.argos"));
}

TEST_CASE("bad input: a missing section", "[bad_input]") {
  SExperimentText experiment;
  experiment.Engines.clear();
  CHECK_THAT(LoadError(experiment), Contains("physics_engines"));
  CHECK_THAT(LoadErrorOfXml("<argos-configuration/>"), Contains("framework"));
}

TEST_CASE("bad input: invalid values in <framework>", "[bad_input]") {
  const std::string wrong =
      GENERATE(as<std::string>{}, "ticks_per_second=\"0\"", "ticks_per_second=\"-1\"",
               "ticks_per_second=\"10.5\"", "ticks_per_second=\"ten\"", "ticks_per_second=\"\"",
               "ticks_per_second=\"99999999999\"");
  CAPTURE(wrong);
  SExperimentText experiment;
  experiment.Framework = Framework(wrong);
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kFrameworkLine)) && Contains("ticks_per_second"));
}

TEST_CASE("bad input: an invalid length of the experiment", "[bad_input]") {
  const std::string wrong =
      GENERATE(as<std::string>{}, "-1", "nan", "inf", "1e30", "0.05", "1s", "1,5");
  CAPTURE(wrong);
  SExperimentText experiment;
  experiment.Framework = Framework("ticks_per_second=\"10\" length=\"" + wrong + "\"");
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kFrameworkLine)) && Contains("\"length\""));
}

TEST_CASE("bad input: invalid threads and methods", "[bad_input]") {
  SExperimentText experiment;
  const std::string good = "ticks_per_second=\"10\"";
  experiment.Framework = Framework(good, "<system threads=\"-1\"/>");
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kFrameworkLine)) && Contains("threads"));
  experiment.Framework = Framework(good, "<system threads=\"4000000000\"/>");
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kFrameworkLine)) &&
                                        Contains("threads") && Contains("4000000000"));
  experiment.Framework = Framework(good, "<system threads=\"2\" method=\"balance_quantiti\"/>");
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kFrameworkLine)) &&
                                        Contains("balance_quantiti") &&
                                        Contains("balance_quantity"));
}

TEST_CASE("bad input: an invalid size of the arena", "[bad_input]") {
  const std::string wrong =
      GENERATE(as<std::string>{}, "0,4,1", "4,-4,1", "4,4,-1", "4,4", "4,4,1,1", "4,4,high", "");
  CAPTURE(wrong);
  SExperimentText experiment;
  experiment.ArenaAttributes = "size=\"" + wrong + "\"";
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kArenaLine)) && Contains("size"));
}

TEST_CASE("bad input: an arena may have no height", "[bad_input]") {
  SExperimentText experiment;
  experiment.ArenaAttributes =
      "size=\"4,4,0\" center=\"" + GENERATE(as<std::string>{}, "0,0,0", "0,0,0.5") + '"';
  const std::string engine =
      GENERATE(as<std::string>{}, "dynamics2d", "kinematics2d", "dynamics3d", "pointmass3d");
  CAPTURE(experiment.ArenaAttributes, engine);
  experiment.Engines = "<physics_engines><" + engine + " id=\"e\"/></physics_engines>";
  experiment.Media = "<media><led id=\"l\" index=\"grid\"/><range_and_bearing id=\"rab\"/></media>";
  experiment.Robot =
      "<distribute><position method=\"uniform\" min=\"-2,-2,0\" max=\"0,2,0\"/>"
      "<orientation method=\"constant\" values=\"0,0,0\"/>"
      "<entity quantity=\"3\" max_trials=\"100\"><e-puck id=\"ep\"><controller config=\"c\"/>"
      "</e-puck></entity></distribute>";
  CHECK(LoadWarnings(experiment) == "");
}

TEST_CASE("bad input: zero and negative sizes and masses", "[bad_input]") {
  const std::string wrong =
      GENERATE(as<std::string>{}, "<box id=\"b\" size=\"0,1,1\" movable=\"false\"><body/></box>",
               "<box id=\"b\" size=\"1,1,-1\" movable=\"false\"><body/></box>",
               "<box id=\"b\" size=\"1,1,1\" movable=\"true\" mass=\"0\"><body/></box>",
               "<box id=\"b\" size=\"1,1,1\" movable=\"true\"><body/></box>",
               "<cylinder id=\"b\" radius=\"0\" height=\"1\" movable=\"false\"><body/></cylinder>",
               "<cylinder id=\"b\" radius=\"1\" height=\"-1\" movable=\"false\"><body/></cylinder>",
               "<cylinder id=\"b\" radius=\"1\" height=\"1\" movable=\"true\" "
               "mass=\"-2\"><body/></cylinder>");
  CAPTURE(wrong);
  SExperimentText experiment;
  experiment.Box = wrong;
  experiment.Robot.clear();
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kArenaLine)));
}

TEST_CASE("bad input: errors on malformed values give attribute, text and expected format",
          "[bad_input]") {
  SExperimentText experiment;
  experiment.Box = "<box id=\"b\" size=\"1,1,1\" movable=\"yes\"><body position=\"1,0,0\"/></box>";
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kArenaLine)) &&
                                        Contains("movable") && Contains("yes") &&
                                        Contains("\"true\" or \"false\""));
  experiment.Box =
      "<box id=\"b\" size=\"1,1,1\" movable=\"false\"><body position=\"1;0;0\"/></box>";
  CHECK_THAT(LoadError(experiment), Contains("position") && Contains("1;0;0") && Contains("x,y,z"));
}

TEST_CASE("bad input: errors on text that ARGoS 3 accepts name --lenient", "[bad_input]") {
  const auto [position, isAccepted] = GENERATE(table<std::string, bool>(
      {{"--1,-1,0", true}, {"-1,,0", true}, {"1,0,0,7", true}, {"1,0", false}, {"", false}}));
  CAPTURE(position);
  SExperimentText experiment;
  experiment.Box = "<box id=\"b\" size=\"0.2,0.2,0.2\" movable=\"false\"><body position=\"" +
                   position + "\"/></box>";
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains("found \"" + position + "\", expected three real numbers"));
  CHECK((error.find("--lenient reads it as ARGoS 3 does") != std::string::npos) == isAccepted);
  experiment.Framework = Framework("ticks_per_second=\"10\" length=\"1\" lenient=\"true\"");
  CHECK((LoadError(experiment) == "") == isAccepted);
}

TEST_CASE("bad input: whole numbers may be written as real numbers", "[bad_input]") {
  SExperimentText experiment;
  experiment.Framework = Framework("ticks_per_second=\"10.0\" length=\"1\" random_seed=\"1e2\"");
  experiment.Media = "<media><led id=\"l\" index=\"grid\" grid_size=\"2,2,1.0\"/></media>";
  experiment.Robot =
      "<distribute><position method=\"uniform\" min=\"-2,-2,0\" max=\"0,2,0\"/>"
      "<orientation method=\"constant\" values=\"0,0,0\"/>"
      "<entity quantity=\"12.0\" max_trials=\"1e3\"><e-puck id=\"ep\"><controller config=\"c\"/>"
      "</e-puck></entity></distribute>";
  CHECK(LoadWarnings(experiment).empty());
}

TEST_CASE("bad input: a lenient experiment reads malformed numbers as ARGoS 3 does",
          "[bad_input]") {
  SExperimentText experiment;
  experiment.Framework =
      Framework("ticks_per_second=\"10\" length=\"1s\" random_seed=\"1\" lenient=\"true\"");
  experiment.Box =
      "<box id=\"b\" size=\"0.2,0.2,0.2,9\" movable=\"false\"><body position=\"1,,0\"/></box>";
  experiment.Robot =
      "<distribute><position method=\"uniform\" min=\"-2,-2,0\" max=\"0,2,0\"/>"
      "<orientation method=\"constant\" values=\"0,0,0\"/>"
      "<entity quantity=\"3 robots\" max_trials=\"100\"><e-puck id=\"ep\" rab_range=\"0.5m\">"
      "<controller config=\"c\"/></e-puck></entity></distribute>";
  const std::string warnings = LoadWarnings(experiment);
  CHECK_THAT(warnings, Contains(At(SExperimentText::kFrameworkLine)) && Contains("\"1s\""));
  CHECK_THAT(warnings, Contains("\"0.2,0.2,0.2,9\"") && Contains("\"1,,0\""));
  CHECK_THAT(warnings, Contains("\"3 robots\""));
  // once, not once for each robot
  const size_t first = warnings.find("\"0.5m\"");
  REQUIRE(first != std::string::npos);
  CHECK(warnings.find("\"0.5m\"", first + 1) == std::string::npos);
  experiment.Framework = Framework("ticks_per_second=\"10\" length=\"1s\" random_seed=\"1\"");
  CHECK_THAT(LoadError(experiment), Contains("found \"1s\""));
}

TEST_CASE("bad input: robots outside every engine", "[bad_input]") {
  SExperimentText experiment;
  experiment.Engines =
      "<physics_engines><dynamics2d id=\"west\"><boundaries><sides><vertex point=\"-2,-2\"/>"
      "<vertex point=\"2,-2\"/><vertex point=\"2,2\"/><vertex point=\"-2,2\"/></sides></boundaries>"
      "</dynamics2d></physics_engines>";
  experiment.Robot = SExperimentText::RobotAt("lost", "3,0,0");
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kArenaLine)) &&
                                        Contains("\"lost\"") && Contains("3,0,0") &&
                                        Contains("\"west\""));
  experiment.Robot = SExperimentText::RobotAt("flying", "0,0,0.5");
  CHECK_THAT(LoadError(experiment), Contains("\"flying\""));
}

TEST_CASE("bad input: more robots than fit into the area", "[bad_input]") {
  SExperimentText experiment;
  experiment.Robot =
      "<distribute><position method=\"uniform\" min=\"0,0,0\" max=\"0.1,0.1,0\"/>"
      "<orientation method=\"constant\" values=\"0,0,0\"/>"
      "<entity quantity=\"7\" max_trials=\"20\"><e-puck id=\"ep\"><controller config=\"c\"/>"
      "</e-puck></entity></distribute>";
  CHECK_THAT(LoadError(experiment), Contains("ep") && Contains("21"));
}

TEST_CASE("bad input: a region that is not a convex polygon", "[bad_input]") {
  SExperimentText experiment;
  experiment.Engines =
      "<physics_engines><dynamics2d id=\"d\"><boundaries><sides><vertex point=\"0,0\"/>"
      "<vertex point=\"0,1\"/><vertex point=\"1,0\"/></sides></boundaries></dynamics2d>"
      "</physics_engines>";
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kEnginesLine)) && Contains("clockwise"));
}

}  // namespace values_test
