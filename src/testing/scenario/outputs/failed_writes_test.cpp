// Every output of a run fails, from any byte on: the run ends with status 1 and a message that
// names the file and the reason, and what it has written can be read.

#include "limited_run.h"
#include "recorded_experiment.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

namespace failed_writes_test {

using namespace argos;
using Catch::Contains;

namespace {

const std::string kFailingWrites = InBuildTree("testing/faults/libargos3_test_failing_writes.so");
constexpr char kFull[] = "No space left on device";

SCircumstances FailingFrom(long byte, const std::string& file) {
  SCircumstances circumstances;
  circumstances.Environment = {"LD_PRELOAD=" + kFailingWrites,
                               "ARGOS_TEST_FAIL_AFTER=" + std::to_string(byte),
                               "ARGOS_TEST_FAIL_FILE=" + file};
  return circumstances;
}

// where errors are reported: the error log, unless this is the file that fails
std::string Errors(const CTestFolder& folder, const SProgramRun& run) {
  return folder.Read("err.txt") + folder.Read("log.txt") + run.Out;
}

// a length that the file has in every run: it may contain times of different lengths
long SizeOf(const CTestFolder& folder, const std::string& file) {
  const auto size = static_cast<long>(std::filesystem::file_size(folder.Path(file)));
  return file == "log.txt" || file == "profile.txt" ? size - 60 : size;
}

// @param part  of the path of the file that fails
void CheckFailure(const std::string& part, long byte) {
  CAPTURE(part, byte);
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  const SProgramRun run = RunProgramUnder(folder, RecordedArguments(), FailingFrom(byte, part));
  CAPTURE(run.Err);
  REQUIRE(run.Status == 1);
  CHECK_THAT(Errors(folder, run), Contains(part) && Contains(kFull) && Contains("[FATAL]"));
  CheckOutputsAreReadable(folder);
}

// @return bytes of a file, from the first to the last one
std::vector<long> Range(long size, long count) {
  std::vector<long> bytes = {0, 1};
  for (long i = 1; i < count; ++i) {
    bytes.push_back(size * i / count);
  }
  bytes.push_back(size - 1);
  std::sort(bytes.begin(), bytes.end());
  bytes.erase(std::unique(bytes.begin(), bytes.end()), bytes.end());
  return bytes;
}

void CheckFailures(long countPerFile) {
  const CTestFolder complete;
  complete.Write("e.argos", RecordedExperiment());
  const SProgramRun run = RunProgramUnder(complete, RecordedArguments(), {});
  CAPTURE(run.Err, Errors(complete, run));
  REQUIRE(run.Status == 0);
  CheckOutputsAreComplete(complete);
  for (const char* file :
       {"frame_0000000010.png", "data.csv", "profile.txt", "log.txt", "err.txt"}) {
    const std::string path = std::string(file).rfind("frame", 0) == 0 ? "out/" : "";
    for (const long byte : Range(SizeOf(complete, path + file), countPerFile)) {
      CheckFailure(file, byte);
    }
  }
}

}  // namespace

TEST_CASE("outputs: a write that fails from any byte on ends the run, and files stay readable",
          "[outputs][faults]") {
  CheckFailures(2);
}

TEST_CASE("outputs: writes fail from one of many bytes on", "[.][soak][outputs][faults]") {
  CheckFailures(60);
}

TEST_CASE("outputs: a write that would fail later does no harm", "[outputs][faults]") {
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  CHECK(RunProgramUnder(folder, RecordedArguments(), FailingFrom(100000000, ".")).Status == 0);
  CheckOutputsAreComplete(folder);
}

TEST_CASE("outputs: a limit of the size of files is an error, not a signal", "[outputs][faults]") {
  const unsigned long size = GENERATE(0u, 40u, 200u);
  CAPTURE(size);
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  SCircumstances circumstances;
  circumstances.FileSize = size;
  circumstances.Out = "/dev/null";
  // the reason must fit somewhere
  circumstances.Err = "/dev/null";
  CHECK(RunProgramUnder(folder, RecordedArguments(), circumstances).Status == 1);
  CheckOutputsAreReadable(folder);
}

TEST_CASE("outputs: a full device in place of any output is an error", "[outputs][faults]") {
  const auto [option, what] = GENERATE(table<std::string, std::string>(
      {{"framework/profiling/@file=/dev/full", "/dev/full"},
       {"loop_functions/foraging/@output=/dev/full", "/dev/full"}}));
  CAPTURE(option);
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  std::vector<std::string> arguments = RecordedArguments();
  arguments.insert(arguments.end(), {"--set", option});
  CHECK(RunProgramUnder(folder, arguments, {}).Status == 1);
  CHECK_THAT(folder.Read("err.txt"),
             Contains("cannot write the file \"" + what) && Contains(kFull));
}

TEST_CASE("outputs: a full device for a log is an error on the other one", "[outputs][faults]") {
  const std::string option = GENERATE("-l", "-e");
  CAPTURE(option);
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  const SProgramRun run = RunProgramUnder(folder, {"-z", "-c", "e.argos", option, "/dev/full"}, {});
  CHECK(run.Status == 1);
  CHECK_THAT(option == "-l" ? run.Err : run.Out,
             Contains("[FATAL]") && Contains("\"/dev/full\": " + std::string(kFull)));
}

TEST_CASE("outputs: a full standard output is an error, for queries, too", "[outputs][faults]") {
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  SCircumstances full;
  full.Out = "/dev/full";
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"-zc", "e.argos"}, {"-q", "sensors"}, {"-h"}, {"-v"}}) {
    CAPTURE(arguments);
    const SProgramRun run = RunProgramUnder(folder, arguments, full);
    CHECK(run.Status == 1);
    CHECK_THAT(folder.Read("stderr.txt"),
               Contains("the standard output cannot be written") && Contains(kFull));
  }
}

TEST_CASE("outputs: a full standard error is an error", "[outputs][faults]") {
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  SCircumstances full;
  full.Err = "/dev/full";
  const SProgramRun run = RunProgramUnder(folder, {"-zc", "e.argos"}, full);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Out, Contains("the standard error cannot be written") && Contains(kFull));
}

}  // namespace failed_writes_test
