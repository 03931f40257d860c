#include <argos3/core/simulator/tick/look_ahead.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/existing_component.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

namespace {

// robots between two stages: they take about as long as one access to memory
constexpr size_t kStep = 8;
// m; how far most sensors reach from the surface of the robot
constexpr Real kReach = 0.1;

const CEmbodiedEntity* FindBody(CControllableEntity& robot) {
  auto* const root = dynamic_cast<CComposableEntity*>(&robot.GetRootEntity());
  return root != nullptr ? FindExistingComponent<CEmbodiedEntity>(*root) : nullptr;
}

}  // namespace

void CLookAhead::SetVisits(const std::vector<SRobotVisit>& visits) {
  m_visits = &visits;
  m_robots.clear();
  m_memory.clear();
  if (visits.size() < CSpace::kFewRobots) {
    return;
  }
  m_robots.reserve(visits.size());
  m_memory.reserve(visits.size());
  std::vector<SMemory> memory;  // the memory of one robot
  for (const SRobotVisit& visit : visits) {
    memory.clear();
    visit.Robot->ListMemory(memory);
    const CEmbodiedEntity* const body = FindBody(*visit.Robot);
    if (body != nullptr) {
      memory.push_back({body->GetBodyNumberAddress(), sizeof(UInt32)});
    }
    m_memory.insert(m_memory.end(), memory.begin(), memory.end());
    m_robots.push_back({body != nullptr ? &body->GetOriginAnchor() : nullptr,
                        static_cast<UInt32>(m_memory.size())});
  }
}

void CLookAhead::BeforeAct(size_t visit) const {
  if (visit + 3 * kStep >= m_robots.size()) {
    return;
  }
  ARGOS_ASSERT(m_robots.size() == m_visits->size(), "the loops have changed since SetVisits()");
  GetRobot(visit + 3 * kStep).LoadEntityAhead();
  GetRobot(visit + 2 * kStep).LoadActuatorListAhead();
  GetRobot(visit + kStep).LoadActuatorsAhead();
}

void CLookAhead::BeforeSense(size_t visit, const CBodyIndex& index) const {
  if (visit + 3 * kStep >= m_robots.size()) {
    return;
  }
  ARGOS_ASSERT(m_robots.size() == m_visits->size(), "the loops have changed since SetVisits()");
  GetRobot(visit + 3 * kStep).LoadEntityAhead();
  const SAnchor* const farOrigin = m_robots[visit + 3 * kStep].Origin;
  if (farOrigin != nullptr) {
    LoadAhead(farOrigin, sizeof(SBodyPose));
  }

  GetRobot(visit + 2 * kStep).LoadControllerAhead();

  const SRobot& near = m_robots[visit + kStep];
  GetRobot(visit + kStep).LoadSensorsAhead();
  if (near.Origin != nullptr) {
    index.LoadListsAhead(near.Origin->Position.GetX(), near.Origin->Position.GetY(), kReach);
  }
  for (UInt32 i = m_robots[visit + kStep - 1].EndOfMemory; i < near.EndOfMemory; ++i) {
    m_memory[i].Load();
  }
}

}  // namespace argos
