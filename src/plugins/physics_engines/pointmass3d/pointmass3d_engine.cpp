#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_engine.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/drivers.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/flyers.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_body.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/engine_manual.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/flight_loop.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_components.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace argos {

namespace {

using EKind = CPointMass3DBody::EKind;

std::string NameOf(const CEmbodiedEntity& body) {
  return "\"" + body.GetRootEntity().GetId() + "\"";
}

EKind GetKind(const CEmbodiedEntity& body) {
  const SBodyDescription& description = *body.GetBodyDescription();
  if (body.IsMovable() && description.Propellers) {
    return EKind::Flyer;
  }
  return body.IsMovable() && description.HasDrive() ? EKind::Driver : EKind::Still;
}

void CheckGains(const std::string& owner, const std::string& loop, const SControlGains& gains,
                bool needsDerivative) {
  RequirePositive(gains.Proportional, owner, "proportional gain on " + loop);
  if (needsDerivative) {
    RequirePositive(gains.Derivative, owner, "derivative gain on " + loop);
  } else {
    RequireNotNegative(gains.Derivative, owner, "derivative gain on " + loop);
  }
}

void CheckDescription(const CEmbodiedEntity& body, EKind kind) {
  const std::string owner = NameOf(body);
  const CVector3& position = body.GetOriginAnchor().Position;
  // written so that NaN fails too
  if (!(std::abs(position.GetX()) + std::abs(position.GetY()) + std::abs(position.GetZ()) <=
        kMaxDistance)) {
    THROW_ARGOSEXCEPTION(owner << " at (" << position << ") is farther than " << kMaxDistance
                               << " m from the origin: positions would no longer be accurate");
  }
  const SBodyDescription& description = *body.GetBodyDescription();
  if (kind == EKind::Driver && description.Drive) {
    RequirePositive(description.Drive->InterwheelDistance, owner,
                    "distance between the wheels (m)");
  } else if (kind == EKind::Flyer) {
    const SPropellersDescription& propellers = *description.Propellers;
    RequirePositive(description.Mass, owner, "mass (kg)");
    RequirePositive(description.GetPlanarInertia(), owner, "moment of inertia (kg m^2)");
    // without a derivative gain, a loop on position has no damping
    CheckGains(owner, "position", propellers.Position, true);
    CheckGains(owner, "yaw", propellers.Yaw, true);
    CheckGains(owner, "velocity", propellers.Velocity, false);
    CheckGains(owner, "yaw rate", propellers.YawRate, false);
    RequirePositive(propellers.MaxForce, owner, "greatest force of the propellers (N)");
    RequirePositive(propellers.MaxTorque, owner, "greatest torque of the propellers (N m)");
  }
}

SPlanarPose GetPlanarPose(const CEmbodiedEntity& body) {
  const SAnchor& origin = body.GetOriginAnchor();
  return MakePlanarPose(origin.Position, origin.Orientation);
}

SFlightPose GetFlightPose(const CEmbodiedEntity& body, const CVector3& frameOrigin) {
  return {body.GetOriginAnchor().Position - frameOrigin, GetPlanarPose(body).ComputeYaw()};
}

UInt32 CountSubsteps(Real tick, Real longest) {
  // the tolerance keeps a rounding error from adding a substep
  const Real needed = std::ceil(tick / longest - 1e-9);
  return static_cast<UInt32>(
      std::clamp<Real>(needed, 1.0, CDescribedBodyEngine::kMaxIterations + 1.0));
}

}  // namespace

CPointMass3DEngine::CPointMass3DEngine()
    : m_flyers(std::make_unique<CFlyers>()), m_drivers(std::make_unique<CDrivers>()) {}

CPointMass3DEngine::~CPointMass3DEngine() = default;

