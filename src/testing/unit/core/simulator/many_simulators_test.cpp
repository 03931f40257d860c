#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <iterator>
#include <thread>

namespace many_simulators_test {

using namespace argos;

namespace {

constexpr int kTicks = 40;

SExperiment Experiment(UInt32 seed, UInt32 threads = 0) {
  return SExperiment{
      .Threads = threads,
      .Method = "balance_length",
      .Seed = seed,
      .Controllers = R"(<toy_controller id='c'>
      <actuators> <toy_drive implementation='default' /> </actuators>
      <sensors> <toy_range implementation='default' noise='0.1' /> </sensors> </toy_controller>)",
      .LoopFunctions = "<loop_functions label='toy_loop_functions' />",
      .Engines = "<toy_engine id='toy' />",
      .Arena = R"(<distribute> <position method='uniform' min='-3,-3,0' max='3,3,0' />
      <orientation method='uniform' min='-180,0,0' max='180,0,0' />
      <entity quantity='100' max_trials='100'> <toy-robot id='r'> <controller config='c' /> </toy-robot> </entity>
    </distribute>)"};
}

// sets a random walk that depends on sensors and on the random numbers of the simulator
void SetRandomWalk(CTestWorld& world) {
  const CSimulator::CScope scope(world.GetSimulator());
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    CRandom::CRNG* const rng = CRandom::CreateRNG("argos");
    dynamic_cast<CToyController&>(robot->GetController()).OnStep =
        [rng](CToyController& controller) {
          controller.Velocity =
              CVector3(controller.LastRange - 0.5,
                       rng->Uniform(CRange<Real>(-0.5, 0.5)) * controller.LastRange, 0.0);
        };
  }
}

std::vector<UInt64> Run(const SExperiment& experiment) {
  CTestWorld world(experiment);
  SetRandomWalk(world);
  std::vector<UInt64> digests;
  for (int i = 0; i < kTicks; ++i) {
    world.Step();
    digests.push_back(world.ComputeDigest());
  }
  return digests;
}

// number of threads of this process
auto CountThreads() {
  namespace fs = std::filesystem;
  return std::distance(fs::directory_iterator("/proc/self/task"), fs::directory_iterator());
}

}  // namespace

TEST_CASE("many simulators: Destroy() leaves no thread behind", "[core][simulator][many]") {
  const auto before = CountThreads();
  CTestWorld world(Experiment(1, 4));
  world.Step();
  REQUIRE(CountThreads() == before + 3);
  world.GetSimulator().Destroy();
  CHECK(CountThreads() == before);
}

TEST_CASE("many simulators: two that alternate in one thread give the same results as each alone",
          "[core][simulator][many]") {
  const std::vector<UInt64> first = Run(Experiment(1));
  const std::vector<UInt64> second = Run(Experiment(2));
  REQUIRE(first != second);
  CTestWorld one(Experiment(1));
  CTestWorld two(Experiment(2));
  SetRandomWalk(two);
  SetRandomWalk(one);
  std::vector<UInt64> firstAgain;
  std::vector<UInt64> secondAgain;
  for (int i = 0; i < kTicks; ++i) {
    one.Step();
    firstAgain.push_back(one.ComputeDigest());
    two.Step();
    secondAgain.push_back(two.ComputeDigest());
  }
  CHECK(firstAgain == first);
  CHECK(secondAgain == second);
}

TEST_CASE("many simulators: destroying one does not affect the other", "[core][simulator][many]") {
  const std::vector<UInt64> alone = Run(Experiment(1));
  CTestWorld one(Experiment(1));
  SetRandomWalk(one);
  std::vector<UInt64> digests;
  for (int i = 0; i < kTicks; ++i) {
    if (i % 10 == 5) {
      CTestWorld passing(Experiment(3));
      passing.Step();
    }
    one.Step();
    digests.push_back(one.ComputeDigest());
  }
  CHECK(digests == alone);
}

TEST_CASE("many simulators: those in several threads give the same results as each alone",
          "[core][simulator][many][threads]") {
  // the simulators are also tested with worker threads of their own
  const UInt32 threads = GENERATE(0U, 2U);
  CAPTURE(threads);
  std::vector<std::vector<UInt64>> alone;
  for (UInt32 seed = 1; seed <= 4; ++seed) {
    alone.push_back(Run(Experiment(seed)));
  }
  std::vector<std::vector<UInt64>> together(alone.size());
  std::vector<std::thread> runners;
  for (UInt32 i = 0; i < together.size(); ++i) {
    runners.emplace_back([i, threads, &together] {
      for (int repetition = 0; repetition < 3; ++repetition) {
        together[i] = Run(Experiment(i + 1, threads));
      }
    });
  }
  for (std::thread& runner : runners) {
    runner.join();
  }
  CHECK(together == alone);
}

