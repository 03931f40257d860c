// Wrong scripts end as a clean run or as an error that names the script, never as a crash. Every
// case is a number, which is shown if it fails.

#include "lua_world.h"

#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/device_list.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/sanitizers.h>
#include <argos3/testing/support/script_mutator.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace lua_mutation_test {

using namespace argos;
using Catch::Contains;

namespace {

constexpr UInt32 kCases = kHasAddressSanitizer ? 150 : 1000;
constexpr UInt32 kSoakCases = 20000;
constexpr UInt32 kTicks = 3;

const std::string kLimits = "max_instructions='100000' max_memory='8' ";
// what the scripts of the experiments expect
const std::string kParameters =
    "alpha='7.5' delta='0.1' velocity='10' max_speed='10' target_distance='60' gain='1000' "
    "light_speed='5' sensors='8' speed='12' source='fb' rate='1' threshold='5' wandering='0.1' "
    "nest_x='-1.1' nest_y='0' period='50' coupling='0.05'";

/** The Lua table of a device: a robot has one device for each. */
std::string TableOf(const SListedDevice& device) {
  for (const char* const common : {"proximity", "light", "quadrotor", "gripper"}) {
    if (device.Tag.find(common) != std::string::npos) {
      return device.Section + common;
    }
  }
  return device.Section + device.Tag;
}

/** A robot "fb" with all devices of its type. */
SLuaExperiment AllDevices(const std::string& robot) {
  SLuaExperiment experiment;
  experiment.Actuators = "";
  std::set<std::string> tables;
  for (const SListedDevice& device : ListedDevices()) {
    if (device.IsOf(robot) && tables.insert(TableOf(device)).second) {
      (device.Section == "sensors" ? experiment.Sensors : experiment.Actuators) += device.ToXml();
    }
  }
  experiment.Params = kLimits + kParameters;
  experiment.Engines = robot == "eye-bot" ? "<pointmass3d id='engine'/>" : "<dynamics2d id='d'/>";
  experiment.Media = MediaForDevices();
  experiment.Robots = RobotForDevices(robot, "fb", "0,0,0", "c");
  experiment.Arena =
      "<floor id='floor' source='loop_functions' pixels_per_meter='1'/>"
      "<light id='lamp' position='1,0,0.5' color='red' intensity='1' medium='leds'/>"
      "<box id='box' size='0.2,0.2,0.2' movable='true' mass='1'><body position='0.4,0,0'/></box>";
  return experiment;
}

std::string ReadFile(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::vector<std::string> SeedScripts() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(InSourceTree("experiments/controllers/lua"))) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> scripts;
  for (const std::filesystem::path& path : paths) {
    scripts.push_back(ReadFile(path));
  }
  // metamethods, coroutines and closures
  scripts.emplace_back(R"(
local point = setmetatable({}, {__index = function(t, k) return k .. '!' end,
  __call = function(self, n) return n * 2 end, __close = function() log('closed') end})
function init() worker = coroutine.wrap(function(a)
    for i = 1, 100 do local b <close> = point a = coroutine.yield(a, i, point[i]) end end) end
function step()
  local v = vector3(1, 2, 3):normalize() + vector3(0, 0, 1) * 2
  local q = quaternion(0.5, vector3(0, 0, 1)) * quaternion()
  local n = select('#', worker(v.x, q.w))
  for key, value in pairs({a = 1, b = {2}, [3] = 'c'}) do log(key, value) end
  local ok, message = pcall(error, {n})
  local text = ('%d %s'):format(n, tostring(v)):gsub('%d+', function(d) return d + 1 end)
  robot.wheels.set_velocity(robot.random.uniform(1, 2), robot.random.gaussian(0.1))
  local f <const> = load('return ...') assert(f(text) == text)
  goto done
  ::done::
end
function reset() worker = nil end
function destroy() log(table.concat({1, 2, 3}, ',')) end
)");
  return scripts;
}

/** Without warnings about parameters, which mutations may leave without a use. */
std::string WithoutUnused(const std::string& errors) {
  return std::regex_replace(errors,
                            std::regex("\\[WARNING\\][^\n]*is not used by anything[^\n]*\n"), "");
}

void CheckNamesScript(const std::string& message, const std::string& script) {
  // a line, except where there is none: a missing function, an error that is not a text
  const bool hasPlace = std::regex_search(message, std::regex(script + ":[0-9]+:")) ||
                        message.find("must define a global function") != std::string::npos ||
                        message.find("(the error is a") != std::string::npos ||
                        message.find("not enough memory") != std::string::npos ||
                        message.find("stack overflow") != std::string::npos ||
                        message.find(script + "\" failed in") != std::string::npos;
  CHECK(hasPlace);
  if (!hasPlace) {
    UNSCOPED_INFO(message);
  }
}

