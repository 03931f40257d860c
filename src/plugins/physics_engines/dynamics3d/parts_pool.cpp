#include <argos3/plugins/simulator/physics_engines/dynamics3d/parts_pool.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>

#include <algorithm>
#include <utility>

namespace argos {

CPartsPool::~CPartsPool() {
  Clear();
}

void CPartsPool::Clear() {
  for (SKind& kind : m_kinds) {
    std::for_each(kind.Spares.begin(), kind.Spares.end(), &DestroyRigidParts);
  }
  m_kinds.clear();
  m_size = 0;
}

CPartsPool::SKind& CPartsPool::GetKind(const SRigidBody& robot) {
  const auto found = std::find_if(m_kinds.begin(), m_kinds.end(), [&robot](const SKind& kind) {
    return kind.Description == robot.Source.Shared;
  });
  if (found != m_kinds.end()) {
    return *found;
  }
  return m_kinds.emplace_back(SKind{robot.Source.Shared, {}});
}

void CPartsPool::Return(SRigidBody& robot, size_t most) {
  if (m_size >= most) {
    DestroyRigidParts(robot);
    return;
  }
  PutToSleep(robot);
  GetKind(robot).Spares.push_back(std::move(static_cast<SRigidParts&>(robot)));
  static_cast<SRigidParts&>(robot) = {};
  ++m_size;
}

bool CPartsPool::Take(SRigidBody& robot) {
  SKind& kind = GetKind(robot);
  if (kind.Spares.empty()) {
    return false;
  }
  static_cast<SRigidParts&>(robot) = std::move(kind.Spares.back());
  kind.Spares.pop_back();
  --m_size;
  ForEachPart(robot, &dBodyEnable);
  return true;
}

}  // namespace argos
