// Standard streams that are closed, pipes without a reader, and what Destroy() of users' code
// throws.

#include "limited_run.h"
#include "recorded_experiment.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <signal.h>
#include <unistd.h>

namespace streams_test {

using namespace argos;
using Catch::Contains;

TEST_CASE("streams: the logs do not go into the files of a run whose streams are closed",
          "[outputs][streams]") {
  const std::vector<int> closed =
      GENERATE(std::vector<int>{1}, std::vector<int>{0, 1, 2}, std::vector<int>{2});
  CAPTURE(closed);
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  SCircumstances circumstances;
  circumstances.Closed = closed;
  CHECK(RunProgramUnder(folder, {"-c", "e.argos", "--digest"}, circumstances).Status == 0);
  CheckOutputsAreReadable(folder);
  CHECK_THAT(folder.Read("data.csv"), !Contains("[INFO]") && Contains("\n20,"));
}

TEST_CASE("streams: a pipe without a reader ends the run in order", "[outputs][streams]") {
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  int ends[2] = {-1, -1};
  REQUIRE(pipe(ends) == 0);
  close(ends[0]);
  SCircumstances circumstances;
  circumstances.PipeAsOut = ends[1];
  const SProgramRun run = RunProgramUnder(folder, {"-c", "e.argos"}, circumstances);
  close(ends[1]);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err,
             Contains("[FATAL] the standard output cannot be written completely: Broken pipe"));
  // Destroy() of the parts has run
  CHECK_THAT(folder.Read("profile.txt"), Contains("wall time"));
  CheckOutputsAreReadable(folder);
}

TEST_CASE("streams: a controller's Destroy() that throws leaves nothing undestroyed",
          "[outputs][streams]") {
  const CTestFolder folder;
  const std::string library = InBuildTree("testing/plugins/libargos3_test_bad_controllers.so");
  std::string text = RecordedExperiment();
  const auto replace = [&text](const std::string& from, const std::string& to) {
    REQUIRE(text.find(from) != std::string::npos);
    text.replace(text.find(from), from.size(), to);
  };
  replace("</controllers>",
          "<test_throws_in_destroy id=\"bad\" library=\"" + library + "\"/></controllers>");
  for (int robot = 0; robot < 2; ++robot) {
    replace("<controller config=\"c\"/>", "<controller config=\"bad\"/>");
  }
  // the loop functions of foraging need its controllers
  const size_t begin = text.find("<loop_functions");
  text.erase(begin, text.find("<arena") - begin);
  folder.Write("e.argos", text);
  const SProgramRun run = RunProgramUnder(folder, {"-c", "e.argos"}, {});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("[FATAL] robot \"b\", controller \"bad\": Destroy()") &&
                          Contains("no good end") && Contains("[WARNING] Destroy() of 1 more"));
  CHECK_THAT(folder.Read("profile.txt"), Contains("phase \"post-step\""));
  // the visualization has removed its lock
  CheckOutputsAreReadable(folder);
}

}  // namespace streams_test
