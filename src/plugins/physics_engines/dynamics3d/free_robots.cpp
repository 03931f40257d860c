#include <argos3/plugins/simulator/physics_engines/dynamics3d/free_robots.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_ghosts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_grips.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// robots that a thread plans together
constexpr size_t kPlanGrain = 256;
// m, above the highest robot: bodies there do not matter
constexpr Real kHeadroom = 0.02;
// substeps by which claims reach beyond the path of the tick
constexpr Real kClaimedSubsteps = 2.0;

// a circle around a body, seen from above
struct SCircle {
  Real X, Y, Radius;  // m
};

SCircle Enclose(const SRigidBody& body) {
  if (body.IsFree) {
    return {body.Roll.Pose.X, body.Roll.Pose.Y, body.BoundingRadius};
  }
  const CVector3 sides = body.High - body.Low;
  return {0.5 * (body.Low.GetX() + body.High.GetX()), 0.5 * (body.Low.GetY() + body.High.GetY()),
          0.5 * std::hypot(sides.GetX(), sides.GetY())};
}

bool IsUpright(const CQuaternion& orientation) {
  return orientation.GetX() == 0.0 && orientation.GetY() == 0.0;
}

bool HasHull(const SBodyDescription& description) {
  return std::any_of(
      description.Shapes.begin(), description.Shapes.end(),
      [](const SShapeDescription& shape) { return shape.Kind == SShapeDescription::EKind::Hull; });
}

// how far from its origin a robot may seek a body to grip, m
Real GetSeekReach(const SRigidBody& robot) {
  const CVector3& offset = robot.Gripper->GetOffset();
  return std::hypot(offset.GetX(), offset.GetY()) + robot.Source.Description->Gripper->SensorRadius;
}

}  // namespace

CFreeRobots::CFreeRobots(const SRigidSettings& settings)
    : m_settings(settings), m_alone(0, std::make_unique<CBalanceQuantitySchedule>()) {
  m_filter.SetMargin(kFreeMargin);
}

void CFreeRobots::Reserve(size_t movables) {
  m_filter.Reserve(movables);
  m_plans.reserve(movables);
}

void CFreeRobots::SetGround(const std::optional<SRollGround>& ground) {
  m_ground = ground;
  m_haveFixedChanged = true;
}

void CFreeRobots::NoteRobot(const SRigidBody& robot) {
  const SBoundingBox box = robot.Source.Description->ComputeBoundingBox(CVector3(), CQuaternion());
  if (box.MaxCorner.GetZ() > m_height) {
    m_height = box.MaxCorner.GetZ();
    m_haveFixedChanged = true;
  }
}

bool CFreeRobots::MayStartFree(const SRigidSource& source, const SRigidPose& pose) const {
  return m_ground && source.Movable && source.Drive && source.Shared != nullptr &&
         IsUpright(pose.Orientation) &&
         std::abs(pose.Position.GetZ() - m_ground->Height) <= kFreeHeight;
}

bool CFreeRobots::IsSeeking(const SRigidBody& body) const {
  return body.Gripper != nullptr && body.Gripper->IsLocked() &&
         body.Source.Description->Gripper.has_value();
}

bool CFreeRobots::IsAtHeight(Real low, Real high) const {
  return low <= m_ground->Height + m_height + kHeadroom && high >= m_ground->Height - kFreeSlack;
}

// Anything that robots at rest on the floor may touch, or that is below their wheels.
void CFreeRobots::ListObstacles(const std::vector<SRigidBody*>& fixed) {
  std::vector<SFootprint> obstacles;
  for (const SRigidBody* body : fixed) {
    if (!IsAtHeight(body->Low.GetZ(), body->High.GetZ())) {
      continue;
    }
    if (IsUpright(body->Fixed.Orientation) && !HasHull(*body->Source.Description)) {
      AppendFootprints(*body->Source.Description,
                       MakePlanarPose(body->Fixed.Position, body->Fixed.Orientation), obstacles);
      continue;
    }
    const CVector3 sides = body->High - body->Low;
    const SCircle circle = Enclose(*body);
    obstacles.push_back(
        {circle.X, circle.Y, 1.0, 0.0, 0.5 * sides.GetX(), 0.5 * sides.GetY(), 0.0});
  }
  m_filter.SetObstacles(obstacles);
}

CFreeRobots::SPlan CFreeRobots::MakePlan(const SRigidBody& robot, Real tick) const {
  SPlan plan;
  const SDriveCommand command = robot.Source.Drive.Read();
  if (!command.IsFinite()) {
    throw SBadDriveCommand{&robot.Source.Owner->GetEmbodiedEntity(), robot.Source.Drive};
  }
  if (!m_ground || robot.Source.Shared == nullptr || IsSeeking(robot) ||
      (!robot.IsFree && robot.IsGripped)) {
    return plan;
  }
  plan.State = robot.IsFree ? robot.Roll : ReadRollState(robot);
  const SDriveCommand& motion = plan.State.Motion;
  plan.Path = std::max(command.ComputeSpeed(), motion.ComputeSpeed()) * tick;
  plan.MayRoll = HoldsArc(robot, command, *m_ground) && HoldsArc(robot, motion, *m_ground) &&
                 (robot.IsFree || RollsFreely(robot, plan.State, *m_ground));
  return plan;
}

