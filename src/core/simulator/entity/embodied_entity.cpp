#include <argos3/core/simulator/entity/embodied_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/pose_digest.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/geometry/articulation.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/geometry/pose_check.h>
#include <argos3/core/utility/text/classic_locale.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>

namespace argos {

namespace {

// "fb0.body_0"; of an entity that is being constructed, its own id
std::string NameOfBody(const CEntity& body) {
  return "body \"" + body.GetContext() + body.GetId() + '"';
}

}  // namespace

CEmbodiedEntity::CEmbodiedEntity(CComposableEntity* parent) : CEmbodiedEntity(parent, "body_0") {}

CEmbodiedEntity::CEmbodiedEntity(CComposableEntity* parent, const std::string& id,
                                 const CVector3& position, const CQuaternion& orientation,
                                 bool movable)
    : CEntity(parent, id),
      m_cInitOriginPosition(position),
      m_cInitOriginOrientation(
          CheckPose([this] { return NameOfBody(*this); }, position, orientation)),
      m_bMovable(movable) {
  m_anchors.push_back(std::make_unique<SAnchor>(*this, "origin", 0, CVector3(), CQuaternion(),
                                                position, m_cInitOriginOrientation));
  m_psOriginAnchor = m_anchors.front().get();
  m_mapAnchors[m_psOriginAnchor->Id] = m_psOriginAnchor;
  m_psOriginAnchor->Enable();
}

CEmbodiedEntity::~CEmbodiedEntity() {
  LeaveIndex();
}

void CEmbodiedEntity::Init(TConfigurationNode& tree) {
  CEntity::Init(tree);
  GetNodeAttributeOrDefault(tree, "position", m_cInitOriginPosition, CVector3());
  GetNodeAttributeOrDefault(tree, "orientation", m_cInitOriginOrientation, CQuaternion());
  CheckPose([&tree] { return tree.GetLocation() + ": <" + tree.Value() + '>'; },
            m_cInitOriginPosition, m_cInitOriginOrientation);
  m_psOriginAnchor->Position = m_cInitOriginPosition;
  m_psOriginAnchor->Orientation = m_cInitOriginOrientation;
}

void CEmbodiedEntity::SetInitPose(const CVector3& position, const CQuaternion& orientation) {
  m_cInitOriginOrientation =
      CheckPose([this] { return "SetInitPose() of " + NameOfBody(*this); }, position, orientation);
  m_cInitOriginPosition = position;
}

void CEmbodiedEntity::Reset() {
  CEntity::Reset();
  m_turnsX = m_turnsY = 0;
  m_cInitOriginPosition = CurrentContext().Arena.Period.Wrap(m_cInitOriginPosition);
  if (m_tPhysicsModelVector.empty() || CurrentContext().IsSpaceResetting) {
    ResetWithoutEngines();
    return;
  }
  ResetLinks();
  MoveModelsTo(m_cInitOriginPosition, m_cInitOriginOrientation);
  ConfirmMove();
}

// engines restore their state of motion in their own Reset()
void CEmbodiedEntity::ResetWithoutEngines() {
  SetOriginPose(m_cInitOriginPosition, m_cInitOriginOrientation);
  ResetLinks();
  // CalculateAnchors() would use the models, which still have the pose before the reset
  for (SAnchor* anchor : m_vecEnabledAnchors) {
    if (anchor->Index != 0) {
      anchor->FollowOrigin();
    }
  }
  for (CPhysicsModel* model : m_tPhysicsModelVector) {
    model->CalculateBoundingBox();
  }
}

void CEmbodiedEntity::MarkStart() {
  CEntity::MarkStart();
  for (const auto& anchor : m_anchors) {
    anchor->InUseCountAtStart = anchor->InUseCount;
  }
}

void CEmbodiedEntity::ReturnToStart() {
  CEntity::ReturnToStart();
  for (const auto& anchor : m_anchors) {
    anchor->ReturnToStart();
  }
}

SAnchor& CEmbodiedEntity::AddAnchor(const std::string& id, const CVector3& offset,
                                    const CQuaternion& relativeOrientation) {
  CRobotsCode::CheckOwn(*this, "AddAnchor()");
  if (m_mapAnchors.find(id) != m_mapAnchors.end()) {
    THROW_ARGOSEXCEPTION("body \"" << GetContext() << GetId() << "\" already has an anchor \"" << id
                                   << "\"");
  }
  m_anchors.push_back(std::make_unique<SAnchor>(*this, id, static_cast<UInt32>(m_anchors.size()),
                                                offset, relativeOrientation, CVector3(),
                                                CQuaternion()));
  SAnchor& anchor = *m_anchors.back();
  anchor.FollowOrigin();
  m_mapAnchors[id] = &anchor;
  return anchor;
}

const SAnchor& CEmbodiedEntity::GetAnchor(const std::string& id) const {
  const auto found = m_mapAnchors.find(id);
  if (found == m_mapAnchors.end()) {
    std::vector<std::string> known;
    for (const auto& entry : m_mapAnchors) {
      known.push_back(entry.first);
    }
    THROW_ARGOSEXCEPTION("body \"" << GetContext() << GetId() << "\" has no anchor \"" << id << "\""
                                   << DidYouMean(id, known));
  }
  return *found->second;
}

SAnchor& CEmbodiedEntity::GetAnchor(const std::string& id) {
  if (m_mapAnchors.count(id) == 0 && HasParent()) {
    // the anchor belongs to a component that the robot creates on demand, such as a camera
    GetParent().HasComponent(id);
  }
  return const_cast<SAnchor&>(static_cast<const CEmbodiedEntity*>(this)->GetAnchor(id));
}

void CEmbodiedEntity::EnableAnchor(const std::string& id) {
  GetAnchor(id).Enable();
}

void CEmbodiedEntity::DisableAnchor(const std::string& id) {
  GetAnchor(id).Disable();
}

bool CEmbodiedEntity::IsAnchorEnabled(const std::string& id) {
  return GetAnchor(id).InUseCount > 0;
}

const SBoundingBox& CEmbodiedEntity::GetBoundingBox() const {
  if (m_sBoundingBox == nullptr) {
    THROW_ARGOSEXCEPTION("body \"" << GetContext() << GetId()
                                   << "\" is in no physics engine: it has no bounding box");
  }
  return *m_sBoundingBox;
}

void CEmbodiedEntity::CalculateBoundingBox() {
  if (m_tPhysicsModelVector.empty()) {
    m_sBoundingBox = nullptr;
    return;
  }
  // all models of a body have the same solids at the same pose
  m_tPhysicsModelVector.front()->CalculateBoundingBox();
  m_sBoundingBox = &m_tPhysicsModelVector.front()->GetBoundingBox();
}

UInt32 CEmbodiedEntity::GetPhysicsModelsNum() const {
  return static_cast<UInt32>(m_tPhysicsModelVector.size());
}

void CEmbodiedEntity::AddPhysicsModel(const std::string& engineId, CPhysicsModel& model) {
  CRobotsCode::CheckShared(*this, "AddPhysicsModel()");
  if (m_bMovable && !m_tPhysicsModelVector.empty()) {
    THROW_ARGOSEXCEPTION("movable body \""
                         << GetContext() << GetId() << "\" is already in the physics engine \""
                         << m_tPhysicsModelMap.begin()->first << "\"; it cannot also be in \""
                         << engineId << "\"");
  }
  // this precedes the insertion: the model is deleted if there is not enough memory
  m_tPhysicsModelVector.reserve(m_tPhysicsModelVector.size() + 1);
  m_tPhysicsModelMap[engineId] = &model;
  m_tPhysicsModelVector.push_back(&model);
  try {
    CalculateBoundingBox();
    // the body may have been placed after its anchors were made
    model.CalculateAnchors();
  } catch (...) {
    RemovePhysicsModel(engineId);
    throw;
  }
}

void CEmbodiedEntity::RemovePhysicsModel(const std::string& engineId) {
  CRobotsCode::CheckShared(*this, "RemovePhysicsModel()");
  const auto found = m_tPhysicsModelMap.find(engineId);
  if (found == m_tPhysicsModelMap.end()) {
    THROW_ARGOSEXCEPTION("body \"" << GetContext() << GetId()
                                   << "\" is not in the physics engine \"" << engineId << "\"");
  }
  auto& models = m_tPhysicsModelVector;
  models.erase(std::find(models.begin(), models.end(), found->second));
  m_tPhysicsModelMap.erase(found);
  if (models.empty()) {
    m_sBoundingBox = nullptr;
  } else {
    m_sBoundingBox = &models.front()->GetBoundingBox();
  }
}

void CEmbodiedEntity::MovePhysicsModel(const std::string& from, const std::string& to,
                                       CPhysicsModel& model) {
  auto entry = m_tPhysicsModelMap.extract(from);
  ARGOS_ASSERT(!entry.empty(), "a model is moved out of an engine that has none");
  auto& models = m_tPhysicsModelVector;
  models.erase(std::find(models.begin(), models.end(), entry.mapped()));
  // reuses the entry of the map, so that AddPhysicsModel() does not allocate one
  entry.key() = to;
  entry.mapped() = &model;
  m_tPhysicsModelMap.insert(std::move(entry));
  AddPhysicsModel(to, model);
}

const CPhysicsModel& CEmbodiedEntity::GetPhysicsModel(size_t index) const {
  if (index >= m_tPhysicsModelVector.size()) {
    THROW_ARGOSEXCEPTION("body \"" << GetContext() << GetId() << "\" has "
                                   << m_tPhysicsModelVector.size() << " physics models; number "
                                   << index << " does not exist");
  }
  return *m_tPhysicsModelVector[index];
}

CPhysicsModel& CEmbodiedEntity::GetPhysicsModel(size_t index) {
  return const_cast<CPhysicsModel&>(
      static_cast<const CEmbodiedEntity*>(this)->GetPhysicsModel(index));
}

const CPhysicsModel& CEmbodiedEntity::GetPhysicsModel(const std::string& engineId) const {
  const auto found = m_tPhysicsModelMap.find(engineId);
  if (found == m_tPhysicsModelMap.end()) {
    THROW_ARGOSEXCEPTION("body \"" << GetContext() << GetId()
                                   << "\" is not in the physics engine \"" << engineId << "\"");
  }
  return *found->second;
}

CPhysicsModel& CEmbodiedEntity::GetPhysicsModel(const std::string& engineId) {
  return const_cast<CPhysicsModel&>(
      static_cast<const CEmbodiedEntity*>(this)->GetPhysicsModel(engineId));
}

void CEmbodiedEntity::MoveModelsTo(const CVector3& position, const CQuaternion& orientation) {
  SetOriginPose(position, orientation);
  for (CPhysicsModel* model : m_tPhysicsModelVector) {
    model->MoveTo(position, orientation);
  }
  if (m_bodyIndex != nullptr) {
    m_bodyIndex->RefreshNow(m_bodyNumber);
  }
}

CVector3 CEmbodiedEntity::GetUnwrappedPosition() const {
  const SPeriodicity& period = CurrentContext().Arena.Period;
  return m_psOriginAnchor->Position +
         CVector3(m_turnsX * period.X.Period, m_turnsY * period.Y.Period, 0.0);
}

void CEmbodiedEntity::CountTurns(const CVector3& next, const SPeriodicity& period) {
  const CVector3 way = next - m_psOriginAnchor->Position;
  const auto count = [](const SPeriodicAxis& axis, Real difference) {
    return axis.IsOn() ? static_cast<SInt32>(std::nearbyint(difference / axis.Period)) : 0;
  };
  m_turnsX -= count(period.X, way.GetX());
  m_turnsY -= count(period.Y, way.GetY());
}

void CEmbodiedEntity::WrapIntoArena() {
  const SPeriodicity& period = CurrentContext().Arena.Period;
  if (period.IsOn()) {
    m_cInitOriginPosition = period.Wrap(m_cInitOriginPosition);
    SetOriginPose(period.Wrap(m_psOriginAnchor->Position), m_psOriginAnchor->Orientation);
  }
}

// one engine without limits is enough for a body in several, such as an immovable one
SBodyPose CEmbodiedEntity::FindPossiblePose(const SBodyPose& pose) const {
  const SBodyPose inArena = {CurrentContext().Arena.Period.Wrap(pose.Position), pose.Orientation};
  SBodyPose possible = inArena;
  for (const CPhysicsModel* model : m_tPhysicsModelVector) {
    possible = model->FindPossiblePose(inArena);
    if (possible.Position == inArena.Position && possible.Orientation == pose.Orientation) {
      break;
    }
  }
  return possible;
}

bool CEmbodiedEntity::MoveTo(const CVector3& position, const CQuaternion& orientation,
                             bool checkOnly, bool ignoreCollisions) {
  CRobotsCode::CheckShared(*this, "MoveTo()");
  const SBodyPose pose =
      FindPossiblePose({position, CheckPose([this] { return "MoveTo() of " + NameOfBody(*this); },
                                            position, orientation)});
  const CVector3 oldPosition = m_psOriginAnchor->Position;
  const CQuaternion oldOrientation = m_psOriginAnchor->Orientation;
  MoveModelsTo(pose.Position, pose.Orientation);
  const bool fits =
      ignoreCollisions || !(checkOnly ? IsCollidingWithSomething() : IsOverlappingSomething());
  if (checkOnly || !fits) {
    MoveModelsTo(oldPosition, oldOrientation);
  } else {
    ConfirmMove();
  }
  return fits;
}

void CEmbodiedEntity::ConfirmMove() {
  for (CPhysicsModel* model : m_tPhysicsModelVector) {
    model->ConfirmMove();
  }
  if (!m_tPhysicsModelVector.empty()) {
    m_tPhysicsModelVector.front()->ChangeEngines();
  }
  // mounted components (LEDs, ...) follow at once
  GetRootEntity().Update();
}

bool CEmbodiedEntity::IsCollidingWithSomething() const {
  return std::ranges::any_of(m_tPhysicsModelVector, &CPhysicsModel::IsCollidingWithSomething);
}

bool CEmbodiedEntity::IsOverlappingSomething() const {
  return std::ranges::any_of(m_tPhysicsModelVector, &CPhysicsModel::IsOverlappingSomething);
}

void CEmbodiedEntity::SetBodyDescription(std::shared_ptr<const SBodyDescription> description) {
  CRobotsCode::CheckShared(*this, "SetBodyDescription()");
  m_description = std::move(description);
  const SArticulation* const articulation =
      m_description != nullptr ? m_description->Articulation.get() : nullptr;
  if (articulation == nullptr) {
    m_links.reset();
  } else {
    if (m_links == nullptr) {
      m_links = std::make_unique<SLinks>();
    }
    m_links->Poses.assign(articulation->GetNumLinks(), SBodyPose());
  }
  NotifyIndex();
}

void CEmbodiedEntity::SetMovable(bool movable) {
  CRobotsCode::CheckShared(*this, "SetMovable()");
  KeepForReset(&m_bMovable, [this, start = m_bMovable] { SetMovable(start); });
  m_bMovable = movable;
  NotifyIndex();
}

void CEmbodiedEntity::NotifyIndex() {
  if (m_bodyIndex == nullptr) {
    return;
  }
  if (m_description != nullptr) {
    m_bodyIndex->Redescribe(m_bodyNumber, *m_description, m_bMovable, GetLinkPoses());
  } else {
    LeaveIndex();
  }
}

// reached only if an engine computes such a pose: poses from elsewhere are checked
void CEmbodiedEntity::ThrowNotFinite(const CVector3& position,
                                     const CQuaternion& orientation) const {
  CTextOutput text;
  text << NameOfBody(*this) << ": its pose is not finite any more: position (" << position
       << "), orientation (w,x,y,z) = (" << orientation.GetW() << "," << orientation.GetX() << ","
       << orientation.GetY() << "," << orientation.GetZ() << ")";
  if (!m_tPhysicsModelMap.empty()) {
    text << ", computed by the physics engine \"" << m_tPhysicsModelMap.begin()->first << '"';
  }
  if (m_description != nullptr) {
    text << "; its mass is " << m_description->Mass << " kg";
  }
  text << "; are its mass, its size, and the forces on it in proportion to those of other bodies?";
  THROW_ARGOSEXCEPTION(text.str());
}

void CEmbodiedEntity::SetOriginPose(const CVector3& position, const CQuaternion& orientation) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckShared(*this, "SetOriginPose()");
  }
  if (!IsFinitePose(position, orientation)) {
    ThrowNotFinite(position, orientation);
  }
  m_psOriginAnchor->Position = position;
  m_psOriginAnchor->Orientation = orientation;
  if (!m_bMovable && m_bodyIndex != nullptr) {
    m_bodyIndex->NoteWideMoved();
  }
}

