// Libraries register their plug-ins while they are loaded. Here several threads load libraries
// while others look labels up, load experiments and run them. A library is loaded once per process:
// the first loading is tested because ctest runs each test case in a process of its own.

#include <argos3/core/simulator/query_plugins.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

namespace loading_in_threads_test {

using namespace argos;

namespace {

constexpr int kLibraries = 4;
constexpr UInt32 kTicks = 11;
// Ten ticks of ten substeps, each an addition to a number between 0.5 and 1 that
// is rounded by at most 5.6e-17.
constexpr Real kTolerance = 6e-15;

std::string Library(int number) {
  return InBuildTree("testing/plugins/libargos3_test_numbered_" + std::to_string(number));
}

// a robot driven by a controller of library libargos3_test_numbered_<number>, and its marker entity
SExperiment NumberedExperiment(int number) {
  const std::string text = std::to_string(number);
  return SExperiment{
      .Controllers = "<test_numbered_controller_" + text + " id='c' library='" + Library(number) +
                     "'> <actuators> <toy_drive implementation='default' /> </actuators> " +
                     "</test_numbered_controller_" + text + ">",
      .Engines = "<toy_engine id='toy' />",
      .Arena =
          "<toy-robot id='r'> <body position='-1,0,0' /> <controller config='c' /> </toy-robot> "
          "<test-marker-" +
          text + " id='m' position='1,2,3' />"};
}

// an experiment that needs no library
SExperiment ToyExperiment() {
  return SExperiment{.Controllers = R"(<toy_controller id='c'>
        <actuators> <toy_drive implementation='default' /> </actuators>
        <sensors> <toy_range implementation='default' /> </sensors>
        <params velocity='0.1,0,0' /> </toy_controller>)",
                     .Engines = "<toy_engine id='toy' />",
                     .Arena =
                         "<toy-robot id='r'> <body position='-1,0,0' /> <controller config='c' /> "
                         "</toy-robot> <toy-lamp id='l' position='0,0,1' />"};
}

// x position of the robot after kTicks of 0.1 s, m; the command of
// the first tick acts in the second
Real RunTo(const SExperiment& experiment) {
  CTestWorld world(experiment);
  world.Step(kTicks);
  return world.Get<CToyRobotEntity>("r").GetEmbodiedEntity().GetOriginAnchor().Position.GetX();
}

// Collects failures of threads for the main thread to report: Catch2's
// assertions are not thread-safe.
class CFailures {
 public:
  void Try(const std::function<void()>& action) {
    try {
      action();
    } catch (std::exception& error) {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_text += std::string(error.what()) + '\n';
    }
  }
  const std::string& GetText() const { return m_text; }

 private:
  std::mutex m_mutex;
  std::string m_text;
};

}  // namespace

TEST_CASE("loading in threads: experiments that load libraries run beside others",
          "[core][simulator][many][threads]") {
  CFailures failures;
  std::atomic<int> numLoading{kLibraries};
  std::vector<std::vector<Real>> ends(kLibraries, std::vector<Real>(kLibraries));
  std::vector<std::thread> threads;
  for (int first = 0; first < kLibraries; ++first) {
    threads.emplace_back([&, first] {
      // each thread begins with another library and proceeds through those of the others
      for (int i = 0; i < kLibraries; ++i) {
        const int number = (first + i) % kLibraries;
        failures.Try([&] { ends[first][number] = RunTo(NumberedExperiment(number)); });
      }
      --numLoading;
    });
  }
  std::vector<Real> toyEnds;
  threads.emplace_back([&] {
    do {
      failures.Try([&] { toyEnds.push_back(RunTo(ToyExperiment())); });
    } while (numLoading > 0);
  });
  threads.emplace_back([&] {
    do {
      failures.Try([&] {
        const std::string error = LoadError(SExperiment{.Arena = "<test-marker id='n' />"});
        if (error.find("there is no entity \"test-marker\"") == std::string::npos) {
          THROW_ARGOSEXCEPTION("another error was expected: " << error);
        }
        if (DescribePlugins("entities").find("[ toy-robot ]") == std::string::npos) {
          THROW_ARGOSEXCEPTION("the list of entities lacks the toy robot");
        }
      });
    } while (numLoading > 0);
  });
  for (std::thread& thread : threads) {
    thread.join();
  }
  CHECK(failures.GetText() == "");
  for (const std::vector<Real>& endsOfThread : ends) {
    for (int number = 0; number < kLibraries; ++number) {
      CHECK_THAT(endsOfThread[number],
                 Catch::WithinAbs(-1.0 + 0.01 * number * 0.1 * (kTicks - 1), kTolerance));
    }
  }
  for (const Real end : toyEnds) {
    CHECK_THAT(end, Catch::WithinAbs(-1.0 + 0.1 * 0.1 * (kTicks - 1), kTolerance));
  }
}

TEST_CASE("loading in threads: the labels of a library appear all at once",
          "[core][plugins][threads]") {
  CFailures failures;
  std::atomic<bool> isLoaded{false};
  bool hasBoth = false;
  std::thread reader([&] {
    while (!CFactory<CCI_Controller>::Exists("test_numbered_controller_0") && !isLoaded) {
      std::this_thread::yield();
    }
    // the second label is registered 50 ms after the first
    hasBoth = CFactory<CEntity>::Exists("test-marker-0");
  });
  failures.Try([&] { CDynamicLoading::LoadLibrary(Library(0)); });
  isLoaded = true;
  reader.join();
  CHECK(failures.GetText() == "");
  CHECK(hasBoth);
}

}  // namespace loading_in_threads_test
