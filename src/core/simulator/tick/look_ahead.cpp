#include <argos3/core/simulator/tick/look_ahead.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/memory/load_ahead.h>

namespace argos {

namespace {

// robots between two stages: they take about as long as one access to memory
constexpr size_t kStep = 8;
// bytes that most devices and controllers use in every tick, from their beginning; of a controller
// also from the end of its base
constexpr size_t kSensorBytes = 160;
constexpr size_t kActuatorBytes = 80;
constexpr size_t kControllerBytes = 96;
// m; how far most sensors reach from the surface of the robot
constexpr Real kReach = 0.1;

void LoadBetween(const void* begin, const void* end) {
  LoadAhead(begin, static_cast<const char*>(end) - static_cast<const char*>(begin));
}

const CEmbodiedEntity* FindBody(CControllableEntity& robot) {
  auto* const root = dynamic_cast<CComposableEntity*>(&robot.GetRootEntity());
  if (root != nullptr) {
    for (CEntity* component : root->GetExistingComponents()) {
      if (auto* const body = dynamic_cast<CEmbodiedEntity*>(component)) {
        return body;
      }
    }
  }
  return nullptr;
}

}  // namespace

void CLookAhead::SetVisits(const std::vector<SRobotVisit>& visits) {
  m_visits = &visits;
  m_robots.clear();
  m_arrays.clear();
  if (visits.size() < CSpace::kFewRobots) {
    return;
  }
  m_robots.reserve(visits.size());
  m_arrays.reserve(visits.size());
  std::vector<CArraySensor::SArray> arrays;  // of a robot
  for (const SRobotVisit& visit : visits) {
    CControllableEntity* const robot = visit.Robot;
    arrays.clear();
    for (const auto& sensor : robot->m_sensors) {
      if (const auto* const withArray = dynamic_cast<const CArraySensor*>(sensor.Simulated)) {
        arrays.push_back(withArray->GetReadingsArray());
        withArray->ListInputs(arrays);
      }
    }
    const CEmbodiedEntity* const body = FindBody(*robot);
    if (body != nullptr) {
      arrays.push_back({&body->m_bodyNumber, sizeof(UInt32)});
    }
    m_arrays.insert(m_arrays.end(), arrays.begin(), arrays.end());
    m_robots.push_back({body != nullptr ? &body->GetOriginAnchor() : nullptr,
                        static_cast<UInt32>(m_arrays.size())});
  }
}

// what the tick reads of a robot
void CLookAhead::LoadHead(const CControllableEntity& robot) {
  LoadAhead(&robot, 1);  // its virtual functions
  LoadBetween(&robot.m_pcController, &robot.m_vecIntersectionPoints + 1);
}

void CLookAhead::BeforeAct(size_t visit) const {
  if (visit + 3 * kStep >= m_robots.size()) {
    return;
  }
  LoadHead(GetRobot(visit + 3 * kStep));
  LoadAhead(GetRobot(visit + 2 * kStep).m_actuators.data(), 1);
  for (const CSimulatedActuator* actuator : GetRobot(visit + kStep).m_actuators) {
    LoadAhead(actuator, kActuatorBytes);
  }
}

void CLookAhead::BeforeSense(size_t visit, const CBodyIndex& index) const {
  if (visit + 3 * kStep >= m_robots.size()) {
    return;
  }
  const SAnchor* const farOrigin = m_robots[visit + 3 * kStep].Origin;
  LoadHead(GetRobot(visit + 3 * kStep));
  if (farOrigin != nullptr) {
    LoadAhead(farOrigin, sizeof(SBodyPose));
  }

  const CControllableEntity& middle = GetRobot(visit + 2 * kStep);
  LoadAhead(middle.m_sensors.data(), 1);
  LoadAhead(middle.m_actuators.data(), 1);
  if (middle.m_pcController != nullptr) {
    LoadAhead(middle.m_pcController, 1);
    LoadAhead(middle.m_pcController + 1, kControllerBytes);
  }
  LoadAround(m_robots[visit + 2 * kStep], index, false);

  const CControllableEntity& near = GetRobot(visit + kStep);
  for (const auto& sensor : near.m_sensors) {
    LoadAhead(sensor.Simulated, kSensorBytes);
  }
  for (const CSimulatedActuator* actuator : near.m_actuators) {
    LoadAhead(actuator, kActuatorBytes);
  }
  LoadAround(m_robots[visit + kStep], index, true);
  const UInt32 endOfArrays = m_robots[visit + kStep].EndOfArrays;
  for (UInt32 i = m_robots[visit + kStep - 1].EndOfArrays; i < endOfArrays; ++i) {
    m_arrays[i].Load();
  }
}

// where the solids around a robot are listed, then the lists
void CLookAhead::LoadAround(const SRobot& robot, const CBodyIndex& index, bool lists) const {
  if (robot.Origin == nullptr || index.m_shapes.empty()) {
    return;
  }
  const CVector3& position = robot.Origin->Position;
  // the radius of this robot and that of the other one, both at most SmallReach()
  const auto cells =
      index.m_grid.CellsAround(position.GetX(), position.GetY(), kReach + 2.0 * index.SmallReach());
  index.m_grid.ForRows(cells, [&index, lists](UInt32 first, UInt32 last) {
    if (lists) {
      const UInt32 begin = index.m_sort.Begin(first);
      LoadAhead(index.m_shapes.data() + begin,
                (index.m_sort.End(last) - begin) * sizeof(SPackedShape));
      return;
    }
    LoadBetween(index.m_sort.GetStartAddress(first), index.m_sort.GetStartAddress(last + 2));
    LoadBetween(index.m_wideCells.GetStartAddress(first),
                index.m_wideCells.GetStartAddress(last + 2));
  });
}

}  // namespace argos
