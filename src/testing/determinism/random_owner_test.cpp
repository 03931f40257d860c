// Random generators of controllers whose robots are added and removed during a run.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <memory>
#include <string>
#include <vector>

namespace random_owner_test {

using namespace argos;

namespace {

constexpr UInt32 kTicks = 40;

/** Moves at random, with a generator created at the start, and another in its first step. */
class CRandomDriver : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    m_drive = GetActuator<CCI_ToyDriveActuator>("toy_drive");
    m_direction = CRandom::CreateRNG("argos");
  }
  void ControlStep() override {
    if (m_speed == nullptr) {
      m_speed = CRandom::CreateRNG("argos");
    }
    const CRange<Real> range(-0.1, 0.1);
    m_drive->SetVelocity(CVector3(m_direction->Uniform(range), m_speed->Uniform(range), 0.0));
  }

 private:
  CCI_ToyDriveActuator* m_drive = nullptr;
  CRandom::CRNG* m_direction = nullptr;
  CRandom::CRNG* m_speed = nullptr;
};

REGISTER_CONTROLLER(CRandomDriver, "random_driver")

SExperiment RandomDrivers(UInt32 threads = 0) {
  SExperiment experiment;
  experiment.Threads = threads;
  experiment.Controllers =
      "<random_driver id='c'><actuators><toy_drive implementation='default'/></actuators>"
      "<sensors/><params/></random_driver>";
  experiment.Engines = "<toy_engine id='toy'/>";
  experiment.LoopFunctions = "<loop_functions label='toy_loop_functions'/>";
  for (int i = 0; i < 6; ++i) {
    experiment.Arena += "<toy-robot id='r" + std::to_string(i) + "'><body position='" +
                        std::to_string(i - 3) + ",0,0'/><controller config='c'/></toy-robot>";
  }
  return experiment;
}

void AddDriver(CTestWorld& world, const std::string& id, Real y) {
  const CSimulator::CScope scope(world.GetSimulator());
  auto robot = std::make_unique<CToyRobotEntity>(id, "c", CVector3(0.0, y, 0.0));
  world.GetSimulator().GetLoopFunctions().AddEntity(*robot.release());
}

void RemoveDriver(CTestWorld& world, const std::string& id) {
  const CSimulator::CScope scope(world.GetSimulator());
  world.GetSimulator().GetLoopFunctions().RemoveEntity(id);
}

size_t CountGenerators(CTestWorld& world) {
  const CSimulator::CScope scope(world.GetSimulator());
  return CRandom::GetCategory("argos").GetNumRNGs();
}

// the order in which robots come and go; the last ones are still there at the end
std::vector<UInt64> RunWithChanges(CTestWorld& world) {
  std::vector<UInt64> digests = {world.ComputeDigest()};
  for (UInt32 tick = 0; tick < kTicks; ++tick) {
    if (tick == 5) {
      AddDriver(world, "new0", 1.0);
      AddDriver(world, "new1", 2.0);
    } else if (tick == 12) {
      RemoveDriver(world, "new0");
      RemoveDriver(world, "r2");
    } else if (tick == 20) {
      AddDriver(world, "new2", 1.0);
      AddDriver(world, "new0", 3.0);
    } else if (tick == 30) {
      RemoveDriver(world, "new1");
    }
    world.Step();
    digests.push_back(world.ComputeDigest());
  }
  return digests;
}

}  // namespace

TEST_CASE("random owners: a run that adds and removes robots repeats after a reset",
          "[determinism][reset][random]") {
  const UInt32 threads = GENERATE(0U, 4U);
  CTestWorld world(RandomDrivers(threads));
  CTestWorld other(RandomDrivers());
  const std::vector<UInt64> first = RunWithChanges(world);
  CHECK(RunWithChanges(other) == first);
  for (int repetition = 0; repetition < 3; ++repetition) {
    // the changes are undone before the reset, or after it as loop functions do
    if (repetition == 1) {
      world.GetSimulator().Reset();
    }
    RemoveDriver(world, "new0");
    RemoveDriver(world, "new2");
    // the order of the entities is part of the digest
    for (const int number : {3, 4, 5}) {
      RemoveDriver(world, "r" + std::to_string(number));
    }
    const CSimulator::CScope scope(world.GetSimulator());
    for (const int number : {2, 3, 4, 5}) {
      auto robot = std::make_unique<CToyRobotEntity>("r" + std::to_string(number), "c",
                                                     CVector3(number - 3, 0.0, 0.0));
      world.GetSimulator().GetLoopFunctions().AddEntity(*robot.release());
    }
    if (repetition != 1) {
      world.GetSimulator().Reset();
    }
    CHECK(RunWithChanges(world) == first);
  }
}

TEST_CASE("random owners: robots that stay in the arena after a reset repeat their run",
          "[determinism][reset][random]") {
  CTestWorld world(RandomDrivers());
  AddDriver(world, "early", 1.0);
  world.Step(3);
  AddDriver(world, "new0", 2.0);
  AddDriver(world, "gone", 3.0);
  world.Step(3);
  RemoveDriver(world, "gone");
  const auto run = [&] {
    world.GetSimulator().Reset();
    std::vector<UInt64> digests;
    for (UInt32 tick = 0; tick < kTicks; ++tick) {
      world.Step();
      digests.push_back(world.ComputeDigest());
    }
    return digests;
  };
  const std::vector<UInt64> first = run();
  CHECK(run() == first);
  CHECK(run() == first);
}

TEST_CASE("random owners: the generators of removed robots and replaced controllers are destroyed",
          "[determinism][random]") {
  CTestWorld world(RandomDrivers());
  world.Step();
  // two of each robot, and that of the simulator
  const size_t atStart = CountGenerators(world);
  CHECK(atStart == 2 * 6 + 1);
  for (int i = 0; i < 300; ++i) {
    const std::string id = "new" + std::to_string(i);
    AddDriver(world, id, 1.0);
    world.Step();
    REQUIRE(CountGenerators(world) == atStart + 2);
    RemoveDriver(world, id);
    REQUIRE(CountGenerators(world) == atStart);
    const CSimulator::CScope scope(world.GetSimulator());
    world.Get<CToyRobotEntity>("r0").GetControllableEntity().SetController("c");
    REQUIRE(CountGenerators(world) == atStart - 1);
  }
}

}  // namespace random_owner_test