void CPointMass3DEngine::Init(TConfigurationNode& tree) {
  CDescribedBodyEngine::Init(tree);
  GetNodeAttributeOrDefault(tree, "gravity", m_gravity, m_gravity);
  RequireIn(kAcceleration, m_gravity, GetOrigin(), "attribute \"gravity\"");
  std::string motion = "exact";
  GetNodeAttributeOrDefault(tree, "motion", motion, motion);
  if (motion != "exact" && motion != "argos3") {
    THROW_ARGOSEXCEPTION(GetOrigin() << ": \"motion\" must be \"exact\" or \"argos3\", found \""
                                     << motion << '"');
  }
  m_moveAsArgos3 = motion == "argos3";
  m_flyers->SetLaw(m_moveAsArgos3 ? EFlightLaw::Argos3 : EFlightLaw::Stable);
}

void CPointMass3DEngine::Destroy() {
  m_flyers->Clear();
  m_drivers->Clear();
  DestroyModels();
  m_userModels.clear();
  m_numOutsideIndex = 0;
  m_substeps = 0;
}

// The entities have been reset to their initial poses.
void CPointMass3DEngine::Reset() {
  ResetRecordedBodies();
  for (const auto& model : GetModels()) {
    Reposition(*model);
  }
  for (const SUserModel& user : m_userModels) {
    user.Model->Reset();
  }
}

bool CPointMass3DEngine::AddEntity(CEntity& entity) {
  if (CallEntityOperation<CPointMass3DOperationAddEntity, CPointMass3DEngine, SOperationOutcome>(
          *this, entity)()) {
    return true;
  }
  return CDescribedBodyEngine::AddEntity(entity);
}

bool CPointMass3DEngine::Accepts(const CEmbodiedEntity& body) const {
  return body.GetBodyDescription()->Articulation == nullptr;
}

std::string CPointMass3DEngine::ExplainRefusal(CEntity& entity) const {
  const CEmbodiedEntity* const body = FindDescribedBody(entity);
  if (body != nullptr && !Accepts(*body)) {
    return "moves points, but a <" + entity.GetTypeDescription() +
           "> with joints has links: add an engine for jointed bodies, such as <dynamics3d>";
  }
  return "accepts only bodies with an SBodyDescription or with a model that a user has registered, "
         "and <" +
         entity.GetTypeDescription() + "> has neither";
}

void CPointMass3DEngine::CheckBody(CEmbodiedEntity& body) const {
  const EKind kind = GetKind(body);
  CheckDescription(body, kind);
  // throw if the components are missing
  FindDrive(body);
  FindQuadrotor(body);
  if (kind == EKind::Flyer) {
    CheckFlyer(body);
  }
}

void CPointMass3DEngine::CheckFlyer(const CEmbodiedEntity& body) const {
  const SBodyDescription& description = *body.GetBodyDescription();
  const Real longest = ComputeMaxFlightSubstep(description);
  if (!m_moveAsArgos3 && CountSubsteps(m_cSimulator.GetTickLength(), longest) > kMaxIterations) {
    THROW_ARGOSEXCEPTION("the controllers of " << NameOf(body) << " need substeps of at most "
                                               << longest << " s: a tick of "
                                               << m_cSimulator.GetTickLength()
                                               << " s would take more than " << kMaxIterations
                                               << "; raise \"ticks_per_second\"");
  }
  const auto [lowest, highest] = ComputeFlightSpace(body);
  if (!(lowest <= highest)) {
    const SBoundingBox box = description.ComputeBoundingBox(CVector3(), CQuaternion());
    THROW_ARGOSEXCEPTION("the arena, of the size \""
                         << m_cSpace.GetArenaSize() << "\" m, is too small for " << NameOf(body)
                         << ", which is kept inside: it needs "
                         << 2.0 * description.ComputeBoundingRadius() << " m along x and y, and "
                         << box.MaxCorner.GetZ() - box.MinCorner.GetZ() << " m of height");
  }
}

