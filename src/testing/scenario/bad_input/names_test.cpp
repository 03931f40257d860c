// Unknown and duplicate names.

#include "experiment_text.h"

#include <catch2/catch.hpp>

namespace names_test {

using namespace argos;
using Catch::Contains;

TEST_CASE("bad input: the experiment without changes is valid", "[bad_input]") {
  CHECK(LoadError(SExperimentText()) == "");
  CHECK(RunError(SExperimentText()) == "");
  CHECK(LoadWarnings(SExperimentText()) == "");
}

TEST_CASE("bad input: an unknown entity", "[bad_input]") {
  SExperimentText experiment;
  experiment.Box = "<bxo id=\"b\"/>";
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kArenaLine)) && Contains("bxo") && Contains("\"box\""));
}

TEST_CASE("bad input: an unknown device, or an unknown implementation", "[bad_input]") {
  SExperimentText experiment;
  const auto withSensor = [](const std::string& sensor) {
    return "<controllers>" +
           SExperimentText::Controller("test_idle", "<params/>",
                                       "<sensors>" + sensor + "</sensors>") +
           "</controllers>";
  };
  experiment.Controllers = withSensor("<proximitty implementation=\"default\"/>");
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kControllersLine)) &&
                                        Contains("proximitty") && Contains("proximity (default)"));
  experiment.Controllers = withSensor("<proximity implementation=\"exact\"/>");
  CHECK_THAT(LoadError(experiment), Contains("exact") && Contains("proximity (default)"));
  experiment.Controllers = withSensor("<proximity/>");
  CHECK_THAT(LoadError(experiment), Contains("implementation"));
}

TEST_CASE("bad input: an unknown physics engine", "[bad_input]") {
  SExperimentText experiment;
  experiment.Engines = "<physics_engines><dynamics2 id=\"dyn2d\"/></physics_engines>";
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains(At(SExperimentText::kEnginesLine)) && Contains("dynamics2") &&
                        Contains("\"dynamics2d\""));
  // that no engine accepts the robot is a consequence, and not reported
  CHECK_THAT(error, !Contains("ep"));
}

TEST_CASE("bad input: an unknown medium", "[bad_input]") {
  SExperimentText experiment;
  experiment.Media = "<media><ledd id=\"leds\"/></media>";
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kMediaLine)) && Contains("ledd"));
}

TEST_CASE("bad input: an unknown visualization is a warning and a headless run", "[bad_input]") {
  SExperimentText experiment;
  experiment.Rest = "<visualization><ofscreen/></visualization>";
  CHECK(RunError(experiment) == "");
  CHECK_THAT(LoadWarnings(experiment), Contains("[WARNING]") &&
                                           Contains(At(SExperimentText::kRestLine)) &&
                                           Contains("ofscreen"));
}

TEST_CASE("bad input: unknown loop functions", "[bad_input]") {
  SExperimentText experiment;
  experiment.Rest = "<loop_functions label=\"no_such_loop_functions\"/>";
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kRestLine)) && Contains("no_such_loop_functions"));
}

TEST_CASE("bad input: an unknown controller id", "[bad_input]") {
  SExperimentText experiment;
  experiment.Robot = "<e-puck id=\"ep\"><body/><controller config=\"cc\"/></e-puck>";
  CHECK_THAT(LoadError(experiment),
             Contains(At(SExperimentText::kArenaLine)) && Contains("\"cc\"") && Contains("\"c\""));
}

TEST_CASE("bad input: an unused attribute or element is a warning with its line", "[bad_input]") {
  SExperimentText experiment;
  experiment.ArenaAttributes += " colour=\"red\"";
  experiment.Rest = "<no_such_section/>";
  const std::string warnings = LoadWarnings(experiment);
  CHECK_THAT(warnings,
             Contains("[WARNING] " + At(SExperimentText::kArenaLine)) && Contains("\"colour\""));
  CHECK_THAT(warnings, Contains("[WARNING] " + At(SExperimentText::kRestLine)) &&
                           Contains("no_such_section"));
}

TEST_CASE("bad input: duplicate ids", "[bad_input]") {
  SExperimentText experiment;
  SECTION("of two boxes") {
    experiment.Box += experiment.Box;
    CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kArenaLine)) &&
                                          Contains("\"b\"") && Contains("unique"));
  }
  SECTION("of a robot and a box") {
    experiment.Robot = SExperimentText::RobotAt("b", "0,0,0");
    CHECK_THAT(LoadError(experiment), Contains("\"b\"") && Contains("unique"));
  }
  SECTION("of two controllers") {
    const std::string one = SExperimentText::Controller("test_idle");
    experiment.Controllers = "<controllers>" + one + one + "</controllers>";
    CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kControllersLine)) &&
                                          Contains("\"c\"") && Contains("unique"));
  }
  SECTION("of two engines") {
    experiment.Engines =
        "<physics_engines><dynamics2d id=\"d\"/><dynamics2d id=\"d\"/></physics_engines>";
    CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kEnginesLine)) &&
                                          Contains("\"d\"") && Contains("unique"));
  }
}

}  // namespace names_test
