// Engines side by side, with robots that cross borders and collide across them: equal bit by bit.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/testing/determinism/swarm.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <map>

namespace determinism_partition_test {

using namespace argos;

namespace {

constexpr UInt32 kRobots = 240;
constexpr UInt32 kTicks = 150;
// types of engines; "mixed": one engine of each type, side by side
const std::vector<std::string> kKinds = {"dynamics2d", "kinematics2d", "dynamics3d", "mixed"};

/** "blind_walker": changes its wheel speeds at random, and so drives into obstacles. */
class CBlindWalker : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_random = CRandom::CreateRNG("argos");
    Reset();
  }
  void Reset() override { m_left = m_right = 12.0; }
  void ControlStep() override {
    if (m_random->Bernoulli(0.05)) {
      m_left = m_random->Uniform(CRange<Real>(-5.0, 15.0));
      m_right = m_random->Uniform(CRange<Real>(-5.0, 15.0));
    }
    m_wheels->SetLinearVelocity(m_left, m_right);
  }

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CRandom::CRNG* m_random = nullptr;
  Real m_left = 0.0, m_right = 0.0;  // cm/s
};

// several types in alternation, like the squares of a chessboard
std::string MixEngines(const std::string& engines) {
  static const std::string kTypes[3] = {"dynamics2d", "dynamics3d", "kinematics2d"};
  std::string mixed;
  size_t number = 0;
  const std::string open = "<" + kTypes[0] + " ";
  const std::string close = "</" + kTypes[0] + ">";
  for (size_t at = 0; at < engines.size();) {
    const size_t end = std::min(engines.find(close, at), engines.size());
    const std::string& type = kTypes[(number + number / 4) % 3];
    std::string one = engines.substr(at, end - at);
    Replace(one, open, "<" + type + " ");
    mixed += one + (end < engines.size() ? "</" + type + ">" : "");
    at = end + close.size();
    ++number;
  }
  return mixed;
}

SExperiment MakeSwarm(UInt32 enginesPerSide, const std::string& engine) {
  // rigid bodies take a hundred times as long
  const bool isSlow = engine == "dynamics3d" || engine == "mixed";
  SExperiment experiment = Swarm(isSlow ? kRobots / 6 : kRobots, enginesPerSide, false,
                                 engine == "mixed" ? "dynamics2d" : engine);
  Replace(experiment.Controllers, "<walker ", "<blind_walker ");
  Replace(experiment.Controllers, "</walker>", "</blind_walker>");
  if (engine == "mixed") {
    experiment.Engines = MixEngines(experiment.Engines);
  }
  return experiment;
}

struct SRun {
  std::vector<UInt64> Digests;
  int Crossings = 0;
  size_t MostGhosts = 0;  // sum over all engines in one tick
};

SRun Run(CTestWorld& world) {
  SRun run;
  std::vector<const CPhysicsEngine*> where;
  const auto note = [&] {
    run.Digests.push_back(world.ComputeDigest());
    std::vector<const CPhysicsEngine*> now;
    for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
      now.push_back(&robot->GetParent()
                         .GetComponent<CEmbodiedEntity>("body")
                         .GetPhysicsModel(size_t(0))
                         .GetEngine());
    }
    for (size_t i = 0; i < where.size(); ++i) {
      run.Crossings += where[i] != now[i] ? 1 : 0;
    }
    where = now;
    size_t ghosts = 0;
    for (const CPhysicsEngine* engine : world.GetSimulator().GetPhysicsEngines()) {
      ghosts += engine->GetGhosts().size();
    }
    run.MostGhosts = std::max(run.MostGhosts, ghosts);
  };
  note();
  for (UInt32 tick = 0; tick < kTicks; ++tick) {
    world.Step();
    note();
  }
  return run;
}

// computed once, by the main thread alone
const SRun& Reference(UInt32 enginesPerSide, const std::string& engine) {
  static std::map<std::pair<std::string, UInt32>, SRun> references;
  SRun& reference = references[{engine, enginesPerSide}];
  if (reference.Digests.empty()) {
    CTestWorld world(MakeSwarm(enginesPerSide, engine));
    reference = Run(world);
  }
  return reference;
}

REGISTER_CONTROLLER(CBlindWalker, "blind_walker")

}  // namespace

TEST_CASE("determinism of partitions: equal for any number of threads and schedule",
          "[determinism][threads][partition]") {
  const UInt32 enginesPerSide = GENERATE(1U, 2U, 4U);
  const UInt32 threads = GENERATE(from_range(MostIfSanitized({1U, 2U, 4U})));
  const std::string method = GENERATE("balance_quantity", "balance_length");
  const std::string engine = GENERATE(from_range(kKinds));
  if (engine == "mixed" && enginesPerSide == 1) {
    WARN("skipped: one engine is not a mixture");
    return;
  }
  CAPTURE(enginesPerSide, threads, method, engine);
  SExperiment experiment = MakeSwarm(enginesPerSide, engine);
  experiment.Threads = threads;
  experiment.Method = method;
  CTestWorld world(experiment);
  CHECK(Run(world).Digests == Reference(enginesPerSide, engine).Digests);
}

TEST_CASE("determinism of partitions: after a reset the run repeats", "[determinism][partition]") {
  const UInt32 enginesPerSide = GENERATE(2U, 4U);
  const std::string engine = GENERATE(from_range(kKinds));
  CAPTURE(enginesPerSide, engine);
  SExperiment experiment = MakeSwarm(enginesPerSide, engine);
  experiment.Threads = 2;
  CTestWorld world(experiment);
  // so that bodies have left the engines in which they started
  world.Step(kTicks / 2);
  world.GetSimulator().Reset();
  CHECK(Run(world).Digests == Reference(enginesPerSide, engine).Digests);
}

TEST_CASE("determinism of partitions: the compared runs have crossings and ghosts",
          "[determinism][partition]") {
  const std::string engine = GENERATE(from_range(kKinds));
  CAPTURE(engine);
  if (engine == "mixed") {
    CHECK(Reference(4, engine).Crossings >= 20);
    CHECK(Reference(4, engine).MostGhosts >= 5);
    return;
  }
  // the slow scenes are smaller
  const int fewest = engine == "dynamics3d" ? 5 : 20;
  CHECK(Reference(1, engine).Crossings == 0);
  CHECK(Reference(1, engine).MostGhosts == 0);
  for (const UInt32 enginesPerSide : {2U, 4U}) {
    CAPTURE(enginesPerSide);
    CHECK(Reference(enginesPerSide, engine).Crossings >= fewest);
    CHECK(Reference(enginesPerSide, engine).MostGhosts >= static_cast<size_t>(fewest / 2));
    // ghosts affect the result
    SExperiment experiment = MakeSwarm(enginesPerSide, engine);
    Replace(experiment.Engines, "<" + engine + " ", "<" + engine + " ghosts='false' ");
    CTestWorld world(experiment);
    CHECK(Run(world).Digests != Reference(enginesPerSide, engine).Digests);
  }
}

}  // namespace determinism_partition_test
