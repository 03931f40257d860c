#include <argos3/core/simulator/tick/loop_functions.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/space/metrics.h>

namespace argos {

// users' classes are created by zero-argument factories: the base class gets the thread's simulator
CLoopFunctions::CLoopFunctions() : m_cSimulator(CurrentSimulator()), m_cSpace(CurrentSpace()) {}

CColor CLoopFunctions::GetFloorColor(const CVector2&) {
  return CColor::WHITE;
}

void CLoopFunctions::SetMetric(const std::string& name, Real value, const std::string& unit) {
  m_cSpace.GetContext().Run.CheckIsNotInPhase("SetMetric()", "it is possible in hooks");
  m_cSpace.GetExtension<CMetrics>().Set(name, value, unit);
}

void CLoopFunctions::MoveEntity(CPositionalEntity& entity, const CVector3& position,
                                const CQuaternion& orientation) {
  entity.MoveTo(position, orientation);
}

bool CLoopFunctions::MoveEntity(CEmbodiedEntity& entity, const CVector3& position,
                                const CQuaternion& orientation, bool checkOnly,
                                bool ignoreCollisions) {
  return entity.MoveTo(position, orientation, checkOnly, ignoreCollisions);
}

void CLoopFunctions::AddEntity(CEntity& entity) {
  m_cSpace.Adopt(std::unique_ptr<CEntity>(&entity));
}

void CLoopFunctions::RemoveEntity(const std::string& id) {
  RemoveEntity(m_cSpace.GetEntity(id));
}

void CLoopFunctions::RemoveEntity(CEntity& entity) {
  if (entity.HasParent()) {
    THROW_ARGOSEXCEPTION("\"" << entity.GetContext() << entity.GetId() << "\" is a component of \""
                              << entity.GetRootEntity().GetId()
                              << "\": only root entities can be removed");
  }
  m_cSpace.Remove(entity);
}

void CLoopFunctions::IterateOverControllableEntities(
    const CSpace::TControllableEntityIterCBType& callback) const {
  m_cSpace.IterateOverControllableEntities(callback);
}

}  // namespace argos
