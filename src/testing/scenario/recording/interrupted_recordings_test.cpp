// Recordings of runs that were killed, or that could not write them.

#include "../command_line/program_run.h"
#include "../outputs/limited_run.h"

#include <argos3/plugins/simulator/outputs/recording/format/recording_reader.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <thread>

namespace interrupted_recordings_test {

using namespace argos;
using Catch::Contains;

namespace {

std::vector<std::string> Arguments(const std::string& length, const std::string& file) {
  return {"-zc", InSourceTree("experiments/flocking.argos"), "--length", length, "--record", file};
}

}  // namespace

TEST_CASE("recording: of runs killed at 20 random moments, all can be opened",
          "[scenario][recording]") {
  std::mt19937 random(5);
  int numWithStates = 0;
  for (int i = 0; i < 20; ++i) {
    const CTestFolder folder;
    const pid_t process = StartProgram(folder, Arguments("100000", "run.rec"));
    REQUIRE(WaitForFile(folder, "run.rec"));
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 1500));
    ::kill(process, SIGKILL);
    CHECK(WaitFor(process) == 128 + SIGKILL);
    try {
      CRecordingReader reader(folder.Path("run.rec"));
      ++numWithStates;
      CHECK_THAT(reader.GetWarning(), Contains("was not finished"));
      UInt32 tick = 0;
      const SRecordedFrame* frame = reader.ReadNext();
      for (; frame != nullptr; frame = reader.ReadNext()) {
        REQUIRE(frame->Tick == tick++);
      }
      CHECK(tick == reader.GetLastTick() + 1);
    } catch (const CARGoSException& error) {
      // killed before it had simulated 100 ticks, or for a second
      CHECK_THAT(error.what(), Contains("has no state of any tick"));
    }
  }
  CHECK(numWithStates > 0);
}

TEST_CASE("replay: a recording of a killed run is played, with a warning",
          "[scenario][recording]") {
  const CTestFolder folder;
  REQUIRE(folder.Run(Arguments("30", "run.rec")).Status == 0);
  const std::string whole = folder.Read("run.rec");
  folder.Write("run.rec", whole.substr(0, whole.size() / 2));
  const SProgramRun run = folder.Run({"-z", "--replay", "run.rec"});
  CHECK(run.Status == 0);
  CHECK_THAT(run.Err, Contains("[WARNING] the recording \"run.rec\" was not finished, or was cut: "
                               "it ends with tick"));
  folder.Write("run.rec", "x" + whole);
  const SProgramRun foreign = folder.Run({"-z", "--replay", "run.rec"});
  CHECK(foreign.Status == 1);
  CHECK_THAT(foreign.Err, Contains("\"run.rec\" is no recording"));
}

TEST_CASE("recording: a file that cannot be created is an error before the run",
          "[scenario][recording]") {
  const CTestFolder folder;
  const SProgramRun run = folder.Run(Arguments("1", "nowhere/run.rec"));
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("<recording>: the run cannot be recorded") &&
                          Contains("cannot write the recording \"nowhere/run.rec\": No such file"));
  CHECK_THAT(folder.Run(Arguments("1", "/dev/full")).Err, Contains("No space left on device"));
  folder.Write("notes.txt", "precious");
  CHECK(folder.Run(Arguments("1", "notes.txt")).Status == 1);
  CHECK(folder.Read("notes.txt") == "precious");
}

TEST_CASE("recording: a full disk ends the run with an error, and what was written is readable",
          "[scenario][recording]") {
  const CTestFolder folder;
  SCircumstances circumstances;
  circumstances.FileSize = 40000;
  const SProgramRun run = RunProgramUnder(folder, Arguments("100000", "run.rec"), circumstances);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("cannot write the recording \"run.rec\": File too large"));
  const CRecordingReader reader(folder.Path("run.rec"));
  CHECK(reader.GetLastTick() > 0);
}

}  // namespace interrupted_recordings_test
