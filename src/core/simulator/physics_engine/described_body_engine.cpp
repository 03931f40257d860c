#include <argos3/core/simulator/physics_engine/described_body_engine.h>

#include <argos3/core/simulator/context/arena.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/recorded_body.h>
#include <argos3/core/utility/memory/room.h>
#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/core/utility/spatial/planar_grid.h>

#include <algorithm>
#include <cmath>
#include <typeinfo>

namespace argos {

namespace {

// spare capacity of an engine with borders, in addition to half of its initial number of bodies
constexpr size_t kSpareBodies = 64;
// m; the origins of frames are multiples of this power of two, so differences from places around
// them are exact
constexpr Real kFrameGrid = 1.0 / 1024.0;
// m; nearer to the world's origin, the frame is that of the world
constexpr Real kNearOrigin = 64.0;
// m; in a wider area the frame is near the bodies, in any other one near the area's centre
constexpr Real kWideArea = 256.0;

// the links of an articulated body have masses; engines may accept bodies without a mass
void CheckMass(const CEmbodiedEntity& body) {
  const Real mass = body.GetBodyDescription()->Mass;
  if (body.IsMovable() && mass != 0.0 && !IsIn(kMass, mass)) {
    RequireIn(kMass, mass, '"' + body.GetRootEntity().GetId() + '"', "its mass");
  }
}

}  // namespace

CDescribedBodyEngine::CDescribedBodyEngine() = default;

CDescribedBodyEngine::~CDescribedBodyEngine() = default;

void CDescribedBodyEngine::Init(TConfigurationNode& tree) {
  CPhysicsEngine::Init(tree);
  if (GetIterations() > kMaxIterations) {
    THROW_ARGOSEXCEPTION(GetOrigin() << ": \"iterations\" must be at most " << kMaxIterations
                                     << ", found " << GetIterations());
  }
}

// The user's model of an entity that does not describe its body; null if there is none.
std::unique_ptr<CRecordedBody> CDescribedBodyEngine::Record(CEntity& root) {
  CEmbodiedEntity* const body = FindEmbodiedEntity(root);
  if (body == nullptr) {
    return nullptr;
  }
  const SBodyDescription* const description = body->GetBodyDescription();
  if (description != nullptr && !description->IsRecorded) {
    return nullptr;
  }
  if (m_recorders.empty()) {
    for (const std::string& label : CFactory<CBodyRecorder>::GetLabels()) {
      m_recorders.emplace_back(CFactory<CBodyRecorder>::New(label));
    }
  }
  for (const auto& recorder : m_recorders) {
    if (std::unique_ptr<CRecordedBody> recorded = recorder->Record(*this, root)) {
      body->SetBodyDescription(recorded->GetDescription());
      return recorded;
    }
  }
  return nullptr;
}

bool CDescribedBodyEngine::AddEntity(CEntity& entity) {
  CRobotsCode::CheckShared("AddEntity() of a physics engine");
  std::unique_ptr<CRecordedBody> recorded = Record(entity);
  CEmbodiedEntity* const body = FindDescribedBody(entity);
  if (body == nullptr || !Accepts(*body)) {
    return false;
  }
  CheckBody(*body);
  CheckMass(*body);
  std::unique_ptr<CDescribedBodyModel> model = CreateModel(*body, recorded.get());
  model->m_recordedBody = std::move(recorded);
  // afterwards nothing deletes the model while the body refers to it
  ReserveOneMore(m_models);
  CDescribedBodyModel& added = *model;
  body->AddPhysicsModel(GetId(), added);
  try {
    AddModel(std::move(model));
  } catch (...) {
    // it may have entered the engine's world in part
    DropWorld();
    body->RemovePhysicsModel(GetId());
    std::erase(m_recorded, &added);
    m_models.pop_back();
    throw;
  }
  return true;
}

void CDescribedBodyEngine::Update() {
  try {
    UpdateWorld();
  } catch (...) {
    DropWorld();
    throw;
  }
}

bool CDescribedBodyEngine::RemoveEntity(CEntity& entity) {
  CRobotsCode::CheckShared("RemoveEntity() of a physics engine");
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
  if (m_models.back()->m_recordedBody != nullptr) {
    m_recorded.push_back(m_models.back().get());
  }
  Enter(*m_models.back());
}

// the last model gets the number of the removed one
std::unique_ptr<CDescribedBodyModel> CDescribedBodyEngine::TakeOut(CDescribedBodyModel& model) {
  ForgetDisplaced(model);
  Leave(model);
  if (model.m_recordedBody != nullptr) {
    std::erase(m_recorded, &model);
  }
  if (model.m_isBundled) {
    model.m_isBundled = false;
    std::erase(m_bundled, &model);
    std::erase(m_strays, &model.GetEmbodiedEntity());
  }
  const size_t number = model.m_number;
  std::swap(m_models[number], m_models.back());
  m_models[number]->m_number = number;
  std::unique_ptr<CDescribedBodyModel> taken = std::move(m_models.back());
  m_models.pop_back();
  return taken;
}

void CDescribedBodyEngine::DestroyModels() {
  m_displaced.clear();
  m_recorded.clear();
  m_bundled.clear();
  m_strays.clear();
  m_models.clear();
  m_recorders.clear();
}

void CDescribedBodyEngine::ResetRecordedBodies() {
  for (CDescribedBodyModel* model : m_recorded) {
    model->m_recordedBody->Reset();
  }
}

void CDescribedBodyEngine::StartRecordedBodies() {
  const Real tick = GetPhysicsClockTick() * GetIterations();
  for (CDescribedBodyModel* model : m_recorded) {
    model->m_recordedBody->StartTick(tick);
  }
}

void CDescribedBodyEngine::FinishRecordedBodies() {
  const Real tick = GetPhysicsClockTick() * GetIterations();
  for (CDescribedBodyModel* model : m_recorded) {
    model->m_recordedBody->FinishTick(tick);
  }
}

void CDescribedBodyEngine::ChooseFrame(bool useBodies) {
  const CRange<CVector3>& arena = GetContext().Arena.Limits;
  SPlanarArea area = {arena.GetMin().GetX(), arena.GetMin().GetY(), arena.GetMax().GetX(),
                      arena.GetMax().GetY()};
  SPlanarArea region = SPlanarArea::Empty();
  for (const CVector2& corner : GetVolume().GetCorners()) {
    region.Include(corner.GetX(), corner.GetY());
  }
  if (region.MinX <= region.MaxX) {
    const SPlanarArea common = {std::max(area.MinX, region.MinX), std::max(area.MinY, region.MinY),
                                std::min(area.MaxX, region.MaxX), std::min(area.MaxY, region.MaxY)};
    area = common.MinX <= common.MaxX && common.MinY <= common.MaxY ? common : region;
  }
  SPlanarArea bodies = SPlanarArea::Empty();
  if (useBodies) {
    for (const auto& model : m_models) {
      if (model->GetEmbodiedEntity().IsMovable()) {
        const CVector3& position = model->GetEmbodiedEntity().GetOriginAnchor().Position;
        bodies.Include(position.GetX(), position.GetY());
      }
    }
  }
  if (bodies.MinX <= bodies.MaxX) {
    // bodies may be outside of the arena, too
    SPlanarArea all = area;
    all.Include(bodies.MinX, bodies.MinY);
    all.Include(bodies.MaxX, bodies.MaxY);
    area = std::max(all.MaxX - all.MinX, all.MaxY - all.MinY) > kWideArea ? bodies : area;
  }
  const Real x = 0.5 * area.MinX + 0.5 * area.MaxX;
  const Real y = 0.5 * area.MinY + 0.5 * area.MaxY;
  m_frameOrigin.Set(0.0, 0.0, 0.0);
  if (std::max(std::abs(x), std::abs(y)) >= kNearOrigin) {
    m_frameOrigin.Set(kFrameGrid * std::round(x / kFrameGrid),
                      kFrameGrid * std::round(y / kFrameGrid), 0.0);
  }
}

std::vector<CDescribedBodyModel*> CDescribedBodyEngine::ListModelsForWorld() {
  ChooseFrame(true);
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
  if (model->m_isBundled || !PrepareTransfer(*model)) {
    return;
  }
  CDescribedBodyEngine* const next = FindNextOfSameType(body);
  if (next == nullptr) {
    CPhysicsEngine::TransferEntity(body);
    return;
  }
  FindCluster(body, m_cluster);
  next->AdoptCluster(*this, m_cluster);
}

void CDescribedBodyEngine::AdoptCluster(CDescribedBodyEngine& from, const TBodies& cluster) {
  if (typeid(from) != typeid(*this)) {
    for (CEmbodiedEntity* each : cluster) {
      AdoptFromOtherType(from, *each);
    }
    return;
  }
  from.CopyGrips(cluster, m_grips);
  for (CEmbodiedEntity* each : cluster) {
    CheckBody(*each);
  }
  for (const CEmbodiedEntity* each : cluster) {
    Adopt(*from.FindModel(*each));
  }
  for (const SGripTransfer& grip : m_grips) {
    RestoreGrip(grip);
  }
}

void CDescribedBodyEngine::AdoptFromOtherType(CDescribedBodyEngine& from, CEmbodiedEntity& body) {
  from.PrepareFor(*this, *from.FindModel(body));
  SBodyMotion motion;
  const bool hasMotion = from.GetMotion(body, motion);
  from.RemoveEntity(body.GetRootEntity());
  AddEntity(body.GetRootEntity());
  if (hasMotion) {
    SetMotion(body, motion);
  }
}

void CDescribedBodyEngine::NoteBundled(CDescribedBodyModel& model) {
  model.m_isBundled = true;
  m_bundled.push_back(&model);
  CEmbodiedEntity& body = model.GetEmbodiedEntity();
  if (!ContainsOriginOf(body)) {
    m_strays.push_back(&body);
  }
}

void CDescribedBodyEngine::ForgetBundles() {
  for (CDescribedBodyModel* model : m_bundled) {
    model->m_isBundled = false;
  }
  m_bundled.clear();
  m_strays.clear();
}

// The engine that receives a body, if that is another engine of this type.
CDescribedBodyEngine* CDescribedBodyEngine::FindNextOfSameType(const CEmbodiedEntity& body) const {
  CPhysicsEngine* const next = FindNextEngine(body, [&body](const CPhysicsEngine& engine) {
    const auto* const described = dynamic_cast<const CDescribedBodyEngine*>(&engine);
    // adding the body is the only way to find out if an engine of another class accepts it
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
