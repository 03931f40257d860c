// Films: what ffmpeg makes of a run, and what happens if it does not.

#include "../command_line/program_run.h"
#include "../outputs/limited_run.h"

#include <argos3/support/child_process.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace films_test {

using namespace argos;
using Catch::Contains;

namespace {

const std::vector<std::string> kSmall = {"--length", "2", "--set", "//offscreen/@size=160x120"};

// 20 ticks of flocking in small pictures
std::vector<std::string> Flocking(const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"-zc", InSourceTree("experiments/flocking.argos")};
  arguments.insert(arguments.end(), kSmall.begin(), kSmall.end());
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

void CheckSuccess(const SProgramRun& run) {
  CAPTURE(run.Out, run.Err);
  REQUIRE(run.Status == 0);
}

// a command of a shell in the folder of the test; @return what it prints
std::string Shell(const CTestFolder& folder, const std::string& command) {
  const std::string whole = "cd '" + folder.Path(".") + "' && (" + command + ") > printed 2>&1";
  CAPTURE(whole);
  const int status = std::system(whole.c_str());
  CAPTURE(folder.Read("printed"));
  REQUIRE(status == 0);
  return folder.Read("printed");
}

bool HasFfmpeg() {
  const bool has = !FindProgram("ffmpeg").empty() && !FindProgram("ffprobe").empty();
  if (!has) {
    WARN("no ffmpeg: films are not tested");
  }
  return has;
}

// codec, width, height, frame rate, number of frames; duration
std::string Probe(const CTestFolder& folder, const std::string& film) {
  return Shell(folder,
               "ffprobe -v error -count_frames -of csv=p=0 -show_entries "
               "stream=codec_name,width,height,r_frame_rate,nb_read_frames:format=duration " +
                   film);
}

// of all pixels' channels, of all frames
std::string Pixels(const CTestFolder& folder, const std::string& input) {
  Shell(folder, "ffmpeg -y -v error " + input + " -pix_fmt rgb24 -f rawvideo pixels");
  return folder.Read("pixels");
}

double MeanDifference(const std::string& first, const std::string& second) {
  REQUIRE(first.size() == second.size());
  double sum = 0.0;
  for (size_t i = 0; i < first.size(); ++i) {
    sum += std::abs(static_cast<unsigned char>(first[i]) - static_cast<unsigned char>(second[i]));
  }
  return sum / static_cast<double>(first.size());
}

SCircumstances WithFfmpeg(const std::string& program, const std::vector<std::string>& more = {}) {
  SCircumstances circumstances;
  circumstances.Environment = {"ARGOS_FFMPEG=" + program};
  circumstances.Environment.insert(circumstances.Environment.end(), more.begin(), more.end());
  return circumstances;
}

// a script in place of ffmpeg; @return its path
std::string WriteFfmpeg(const CTestFolder& folder, const std::string& commands) {
  const std::string path = folder.Write("ffmpeg", "#!/bin/sh\n" + commands + "\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

// such a script on a disk with a fault. @param fault  NAME=FILE, for the library of failing writes
SCircumstances WithFaultyDisk(const CTestFolder& folder, const std::string& commands,
                              const std::string& fault) {
  return WithFfmpeg(
      WriteFfmpeg(folder, commands),
      {fault, "LD_PRELOAD=" + InBuildTree("testing/faults/libargos3_test_failing_writes.so")});
}

std::vector<std::string> ListParts(const CTestFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.Path("."))) {
    const std::string name = entry.path().filename().string();
    if (name.find(".part") != std::string::npos) {
      names.push_back(name);
    }
  }
  return names;
}

}  // namespace

TEST_CASE("films: each format has the frames of the run, and its duration",
          "[scenario][recording][films]") {
  if (!HasFfmpeg()) {
    return;
  }
  const auto [film, codec] = GENERATE(
      table<std::string, std::string>({{"a.mp4", "h264"}, {"a.webm", "vp9"}, {"a.gif", "gif"}}));
  CAPTURE(film);
  const CTestFolder folder;
  const SProgramRun run = folder.Run(Flocking({"--video", film, "--speed", "2"}));
  CheckSuccess(run);
  CHECK_THAT(run.Notices, Contains("writing a film to " + film +
                                   ", 160x120 pixels, 20 frames a second, 2x real time") &&
                              Contains("The film " + film + " is complete: 21 pictures, 1.05 s"));
  CHECK_THAT(Probe(folder, film), Catch::StartsWith(codec + ",160,120,20/1,21\n1.05"));
  CHECK(ListParts(folder).empty());
}

