// The borders of a dynamics3d engine: walls, ghosts, and transfers to other engines.

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/entity/robots_code.h>
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

// m, greatest penetration of a body at rest on the bottom of a region
constexpr Real kSunk = 1e-3;
// m, greatest distance behind a wall of the origin of a body that leans on it or hits it
constexpr Real kInWall = 0.05;
// m, rad: bodies within these limits of height and lean may enter a 2D engine. Robots that avoid
// each other cross at most 1.1 mm high, leaning by 1.3 degrees; robots that push each other lean by
// up to 11 degrees.
constexpr Real kStepOntoPlane = 0.01;
constexpr Real kLeanOntoPlane = 10.0 / 180.0 * ARGOS_PI;

// the height of the plane of a 2D engine, m
std::optional<Real> FindPlane(const CPhysicsEngine& engine) {
  const auto [low, high] = engine.GetHeightSpan();
  return low == high ? std::optional<Real>(low) : std::nullopt;
}

}  // namespace

// Bodies at rest on the bottom of the region penetrate it slightly.
bool CDynamics3DEngine::IsPointContained(const CVector3& point) {
  return CPhysicsEngine::IsPointContained(point) ||
         CPhysicsEngine::IsPointContained(point + CVector3(0.0, 0.0, kSunk));
}

// The origin of a body that lies on its side may be at a wall.
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
    m_world->AddWall(*wall.Description, {wall.Position - GetFrameOrigin(), wall.Orientation});
  }
}

Real CDynamics3DEngine::GetGhostReach() const {
  return m_world != nullptr ? m_world->ComputeGhostReach() : CPhysicsEngine::GetGhostReach();
}

// Robots behind the border, on wheels or propellers. Passive objects are left out: they must give
// way when pushed, and a ghost cannot.
void CDynamics3DEngine::UpdateGhosts() {
  m_ghostCylinders.clear();
  for (const SGhost& ghost : GetGhosts()) {
    const SBodyDescription& description = *ghost.Body->GetBodyDescription();
    if (description.HasDrive() || description.Propellers) {
      m_ghostCylinders.push_back(
          EncloseRobot(description, {ghost.Position - GetFrameOrigin(), ghost.Orientation}));
    }
  }
  m_world->SetGhosts(m_ghostCylinders);
}

// Bodies keep their full state of motion.
void CDynamics3DEngine::Adopt(CDescribedBodyModel& model) {
  auto& adopted = static_cast<CDynamics3DModel&>(model);
  const SRigidMotion motion =
      adopted.m_body != nullptr ? GetRigidMotion(adopted.GetBody()) : SRigidMotion();
  CDescribedBodyEngine::Adopt(model);
  if (adopted.m_body != nullptr) {
    PlaceAtAnchor(adopted, motion);
  }
}

// Onto a plane may go only what stands upright on it.
bool CDynamics3DEngine::MayMoveTo(const CPhysicsEngine& next,
                                  const CDescribedBodyModel& model) const {
  const std::optional<Real> plane = FindPlane(next);
  const SRigidPose pose = PoseOf(static_cast<const CDynamics3DModel&>(model).m_cEmbodiedEntity);
  return !plane || (std::abs(pose.Position.GetZ() - *plane) <= kStepOntoPlane &&
                    ComputeLean(pose.Orientation) <= kLeanOntoPlane);
}

void CDynamics3DEngine::PrepareFor(const CPhysicsEngine& next, CDescribedBodyModel& leaving) {
  if (const std::optional<Real> plane = FindPlane(next)) {
    auto& model = static_cast<CDynamics3DModel&>(leaving);
    CEmbodiedEntity& body = model.m_cEmbodiedEntity;
    const SRigidPose pose = PoseOf(body);
    body.SetOriginPose(CVector3(pose.Position.GetX(), pose.Position.GetY(), *plane),
                       SetUpright(pose.Orientation));
    model.CalculateBoundingBox();
    model.CalculateAnchors();
  }
}

// @return whether the body may leave; false if only its height or its lean prevents the transfer.
bool CDynamics3DEngine::PrepareTransfer(CDescribedBodyModel& leaving) {
  auto& model = static_cast<CDynamics3DModel&>(leaving);
  const SBodyDescription& description = *model.m_cEmbodiedEntity.GetBodyDescription();
  const CPhysicsEngine* refuses = nullptr;
  const auto accepts = [&](const CPhysicsEngine& next) {
    if (&next == this ||
        (FindPlane(next) && (description.Propellers || description.Articulation))) {
      return false;
    }
    if (!MayMoveTo(next, model)) {
      refuses = refuses == nullptr ? &next : refuses;
      return false;
    }
    return true;
  };
  if (const CPhysicsEngine* const next = FindNextEngine(model.m_cEmbodiedEntity, accepts)) {
    PrepareFor(*next, model);
    return true;
  }
  if (refuses != nullptr) {
    WarnStranded(model, *refuses);
  }
  return refuses == nullptr;
}

void CDynamics3DEngine::WarnStranded(const CDynamics3DModel& model, const CPhysicsEngine& plane) {
  if (m_hasWarnedStranded) {
    return;
  }
  m_hasWarnedStranded = true;
  const SRigidPose pose = PoseOf(model.m_cEmbodiedEntity);
  LOGERR << "[WARNING] " << NameOf(model.m_cEmbodiedEntity) << " has left the region of \""
         << GetId() << "\" at (" << pose.Position << "), leaning by "
         << ComputeLean(pose.Orientation) / ARGOS_PI * 180.0 << " degrees, but the plane of \""
         << plane.GetId() << "\" accepts only bodies within " << kStepOntoPlane
         << " m of z = " << *FindPlane(plane) << " m that lean by less than "
         << kLeanOntoPlane / ARGOS_PI * 180.0 << " degrees: it stays in \"" << GetId()
         << "\" until it meets both. Put borders with 2D engines on level ground (reported once)"
         << std::endl;
}

bool CDynamics3DEngine::GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const {
  const auto* const model = static_cast<const CDynamics3DModel*>(FindModel(body));
  if (model == nullptr || model->m_body == nullptr) {
    return false;
  }
  const SRigidMotion rigid = GetRigidMotion(model->GetBody());
  // of the centre of mass; upright bodies rotate about the vertical axis through it and the origin
  motion.Velocity = rigid.Velocity;
  motion.Rotation = rigid.AngularVelocity;
  return true;
}

void CDynamics3DEngine::SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) {
  CRobotsCode::CheckShared("CPhysicsEngine::SetMotion()");
  auto* const model = static_cast<CDynamics3DModel*>(FindModel(body));
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

CDynamics3DModel& CDynamics3DEngine::GetModel(const CEmbodiedEntity& body) const {
  return static_cast<CDynamics3DModel&>(*FindModel(body));
}

void CDynamics3DEngine::FindCluster(CEmbodiedEntity& body, TBodies& cluster) const {
  if (m_world != nullptr) {
    m_world->GetGrips().FindCluster(body, cluster);
  } else {
    CDescribedBodyEngine::FindCluster(body, cluster);
  }
}

void CDynamics3DEngine::CopyGrips(const TBodies& cluster, std::vector<SGripTransfer>& grips) const {
  grips.clear();
  if (m_world != nullptr) {
    m_world->GetGrips().CopyGrips(cluster, grips);
  }
}

void CDynamics3DEngine::RestoreGrip(const SGripTransfer& grip) {
  if (m_world != nullptr) {
    m_world->GetGrips().Grip(GetModel(*grip.Holder).GetBody(), GetModel(*grip.Held).GetBody(),
                             grip.Arm);
  }
}

}  // namespace argos