/** Loads, steps, resets, and destroys; every error must name the script. */
void RunToTheEnd(const SLuaExperiment& experiment, const std::string& script) {
  std::string errors;
  try {
    CLuaWorld world(experiment);
    world.Step(kTicks);
    world.GetSimulator().Reset();
    world.Step();
    world.Destroy();
  } catch (const CARGoSException& error) {
    errors = error.what();
  }
  errors += WithoutUnused(TakeLogErr());
  TakeLog();
  INFO(errors);
  if (!errors.empty()) {
    CheckNamesScript(errors, script);
  }
  CHECK_THAT(errors, !Contains("does not name"));
}

void RunMutations(UInt32 first, UInt32 last) {
  const std::vector<std::string> seeds = SeedScripts();
  SLuaExperiment robots[] = {AllDevices("foot-bot"), AllDevices("e-puck"), AllDevices("eye-bot")};
  for (UInt32 number = first; number < last; ++number) {
    CScriptMutator mutator(number);
    SLuaExperiment& experiment = robots[number % 3];
    experiment.Script = mutator.Mutate(seeds[number % seeds.size()]);
    CAPTURE(number, experiment.Script);
    RunToTheEnd(experiment, "robot\\.lua");
  }
}

std::string CallingScript(const std::string& table, UInt32 seed, const std::string& skipped) {
  return RandomCallsScript(table, seed, 100) + skipped;
}

void RunCalls(UInt32 first, UInt32 last) {
  const std::string functions =
      "\nfunction init() call_all() end\nfunction step() call_all() end\n"
      "function reset() call_all() end\nfunction destroy() call_all() end\n";
  SLuaExperiment robots[] = {AllDevices("foot-bot"), AllDevices("e-puck"), AllDevices("eye-bot")};
  for (UInt32 number = first; number < last; ++number) {
    SLuaExperiment& experiment = robots[number % 3];
    experiment.Script = CallingScript("robot", number, functions);
    CAPTURE(number);
    RunToTheEnd(experiment, "robot\\.lua");
  }
}

void RunLoopCalls(UInt32 first, UInt32 last) {
  SLuaExperiment experiment = AllDevices("foot-bot");
  experiment.Script =
      "value = 1 function init() end function step() end function reset() end function destroy() "
      "end\n";
  experiment.LoopParams = kLimits;
  for (UInt32 number = first; number < last; ++number) {
    experiment.LoopScript =
        CallingScript("simulation", number,
                      "\nfunction init() call_all() end\nfunction pre_step() call_all() end\n"
                      "function post_step() call_all() end\nfunction destroy() call_all() end\n");
    CAPTURE(number);
    RunToTheEnd(experiment, "loop\\.lua");
  }
}

}  // namespace

TEST_CASE("lua mutation: tokens of a script joined are the script", "[lua][mutation]") {
  for (const std::string& script : SeedScripts()) {
    std::string joined;
    for (const std::string& token : ToTokens(script)) {
      joined += token;
    }
    CHECK(joined == script);
  }
}

TEST_CASE("lua mutation: the seeds are scripts that run, or that miss only a device",
          "[lua][mutation]") {
  SLuaExperiment experiment = AllDevices("foot-bot");
  experiment.Script = SeedScripts().back();
  CLuaWorld world(experiment);
  world.Step(kTicks);
  CHECK(TakeLogErr() == "");
  CHECK(TakeLog() != "");
}

TEST_CASE("lua mutation: mutated scripts end cleanly or with an error that names the script",
          "[lua][mutation]") {
  RunMutations(0, kCases);
}

TEST_CASE("lua mutation: functions of a robot take or refuse random arguments", "[lua][mutation]") {
  RunCalls(0, kCases / 50);
}

TEST_CASE("lua mutation: functions of \"simulation\" take or refuse random arguments",
          "[lua][mutation]") {
  RunLoopCalls(0, kCases / 50);
}

TEST_CASE("lua mutation soak: many scripts and calls", "[.][soak][lua][mutation]") {
  RunMutations(kCases, kCases + kSoakCases);
  RunCalls(kCases, kCases + kSoakCases / 50);
  RunLoopCalls(kCases, kCases + kSoakCases / 50);
}

}  // namespace lua_mutation_test
