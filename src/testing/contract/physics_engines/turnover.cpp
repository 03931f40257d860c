#include <argos3/testing/contract/physics_engines/turnover.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <unistd.h>

namespace argos {

namespace {

// share by which the memory may grow after the first tenth of the time, and what buffers may grow
// by besides, bytes: in four hours dynamics2d grew by 1.7 MiB, and no more in the last two
constexpr double kGrowth = 0.02;
constexpr double kBuffers = 2.0 * 1048576.0;

// resident memory of this process, bytes
double ReadResidentMemory() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  REQUIRE(resident > 0.0);
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

double ReadMinutes() {
  const char* text = std::getenv("ARGOS_SOAK_MINUTES");
  return text != nullptr ? std::strtod(text, nullptr) : 60.0;
}

// @param progress  share of the time that is over after so many ticks.
void RunSoak(const std::function<double(UInt64)>& progress, const std::function<void()>& tick,
             const std::function<void()>& check) {
  constexpr size_t kParts = 10;
  std::array<double, kParts> greatest{};  // resident memory in each tenth of the time, bytes
  UInt64 ticks = 0;
  while (progress(ticks) < 1.0) {
    tick();
    if (++ticks % 10 == 0) {
      check();
      const auto part = static_cast<size_t>(progress(ticks) * kParts);
      double& most = greatest[std::min(part, kParts - 1)];
      most = std::max(most, ReadResidentMemory());
    }
  }
  std::ostringstream parts;
  for (const double bytes : greatest) {
    parts << ' ' << std::fixed << std::setprecision(2) << bytes / 1048576.0;
  }
  WARN(ticks << " ticks; resident memory in each tenth of the time, MiB:" << parts.str());
  REQUIRE(greatest[0] > 0.0);
  CHECK(*std::max_element(greatest.begin(), greatest.end()) <=
        (1.0 + kGrowth) * greatest[0] + kBuffers);
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
  const std::chrono::duration<double> whole(60.0 * ReadMinutes());
  const TClock::time_point start = TClock::now();
  RunSoak([&](UInt64) { return (TClock::now() - start) / whole; }, tick, check);
}

void SoakSimulated(UInt32 ticksPerSecond, const std::function<void()>& tick) {
  const double whole = 60.0 * ReadMinutes() * ticksPerSecond;
  RunSoak([&](UInt64 ticks) { return static_cast<double>(ticks) / whole; }, tick, [] {});
}

}  // namespace argos
