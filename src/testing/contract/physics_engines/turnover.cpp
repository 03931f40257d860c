#include <argos3/testing/contract/physics_engines/turnover.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace argos {

namespace {

// share by which the memory may grow after the first tenth of the time
constexpr double kGrowth = 0.02;

// resident memory of this process, bytes
double ReadResidentMemory() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  REQUIRE(resident > 0.0);
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

// minutes of wall time
double ReadDuration() {
  const char* text = std::getenv("ARGOS_SOAK_MINUTES");
  return text != nullptr ? std::strtod(text, nullptr) : 60.0;
}

}  // namespace

CTurnover::CTurnover(CTestWorld& world, Real side, UInt32 perTick)
    : m_world(world), m_scope(world.GetSimulator()), m_reach(0.5 * side - 0.3), m_perTick(perTick) {
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    m_ids.push_back(robot->GetRootEntity().GetId());
  }
  m_fixed = CountModels() - m_ids.size();
}

void CTurnover::Tick() {
  for (UInt32 i = 0; i < m_perTick; ++i) {
    Remove();
    Add();
    Move();
  }
  m_world.Step();
}

void CTurnover::Check() {
  CSpace& space = m_world.GetSpace();
  REQUIRE(space.GetControllableEntities().size() == m_ids.size());
  REQUIRE(CountModels() == m_fixed + m_ids.size());
  size_t wrong = 0;
  for (CControllableEntity* robot : space.GetControllableEntities()) {
    const auto& body = robot->GetParent().GetComponent<CEmbodiedEntity>("body");
    const CVector3& place = body.GetOriginAnchor().Position;
    const bool isInside =
        std::max(std::abs(place.GetX()), std::abs(place.GetY())) < m_reach + 1.0 &&
        std::isfinite(place.GetZ());
    wrong += body.GetPhysicsModelsNum() == 1 && isInside ? 0 : 1;
  }
  REQUIRE(wrong == 0);
}

CVector3 CTurnover::DrawPlace() {
  return {m_random.Uniform(-m_reach, m_reach), m_random.Uniform(-m_reach, m_reach), 0.0};
}
size_t CTurnover::DrawRobot() {
  return static_cast<size_t>(m_random.Uniform(0.0, 1.0) * static_cast<double>(m_ids.size()));
}
CLoopFunctions& CTurnover::GetFunctions() {
  return m_world.GetSimulator().GetLoopFunctions();
}

void CTurnover::Remove() {
  const size_t robot = DrawRobot();
  GetFunctions().RemoveEntity(m_ids[robot]);
  m_ids[robot] = m_ids.back();
  m_ids.pop_back();
}

void CTurnover::Add() {
  // places that are occupied are refused by moving there
  auto* robot = new CEPuckEntity("new" + std::to_string(m_added++), "diffusion");
  GetFunctions().AddEntity(*robot);
  m_ids.push_back(robot->GetId());
  MoveToFreePlace(robot->GetEmbodiedEntity());
}

void CTurnover::Move() {
  auto& robot = m_world.Get<CEPuckEntity>(m_ids[DrawRobot()]);
  MoveToFreePlace(robot.GetEmbodiedEntity());
}

void CTurnover::MoveToFreePlace(CEmbodiedEntity& body) {
  for (int trial = 0; trial < 1000; ++trial) {
    const CQuaternion heading(CRadians(m_random.Uniform(-3.0, 3.0)), CVector3::Z);
    if (GetFunctions().MoveEntity(body, DrawPlace(), heading)) {
      return;
    }
  }
  FAIL("no free place for a robot");
}

size_t CTurnover::CountModels() {
  size_t count = 0;
  for (CPhysicsEngine* engine : m_world.GetSimulator().GetPhysicsEngines()) {
    count += engine->GetNumPhysicsModels();
  }
  return count;
}

void Soak(const std::function<void()>& tick, const std::function<void()>& check) {
  using TClock = std::chrono::steady_clock;
  const std::chrono::duration<double> whole(60.0 * ReadDuration());
  const TClock::time_point start = TClock::now();
  double first = 0.0;
  double greatest = 0.0;
  UInt64 ticks = 0;
  while (TClock::now() - start < whole) {
    tick();
    if (++ticks % 10 != 0) {
      continue;
    }
    check();
    const double now = ReadResidentMemory();
    if (TClock::now() - start < 0.1 * whole) {
      first = std::max(first, now);
    }
    greatest = std::max(greatest, now);
  }
  WARN(ticks << " ticks; resident memory " << first / 1048576.0
             << " MiB in the first tenth of the time, at most " << greatest / 1048576.0 << " MiB");
  REQUIRE(first > 0.0);
  CHECK(greatest <= (1.0 + kGrowth) * first);
}

}  // namespace argos
