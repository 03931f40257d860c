#include <argos3/plugins/simulator/physics_engines/planar/planar_engine.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>

#include <algorithm>
#include <typeinfo>

namespace argos {

namespace {

// bodies for which an engine with borders has room beyond half as many again as it starts with
constexpr size_t kRoomForComers = 64;

}  // namespace

void CPlanarEngine::Init(TConfigurationNode& tree) {
  CPhysicsEngine::Init(tree);
  CheckIterations(tree, *this);
  m_elevation = ReadElevation(tree);
  if (NodeExists(tree, "spatial_hash")) {
    // tunes a broad phase that no engine here has
    MarkSubtreeRead(GetNode(tree, "spatial_hash"));
  }
}

std::string CPlanarEngine::ExplainRefusal(CEntity& entity) const {
  return ExplainPlanarRefusal(entity, m_elevation);
}

bool CPlanarEngine::AddEntity(CEntity& entity) {
  CEmbodiedEntity* const body = FindPlanarBody(entity);
  if (body == nullptr || !IsOnPlane(*body, m_elevation)) {
    return false;
  }
  CheckPlanarBody(*body);
  std::unique_ptr<CPlanarModel> model = MakeModel(*body, FindWheels(*body));
  body->AddPhysicsModel(GetId(), *model);
  AddModel(std::move(model));
  return true;
}

bool CPlanarEngine::RemoveEntity(CEntity& entity) {
  CEmbodiedEntity* const body = FindPlanarBody(entity);
  for (UInt32 i = 0; body != nullptr && i < body->GetPhysicsModelsNum(); ++i) {
    if (&body->GetPhysicsModel(i).GetEngine() != this) {
      continue;
    }
    const auto model = TakeOut(static_cast<CPlanarModel&>(body->GetPhysicsModel(i)));
    body->RemovePhysicsModel(GetId());
    return true;
  }
  return false;
}

void CPlanarEngine::AddModel(std::unique_ptr<CPlanarModel> model) {
  model->m_number = m_models.size();
  m_models.push_back(std::move(model));
  Enter(*m_models.back());
}

// the last model takes the number of the one that goes
std::unique_ptr<CPlanarModel> CPlanarEngine::TakeOut(CPlanarModel& model) {
  Leave(model);
  const size_t number = model.m_number;
  std::swap(m_models[number], m_models.back());
  m_models[number]->m_number = number;
  std::unique_ptr<CPlanarModel> taken = std::move(m_models.back());
  m_models.pop_back();
  return taken;
}

CPlanarEngine* CPlanarEngine::FindNext(const CEmbodiedEntity& body) const {
  CPhysicsEngine* const engine = FindNextEngine(body);
  if (engine == nullptr || engine == this || typeid(*engine) != typeid(*this)) {
    return nullptr;
  }
  auto* const next = static_cast<CPlanarEngine*>(engine);
  return IsOnPlane(body, next->m_elevation) ? next : nullptr;
}

// The model is made anew where it is, because models refer to their engine for ever, and a tick
// must not ask for memory.
void CPlanarEngine::TakeOver(CPlanarModel& model) {
  auto& from = static_cast<CPlanarEngine&>(model.GetEngine());
  std::unique_ptr<CPlanarModel> taken = from.TakeOut(model);
  CEmbodiedEntity& body = model.m_cEmbodiedEntity;
  RemakeModel(*taken, body, model.m_wheels);
  body.MovePhysicsModel(from.GetId(), GetId(), *taken);
  AddModel(std::move(taken));
}

std::vector<CPlanarModel*> CPlanarEngine::ListModelsForWorld() {
  m_models.reserve(WithComers(m_models.size()));
  std::vector<CPlanarModel*> models;
  models.reserve(m_models.size());
  for (const auto& model : m_models) {
    models.push_back(model.get());
  }
  std::sort(models.begin(), models.end(), [](const CPlanarModel* a, const CPlanarModel* b) {
    return a->m_cEmbodiedEntity.GetIndex() < b->m_cEmbodiedEntity.GetIndex();
  });
  return models;
}

// room that is not used costs no memory
size_t CPlanarEngine::WithComers(size_t bodies) const {
  return IsEntityTransferActive() ? bodies + bodies / 2 + kRoomForComers : bodies;
}

const std::vector<SGhostDisc>& CPlanarEngine::TakeGhosts() {
  ListGhostDiscs(*this, m_elevation, m_ghostDiscs);
  return m_ghostDiscs;
}

}  // namespace argos
