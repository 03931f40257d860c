// What an engine of rigid bodies does at the border of its region.

#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/engine_poses.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/ode_session.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_world.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace argos {

namespace {

// m: what rests on the bottom of a region has sunk in by less
constexpr Real kSunk = 1e-3;
// m: origins of what leans on a wall, or hits it, are behind it by less
constexpr Real kInWall = 0.05;
// m, rad: what stands that near to the height of a plane, and leans by no more, may enter it.
// Robots that avoid each other cross up to 1.1 mm high and lean by 1.3 degrees, those that push
// each other by 11 degrees.
constexpr Real kStepOntoPlane = 0.01;
constexpr Real kLeanOntoPlane = 10.0 / 180.0 * ARGOS_PI;

// the height of an engine in which bodies stand on a plane, m
std::optional<Real> FindPlane(const CPhysicsEngine& engine) {
  const auto [low, high] = engine.GetHeightSpan();
  return low == high ? std::optional<Real>(low) : std::nullopt;
}

}  // namespace

// What rests on the bottom of the region has sunk in a little.
bool CDynamics3DEngine::IsPointContained(const CVector3& point) {
  return CPhysicsEngine::IsPointContained(point) ||
         CPhysicsEngine::IsPointContained(point + CVector3(0.0, 0.0, kSunk));
}

// The origin of what lies may be at a wall.
bool CDynamics3DEngine::HasLeft(const CVector3& point) {
  if (IsPointContained(point)) {
    return false;
  }
  const SFace* const exit = GetVolume().FindExit(point);
  return exit == nullptr || !exit->IsWall || GetVolume().ComputeDistance(point) > kInWall;
}

// faces of the region that are walls
void CDynamics3DEngine::BuildWalls() {
  const SHorizontalFace* const bottom = GetVolume().BottomFace;
  // a floor of that height, or above, is enough
  const bool isFloor =
      std::any_of(m_planes.begin(), m_planes.end(), [bottom](const SGroundPlane& plane) {
        return bottom != nullptr && plane.Height >= bottom->Height;
      });
  if (bottom != nullptr && bottom->IsWall && !isFloor) {
    m_world->AddPlane({bottom->Height, m_settings->Friction});
  }
  const SHorizontalFace* const top = GetVolume().TopFace;
  if (top != nullptr && top->IsWall) {
    m_world->AddCeiling({top->Height, m_settings->Friction});
  }
  m_walls = GetVolume().DescribeWalls();
  for (const SWallSlab& wall : m_walls) {
    m_world->AddWall(*wall.Description, {wall.Position, wall.Orientation});
  }
}

Real CDynamics3DEngine::GetGhostReach() const {
  return m_world != nullptr ? m_world->ComputeGhostReach() : CPhysicsEngine::GetGhostReach();
}

// Robots behind the border, on wheels or propellers. Things are left out: a ghost cannot be pushed,
// and they are to be.
void CDynamics3DEngine::TakeGhosts() {
  m_ghostCylinders.clear();
  for (const SGhost& ghost : GetGhosts()) {
    const SBodyDescription& description = *ghost.Body->GetBodyDescription();
    if (description.Drive || description.Propellers) {
      m_ghostCylinders.push_back(EncloseRobot(description, {ghost.Position, ghost.Orientation}));
    }
  }
  m_world->SetGhosts(m_ghostCylinders);
}

void CDynamics3DEngine::TransferEntity(CEmbodiedEntity& body) {
  auto* const model = dynamic_cast<CDynamics3DModel*>(&body.GetPhysicsModel(size_t(0)));
  if (model == nullptr || &model->GetEngine() != this || !PrepareExit(*model)) {
    return;
  }
  const SRigidMotion motion =
      model->m_body != nullptr ? GetRigidMotion(*model->m_body) : SRigidMotion();
  CDynamics3DEngine* const next = FindNext(body);
  if (next != nullptr && next->m_world != nullptr && m_world != nullptr &&
      m_world->GetGrips().IsInGrip(*model->m_body)) {
    TransferCluster(*model, *next);
    return;
  }
  CPhysicsEngine::TransferEntity(body);
  auto* const moved = dynamic_cast<CDynamics3DModel*>(&body.GetPhysicsModel(size_t(0)));
  if (moved != nullptr && moved->m_body != nullptr) {
    moved->GetDynamics3DEngine().PlaceAtAnchor(*moved, motion);
  }
}

// Sets down on the plane what goes to an engine that has only that.
// @return whether it may go; if not, only the way it stands is against it.
bool CDynamics3DEngine::PrepareExit(CDynamics3DModel& model) {
  CEmbodiedEntity& body = model.m_cEmbodiedEntity;
  const SRigidPose pose = PoseOf(body);
  const CPhysicsEngine* refuses = nullptr;
  CPhysicsEngine* const behindGate = FindEngineBehindGate(body);
  // in the order in which the space offers it to them
  const auto isTakenBy = [&](CPhysicsEngine* next) {
    if (next == nullptr || next == this || !next->IsPointContained(pose.Position)) {
      return false;
    }
    const std::optional<Real> plane = FindPlane(*next);
    if (!plane) {
      return true;
    }
    if (body.GetBodyDescription()->Propellers) {
      return false;
    }
    if (std::abs(pose.Position.GetZ() - *plane) > kStepOntoPlane ||
        ComputeLean(pose.Orientation) > kLeanOntoPlane) {
      refuses = refuses == nullptr ? next : refuses;
      return false;
    }
    body.SetOriginPose(CVector3(pose.Position.GetX(), pose.Position.GetY(), *plane),
                       SetUpright(pose.Orientation));
    model.CalculateBoundingBox();
    model.CalculateAnchors();
    return true;
  };
  const CPhysicsEngine::TVector& engines = m_cSimulator.GetPhysicsEngines();
  if (isTakenBy(behindGate) || std::any_of(engines.begin(), engines.end(), isTakenBy) ||
      refuses == nullptr) {
    return true;
  }
  TellOfStranded(model, *refuses);
  return false;
}