TEST_CASE("films: frames are those that are drawn into files", "[scenario][recording][films]") {
  if (!HasFfmpeg()) {
    return;
  }
  const CTestFolder folder;
  std::vector<std::string> arguments =
      Flocking({"--video", "a.mp4", "--set", "//visualization/offscreen/@directory=frames", "--set",
                "//offscreen/@every=1"});
  arguments[0] = "-c";
  CheckSuccess(folder.Run(arguments));
  const std::string film = Pixels(folder, "-i a.mp4");
  const std::string frames = Pixels(folder, "-framerate 10 -pattern_type glob -i 'frames/*.png'");
  CHECK(frames.size() == 21u * 160 * 120 * 3);
  // of 255: loss of the codec, mainly of the resolution of colours
  CHECK(MeanDifference(film, frames) < 3.0);
}

TEST_CASE("films: a replay gives the film of the run", "[scenario][recording][films]") {
  if (!HasFfmpeg()) {
    return;
  }
  const CTestFolder folder;
  CheckSuccess(folder.Run(Flocking({"--record", "run.rec", "--video", "live.mp4"})));
  CheckSuccess(folder.Run({"-z", "--replay", "run.rec", "--video", "replayed.mp4", "--set",
                           "//offscreen/@size=160x120"}));
  CHECK(Pixels(folder, "-i live.mp4") == Pixels(folder, "-i replayed.mp4"));
  // every fifth state, in real time: the distance of states is that of the frames
  CheckSuccess(folder.Run({"-z", "--replay", "run.rec", "--from", "3", "--every", "5", "--video",
                           "part.mp4", "--set", "//offscreen/@size=160x120"}));
  CHECK_THAT(Probe(folder, "part.mp4"), Catch::StartsWith("h264,160,120,2/1,4\n2.0"));
}

TEST_CASE("films: odd sizes are rounded up, and low rates repeat frames",
          "[scenario][recording][films]") {
  if (!HasFfmpeg()) {
    return;
  }
  const CTestFolder folder;
  CheckSuccess(folder.Run(Flocking({"--video", "a.mp4", "--set", "//offscreen/@size=161x121",
                                    "--set", "//offscreen/@every=20"})));
  CHECK_THAT(Probe(folder, "a.mp4"), Catch::StartsWith("h264,162,122,1/1,4\n4.0"));
}

TEST_CASE("films: without ffmpeg there are frames, and the command that makes the film",
          "[scenario][recording][films]") {
  const CTestFolder folder;
  const SProgramRun run =
      RunProgramUnder(folder, Flocking({"--video", "it's.mp4"}), WithFfmpeg("/nowhere/ffmpeg"));
  CheckSuccess(run);
  CHECK_THAT(run.Err, Contains("[WARNING] There is no ffmpeg in PATH, nor as ARGOS_FFMPEG"));
  CHECK(std::filesystem::exists(folder.Path("it's.mp4.frames/frame_0000000020.png")));
  CHECK_FALSE(std::filesystem::exists(folder.Path("it's.mp4")));
  const size_t start = run.Err.find("\n  ffmpeg ");
  REQUIRE(start != std::string::npos);
  if (!HasFfmpeg()) {
    return;
  }
  const size_t end = run.Err.find('\n', start + 1);
  Shell(folder, run.Err.substr(start + 1, end - start - 1));
  CHECK_THAT(Probe(folder, "\"it's.mp4\""), Catch::StartsWith("h264,160,120,10/1,21\n2.1"));
}

TEST_CASE("films: an encoder that fails is an error with its last messages",
          "[scenario][recording][films]") {
  const std::string reads = GENERATE("", "head -c 300000 > /dev/null; ", "cat > /dev/null; ");
  CAPTURE(reads);
  const CTestFolder folder;
  folder.Write("fake.sh", "#!/bin/sh\n" + reads + "echo 'no such encoder' >&2; exit 7\n");
  ::chmod(folder.Path("fake.sh").c_str(), 0755);
  const SProgramRun run = RunProgramUnder(folder, Flocking({"--video", "a.mp4", "--csv", "tables"}),
                                          WithFfmpeg("./fake.sh"));
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err,
             Contains("The film \"a.mp4\" cannot be written: \"./fake.sh\" ended with "
                      "exit status 7 before the film was complete; its last messages:\n[FATAL] "
                      "  no such encoder"));
  CHECK(std::filesystem::exists(folder.Path("tables/robots.csv")));
  CHECK(ListParts(folder).empty());
  CHECK_FALSE(std::filesystem::exists(folder.Path("a.mp4")));
}

TEST_CASE("films: a limit of the size of files is an error", "[scenario][recording][films]") {
  if (!HasFfmpeg()) {
    return;
  }
  const CTestFolder folder;
  SCircumstances circumstances;
  circumstances.FileSize = 4096;
  circumstances.Out = "/dev/null";
  const SProgramRun run = RunProgramUnder(folder, Flocking({"--video", "a.mp4"}), circumstances);
  CHECK(run.Status == 1);
  CHECK_THAT(folder.Read("stderr.txt"), Contains("The film \"a.mp4\" cannot be written"));
  CHECK(ListParts(folder).empty());
}

