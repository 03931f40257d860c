#include <argos3/core/simulator/physics_engine/described_body_engine.h>

#include <argos3/core/simulator/entity/embodied_entity.h>

#include <algorithm>
#include <typeinfo>

namespace argos {

namespace {

// spare capacity of an engine with borders, in addition to half of its initial number of bodies
constexpr size_t kSpareBodies = 64;

}  // namespace

void CDescribedBodyEngine::Init(TConfigurationNode& tree) {
  CPhysicsEngine::Init(tree);
  if (GetIterations() > kMaxIterations) {
    THROW_ARGOSEXCEPTION(GetOrigin() << ": \"iterations\" must be at most " << kMaxIterations
                                     << ", found " << GetIterations());
  }
}

bool CDescribedBodyEngine::AddEntity(CEntity& entity) {
  CEmbodiedEntity* const body = FindDescribedBody(entity);
  if (body == nullptr || !Accepts(*body)) {
    return false;
  }
  CheckBody(*body);
  std::unique_ptr<CDescribedBodyModel> model = CreateModel(*body);
  body->AddPhysicsModel(GetId(), *model);
  AddModel(std::move(model));
  return true;
}

bool CDescribedBodyEngine::RemoveEntity(CEntity& entity) {
  CEmbodiedEntity* const body = FindDescribedBody(entity);
  CDescribedBodyModel* const model = body != nullptr ? FindModel(*body) : nullptr;
  if (model == nullptr) {
    return false;
  }
  const std::unique_ptr<CDescribedBodyModel> removed = TakeOut(*model);
  body->RemovePhysicsModel(GetId());
  return true;
}

CDescribedBodyModel* CDescribedBodyEngine::FindModel(const CEmbodiedEntity& body) const {
  for (size_t i = 0; i < body.GetPhysicsModelsNum(); ++i) {
    const CPhysicsModel& model = body.GetPhysicsModel(i);
    if (&model.GetEngine() == this) {
      return const_cast<CDescribedBodyModel*>(dynamic_cast<const CDescribedBodyModel*>(&model));
    }
  }
  return nullptr;
}

void CDescribedBodyEngine::AddModel(std::unique_ptr<CDescribedBodyModel> model) {
  model->m_number = m_models.size();
  m_models.push_back(std::move(model));
  Enter(*m_models.back());
}

// the last model gets the number of the removed one
std::unique_ptr<CDescribedBodyModel> CDescribedBodyEngine::TakeOut(CDescribedBodyModel& model) {
  ForgetDisplaced(model);
  Leave(model);
  const size_t number = model.m_number;
  std::swap(m_models[number], m_models.back());
  m_models[number]->m_number = number;
  std::unique_ptr<CDescribedBodyModel> taken = std::move(m_models.back());
  m_models.pop_back();
  return taken;
}

void CDescribedBodyEngine::DestroyModels() {
  m_displaced.clear();
  m_models.clear();
}

std::vector<CDescribedBodyModel*> CDescribedBodyEngine::ListModelsForWorld() {
  m_models.reserve(AddSpareCapacity(m_models.size()));
  std::vector<CDescribedBodyModel*> models;
  models.reserve(m_models.size());
  for (const auto& model : m_models) {
    models.push_back(model.get());
  }
  std::sort(models.begin(), models.end(),
            [](const CDescribedBodyModel* a, const CDescribedBodyModel* b) {
              return a->GetEmbodiedEntity().GetIndex() < b->GetEmbodiedEntity().GetIndex();
            });
  return models;
}

// unused capacity is never touched, so it costs no memory
size_t CDescribedBodyEngine::AddSpareCapacity(size_t bodies) const {
  return IsEntityTransferActive() ? bodies + bodies / 2 + kSpareBodies : bodies;
}

void CDescribedBodyEngine::TransferEntity(CEmbodiedEntity& body) {
  if (&body.GetPhysicsModel(size_t(0)).GetEngine() != this) {
    // already transferred with its cluster
    return;
  }
  CDescribedBodyModel* const model = FindModel(body);
  if (model == nullptr) {
    CPhysicsEngine::TransferEntity(body);
    return;
  }
  if (!PrepareTransfer(*model)) {
    return;
  }
  CDescribedBodyEngine* const next = FindNextOfSameType(body);
  if (next == nullptr) {
    CPhysicsEngine::TransferEntity(body);
    return;
  }
  FindCluster(body, m_cluster);
  CopyGrips(m_cluster, m_grips);
  for (CEmbodiedEntity* each : m_cluster) {
    next->CheckBody(*each);
  }
  for (const CEmbodiedEntity* each : m_cluster) {
    next->Adopt(*FindModel(*each));
  }
  for (const SGripTransfer& grip : m_grips) {
    next->RestoreGrip(grip);
  }
}

// The engine that receives a body, if that is another engine of this type.
CDescribedBodyEngine* CDescribedBodyEngine::FindNextOfSameType(const CEmbodiedEntity& body) const {
  CPhysicsEngine* const next = FindNextEngine(body, [&body](const CPhysicsEngine& engine) {
    const auto* const described = dynamic_cast<const CDescribedBodyEngine*>(&engine);
    // for an engine of another class, only adding the body shows if it is accepted
    return described == nullptr || described->Accepts(body);
  });
  const bool isOther = next != nullptr && next != this;
  return isOther && typeid(*next) == typeid(*this) ? static_cast<CDescribedBodyEngine*>(next)
                                                   : nullptr;
}

void CDescribedBodyEngine::Adopt(CDescribedBodyModel& model) {
  auto& from = static_cast<CDescribedBodyEngine&>(model.GetEngine());
  std::unique_ptr<CDescribedBodyModel> taken = from.TakeOut(model);
  taken->SetEngine(*this);
  taken->GetEmbodiedEntity().MovePhysicsModel(from.GetId(), GetId(), *taken);
  AddModel(std::move(taken));
}

bool CDescribedBodyEngine::LeadsCluster(CEmbodiedEntity& body) {
  FindCluster(body, m_cluster);
  return std::none_of(m_cluster.begin(), m_cluster.end(), [&body](const CEmbodiedEntity* each) {
    return each->GetIndex() < body.GetIndex();
  });
}

void CDescribedBodyEngine::NoticeMove(CDescribedBodyModel& model) {
  if (!HasWorld()) {
    return;
  }
  if (!DefersMoves()) {
    Reposition(model);
  } else if (!model.m_isDisplaced) {
    model.m_isDisplaced = true;
    m_displaced.push_back(&model);
  }
}

void CDescribedBodyEngine::NoticeConfirmedMove(CDescribedBodyModel& model) {
  ForgetDisplaced(model);
  if (DefersMoves() && HasWorld()) {
    Reposition(model);
  }
}

// Most displaced bodies have been put back by code that tested whether a place is free.
void CDescribedBodyEngine::RepositionDisplaced() {
  for (CDescribedBodyModel* model : m_displaced) {
    model->m_isDisplaced = false;
    if (!IsAtLastPose(*model)) {
      Reposition(*model);
    }
  }
  m_displaced.clear();
}

void CDescribedBodyEngine::ForgetDisplaced() {
  for (CDescribedBodyModel* model : m_displaced) {
    model->m_isDisplaced = false;
  }
  m_displaced.clear();
}

void CDescribedBodyEngine::ForgetDisplaced(CDescribedBodyModel& model) {
  if (model.m_isDisplaced) {
    model.m_isDisplaced = false;
    // searched from the end, where the model usually is
    m_displaced.erase(std::find(m_displaced.rbegin(), m_displaced.rend(), &model).base() - 1);
  }
}

}  // namespace argos