void CEmbodiedEntity::SetLinkPose(UInt32 link, const SBodyPose& pose) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckShared(*this, "SetLinkPose()");
  }
  ARGOS_ASSERT(m_links != nullptr && link < m_links->Poses.size(), "there is no link " << link);
  if (!IsFinitePose(pose.Position, pose.Orientation)) {
    ThrowNotFinite(pose.Position, pose.Orientation);
  }
  m_links->Poses[link] = pose;
  for (const SLinks::SMounted& mounted : m_links->Anchors) {
    if (mounted.Link == link) {
      const SBodyPose place = Compose(pose, mounted.Offset);
      mounted.Anchor->OffsetPosition = place.Position;
      mounted.Anchor->OffsetOrientation = place.Orientation;
    }
  }
}

void CEmbodiedEntity::MountOnLink(SAnchor& anchor, UInt32 link) {
  ARGOS_ASSERT(m_links != nullptr && link < m_links->Poses.size() && anchor.Index != 0,
               "anchor \"" << anchor.Id << "\" cannot be mounted on link " << link);
  m_links->Anchors.push_back({link, &anchor, {anchor.OffsetPosition, anchor.OffsetOrientation}});
}

void CEmbodiedEntity::ResetLinks() {
  for (UInt32 link = 0; m_links != nullptr && link < m_links->Poses.size(); ++link) {
    SetLinkPose(link, SBodyPose());
  }
}

void CEmbodiedEntity::EnterIndex(CBodyIndex& index) {
  ARGOS_ASSERT(m_bodyIndex == nullptr && m_description != nullptr,
               "a body enters an index with a description, and one index only");
  m_bodyNumber = index.Add(*this, *m_psOriginAnchor, *m_description, m_bMovable, GetLinkPoses());
  // afterwards: without enough memory the body is in no index
  m_bodyIndex = &index;
}

void CEmbodiedEntity::LeaveIndex() {
  if (m_bodyIndex != nullptr) {
    m_bodyIndex->Remove(m_bodyNumber);
    m_bodyIndex = nullptr;
    m_bodyNumber = CBodyIndex::kNoBody;
  }
}

void CEmbodiedEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  AddPose(digest, m_psOriginAnchor->Position, m_psOriginAnchor->Orientation);
  if (m_links != nullptr) {
    for (const SBodyPose& link : m_links->Poses) {
      AddPose(digest, link.Position, link.Orientation);
    }
  }
}

}  // namespace argos
