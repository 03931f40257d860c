// A program of its own, with one test case: plug-ins are loaded on demand once per process.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

namespace loading_on_demand_test {

using namespace argos;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

constexpr int kThreads = 8;
constexpr UInt32 kTicks = 11;

// an empty folder that is the plug-in path during its lifetime
class CPluginFolder {
 public:
  CPluginFolder()
      : m_path(fs::temp_directory_path() / ("argos_demand." + std::to_string(getpid()))) {
    fs::remove_all(m_path);
    fs::create_directories(m_path);
    setenv("ARGOS_PLUGIN_PATH", m_path.c_str(), 1);
  }
  ~CPluginFolder() {
    unsetenv("ARGOS_PLUGIN_PATH");
    fs::remove_all(m_path);
  }
  const fs::path& Path() const { return m_path; }

 private:
  fs::path m_path;
};

// a robot whose controller is in libargos3_test_numbered_1, a library that the file does not name
SExperiment Experiment(const std::string& arena = "") {
  return SExperiment{.Controllers =
                         "<test_numbered_controller_1 id='c'> <actuators> <toy_drive "
                         "implementation='default' /> </actuators> </test_numbered_controller_1>",
                     .Engines = "<toy_engine id='toy' />",
                     .Arena =
                         "<toy-robot id='r'> <body position='-1,0,0' /> <controller config='c' /> "
                         "</toy-robot> <test-marker-1 id='m' position='1,2,3' />" +
                         arena};
}

// the result of a function that is called in a child process
std::string InChild(std::string (*function)()) {
  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  const pid_t child = fork();
  if (child == 0) {
    const std::string text = function();
    const bool written = write(ends[1], text.data(), text.size()) == ssize_t(text.size());
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t size = 0; (size = read(ends[0], buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), size_t(size));
  }
  close(ends[0]);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(status == 0);
  return text;
}

}  // namespace

TEST_CASE("loading on demand: the first unknown label loads all plug-ins, once per process",
          "[core][simulator][plugins][threads]") {
  const CPluginFolder folder;
  const fs::path library = folder.Path() / "libargos3_test_numbered_1.so";

  // a plug-in that does not load is an error, which names the label that needed it
  std::ofstream(folder.Path() / "libbroken.so") << "this is no library";
  const std::string broken = InChild([] { return LoadError(Experiment()); });
  CHECK_THAT(broken, Contains("is not registered, and not all plug-ins can be loaded") &&
                         Contains("libbroken.so"));
  fs::remove(folder.Path() / "libbroken.so");

  fs::create_symlink(InBuildTree("testing/plugins/libargos3_test_numbered_1.so"), library);
  // factories alone load nothing: only an experiment does
  CHECK_FALSE(CFactory<CCI_Controller>::Exists("test_numbered_controller_1"));

  std::vector<std::string> errors(kThreads);
  std::vector<Real> ends(kThreads);
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      try {
        CTestWorld world(Experiment());
        world.Step(kTicks);
        ends[i] =
            world.Get<CToyRobotEntity>("r").GetEmbodiedEntity().GetOriginAnchor().Position.GetX();
      } catch (std::exception& error) {
        errors[i] = error.what();
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (int i = 0; i < kThreads; ++i) {
    CHECK(errors[i] == "");
    // 1 cm/s for ten ticks of 0.1 s; each of their ten substeps rounds a number below 1 by at
    // most 5.6e-17
    CHECK_THAT(ends[i], Catch::WithinAbs(-0.99, 6e-15));
  }

  // an unknown label is an error as before, and loads nothing again
  fs::create_symlink(InBuildTree("testing/plugins/libargos3_test_numbered_2.so"),
                     folder.Path() / "libargos3_test_numbered_2.so");
  const std::string unknown = LoadError(Experiment("<test-marker-2 id='n' position='0,0,0' />"));
  CHECK_THAT(unknown, Contains("there is no entity \"test-marker-2\"") &&
                          Contains("did you mean \"test-marker-1\"") &&
                          Contains(folder.Path().string()));
}

}  // namespace loading_on_demand_test