TEST_CASE("current simulator: each thread has its own, and scopes nest",
          "[core][simulator][many]") {
  CSimulator& byDefault = CSimulator::GetInstance();
  CSimulator one;
  CSimulator two;
  {
    const CSimulator::CScope outer(one);
    CHECK(&CSimulator::GetInstance() == &one);
    {
      const CSimulator::CScope inner(two);
      CHECK(&CSimulator::GetInstance() == &two);
    }
    CHECK(&CSimulator::GetInstance() == &one);
    CSimulator* other = nullptr;
    std::thread([&] { other = &CSimulator::GetInstance(); }).join();
    CHECK(other == &byDefault);
  }
  CHECK(&CSimulator::GetInstance() == &byDefault);
}

TEST_CASE("current simulator: each simulator has its own random categories",
          "[core][simulator][many]") {
  CSimulator one;
  CSimulator two;
  {
    const CSimulator::CScope scope(one);
    CHECK(CRandom::CreateCategory("mine", 1));
  }
  {
    const CSimulator::CScope scope(two);
    CHECK_FALSE(CRandom::ExistsCategory("mine"));
    CHECK(CRandom::CreateCategory("mine", 2));
  }
  const CSimulator::CScope scope(one);
  CHECK(CRandom::GetSeedOf("mine") == 1);
  // outside any simulator the thread has yet another registry
  std::thread([] { CHECK_FALSE(CRandom::ExistsCategory("mine")); }).join();
}

TEST_CASE("current simulator: a thread without one sees the only one with an experiment",
          "[core][simulator][many]") {
  CSimulator& byDefault = CSimulator::GetInstance();
  CSimulator unused;
  // what another thread sees
  const auto find = [] {
    CSimulator* found = nullptr;
    std::thread([&found] { found = &CSimulator::GetInstance(); }).join();
    return found;
  };
  const auto findSeed = [] {
    UInt32 seed = 0;
    std::thread([&seed] {
      seed = CRandom::ExistsCategory("argos") ? CRandom::GetSeedOf("argos") : 0;
    }).join();
    return seed;
  };
  {
    CTestWorld world(Experiment(5));
    CHECK(find() == &world.GetSimulator());
    CHECK(findSeed() == 5);
    // so does this thread outside of a scope
    CHECK(&CSimulator::GetInstance() == &world.GetSimulator());
    {
      const CSimulator::CScope scope(unused);
      CHECK(&CSimulator::GetInstance() == &unused);
      CHECK_FALSE(CRandom::ExistsCategory("argos"));
      CHECK(find() == &world.GetSimulator());
    }
    CHECK(&CSimulator::GetInstance() == &world.GetSimulator());
    CHECK(CRandom::GetSeedOf("argos") == 5);
    world.GetSimulator().Destroy();
    CHECK(find() == &byDefault);
    CHECK(findSeed() == 0);
  }
  CHECK(&CSimulator::GetInstance() == &byDefault);
}

TEST_CASE("current simulator: of several with experiments, a thread has its own, or must choose",
          "[core][simulator][many]") {
  const auto catchText = [] {
    std::string text;
    std::thread([&text] {
      try {
        CSimulator::GetInstance();
      } catch (const CARGoSException& error) {
        text = error.what();
      }
    }).join();
    return text;
  };
  CTestWorld one(Experiment(1));
  CHECK(catchText().empty());
  {
    CTestWorld two(Experiment(2));
    CHECK_THAT(catchText(), Catch::Contains("2 simulators of this process have an experiment") &&
                                Catch::Contains("CSimulator::CScope"));
    // the one that this thread has loaded last
    CHECK(&CSimulator::GetInstance() == &two.GetSimulator());
    std::thread([&two] {
      const CSimulator::CScope scope(two.GetSimulator());
      CHECK(&CSimulator::GetInstance() == &two.GetSimulator());
    }).join();
  }
  CHECK(catchText().empty());
  CHECK(&CSimulator::GetInstance() == &one.GetSimulator());
}

}  // namespace many_simulators_test
