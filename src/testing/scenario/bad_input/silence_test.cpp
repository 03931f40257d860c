// What ARGoS 3 accepts silently is reported, and all errors are reported at once.

#include "experiment_text.h"

#include <argos3/core/utility/text/string_utilities.h>

#include <catch2/catch.hpp>

namespace argos::silence_test {

using Catch::Contains;

namespace {

std::string Box(const std::string& attributes, const std::string& position) {
  return "<box " + attributes + "><body position=\"" + position + "\"/></box>";
}

std::size_t CountLines(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("silence: text in an element is reported, with what was meant", "[bad_input][silence]") {
  SExperimentText experiment;
  experiment.Controllers =
      "<controllers>" +
      SExperimentText::Controller("test_idle", "<params> velocity=\"40\" </params>") +
      "</controllers>";
  CHECK_THAT(LoadWarnings(experiment),
             Contains(At(SExperimentText::kControllersLine)) &&
                 Contains("<params>: the text 'velocity=\"40\"' inside it is not used by anything; "
                          "attributes belong into the tag: <params velocity=\"40\" />"));
  experiment = SExperimentText();
  experiment.Media = "<media>some text</media>";
  CHECK_THAT(LoadWarnings(experiment), Contains(At(SExperimentText::kMediaLine)) &&
                                           Contains("<media>: the text 'some text'"));
}

TEST_CASE("silence: a misspelt attribute gives the nearest name", "[bad_input][silence]") {
  SExperimentText experiment;
  experiment.Engines = "<physics_engines><dynamics2d id=\"d\" iteratoins=\"5\"/></physics_engines>";
  CHECK_THAT(LoadWarnings(experiment),
             Contains(At(SExperimentText::kEnginesLine)) &&
                 Contains("\"iteratoins\" is not used by anything; did you mean \"iterations\"?"));
}

TEST_CASE("silence: a device of a controller must not be repeated", "[bad_input][silence]") {
  const std::string device = GENERATE("proximity", "differential_steering");
  CAPTURE(device);
  SExperimentText experiment;
  experiment.Controllers =
      "<controllers>" +
      SExperimentText::Controller("test_idle", "<params/>",
                                  "<sensors><proximity implementation=\"default\"/></sensors>") +
      "</controllers>";
  const std::string element = '<' + device + " implementation=\"default\"/>";
  Replace(experiment.Controllers, element, '\n' + element + "\n<!-- -->\n" + element);
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains(At(SExperimentText::kControllersLine + 3) + " <" + device +
                             ">: there is already one at "));
  const std::string first = At(SExperimentText::kControllersLine + 1);
  CHECK_THAT(error, Contains("at " + first.substr(0, first.rfind(':')) + "; merge them"));
  // once, whatever the number of robots
  CHECK(error.find("already one") == error.rfind("already one"));
}

TEST_CASE("silence: a section of which only the first is read must not be repeated",
          "[bad_input][silence]") {
  SExperimentText experiment;
  int line = SExperimentText::kArenaLine;
  std::string tag;
  SECTION("a section of the experiment") {
    tag = GENERATE("framework", "controllers", "physics_engines", "media", "arena");
    line = SExperimentText::kRestLine;
    experiment.Rest = '<' + tag + "><light id=\"l\"/></" + tag + '>';
  }
  SECTION("a section of a controller") {
    tag = GENERATE("sensors", "params");
    line = SExperimentText::kControllersLine + 1;
    experiment.Controllers =
        "<controllers>" +
        SExperimentText::Controller("test_idle", "<params/>\n<" + tag + "><x/></" + tag + '>') +
        "</controllers>";
  }
  SECTION("a part of an entity") {
    tag = "body";
    experiment.Box =
        "<box id=\"b\" size=\"0.2,0.2,0.2\" movable=\"false\">"
        "<body position=\"1,0,0\"/><body position=\"1,1,0\"/></box>";
  }
  SECTION("the LEDs of a prototype") {
    tag = "leds";
    experiment.Media = "<media><led id=\"led\"/></media>";
    experiment.Box =
        "<prototype id=\"p\" movable=\"true\"><body position=\"1,0,0\"/>\n<links ref=\"base\">"
        "<link id=\"base\" geometry=\"box\" size=\"0.1,0.1,0.1\" mass=\"1\"/></links><devices>"
        "<leds medium=\"led\"><led anchor=\"origin\" offset=\"0,0,0.1\" color=\"red\"/></leds>\n"
        "<leds medium=\"led\"><led anchor=\"origin\" offset=\"0,0,0.2\" color=\"red\"/></leds>"
        "</devices></prototype>";
    line += 2;
  }
  CAPTURE(tag, experiment.ToXml());
  CHECK_THAT(LoadError(experiment),
             Contains(At(line) + " <" + tag + ">: there is already one at test.argos:") &&
                 Contains("; merge them, or remove one"));
}

TEST_CASE("silence: what users' code reads may be repeated", "[bad_input][silence]") {
  SExperimentText experiment;
  experiment.Controllers = "<controllers>" +
                           SExperimentText::Controller("test_idle", "<params><a/><a/></params>") +
                           "</controllers>";
  CHECK(LoadError(experiment).empty());
}

TEST_CASE("silence: empty ids are reported", "[bad_input][silence]") {
  SExperimentText experiment;
  experiment.Box = Box("id=\"\" size=\"0.2,0.2,0.2\" movable=\"false\"", "1,0,0");
  CHECK_THAT(LoadWarnings(experiment), Contains(At(SExperimentText::kArenaLine)) &&
                                           Contains("<box>: attribute \"id\" is empty"));
}

TEST_CASE("silence: bodies outside of the arena are reported once", "[bad_input][silence]") {
  SExperimentText experiment;
  experiment.Robot = SExperimentText::RobotAt("e0", "3,0,0") +
                     SExperimentText::RobotAt("e1", "0,-3,0") +
                     SExperimentText::RobotAt("e2", "0,0,0");
  const std::string warnings = LoadWarnings(experiment);
  CHECK_THAT(warnings, Contains("2 bodies are outside of the arena, from (-2,-2,-0.5) to "
                                "(2,2,0.5): \"e0\" at (3,0,0), ..."));
  CHECK(CountLines(warnings, "[WARNING]") == 1);
  // walls may stand around the arena
  experiment.Robot = SExperimentText::RobotAt("e2", "0,0,0") +
                     Box("id=\"w\" size=\"0.1,4,0.5\" movable=\"false\"", "2.05,0,0");
  CHECK(LoadWarnings(experiment).empty());
}

TEST_CASE("silence: the number of warnings is limited", "[bad_input][silence]") {
  SExperimentText experiment;
  experiment.Media = "<media>";
  for (int i = 0; i < 50; ++i) {
    experiment.Media += "<led id=\"l" + std::to_string(i) + "\" colour=\"red\"/>\n";
  }
  experiment.Media += "</media>";
  const std::string warnings = LoadWarnings(experiment);
  CHECK(CountLines(warnings, "[WARNING]") == 21);
  CHECK_THAT(warnings, Contains("[WARNING] ... and 30 warnings more"));
}

TEST_CASE("errors: several faults of an element are reported at once", "[bad_input][silence]") {
  SExperimentText experiment;
  experiment.Box =
      "<box id=\"b\" size=\"1,x,1\" movable=\"yes\"><body position=\"far\" "
      "orientation=\"up\"/></box>";
  CHECK_THAT(LoadError(experiment), Contains("4 errors") && Contains("\"size\"") &&
                                        Contains("\"movable\"") && Contains("\"position\"") &&
                                        Contains("\"orientation\""));
  experiment = SExperimentText();
  experiment.Engines =
      "<physics_engines><dynamics2d id=\"d\" iterations=\"0\" elevation=\"x\" "
      "gripping_rigidity=\"y\"/></physics_engines>";
  CHECK_THAT(LoadError(experiment), Contains("3 errors") && Contains("\"iterations\"") &&
                                        Contains("\"elevation\"") &&
                                        Contains("\"gripping_rigidity\""));
  // a single fault stays a single error
  experiment = SExperimentText();
  experiment.Box = Box("id=\"b\" size=\"1,x,1\" movable=\"false\"", "1,0,0");
  CHECK_THAT(LoadError(experiment), Contains("\"size\"") && !Contains("errors"));
}

TEST_CASE("errors: faults of several devices are reported at once", "[bad_input][silence]") {
  SExperimentText experiment;
  experiment.Controllers =
      "<controllers>" +
      SExperimentText::Controller(
          "test_idle", "<params/>",
          "<sensors><proximity implementation=\"default\" noise_level=\"loud\"/>\n"
          "<light implementation=\"defautl\"/>\n"
          "<ground implementation=\"rot_z_only\" noise_level=\"-1\"/></sensors>") +
      "</controllers>";
  CHECK_THAT(LoadError(experiment), Contains("3 errors in its devices") && Contains("\"loud\"") &&
                                        Contains("defautl") && Contains("-1"));
}

TEST_CASE("errors: several faults of a device are reported at once", "[bad_input][silence]") {
  SExperimentText experiment;
  experiment.Controllers =
      "<controllers>" +
      SExperimentText::Controller("test_idle", "<params/>",
                                  "<sensors><proximity implementation=\"default\" "
                                  "noise_level=\"loud\" show_rays=\"perhaps\"/></sensors>") +
      "</controllers>";
  CHECK_THAT(LoadError(experiment), Contains("2 errors in its devices") && Contains("\"loud\"") &&
                                        Contains("\"perhaps\""));
}

TEST_CASE("errors: faults of <distribute> and of what follows are reported at once",
          "[bad_input][silence]") {
  SExperimentText experiment;
  experiment.Robot =
      "<distribute><position method=\"unifrom\" min=\"-1,-1,0\" max=\"1,1,0\"/>"
      "<orientation method=\"constant\" values=\"0,0\"/>"
      "<entity quantity=\"-3\" max_trials=\"many\"><e-puck id=\"e\" rab_range=\"far\">"
      "<controller config=\"d\"/></e-puck></entity></distribute>"
      "<distribute><position method=\"constant\" values=\"0,0,0\"/></distribute>";
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains("unifrom") && Contains("\"values\"") && Contains("\"quantity\"") &&
                        Contains("\"max_trials\"") && Contains("\"far\"") &&
                        Contains("<orientation> is missing"));
}

}  // namespace argos::silence_test
