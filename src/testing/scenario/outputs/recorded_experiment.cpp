#include "recorded_experiment.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <FreeImage.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace argos {

namespace {

namespace fs = std::filesystem;

constexpr int kTicks = 20;
const char* const kFrames[] = {"out/frame_0000000000.png", "out/frame_0000000010.png",
                               "out/frame_0000000020.png"};

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void CheckPicture(const std::string& path) {
  CAPTURE(path);
  FIBITMAP* const bitmap = FreeImage_Load(FIF_PNG, path.c_str());
  REQUIRE(bitmap != nullptr);
  CHECK(FreeImage_GetWidth(bitmap) == 32);
  CHECK(FreeImage_GetHeight(bitmap) == 32);
  FreeImage_Unload(bitmap);
}

// the number of rows below the title; rows are whole and in order
int CheckTable(const std::string& text) {
  int rows = 0;
  std::istringstream lines(text);
  std::string line;
  CAPTURE(text);
  REQUIRE((text.empty() || text.back() == '\n'));
  for (; std::getline(lines, line); ++rows) {
    if (rows == 0) {
      REQUIRE(line == "tick,out,resting,delivered");
      continue;
    }
    REQUIRE(std::count(line.begin(), line.end(), ',') == 3);
    REQUIRE(line.substr(0, line.find(',')) == std::to_string(rows));
  }
  return std::max(0, rows - 1);
}

}  // namespace

std::string RecordedExperiment() {
  const std::string library = InBuildTree("experiments/libfootbot_foraging");
  return R"(<argos-configuration>
  <framework>
    <experiment length="2" ticks_per_second="10" random_seed="1"/>
    <profiling file="profile.txt" format="human_readable" truncate_file="true"/>
  </framework>
  <controllers>
    <footbot_foraging_controller id="c" library=")" +
         library + R"(">
      <actuators>
        <differential_steering implementation="default"/>
        <leds implementation="default" medium="leds"/>
        <range_and_bearing implementation="default"/>
      </actuators>
      <sensors>
        <range_and_bearing implementation="medium" medium="rab"/>
        <footbot_proximity implementation="default"/>
        <footbot_light implementation="rot_z_only"/>
        <footbot_motor_ground implementation="rot_z_only"/>
      </sensors>
      <params max_speed="10" exploring_ticks="600" resting_ticks="50" leaving_probability="0.1"/>
    </footbot_foraging_controller>
  </controllers>
  <loop_functions library=")" +
         library + R"(" label="foraging_loop_functions">
    <foraging items="3" radius="0.1" area_x="0.6:2.3" area_y="-1.6:1.6" output="data.csv"/>
  </loop_functions>
  <arena size="5.4,4,1">
    <floor id="floor" source="loop_functions" pixels_per_meter="4"/>
    <foot-bot id="a"><body position="-1,1,0"/><controller config="c"/></foot-bot>
    <foot-bot id="b"><body position="-1,-1,0"/><controller config="c"/></foot-bot>
  </arena>
  <physics_engines><dynamics2d id="d"/></physics_engines>
  <media><led id="leds"/><range_and_bearing id="rab"/></media>
  <visualization><offscreen size="32x32" every="10" samples="1"/></visualization>
  <unknown_element/>
</argos-configuration>
)";
}

std::vector<std::string> RecordedArguments() {
  return {"-c", "e.argos", "-l", "log.txt", "-e", "err.txt", "--digest"};
}

void CheckOutputsAreReadable(const CTestFolder& folder) {
  std::error_code ignored;
  fs::directory_iterator entry(folder.Path("out"), ignored);
  for (; entry != fs::directory_iterator(); ++entry) {
    const std::string path = entry->path().string();
    CAPTURE(path);
    REQUIRE(EndsWith(path, ".png"));
    CheckPicture(path);
  }
  CheckTable(folder.Read("data.csv"));
  for (const char* file : {"log.txt", "err.txt", "profile.txt"}) {
    const std::string text = folder.Read(file);
    CAPTURE(file, text);
    CHECK((text.empty() || text.back() == '\n'));
  }
}

void CheckOutputsAreComplete(const CTestFolder& folder) {
  CheckOutputsAreReadable(folder);
  for (const char* frame : kFrames) {
    CheckPicture(folder.Path(frame));
  }
  CHECK(CheckTable(folder.Read("data.csv")) == kTicks);
  CHECK_THAT(folder.Read("log.txt"), Catch::Contains("digest: "));
  CHECK_THAT(folder.Read("err.txt"), Catch::Contains("unknown_element"));
  CHECK_THAT(folder.Read("profile.txt"), Catch::Contains("phase \"post-step\""));
}

}  // namespace argos