// The corners of the box in which the position of a flying body is kept, m.
std::pair<CVector3, CVector3> CPointMass3DEngine::ComputeFlightSpace(
    const CEmbodiedEntity& body) const {
  const SBodyDescription& description = *body.GetBodyDescription();
  const Real radius = description.ComputeBoundingRadius();
  const SBoundingBox box = description.ComputeBoundingBox(CVector3(), CQuaternion());
  const CRange<CVector3>& arena = m_cSpace.GetArenaLimits();
  return {arena.GetMin() + CVector3(radius, radius, -box.MinCorner.GetZ()),
          arena.GetMax() - CVector3(radius, radius, box.MaxCorner.GetZ())};
}

std::unique_ptr<CDescribedBodyModel> CPointMass3DEngine::CreateModel(
    CEmbodiedEntity& body, const CRecordedBody* recorded) {
  return std::make_unique<CPointMass3DBody>(*this, body, GetKind(body), FindDrive(body, recorded));
}

void CPointMass3DEngine::Enter(CDescribedBodyModel& model) {
  auto& entering = static_cast<CPointMass3DBody&>(model);
  CEmbodiedEntity& body = entering.m_cEmbodiedEntity;
  const SBodyDescription& description = *body.GetBodyDescription();
  if (m_flyers->GetCount() + m_drivers->GetCount() == 0) {
    ChooseFrame(false);
    m_flyers->SetOrigin(GetFrameOrigin());
  }
  if (entering.m_kind == EKind::Flyer) {
    CFlyers::SSettings settings;
    settings.Owner = &entering;
    settings.Quadrotor = FindQuadrotor(body);
    settings.Body = &description;
    settings.Gravity = m_gravity;
    std::tie(settings.Lowest, settings.Highest) = ComputeFlightSpace(body);
    settings.Lowest -= GetFrameOrigin();
    settings.Highest -= GetFrameOrigin();
    entering.m_handle = m_flyers->Add(settings, GetFlightPose(body, GetFrameOrigin()));
    m_substeps = 0;
  } else if (entering.m_kind == EKind::Driver) {
    entering.m_handle = m_drivers->Add(entering, entering.m_drive, ToFrame(GetPlanarPose(body)),
                                       body.GetOriginAnchor().Position.GetZ());
  }
}

bool CPointMass3DEngine::RemoveEntity(CEntity& entity) {
  if (CDescribedBodyEngine::RemoveEntity(entity)) {
    return true;
  }
  const CEmbodiedEntity* const body = FindEmbodiedEntity(entity);
  for (UInt32 i = 0; body != nullptr && i < body->GetPhysicsModelsNum(); ++i) {
    if (&body->GetPhysicsModel(i).GetEngine() == this) {
      return CallEntityOperation<CPointMass3DOperationRemoveEntity, CPointMass3DEngine,
                                 SOperationOutcome>(*this, entity)();
    }
  }
  return false;
}

// the last body of the same kind gets the slot of the removed one
void CPointMass3DEngine::Leave(CDescribedBodyModel& model) {
  auto& leaving = static_cast<CPointMass3DBody&>(model);
  const SPointMassHandle handle = std::exchange(leaving.m_handle, SPointMassHandle());
  const auto remove = [&handle](auto& bodies) {
    CPointMass3DBody* const moved = bodies.Remove(handle);
    if (moved != nullptr) {
      moved->m_handle = bodies.GetHandle(handle.Slot);
    }
  };
  if (leaving.m_kind == EKind::Flyer) {
    remove(*m_flyers);
    m_substeps = 0;
  } else if (leaving.m_kind == EKind::Driver) {
    remove(*m_drivers);
  }
}

void CPointMass3DEngine::Reposition(CDescribedBodyModel& model) {
  const auto& displaced = static_cast<CPointMass3DBody&>(model);
  const CEmbodiedEntity& body = displaced.m_cEmbodiedEntity;
  if (displaced.m_kind == EKind::Flyer) {
    m_flyers->Place(m_flyers->GetNumber(displaced.m_handle), GetFlightPose(body, GetFrameOrigin()));
  } else if (displaced.m_kind == EKind::Driver) {
    m_drivers->Place(m_drivers->GetNumber(displaced.m_handle), ToFrame(GetPlanarPose(body)),
                     body.GetOriginAnchor().Position.GetZ());
  }
}