void CFreeRobots::StartTick(const SBodies& bodies, Real fastest, Real tick, CThreadPool* pool) {
  for (SRigidBody* body : bodies.Active) {
    body->IsGripped = body->TurretBody != nullptr;
  }
  bodies.Grips.ForEachGrip(
      [](SRigidBody& holder, SRigidBody& held) { holder.IsGripped = held.IsGripped = true; });
  const std::vector<SRigidBody*>& movables = bodies.Movables;
  m_plans.resize(movables.size());
  const auto plan = [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      m_plans[i] = movables[i]->HasDrive() ? MakePlan(*movables[i], tick) : SPlan();
    }
  };
  if (pool != nullptr) {
    pool->ParallelFor(movables.size(), kPlanGrain, plan);
  } else {
    plan(0, movables.size(), 0);
  }
  if (!m_ground) {
    return;
  }
  if (m_haveFixedChanged) {
    ListObstacles(bodies.Fixed);
    m_haveFixedChanged = false;
  }
  m_reach = fastest * tick;
  for (const SPlan& each : m_plans) {
    m_reach = std::max(m_reach, each.Path);
  }
  m_reach = (1.0 + kClaimedSubsteps / m_settings.Substeps) * m_reach + kFreeSlack;
  m_filter.Clear(movables.size());
  for (UInt32 i = 0; i < movables.size(); ++i) {
    if (m_plans[i].MayRoll) {
      const SRigidBody& robot = *movables[i];
      const SPlanarPose& pose = m_plans[i].State.Pose;
      m_filter.Place(
          i, pose.X, pose.Y,
          robot.BoundingRadius + (robot.IsFree ? m_plans[i].Path + kFreeSlack : m_reach));
    }
  }
  m_filter.MarkAll(pool != nullptr ? *pool : m_alone);
  MarkOthers(bodies);
}

// Marks the robots near bodies that cannot be free.
void CFreeRobots::MarkOthers(const SBodies& bodies) {
  const Real path = m_reach;
  const auto mark = [this, path](const SRigidBody& body) {
    const SCircle circle = Enclose(body);
    const Real own = IsSeeking(body) ? std::max(circle.Radius, GetSeekReach(body)) : circle.Radius;
    // objects may be turned, or squeezed out
    const Real most = body.HasDrive() ? path : kTurningReach * path;
    m_filter.MarkNear(circle.X, circle.Y, own + most);
  };
  for (UInt32 i = 0; i < bodies.Movables.size(); ++i) {
    const SRigidBody& body = *bodies.Movables[i];
    if (m_plans[i].MayRoll) {
      continue;
    }
    if (body.IsFree || IsAtHeight(body.Low.GetZ() - path, body.High.GetZ() + path)) {
      mark(body);
    }
  }
  for (const SGhostCylinder& ghost : bodies.Ghosts) {
    if (IsAtHeight(ghost.Low - path, ghost.High + path)) {
      m_filter.MarkNear(ghost.X, ghost.Y, ghost.Radius + path);
    }
  }
}

bool CFreeRobots::MustActivate(const SRigidBody& robot) const {
  return !m_ground || !m_plans[robot.Number].MayRoll ||
         m_filter.GetMark(robot.Number) == CProximityFilter::Active;
}

bool CFreeRobots::MayFree(SRigidBody& robot) const {
  if (!m_ground || !m_plans[robot.Number].MayRoll ||
      m_filter.GetMark(robot.Number) != CProximityFilter::Free) {
    return false;
  }
  robot.Roll = m_plans[robot.Number].State;
  return true;
}

void CFreeRobots::Claim(SRigidBody& body) const {
  const CVector3 around(m_reach, m_reach, m_reach);
  body.ClaimLow = body.Low - around;
  body.ClaimHigh = body.High + around;
}

bool CFreeRobots::ExtendClaim(SRigidBody& body, Real substep, Real rest, std::vector<UInt32>& met) {
  // bounds are those at the start of the substep
  const Real speed = FromODE(dBodyGetLinearVel(body.Body)).Length();
  const Real next = kClaimedSubsteps * speed * substep;
  bool stays = true;
  for (UInt32 axis = 0; axis < 3; ++axis) {
    stays = stays && body.Low[axis] - next >= body.ClaimLow[axis] &&
            body.High[axis] + next <= body.ClaimHigh[axis];
  }
  if (stays) {
    return false;
  }
  const Real path = speed * rest + next + kFreeSlack;
  const CVector3 around(path, path, path);
  body.ClaimLow = body.Low - around;
  body.ClaimHigh = body.High + around;
  if (!IsAtHeight(body.ClaimLow.GetZ(), body.ClaimHigh.GetZ())) {
    return false;
  }
  const SCircle circle = Enclose(body);
  m_filter.MarkNear(circle.X, circle.Y, circle.Radius + path, &met);
  return true;
}

}  // namespace argos
