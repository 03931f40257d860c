// Invalid libraries, and controllers that throw.

#include "experiment_text.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace controllers_test {

using namespace argos;
using Catch::Contains;

namespace {

std::string Controllers(const std::string& controller) {
  return "<controllers>" + controller + "</controllers>";
}

std::string FromLibrary(const std::string& label, const std::string& library) {
  return "<controllers><" + label + " id=\"c\" library=\"" + library +
         "\"><actuators/><sensors/><params/></" + label + "></controllers>";
}

}  // namespace

TEST_CASE("bad input: a library that does not exist", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = FromLibrary("test_idle", "no/such/library");
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains(At(SExperimentText::kControllersLine)) && Contains("no/such/library"));
  // that the robot has no controller is a consequence, and not reported
  CHECK_THAT(error, !Contains(At(SExperimentText::kArenaLine)));
}

TEST_CASE("bad input: a file that is not a library", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = FromLibrary("test_idle", InSourceTree("CMakeLists.txt"));
  CHECK_THAT(LoadError(experiment), Contains("CMakeLists.txt"));
}

TEST_CASE("bad input: a library without the requested controller", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = FromLibrary("test_idel", BadControllersLibrary());
  CHECK_THAT(LoadError(experiment), Contains("test_idel") && Contains("test_idle"));
}

TEST_CASE("bad input: a library that was built against another version", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = FromLibrary("test_wrong_build_controller", OtherVersionLibrary());
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kControllersLine)) &&
                                        Contains("argos3_test_wrong_build") &&
                                        Contains("core=000000000000"));
}

TEST_CASE("bad input: a controller without an id", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers =
      Controllers("<test_idle id=\"\" library=\"" + BadControllersLibrary() + "\"/>");
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains(At(SExperimentText::kControllersLine)) && Contains("<test_idle>") &&
                        Contains("attribute \"id\" is empty"));
}

TEST_CASE("bad input: a robot that refers to a controller without an id", "[bad_input]") {
  SExperimentText experiment;
  experiment.Robot = "<e-puck id=\"ep\"><body/><controller config=\"\"/></e-puck>";
  CHECK_THAT(LoadError(experiment), Contains(At(SExperimentText::kArenaLine)) &&
                                        Contains("attribute \"config\" is empty") &&
                                        Contains("<controllers>"));
  // also for <distribute> with many robots, and reported once
  experiment.Robot =
      "<distribute><position method=\"uniform\" min=\"-1,-1,0\" max=\"1,1,0\"/><orientation "
      "method=\"constant\" values=\"0,0,0\"/><entity quantity=\"5\" max_trials=\"9\">" +
      experiment.Robot + "</entity></distribute>";
  const std::string error = LoadError(experiment);
  const std::string found = "attribute \"config\" is empty";
  REQUIRE_THAT(error, Contains(found));
  CHECK(error.find(found) == error.rfind(found));
}

TEST_CASE("bad input: a controller that throws in Init", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = Controllers(SExperimentText::Controller("test_throws_in_init"));
  CHECK_THAT(LoadError(experiment), Contains("ep") && Contains("no good beginning") &&
                                        Contains(At(SExperimentText::kArenaLine)));
}

TEST_CASE("bad input: a controller that throws in its step", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = Controllers(SExperimentText::Controller("test_throws_in_step"));
  CHECK_THAT(RunError(experiment),
             Contains("\"ep\"") && Contains("tired after two steps") && Contains("tick 3"));
}

TEST_CASE("bad input: a controller that throws a value that is not a std::exception",
          "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = Controllers(
      SExperimentText::Controller("test_throws_in_step", "<params no_exception=\"true\"/>"));
  CHECK_THAT(RunError(experiment), Contains("\"ep\"") && Contains("tick 3"));
}

TEST_CASE("bad input: files written before a controller threw are intact", "[bad_input]") {
  const std::string file = InBuildTree("bad_input_steps.txt");
  std::remove(file.c_str());
  SExperimentText experiment;
  experiment.Controllers = Controllers(
      SExperimentText::Controller("test_throws_in_step", "<params file=\"" + file + "\"/>"));
  REQUIRE(RunError(experiment) != "");
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  CHECK(text.str() == "step 0\nstep 1\nstep 2\n");
  std::remove(file.c_str());
}

TEST_CASE("bad input: wheel speeds that are infinite or NaN", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = Controllers(SExperimentText::Controller("test_not_a_number"));
  CHECK_THAT(RunError(experiment), Contains("\"ep\"") && Contains("nan"));
}

TEST_CASE("bad input: all errors are reported together", "[bad_input]") {
  SExperimentText experiment;
  experiment.Controllers = Controllers(SExperimentText::Controller("test_idel"));
  experiment.Media = "<media><no_medium id=\"m\"/></media>";
  experiment.Box =
      "<box id=\"b\" size=\"0,1,1\" movable=\"false\"><body/></box><no_entity id=\"n\"/>";
  experiment.Rest = "<loop_functions label=\"no_loop_functions\"/>";
  const std::string error = LoadError(experiment);
  CHECK_THAT(error, Contains("5 errors"));
  CHECK_THAT(error, Contains("test_idel"));
  CHECK_THAT(error, Contains("no_medium"));
  CHECK_THAT(error, Contains("<box"));
  CHECK_THAT(error, Contains("no_entity"));
  CHECK_THAT(error, Contains("no_loop_functions"));
}

}  // namespace controllers_test