void CPointMass3DEngine::Adopt(CDescribedBodyModel& model) {
  const auto& adopted = static_cast<CPointMass3DBody&>(model);
  if (adopted.m_kind != EKind::Flyer) {
    CDescribedBodyEngine::Adopt(model);
    return;
  }
  const auto& from = static_cast<CPointMass3DEngine&>(model.GetEngine());
  SFlightState state = from.m_flyers->GetState(from.m_flyers->GetNumber(adopted.m_handle));
  CDescribedBodyEngine::Adopt(model);
  for (UInt32 axis = 0; axis < 3; ++axis) {
    state[axis].Place += from.GetFrameOrigin()[axis] - GetFrameOrigin()[axis];
  }
  m_flyers->SetState(m_flyers->GetNumber(adopted.m_handle), state);
}

CPointMass3DBody* CPointMass3DEngine::FindBody(const CEmbodiedEntity& body) const {
  return static_cast<CPointMass3DBody*>(FindModel(body));
}

bool CPointMass3DEngine::GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const {
  const CPointMass3DBody* const model = FindBody(body);
  if (model == nullptr || model->m_kind == EKind::Still) {
    return false;
  }
  if (model->m_kind == EKind::Flyer) {
    const SFlightState state = m_flyers->GetState(m_flyers->GetNumber(model->m_handle));
    motion.Velocity = CVector3(state[0].Speed, state[1].Speed, state[2].Speed);
    motion.Rotation = CVector3(0.0, 0.0, state[3].Speed);
  } else {
    const SDriveCommand command = m_drivers->GetCommand(m_drivers->GetNumber(model->m_handle));
    motion.Velocity = CVector3(command.Ahead, command.Left, 0.0);
    motion.Rotation = CVector3(0.0, 0.0, command.YawRate);
    motion.Velocity.Rotate(body.GetOriginAnchor().Orientation);
  }
  return true;
}

void CPointMass3DEngine::SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) {
  CRobotsCode::CheckShared("CPhysicsEngine::SetMotion()");
  const CPointMass3DBody* const model = FindBody(body);
  if (model == nullptr || model->m_kind != EKind::Flyer) {
    return;
  }
  const UInt32 number = m_flyers->GetNumber(model->m_handle);
  SFlightState state = m_flyers->GetState(number);
  for (UInt32 axis = 0; axis < 3; ++axis) {
    state[axis].Speed = motion.Velocity[axis];
  }
  state[3].Speed = motion.Rotation.GetZ();
  m_flyers->SetState(number, state);
}

UInt32 CPointMass3DEngine::GetSubsteps() {
  if (m_substeps == 0) {
    m_substeps = std::max(GetIterations(), CountSubsteps(m_cSimulator.GetTickLength(),
                                                         m_flyers->ComputeMaxSubstep()));
  }
  return m_substeps;
}

