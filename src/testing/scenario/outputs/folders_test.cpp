// Two runs in one folder, killed runs, and names that would leave the folder.

#include "limited_run.h"
#include "recorded_experiment.h"

#include <catch2/catch.hpp>

#include <signal.h>
#include <sys/file.h>
#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace folders_test {

using namespace argos;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

// a run with frames and data that ends only when it is killed
class CEndlessRun {
 public:
  explicit CEndlessRun(const CTestFolder& folder) {
    SCircumstances circumstances;
    circumstances.Out = "endless.txt";
    circumstances.Err = "endless_errors.txt";
    m_process = StartProgram(
        folder, {"-c", "e.argos", "--length", "0", "--set", "framework/experiment/@real_time=true"},
        circumstances);
    REQUIRE(WaitForFile(folder, "out/frame_0000000000.png"));
  }
  ~CEndlessRun() { Kill(); }
  CEndlessRun(const CEndlessRun&) = delete;
  CEndlessRun& operator=(const CEndlessRun&) = delete;

  void Kill() {
    if (m_process > 0) {
      kill(m_process, SIGKILL);
      WaitFor(m_process);
      m_process = 0;
    }
  }
  std::string Name() const { return "process " + std::to_string(m_process); }

 private:
  pid_t m_process = 0;
};

}  // namespace

TEST_CASE("folders: a second run cannot write the frames of one that runs", "[outputs][folders]") {
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  CEndlessRun first(folder);
  const std::vector<std::string> second = {"-c",    "e.argos",
                                           "--set", "loop_functions/foraging/@output=other.csv",
                                           "--set", "framework/profiling/@file=other.txt"};
  const SProgramRun refused = RunProgramUnder(folder, second, {});
  CHECK(refused.Status == 1);
  CHECK_THAT(refused.Err, Contains("\"out\"") && Contains(first.Name()) && Contains("frame_"));
  SECTION("other names are free") {
    std::vector<std::string> other = second;
    other.insert(other.end(), {"--set", "visualization/offscreen/@base_name=second_"});
    CHECK(RunProgramUnder(folder, other, {}).Status == 0);
    CHECK(fs::exists(folder.Path("out/second_0000000020.png")));
  }
  SECTION("a killed run locks nothing") {
    first.Kill();
    CHECK(RunProgramUnder(folder, second, {}).Status == 0);
    CheckOutputsAreReadable(folder);
  }
}

TEST_CASE("folders: a folder of --csv that cannot be is an error before the run",
          "[outputs][folders]") {
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  const bool isCheck = GENERATE(false, true);
  const SProgramRun run =
      folder.Run({"-zc", "e.argos", "--csv", "e.argos/csv", isCheck ? "--check" : "--quiet"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("--csv: ") && Contains("e.argos"));
}

TEST_CASE("folders: a second run cannot write the data of one that runs", "[outputs][folders]") {
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  const CEndlessRun first(folder);
  const SProgramRun refused = RunProgramUnder(
      folder, {"-z", "-c", "e.argos", "--set", "framework/profiling/@file=other.txt"}, {});
  CHECK(refused.Status == 1);
  CHECK_THAT(refused.Err, Contains("cannot write the file \"data.csv\"") && Contains("process") &&
                              Contains("is writing it"));
}

TEST_CASE("folders: the parts that killed runs have left are removed, and nothing else",
          "[outputs][folders]") {
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  fs::create_directory(folder.Path("out"));
  folder.Write("out/frame_0000000007.png.argos3.part", "half a pict");
  folder.Write("out/other_0000000007.bmp.argos3.part", "half a pict");
  const std::vector<std::string> ofOthers = {"out/film.part", "out/notes.txt",
                                             "out/frame_0000000007.png.part"};
  for (const std::string& name : ofOthers) {
    folder.Write(name, "others'");
  }
  // a part that is being written
  folder.Write("out/live_0000000001.png.argos3.part", "half a pict");
  const int live = open(folder.Path("out/live_0000000001.png.argos3.part").c_str(), O_RDONLY);
  REQUIRE(flock(live, LOCK_EX) == 0);
  CHECK(RunProgramUnder(folder, {"-c", "e.argos"}, {}).Status == 0);
  close(live);
  CHECK_FALSE(fs::exists(folder.Path("out/frame_0000000007.png.argos3.part")));
  CHECK_FALSE(fs::exists(folder.Path("out/other_0000000007.bmp.argos3.part")));
  CHECK(fs::exists(folder.Path("out/live_0000000001.png.argos3.part")));
  for (const std::string& name : ofOthers) {
    CHECK(folder.Read(name) == "others'");
  }
}

TEST_CASE("folders: data of a killed run consist of whole lines", "[outputs][folders]") {
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  SCircumstances circumstances;
  circumstances.Out = "endless.txt";
  const pid_t process =
      StartProgram(folder, {"-z", "-c", "e.argos", "--length", "0"}, circumstances);
  CHECK(WaitForFile(folder, "data.csv"));
  kill(process, SIGKILL);
  WaitFor(process);
  const std::string data = folder.Read("data.csv");
  REQUIRE_FALSE(data.empty());
  // whole lines are written at once, but a killed process ends within write(), between two pages
  const bool isWhole = data.back() == '\n' || data.size() % 4096 == 0;
  CAPTURE(data.size());
  CHECK(isWhole);
}

TEST_CASE("folders: the base name of frames does not lead out of their folder",
          "[outputs][folders][bad_input]") {
  const std::string name = GENERATE("../frame_", "/tmp/frame_", "a/b");
  CAPTURE(name);
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  const SProgramRun run = RunProgramUnder(
      folder, {"-c", "e.argos", "--set", "visualization/offscreen/@base_name=" + name}, {});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("base name") && Contains('"' + name + '"') && Contains("directory"));
}

TEST_CASE("folders: frames go to paths of any length that the system allows",
          "[outputs][folders]") {
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  std::string directory = "out";
  while (directory.size() < 700) {
    directory += '/' + std::string(60, 'd');
  }
  const std::string option = "visualization/offscreen/@directory=" + directory;
  CHECK(RunProgramUnder(folder, {"-c", "e.argos", "--set", option}, {}).Status == 0);
  CHECK(fs::exists(folder.Path(directory + "/frame_0000000020.png")));
  // a folder in the place of the frame
  fs::create_directories(folder.Path("second/frame_0000000010.png"));
  fs::rename(folder.Path("second"), folder.Path(directory + "/second"));
  const SProgramRun run =
      RunProgramUnder(folder, {"-c", "e.argos", "--set", option + "/second"}, {});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("frame_0000000010.png\" cannot be written: Is a directory"));
}

}  // namespace folders_test