TEST_CASE("films: a full disk ends the run at its second picture, whatever the encoder does",
          "[scenario][recording][films]") {
  const CTestFolder folder;
  // like ffmpeg, which writes nothing while its buffers have room
  const SCircumstances fullDisk =
      WithFaultyDisk(folder, "cat > /dev/null\nsleep 100", "ARGOS_TEST_FULL_DISK=a.mp4");
  const SProgramRun run =
      RunProgramUnder(folder, Flocking({"--video", "a.mp4", "--csv", "tables"}), fullDisk);
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err,
             Contains("The film \"a.mp4\" cannot be written: no space is left on its disk"));
  CHECK(ListParts(folder).empty());
  CHECK_FALSE(std::filesystem::exists(folder.Path("a.mp4")));
  // of 20 ticks: the second picture is due in one of the first
  const std::string table = folder.Read("tables/robots.csv");
  CHECK_THAT(table, Contains("\n0,1,") && !Contains("\n0,6,"));
}

TEST_CASE("films: a file system that does not say how large it is, is not full",
          "[scenario][recording][films]") {
  const CTestFolder folder;
  const SProgramRun run =
      RunProgramUnder(folder, Flocking({"--video", "a.mp4"}),
                      WithFaultyDisk(folder, "cat > /dev/null", "ARGOS_TEST_NO_SIZES=a.mp4"));
  CHECK(run.Err == "");
  CHECK(run.Status == 0);
  CHECK(std::filesystem::exists(folder.Path("a.mp4")));
}

TEST_CASE("films: an encoder that does nothing is killed, and is an error",
          "[scenario][recording][films]") {
  const CTestFolder folder;
  const SProgramRun run =
      RunProgramUnder(folder, Flocking({"--video", "a.mp4"}),
                      WithFfmpeg(WriteFfmpeg(folder, "sleep 100"), {"ARGOS_OUTPUT_TIMEOUT=0.5"}));
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("The film \"a.mp4\" cannot be written") &&
                          Contains("no sign of life for 0.5 s (ARGOS_OUTPUT_TIMEOUT)"));
  CHECK(ListParts(folder).empty());
}

TEST_CASE("films: places and names that cannot be written are errors before the run",
          "[scenario][recording][films]") {
  const CTestFolder folder;
  folder.Write("file", "");
  const auto [film, complaint] = GENERATE(table<std::string, std::string>(
      {{"a.avi", "its name must end in .mp4, .webm or .gif"},
       {"file/a.mp4", "The film \"file/a.mp4\" cannot be written: the folder \"file\""}}));
  CAPTURE(film);
  const SProgramRun run = folder.Run(Flocking({"--video", film}));
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains(complaint));
  CHECK_THAT(folder.Run(Flocking({"--speed", "2"})).Err,
             Contains("--speed can only be used with --video FILE"));
  CHECK_THAT(folder.Run(Flocking({"--video", "a.mp4", "--speed", "0"})).Err,
             Contains("--speed 0: expected a number from 0.0001 to 10000"));
}

TEST_CASE("films: an experiment without views gets the default one",
          "[scenario][recording][films]") {
  if (!HasFfmpeg()) {
    return;
  }
  const CTestFolder folder;
  folder.Write("e.argos", R"(
<argos-configuration>
  <framework><experiment length="1" ticks_per_second="10" random_seed="3" /></framework>
  <controllers />
  <arena size="4,4,1">
    <box id="crate" size="0.3,0.2,0.2" movable="true" mass="0.5"><body position="0.5,0,0" /></box>
  </arena>
  <physics_engines><dynamics2d id="dyn2d" /></physics_engines>
  <media />
</argos-configuration>
)");
  CheckSuccess(
      folder.Run({"-c", "e.argos", "--video", "new/a.mp4", "--set", "//offscreen/@size=64x48"}));
  CHECK_THAT(Probe(folder, "new/a.mp4"), Catch::StartsWith("h264,64,48,10/1,11\n1.1"));
}

TEST_CASE("films: an interrupted run leaves a whole film", "[scenario][recording][films]") {
  if (!HasFfmpeg()) {
    return;
  }
  const CTestFolder folder;
  const SProgramRun run =
      folder.Run({"-zc", InSourceTree("experiments/flocking.argos"), "--length", "100000",
                  "--video", "a.mp4", "--set", "//offscreen/@size=160x120"},
                 SIGINT, "writing a film");
  CHECK(run.Status == 130);
  CHECK_THAT(run.Notices, Contains("The film a.mp4 is complete"));
  CHECK_THAT(Probe(folder, "a.mp4"), Catch::StartsWith("h264,160,120,10/1,"));
}

}  // namespace films_test