void CPointMass3DEngine::UpdateWorld() {
  StartRecordedBodies();
  const Real tick = m_cSimulator.GetTickLength();
  if (m_moveAsArgos3) {
    // one substep of a tick's iterations
    m_drivers->Advance(GetPhysicsClockTick());
    m_flyers->Advance(GetPhysicsClockTick(), 1);
  } else {
    m_drivers->Advance(tick);
    m_flyers->Advance(tick / GetSubsteps(), GetSubsteps());
  }
  if (GetVolume().HasWalls()) {
    HoldInsideWalls();
  }
  for (UInt32 i = 0; i < m_drivers->GetCount(); ++i) {
    const SPlanarPose pose = ToWorld(m_drivers->GetPose(i));
    CTurretEntity* const turret = m_drivers->GetOwner(i).m_turret;
    if (turret != nullptr) {
      turret->Advance(tick);
    }
    WriteBack(m_drivers->GetOwner(i), CVector3(pose.X, pose.Y, m_drivers->GetHeight(i)),
              pose.HalfCos, pose.HalfSin);
  }
  for (UInt32 i = 0; i < m_flyers->GetCount(); ++i) {
    const SFlightPose pose = m_flyers->GetPose(i);
    const Real yaw = pose.Yaw > ARGOS_PI ? pose.Yaw - 2.0 * ARGOS_PI : pose.Yaw;
    WriteBack(m_flyers->GetOwner(i), pose.Position + GetFrameOrigin(), std::cos(0.5 * yaw),
              std::sin(0.5 * yaw));
  }
  if (!m_userModels.empty()) {
    UpdateUserModels();
  }
  FinishRecordedBodies();
}

void CPointMass3DEngine::HoldInsideWalls() {
  const auto hold = [this](const CPointMass3DBody& body, CVector3& position, CVector3& velocity) {
    const SBodyDescription& description = *body.m_cEmbodiedEntity.GetBodyDescription();
    const SBoundingBox box = description.ComputeBoundingBox(CVector3(), CQuaternion());
    return GetVolume().HoldInside(position, velocity, description.ComputeBoundingRadius(),
                                  box.MaxCorner.GetZ());
  };
  for (UInt32 i = 0; i < m_drivers->GetCount(); ++i) {
    SPlanarPose pose = ToWorld(m_drivers->GetPose(i));
    CVector3 position(pose.X, pose.Y, m_drivers->GetHeight(i));
    CVector3 velocity;
    if (hold(m_drivers->GetOwner(i), position, velocity)) {
      pose.X = position.GetX();
      pose.Y = position.GetY();
      m_drivers->Place(i, ToFrame(pose), position.GetZ());
    }
  }
  for (UInt32 i = 0; i < m_flyers->GetCount(); ++i) {
    SFlightState state = m_flyers->GetState(i);
    CVector3 position = CVector3(state[0].Place, state[1].Place, state[2].Place) + GetFrameOrigin();
    CVector3 velocity(state[0].Speed, state[1].Speed, state[2].Speed);
    if (hold(m_flyers->GetOwner(i), position, velocity)) {
      for (UInt32 axis = 0; axis < 3; ++axis) {
        state[axis].Place = position[axis] - GetFrameOrigin()[axis];
        state[axis].Speed = velocity[axis];
      }
      m_flyers->SetState(i, state);
    }
  }
}

void CPointMass3DEngine::WriteBack(CPointMass3DBody& model, const CVector3& position, Real halfCos,
                                   Real halfSin) {
  CEmbodiedEntity& body = model.m_cEmbodiedEntity;
  body.SetOriginPose(position, CQuaternion(halfCos, 0.0, 0.0, halfSin));
  if (body.GetEnabledAnchors().size() > 1) {
    model.CalculateAnchors();
  }
  model.CalculateBoundingBox();
  if (body.HasFollowers()) {
    model.m_root.Update();
  }
  if (IsEntityTransferActive() && !IsPointContained(position)) {
    ScheduleEntityForTransfer(body);
  }
}

void CPointMass3DEngine::UpdateUserModels() {
  for (const SUserModel& user : m_userModels) {
    user.Model->UpdateFromEntityStatus();
    const UInt32 substeps = m_moveAsArgos3 ? 1 : GetIterations();
    for (UInt32 i = 0; i < substeps; ++i) {
      user.Model->Step();
    }
    user.Model->UpdateEntityStatus();
  }
}

void CPointMass3DEngine::AddPhysicsModel(const std::string& id, CPointMass3DModel& model) {
  m_userModels.push_back({id, std::unique_ptr<CPointMass3DModel>(&model)});
  CountBodiesOutsideIndex();
}

