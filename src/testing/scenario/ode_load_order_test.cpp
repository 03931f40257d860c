// dynamics3d gives the same results in whatever order its libraries were loaded.

#include "command_line/program_run.h"

#include <argos3/testing/contract/physics_engines/regions.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <dlfcn.h>

#include <cstdlib>
#include <optional>
#include <regex>

namespace ode_load_order_test {

using namespace argos;

namespace {

/** Sets an environment variable of this process and of its children for its lifetime. */
class CEnvironmentVariable {
 public:
  CEnvironmentVariable(const char* name, const std::string& value) : m_name(name) {
    if (const char* const before = std::getenv(name)) {
      m_before = before;
    }
    setenv(name, value.c_str(), 1);
  }
  ~CEnvironmentVariable() {
    if (m_before) {
      setenv(m_name, m_before->c_str(), 1);
    } else {
      unsetenv(m_name);
    }
  }
  CEnvironmentVariable(const CEnvironmentVariable&) = delete;
  CEnvironmentVariable& operator=(const CEnvironmentVariable&) = delete;

 private:
  const char* m_name;
  std::optional<std::string> m_before;
};

// heaps of boxes that fall apart, in two engines side by side
SExperiment Heaps() {
  const auto engine = [](const std::string& id, const std::vector<SCorner>& corners) {
    return "<dynamics3d id='" + id + "'><floor/><gravity g='9.81'/><solver stepper='iterative'/>" +
           Boundaries(corners) + "</dynamics3d>";
  };
  SExperiment experiment;
  experiment.Length = 2.0;
  experiment.ArenaSize = "10,10,4";
  experiment.Engines = engine("west", {{-5, -5}, {0, -5}, {0, 5}, {-5, 5}}) +
                       engine("east", {{0, -5}, {5, -5}, {5, 5}, {0, 5}});
  for (const char* const heap : {"-2", "2"}) {
    for (int level = 0; level < 6; ++level) {
      experiment.Arena += "<box id='b" + std::string(heap) + "_" + std::to_string(level) +
                          "' size='0.3,0.3,0.2' movable='true' mass='1'><body position='" + heap +
                          "," + std::to_string(0.05 * level) + "," + std::to_string(0.21 * level) +
                          "'/></box>\n";
    }
  }
  return experiment;
}

std::string RunHeaps(const CTestFolder& folder, const std::string& threads) {
  const SProgramRun run = folder.Run({"-z", "-c", "heaps.argos", "--digest", "--threads", threads});
  CHECK(run.Err == "");
  REQUIRE(run.Status == 0);
  std::smatch match;
  REQUIRE(std::regex_search(run.Out, match, std::regex("digest: ([0-9a-f]{16})\n")));
  return match[1].str();
}

}  // namespace

TEST_CASE("dynamics3d: results do not depend on whether ODE was loaded before the engine",
          "[command_line][dynamics3d]") {
  const CTestFolder folder;
  folder.Write("heaps.argos", Heaps().ToXml());
  const std::string expected = RunHeaps(folder, "0");
  Dl_info ode;
  REQUIRE(dladdr(dlsym(RTLD_DEFAULT, "dRandSetSeed"), &ode) != 0);
  const CEnvironmentVariable first("LD_PRELOAD", ode.dli_fname);
  // the runtime of a sanitizer wants to be the first library, but need not be
  const char* const options = std::getenv("ASAN_OPTIONS");
  const CEnvironmentVariable asan(
      "ASAN_OPTIONS", std::string(options != nullptr ? options : "") + ":verify_asan_link_order=0");
  CHECK(RunHeaps(folder, "0") == expected);
  CHECK(RunHeaps(folder, "2") == expected);
}

TEST_CASE("dynamics3d: a failed assertion of ODE is an error, and the process goes on",
          "[dynamics3d]") {
  SExperiment experiment;
  experiment.Engines = "<dynamics3d id='engine'/>";
  CTestWorld world(experiment);
  world.Step(1);
  // the tests are not linked with ODE
  using TCreate = void* (*)();
  using TStep = int (*)(void*, double);
  using TDestroy = void (*)(void*);
  const auto create = reinterpret_cast<TCreate>(dlsym(RTLD_DEFAULT, "dWorldCreate"));
  const auto step = reinterpret_cast<TStep>(dlsym(RTLD_DEFAULT, "dWorldStep"));
  const auto destroy = reinterpret_cast<TDestroy>(dlsym(RTLD_DEFAULT, "dWorldDestroy"));
  REQUIRE(create != nullptr);
  void* const other = create();
  CHECK_THROWS_WITH(step(other, -1.0), Catch::Contains("the Open Dynamics Engine fails: ") &&
                                           Catch::Contains("stepsize must be > 0"));
  destroy(other);
  CHECK_NOTHROW(world.Step(1));
}

}  // namespace ode_load_order_test