void CDynamics3DEngine::TellOfStranded(const CDynamics3DModel& model, const CPhysicsEngine& plane) {
  if (m_hasToldOfStranded) {
    return;
  }
  m_hasToldOfStranded = true;
  const SRigidPose pose = PoseOf(model.m_cEmbodiedEntity);
  LOGERR << "[WARNING] " << NameOf(model.m_cEmbodiedEntity) << " has left the region of \""
         << GetId() << "\" at (" << pose.Position << "), leaning by "
         << ComputeLean(pose.Orientation) / ARGOS_PI * 180.0 << " degrees, but the plane of \""
         << plane.GetId() << "\" takes only what stands within " << kStepOntoPlane
         << " m of z = " << *FindPlane(plane) << " m and leans by less than "
         << kLeanOntoPlane / ARGOS_PI * 180.0 << " degrees: it stays in \"" << GetId()
         << "\" until it does. Put borders with planes on level ground (told once)" << std::endl;
}

bool CDynamics3DEngine::GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const {
  const auto* const model = dynamic_cast<const CDynamics3DModel*>(&body.GetPhysicsModel(size_t(0)));
  if (model == nullptr || model->m_body == nullptr) {
    return false;
  }
  const SRigidMotion rigid = GetRigidMotion(*model->m_body);
  // of the centre of mass; bodies that stand turn about the vertical, on which the origin is, too
  motion = {rigid.Velocity, rigid.AngularVelocity};
  return true;
}

void CDynamics3DEngine::SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) {
  auto* const model = dynamic_cast<CDynamics3DModel*>(&body.GetPhysicsModel(size_t(0)));
  if (model == nullptr || model->m_body == nullptr) {
    return;
  }
  SRigidMotion rigid;
  rigid.Velocity = motion.Velocity;
  rigid.AngularVelocity = motion.Rotation;
  if (const auto& drive = body.GetBodyDescription()->Drive) {
    CVector3 ahead = CVector3::X;
    ahead.Rotate(body.GetOriginAnchor().Orientation);
    const Real speed = motion.Velocity.DotProduct(ahead);
    const Real turn = 0.5 * drive->InterwheelDistance * motion.Rotation.GetZ();
    rigid.WheelSpins = {(speed - turn) / drive->WheelRadius, (speed + turn) / drive->WheelRadius};
  }
  UseODEInThisThread();
  PlaceAtAnchor(*model, rigid);
}

// the engine that would take the body, if it is another one of this type
CDynamics3DEngine* CDynamics3DEngine::FindNext(const CEmbodiedEntity& body) const {
  auto* const next = dynamic_cast<CDynamics3DEngine*>(FindNextEngine(body));
  return next != this ? next : nullptr;
}

// Of all that hangs together with a body in grips, does it have the lowest index?
bool CDynamics3DEngine::LeadsItsCluster(const CDynamics3DModel& model) {
  m_world->GetGrips().FindCluster(*model.m_body, m_cluster);
  return std::none_of(m_cluster.begin(), m_cluster.end(), [&model](const SRigidBody* each) {
    return each->Source.Owner->GetEmbodiedEntity().GetIndex() < model.m_cEmbodiedEntity.GetIndex();
  });
}

void CDynamics3DEngine::TransferCluster(const CDynamics3DModel& model, CDynamics3DEngine& next) {
  struct SMember {
    CEmbodiedEntity* Body;
    SRigidMotion Motion;
  };
  struct SGrip {
    CEmbodiedEntity* Holder;
    CEmbodiedEntity* Held;
    CVector3 Arm;
  };
  m_world->GetGrips().FindCluster(*model.m_body, m_cluster);
  m_world->GetGrips().CopyGrips(m_cluster, m_grips);
  std::vector<SMember> members;
  std::vector<SGrip> grips;
  for (const SRigidBody* each : m_cluster) {
    members.push_back({&each->Source.Owner->GetEmbodiedEntity(), GetRigidMotion(*each)});
  }
  for (const SRigidGripToMove& grip : m_grips) {
    grips.push_back({&grip.Holder->GetEmbodiedEntity(), &grip.Held->GetEmbodiedEntity(), grip.Arm});
  }
  const auto modelOf = [](CEmbodiedEntity& body) -> CDynamics3DModel& {
    return static_cast<CDynamics3DModel&>(body.GetPhysicsModel(size_t(0)));
  };
  for (const SMember& member : members) {
    RemoveEntity(member.Body->GetRootEntity());
    next.AddEntity(member.Body->GetRootEntity());
    next.PlaceAtAnchor(modelOf(*member.Body), member.Motion);
  }
  for (const SGrip& grip : grips) {
    next.m_world->GetGrips().Grip(*modelOf(*grip.Holder).m_body, *modelOf(*grip.Held).m_body,
                                  grip.Arm);
  }
}

}  // namespace argos