void CPointMass3DEngine::RemovePhysicsModel(const std::string& id) {
  const auto found = std::ranges::find(m_userModels, id, &SUserModel::Id);
  if (found == m_userModels.end()) {
    THROW_ARGOSEXCEPTION("the physics engine \"" << GetId() << "\" has no model of \"" << id
                                                 << "\"");
  }
  m_userModels.erase(found);
  CountBodiesOutsideIndex();
}

void CPointMass3DEngine::CountBodiesOutsideIndex() {
  m_numOutsideIndex = static_cast<size_t>(
      std::count_if(m_userModels.begin(), m_userModels.end(), [](const SUserModel& user) {
        return user.Model->GetEmbodiedEntity().GetBodyDescription() == nullptr;
      }));
}

void CPointMass3DEngine::CheckIntersectionWithRay(TEmbodiedEntityIntersectionData& data,
                                                  const CRay3& ray) const {
  for (const SUserModel& user : m_userModels) {
    Real tOnRay = 0.0;
    if (user.Model->CheckIntersectionWithRay(tOnRay, ray)) {
      data.emplace_back(&user.Model->GetEmbodiedEntity(), tOnRay);
    }
  }
}

bool CPointMass3DEngine::HasOverlap(const CPhysicsModel& model) const {
  const auto overlaps = [&model](const CPhysicsModel& other) {
    return &other != &model && model.GetBoundingBox().Intersects(other.GetBoundingBox());
  };
  return std::any_of(GetModels().begin(), GetModels().end(),
                     [&](const auto& body) { return overlaps(*body); }) ||
         std::any_of(m_userModels.begin(), m_userModels.end(),
                     [&](const SUserModel& user) { return overlaps(*user.Model); });
}

REGISTER_PHYSICS_ENGINE(
    CPointMass3DEngine, "pointmass3d", "the authors of this project", "1.0",
    "Point masses in space, for flying robots.",
    R"(Bodies pass through each other: there are no contacts, so this engine is for robots that fly, and for robots
that never meet obstacles.

A robot with propellers is a mass under gravity with controllers along x, y and z and about the vertical; only its
yaw is kept. It stays within the limits of the arena, whose borders stop it. A robot with a drive follows the exact arc
of its command, at the height where it was put. Objects, movable or not, stay where they are put; sensors see all of
them. Bodies are not placed where they would overlap others.
)" + RequiredEngineXML(R"(<pointmass3d id="pm3d" />)") +
        OptionalEngineXML("pointmass3d",
                          R"(id="pm3d" iterations="10" motion="exact" gravity="-9.81")",
                          std::string(), R"(        <top height="5" />
        <bottom height="0" />
)") + R"(
ATTRIBUTES

  id          text, required: unique among the engines.
  iterations  integer in [1,10000], default 10: least number of substeps of a tick; in each, the controllers of
              flying robots run once. There are more if one would be longer than 2/3 of the time constant of a
              robot's fastest controller: an eye-bot takes substeps of at most 1/30 s, so 3 in a tick of 0.1 s.
  motion      exact (default) or argos3: as in version 3.0.0-beta59 of ARGoS, to repeat its experiments. A tick is
              then one substep of the length of a tick divided by iterations, so that with the default of 10
              everything moves at a tenth of its speed; the loops on velocity and yaw rate are those of
              ARGoS, which oscillate up to the limits of thrust; and a robot at a border keeps its velocity.
  gravity     m/s^2, default -9.81: acceleration along z, negative is down.
  boundaries  the region of the engine, default everything: top@height and bottom@height, in m, and
              sides/vertex@point, in m, at least three, counter-clockwise, convex. A body that leaves it is
              transferred to the engine whose region it enters. top, bottom and each vertex, for the side from there
              to the next one, may have wall="true", which holds bodies inside, or gate="id", which transfers bodies
              that cross it to that engine (doc/space_partitioning.md).
)",
    "Usable")

}  // namespace argos
