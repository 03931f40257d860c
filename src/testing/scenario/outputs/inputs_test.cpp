// FIFOs, devices and folders in the place of files that are read: errors, and no waiting.

#include "limited_run.h"
#include "recorded_experiment.h"

#include <catch2/catch.hpp>

#include <sys/stat.h>

#include <filesystem>

namespace inputs_test {

using namespace argos;
using Catch::Contains;

namespace {

struct SPlace {
  std::string Name;
  std::string Problem;
};

// the test driver would end a program that waits
SPlace MakePlace(const CTestFolder& folder, int kind) {
  switch (kind) {
    case 0:
      REQUIRE(mkfifo(folder.Path("fifo").c_str(), 0600) == 0);
      return {"fifo", "it is a FIFO"};
    case 1:
      return {"/dev/zero", "it is a device"};
    default:
      std::filesystem::create_directory(folder.Path("folder"));
      return {"folder", "directory"};
  }
}

void CheckRefused(const CTestFolder& folder, const std::vector<std::string>& arguments,
                  const SPlace& place) {
  const SProgramRun run = RunProgramUnder(folder, arguments, {});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains(place.Name) && Contains(place.Problem));
}

}  // namespace

TEST_CASE("inputs: an experiment file that is no file is an error", "[outputs][bad_input]") {
  const CTestFolder folder;
  const SPlace place = MakePlace(folder, GENERATE(0, 1, 2));
  CheckRefused(folder, {"-c", place.Name}, place);
}

TEST_CASE("inputs: an image that is no file is an error", "[outputs][bad_input]") {
  const CTestFolder folder;
  const SPlace place = MakePlace(folder, GENERATE(0, 1, 2));
  folder.Write("e.argos", RecordedExperiment());
  CheckRefused(folder,
               {"-c", "e.argos", "--set", "arena/floor/@source=image", "--set",
                "arena/floor/@path=" + place.Name},
               place);
}

TEST_CASE("inputs: a library that is no file is an error", "[outputs][bad_input]") {
  const CTestFolder folder;
  const SPlace place = MakePlace(folder, GENERATE(0, 1, 2));
  folder.Write("e.argos", RecordedExperiment());
  CheckRefused(
      folder,
      {"-c", "e.argos", "--set", "controllers/footbot_foraging_controller/@library=" + place.Name},
      place);
}

TEST_CASE("inputs: a Lua script that is no file is an error", "[outputs][bad_input]") {
  const CTestFolder folder;
  const SPlace place = MakePlace(folder, GENERATE(0, 1, 2));
  folder.Write("e.argos", R"(<argos-configuration>
    <framework><experiment length="1" ticks_per_second="10" random_seed="1"/></framework>
    <controllers><lua_controller id="c"><actuators/><sensors/><params script="script.lua"/>
    </lua_controller></controllers>
    <arena size="4,4,1"><foot-bot id="a"><body position="0,0,0"/><controller config="c"/>
    </foot-bot></arena>
    <physics_engines><dynamics2d id="d"/></physics_engines><media/></argos-configuration>)");
  CheckRefused(
      folder, {"-c", "e.argos", "--set", "controllers/lua_controller/params/@script=" + place.Name},
      place);
}

TEST_CASE("inputs: an experiment in a file of the shell is read", "[outputs]") {
  // the standard input may be a regular file
  const CTestFolder folder;
  folder.Write("e.argos", RecordedExperiment());
  std::filesystem::create_symlink(folder.Path("e.argos"), folder.Path("link.argos"));
  CHECK(RunProgramUnder(folder, {"-z", "-c", "link.argos"}, {}).Status == 0);
}

}  // namespace inputs_test
