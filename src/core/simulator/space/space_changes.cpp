// Adding and removing of root entities, at once or at the end of the tick; quarantine.

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/engine_assignment.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <memory>
#include <vector>

namespace argos {

namespace {

template <typename COMPONENT>
std::vector<COMPONENT*> ListComponents(CEntity& root) {
  std::vector<COMPONENT*> found;
  if (auto* const composable = dynamic_cast<CComposableEntity*>(&root)) {
    for (CEntity* component : composable->GetExistingComponents()) {
      if (auto* const wanted = dynamic_cast<COMPONENT*>(component)) {
        found.push_back(wanted);
      }
    }
  }
  return found;
}

}  // namespace

void CSpace::CheckMayChange() const {
  m_context.Run.CheckIsNotInPhase(
      "an operation that adds or removes entities",
      "AddEntity() and RemoveEntity() of the loop functions add and remove at the end of the tick");
}

void CSpace::Adopt(std::unique_ptr<CEntity> entity) {
  if (m_context.Run.DefersChanges()) {
    const auto owned = std::make_shared<std::unique_ptr<CEntity>>(std::move(entity));
    m_context.Run.Defer([this, owned] { AdoptNow(std::move(*owned)); });
    return;
  }
  AdoptNow(std::move(entity));
}

void CSpace::AdoptNow(std::unique_ptr<CEntity> entity) {
  ARGOS_ASSERT(entity != nullptr && !entity->HasParent(),
               "only a root entity is added to the space");
  for (CControllableEntity* robot : ListComponents<CControllableEntity>(*entity)) {
    robot->SetLateController();
  }
  // the operations own it from here on
  CEntity& added = *entity.release();
  try {
    CallEntityOperation<CSpaceOperationAddEntity, CSpace, void>(*this, added);
  } catch (...) {
    // the removal tolerates a partly added entity, and deletes it
    CallEntityOperation<CSpaceOperationRemoveEntity, CSpace, void>(*this, added);
    throw;
  }
  if (added.GetIndex() < 0) {
    entity.reset(&added);
    THROW_ARGOSEXCEPTION("the class of \"" << added.GetId() << "\" (<" << added.GetTypeDescription()
                                           << ">) has no space operations; its source needs a "
                                              "REGISTER_STANDARD_SPACE_OPERATIONS_ON_... line");
  }
}

void CSpace::Remove(CEntity& root) {
  if (m_context.Run.DefersChanges()) {
    // it may be gone at the end of the tick, and its id may be that of another one
    m_context.Run.DeferRemoval(&root, [this, id = root.GetId(), index = root.GetIndex()] {
      if (CEntity* const found = TryGetRoot(id, index)) {
        RemoveNow(*found);
      }
    });
    return;
  }
  {
    // changes that Destroy() of its controller requests
    const CRunState::CScope scope(m_context.Run, CRunState::EActivity::Changing);
    RemoveNow(root);
  }
  m_context.RobotFailures.Report();
  m_context.Run.ApplyChanges();
}

void CSpace::RemoveNow(CEntity& root) {
  ARGOS_ASSERT(!root.HasParent(), "\"" << root.GetId() << "\" is a component: its root is removed");
  CallEntityOperation<CSpaceOperationRemoveEntity, CSpace, void>(*this, root);
}

CEntity* CSpace::TryGetRoot(const std::string& id, ssize_t index) const {
  const auto found = m_rootById.find(id);
  const bool isSame = found != m_rootById.end() && found->second->GetIndex() == index;
  return isSame ? found->second.get() : nullptr;
}

void CSpace::QuarantineLater(CEntity& root) {
  m_context.Run.Defer([this, id = root.GetId(), index = root.GetIndex()] {
    if (CEntity* const found = TryGetRoot(id, index)) {
      QuarantineNow(*found);
    }
  });
}

void CSpace::QuarantineNow(CEntity& root) {
  for (CControllableEntity* robot : ListComponents<CControllableEntity>(root)) {
    robot->SetQuarantined(true);
  }
  // components leave their media
  root.SetEnabled(false);
  for (CEmbodiedEntity* body : ListComponents<CEmbodiedEntity>(root)) {
    CEngineAssignment(m_context).Remove(*body);
  }
}

// Reset() calls it, when the poses of bodies are those of the start
void CSpace::TakeBackQuarantined() {
  for (CControllableEntity* robot : m_robots) {
    if (!robot->IsQuarantined()) {
      continue;
    }
    robot->SetQuarantined(false);
    for (CEmbodiedEntity* body : ListComponents<CEmbodiedEntity>(robot->GetRootEntity())) {
      CEngineAssignment(m_context).Add(*body);
    }
  }
}

}  // namespace argos
