// Messages that the first mistakes of a beginner cause.

#include "experiment_text.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <regex>

namespace bad_input_messages_test {

using namespace argos;
using Catch::Contains;

namespace {

std::string WithDevices(const std::string& actuators, const std::string& sensors) {
  return "<controllers><test_idle id=\"c\" library=\"" + BadControllersLibrary() +
         "\"><actuators>" + actuators + "</actuators><sensors>" + sensors +
         "</sensors><params/></test_idle></controllers>";
}

}  // namespace

TEST_CASE("messages: another root element is an error", "[bad_input][messages]") {
  std::string xml = SExperimentText().ToXml();
  for (std::size_t at = xml.find("argos-configuration"); at != std::string::npos;
       at = xml.find("argos-configuration")) {
    xml.replace(at, 19, "experiment");
  }
  CHECK(LoadErrorOfXml(xml) ==
        "[FATAL] test.argos:1: the root element is <experiment>, expected <argos-configuration>; "
        "is it an experiment file?");
}

TEST_CASE("messages: an error in <framework> hides no others", "[bad_input][messages]") {
  SExperimentText experiment;
  experiment.Framework =
      "<framework><experiment ticks_per_second=\"ten\" length=\"1\"/></framework>";
  experiment.Engines = "<physics_engines><dynamic2d id=\"dyn2d\"/></physics_engines>";
  experiment.Box = "<bxo id=\"b\"/>";
  CHECK_THAT(LoadError(experiment),
             Contains("[FATAL] 3 errors in the experiment:\n[FATAL] 1. test.argos:2: <experiment>: "
                      "attribute \"ticks_per_second\": found \"ten\"") &&
                 Contains("\n[FATAL] 2. test.argos:4: there is no physics engine of type "
                          "<dynamic2d>; did you mean \"dynamics2d\"") &&
                 Contains("\n[FATAL]    there is no entity \"bxo\"; did you mean \"box\"?\n"));
}

TEST_CASE("messages: an arena without a size", "[bad_input][messages]") {
  SExperimentText experiment;
  experiment.ArenaAttributes = "";
  CHECK_THAT(LoadError(experiment),
             Catch::StartsWith(
                 "[FATAL] test.argos:6: <arena>: attribute \"size\" is missing; it has none"));
}

TEST_CASE("messages: a missing attribute is not recommended by its misspelling",
          "[bad_input][messages]") {
  SExperimentText experiment;
  experiment.Box = "<box id=\"b\" size=\"0.2,0.2,0.2\"><body position=\"1,0,0\"/></box>";
  CHECK_THAT(LoadError(experiment),
             Contains("<box>: attribute \"movable\" is missing; it has: id, size"));
  experiment.Box =
      "<distribute><position method=\"uniform\" min=\"-1,-1,0\" max=\"1,1,0\"/>"
      "<orientation metod=\"constant\" values=\"0,0,0\"/><entity quantity=\"1\" "
      "max_trials=\"9\"><e-puck id=\"x\"><controller config=\"c\"/></e-puck></entity></distribute>";
  CHECK_THAT(LoadError(experiment), Contains("<orientation>: attribute \"method\" is missing; is "
                                             "\"metod\" a misspelling of it?"));
}

TEST_CASE("messages: a missing implementation lists those that there are",
          "[bad_input][messages]") {
  SExperimentText experiment;
  experiment.Controllers =
      WithDevices("<differential_steering/>", "<range_and_bearing medium=\"rab\"/>");
  const std::string error = LoadError(experiment);
  CHECK_THAT(error,
             Contains("<differential_steering>: attribute \"implementation\" is missing; the "
                      "actuator has: \"dead_reckoning\", \"default\""));
  CHECK_THAT(error, Contains("<range_and_bearing>: attribute \"implementation\" is missing; the "
                             "sensor has: \"medium\""));
}

TEST_CASE("messages: a library without the label that its element names says what it registers",
          "[bad_input][messages]") {
  SExperimentText experiment;
  experiment.Rest =
      "<loop_functions library=\"" + BadControllersLibrary() + "\" label=\"walker\"/>";
  CHECK_THAT(LoadError(experiment), Contains("\"walker\"") &&
                                        Contains(".so\" is loaded and registers ") &&
                                        Contains("test_idle") && !Contains("ARGOS_PLUGIN_PATH"));
}

TEST_CASE("messages: unknown plug-ins say how to name a library and where it is searched",
          "[bad_input][messages]") {
  SExperimentText experiment;
  SECTION("an entity") {
    experiment.Box = "<my-robot id=\"b\"/>";
    CHECK_THAT(LoadError(experiment), Contains("there is no entity \"my-robot\""));
  }
  SECTION("a device") {
    experiment.Controllers = WithDevices("", "<compass implementation=\"default\"/>");
    CHECK_THAT(LoadError(experiment), Contains("there is no sensor \"compass (default)\""));
  }
  SECTION("an add-on") {
    experiment.Engines =
        "<physics_engines><dynamics3d id=\"d\"><wind/></dynamics3d></physics_engines>";
    CHECK_THAT(LoadError(experiment), Contains("<dynamics3d> has no add-on <wind>"));
  }
  SECTION("a medium") {
    experiment.Media = "<media><sound id=\"s\"/></media>";
    CHECK_THAT(LoadError(experiment), Contains("there is no medium of type <sound>"));
  }
  CHECK(std::regex_search(
      LoadError(experiment),
      std::regex("\n\\[FATAL\\] If a library of yours has it: name the library, with "
                 "library=\"PATH\" in this element, or put its folder into ARGOS_PLUGIN_PATH; "
                 "searched in: [^\n]*" +
                 InBuildTree("lib/argos3"))));
}

TEST_CASE("messages: the library of any element that names a plug-in is loaded",
          "[bad_input][messages]") {
  const std::string library = " library=\"/none/libx\"";
  SExperimentText experiment;
  std::string place = "6: <e-puck>";
  SECTION("a robot") {
    experiment.Robot.insert(std::string("<e-puck").size(), library);
  }
  SECTION("a device") {
    experiment.Controllers =
        WithDevices("<differential_steering implementation=\"default\"" + library + "/>", "");
    place = "3: <differential_steering>";
  }
  SECTION("an engine") {
    experiment.Engines = "<physics_engines><dynamics2d id=\"d\"" + library + "/></physics_engines>";
    place = "4: <dynamics2d>";
  }
  SECTION("an add-on") {
    experiment.Engines = "<physics_engines><dynamics3d id=\"d\"><floor" + library +
                         "/></dynamics3d></physics_engines>";
    place = "4: <floor>";
  }
  SECTION("a medium") {
    experiment.Media = "<media><led id=\"leds\"" + library + "/></media>";
    place = "5: <led>";
  }
  CHECK_THAT(LoadError(experiment), Contains("test.argos:" + place + ": attribute \"library\"") &&
                                        Contains("\n[FATAL] The library \"/none/libx\" cannot be "
                                                 "loaded; tried:\n[FATAL]   /none/libx[.so]: no "
                                                 "such file"));
}

TEST_CASE("messages: robots that begin inside a wall are a warning", "[bad_input][messages]") {
  SExperimentText experiment;
  experiment.Robot = SExperimentText::RobotAt("ep", "0.9,0,0");
  CHECK(LoadWarnings(experiment) == "[WARNING] \"ep\" at (0.9,0,0) overlaps \"b\" at the start\n");
  experiment.Robot += SExperimentText::RobotAt("eq", "1,0.1,0");
  CHECK(LoadWarnings(experiment) ==
        "[WARNING] \"ep\" at (0.9,0,0) overlaps \"b\" at the start, and 1 more\n");
  // beside it, with a radius of 3.7 cm
  experiment.Robot = SExperimentText::RobotAt("ep", "0.86,0,0");
  CHECK(LoadWarnings(experiment).empty());
}

TEST_CASE("messages: a closing tag of another element is named", "[bad_input][messages]") {
  std::string xml = SExperimentText().ToXml();
  xml.replace(xml.find("</arena>"), 8, "</arean>");
  CHECK(LoadErrorOfXml(xml) ==
        "[FATAL] test.argos:6: not well-formed XML: </arean> is found where </arena> must come "
        "first: <arena> of line 6 is still open");
}

}  // namespace bad_input_messages_test
