#include <argos3/core/simulator/tick/look_ahead.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/utility/memory/load_ahead.h>

namespace argos {

namespace {

// robots between two stages: they take about as long as one access to memory
constexpr size_t kStep = 8;
// bytes from the beginning of a device or controller that most of them use in every tick
constexpr size_t kDeviceBytes = 128;
constexpr size_t kControllerBytes = sizeof(CCI_Controller) + 96;
// m; how far most sensors reach from the surface of the robot
constexpr Real kReach = 0.1;
// with fewer robots, what a tick reads of them fits into the second-level cache of most processors
constexpr size_t kFewRobots = 500;

void LoadBetween(const void* begin, const void* end) {
  LoadAhead(begin, static_cast<const char*>(end) - static_cast<const char*>(begin));
}

const SAnchor* FindOrigin(CControllableEntity& robot) {
  auto* const root = dynamic_cast<CComposableEntity*>(&robot.GetRootEntity());
  if (root != nullptr) {
    for (CEntity* component : root->GetExistingComponents()) {
      if (auto* const body = dynamic_cast<CEmbodiedEntity*>(component)) {
        return &body->GetOriginAnchor();
      }
    }
  }
  return nullptr;
}

}  // namespace

void CLookAhead::SetRobots(const std::vector<CControllableEntity*>& robots) {
  m_controllables = &robots;
  m_robots.clear();
  m_arrays.clear();
  if (robots.size() < kFewRobots) {
    return;
  }
  m_robots.reserve(robots.size());
  m_arrays.reserve(robots.size());
  for (CControllableEntity* robot : robots) {
    for (const auto& sensor : robot->m_sensors) {
      if (const auto* const withArray = dynamic_cast<const CArraySensor*>(sensor.Simulated)) {
        m_arrays.push_back(withArray->GetReadingsArray());
      }
    }
    m_robots.push_back({FindOrigin(*robot), static_cast<UInt32>(m_arrays.size())});
  }
}

void CLookAhead::BeforeAct(size_t number) const {
  if (number + 3 * kStep >= m_robots.size()) {
    return;
  }
  LoadAhead(&GetRobot(number + 3 * kStep), sizeof(CControllableEntity));
  LoadAhead(GetRobot(number + 2 * kStep).m_actuators.data(), 1);
  for (const CSimulatedActuator* actuator : GetRobot(number + kStep).m_actuators) {
    LoadAhead(actuator, kDeviceBytes);
  }
}

void CLookAhead::BeforeSense(size_t number, const CBodyIndex& index) const {
  if (number + 3 * kStep >= m_robots.size()) {
    return;
  }
  const SAnchor* const farOrigin = m_robots[number + 3 * kStep].Origin;
  LoadAhead(&GetRobot(number + 3 * kStep), sizeof(CControllableEntity));
  if (farOrigin != nullptr) {
    LoadAhead(farOrigin, sizeof(SAnchor));
  }

  const CControllableEntity& middle = GetRobot(number + 2 * kStep);
  LoadAhead(middle.m_sensors.data(), 1);
  LoadAhead(middle.m_actuators.data(), 1);
  if (middle.m_pcController != nullptr) {
    LoadAhead(middle.m_pcController, kControllerBytes);
  }
  LoadAround(m_robots[number + 2 * kStep], index, false);

  const CControllableEntity& near = GetRobot(number + kStep);
  for (const auto& sensor : near.m_sensors) {
    LoadAhead(sensor.Simulated, kDeviceBytes);
  }
  for (const CSimulatedActuator* actuator : near.m_actuators) {
    LoadAhead(actuator, kDeviceBytes);
  }
  LoadAround(m_robots[number + kStep], index, true);
  const UInt32 endOfArrays = m_robots[number + kStep].EndOfArrays;
  for (UInt32 i = m_robots[number + kStep - 1].EndOfArrays; i < endOfArrays; ++i) {
    LoadAhead(m_arrays[i].Start, m_arrays[i].Bytes);
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
                (index.m_sort.End(last) - begin) * sizeof(SIndexedShape));
      return;
    }
    LoadBetween(index.m_sort.GetStartAddress(first), index.m_sort.GetStartAddress(last + 2));
    LoadBetween(index.m_wideCells.GetStartAddress(first),
                index.m_wideCells.GetStartAddress(last + 2));
  });
}

}  // namespace argos
