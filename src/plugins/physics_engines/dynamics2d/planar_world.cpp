#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/memory/load_ahead.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/drive_motion.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_components.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// robots that a thread plans in a run
constexpr size_t kPlanGrain = 512;
// robots between prefetching and reading what is elsewhere in memory
constexpr size_t kPlanAhead = 8;

}  // namespace

CPlanarWorld::CPlanarWorld(const SPlanarSettings& settings)
    : m_store(settings),
      m_active(m_store),
      m_grips(m_store, m_active),
      m_ghosts(m_store, m_active),
      m_substepPolicy(settings),
      m_crowd(m_store) {
  m_discPairs.SetPeriod(settings.Period);
}

void CPlanarWorld::AddDriven(const SPlanarOwner& owner, const SBodyDescription& description,
                             const SPlanarPose& pose, const CDriveSource& drive) {
  m_store.AddDriven(owner, description, pose, drive);
  m_crowd.ExpectOverlaps();
}

void CPlanarWorld::Remove(const SPlanarHandle& handle) {
  m_grips.Remove(handle);
  const UInt32 slot = handle.Slot;
  if (handle.Kind != EPlanarKind::Driven) {
    m_store.Remove(handle);
    m_crowd.ForgetSolids();
    return;
  }
  if (m_store.GetDriven(handle).IsActive()) {
    m_active.Deactivate(slot);
  }
  m_crowd.Forget(slot);
  m_crowd.Forget(static_cast<UInt32>(m_store.GetDriven().size() - 1));
  m_store.Remove(handle);
  m_active.UpdateSlot(slot);
}

// Box2D allocates bodies, contacts and joints in blocks that it keeps. Creating as many as a swarm
// of this size is likely to need, and destroying them, leaves the blocks for the ticks; so do the
// vectors here.
void CPlanarWorld::ReserveForTick() {
  constexpr size_t kClusterSize = 4;  // discs, of which each touches each
  // Where there are no grippers, Box2D gets no robot. Else memory for an eighth of them is
  // allocated here; more robots allocate more in a tick.
  const bool mayBeActive = m_grips.HasManipulators();
  const size_t numActive = mayBeActive ? m_store.GetDriven().size() / 8 + 64 : 0;
  const size_t numDiscs = numActive / kClusterSize * kClusterSize;

  b2World& world = m_store.GetWorld();
  b2AABB everything;
  everything.lowerBound.SetZero();
  everything.upperBound.SetZero();
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr;
         fixture = fixture->GetNext()) {
      if (!body->IsEnabled()) {
        continue;
      }
      everything.Combine(fixture->GetAABB(0));
    }
  }
  b2CircleShape disc;
  disc.m_radius = 1.0F;
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  std::vector<b2Body*> spares;
  for (size_t i = 0; i < numDiscs; ++i) {
    // outside of all bodies, and each cluster apart from the others
    const size_t numClustersBefore = i / kClusterSize;
    const auto cluster = static_cast<float>(numClustersBefore);
    definition.position.Set(everything.upperBound.x + 10.0F,
                            everything.lowerBound.y + 10.0F * cluster);
    b2Body* spare = world.CreateBody(&definition);
    spare->CreateFixture(&disc, 1.0F);
    b2MotorJointDef motor;
    motor.bodyA = &m_store.GetGround();
    motor.bodyB = spare;
    world.CreateJoint(&motor);
    spares.push_back(spare);
  }
  m_grips.CreateSpares(spares);
  world.Step(0.0F, 0, 0);  // finds contacts, moves nothing
  for (b2Body* spare : spares) {
    world.DestroyBody(spare);
  }
  m_overlaps.Reserve(2 * (numActive + m_store.GetPassive().capacity()) +
                     m_store.GetImmovable().size());
  m_active.Reserve(numActive, m_store.GetDriven().capacity());
  m_ties.Reserve(numActive);
  m_store.ReserveNumbers(numActive);
  m_ghosts.Reserve(m_store.GetGrippable().capacity());
  m_discPairs.Reserve(m_store.GetDriven().capacity());
  const size_t solids = m_store.GetPassive().capacity() + m_store.GetDrivenSolids().size();
  m_crowd.Reserve(m_store.GetDriven().capacity(), m_store.HasSolids() ? solids : 0);
  m_longestOfRun.reserve(m_store.GetDriven().capacity() / kPlanGrain + 1);
}

// the slack of the proximity filter, m
Real CPlanarWorld::GetSlack() const {
  return kProximitySlack * m_store.GetMetresPerUnit();
}

Real CPlanarWorld::ComputeGhostReach() const {
  // a robot and the robot that approaches it may both move by the longest path
  return m_store.GetWidestMovable() +
         (2.0 + kGuardMargin) * kProximitySlack * m_store.GetMetresPerUnit() +
         std::max(2.0 * m_longestPath, kStartSpeed * GetTick());
}

void CPlanarWorld::Advance(CThreadPool& pool) {
  for (SPassiveBody& body : m_store.GetPassive()) {
    body.Moved = false;
  }
  m_grips.StartTick();
  PlanDriven(pool);
  FindMeetings(pool);
  m_active.Select(m_discPairs, m_crowd);
  m_grips.MakeGrips();
  m_ghosts.Place(m_discPairs, m_crowd, GetReach(), m_longestPath);
  m_crowd.Advance(pool, m_discPairs, m_longestPath, GetReach());
  UInt32 substeps = 1;
  if (IsAnyAwake()) {
    m_active.StartTick();
    if (m_grips.IsHoldingAny()) {
      m_ties.Settle(m_store, m_active, m_grips);
    }
    substeps = ChooseSubsteps();
    StepBox2D(substeps);
    m_active.FinishTick(substeps);
  }
  m_grips.FinishTick(static_cast<float>(GetTick() / substeps));
  m_ghosts.Remove();
  FinishPassive();
}

// Computes the state of each robot at the end of the tick if nothing is in its way.
void CPlanarWorld::PlanDriven(CThreadPool& pool) {
  const size_t count = m_store.GetDriven().size();
  m_discPairs.Start(count);
  m_longestOfRun.assign((count + kPlanGrain - 1) / kPlanGrain, 0.0);
  pool.ParallelFor(m_longestOfRun.size(), 1, [&](size_t begin, size_t end, UInt32) {
    for (size_t run = begin; run < end; ++run) {
      m_longestOfRun[run] = PlanRun(run * kPlanGrain, std::min(count, (run + 1) * kPlanGrain));
    }
  });
  m_longestPath = 0.0;
  for (const Real longest : m_longestOfRun) {
    m_longestPath = std::max(m_longestPath, longest);
  }
}

// @return the longest path of robots [begin, end), m.
Real CPlanarWorld::PlanRun(size_t begin, size_t end) {
  std::vector<SDrivenBody>& driven = m_store.GetDriven();
  Real longest = 0.0;
  for (size_t slot = begin; slot < end; ++slot) {
    if (slot + kPlanAhead < driven.size() && driven[slot + kPlanAhead].Drive.HasWheels()) {
      LoadAhead(driven[slot + kPlanAhead].Drive.GetWheels(), 2 * sizeof(Real));
    }
    longest = std::max(longest, Plan(driven[slot], static_cast<UInt32>(slot)));
  }
  return longest;
}

// @return the length of the path, or of that at the present speed if it is longer, m.
Real CPlanarWorld::Plan(SDrivenBody& body, UInt32 slot) {
  const Real tick = GetTick();
  const Real lag = m_store.GetSettings().VelocityLag;
  body.NextCommand = ReadCommand(body, tick);
  body.IsLimited = false;
  SDriveCommand command = body.NextCommand;
  SDriveCommand last = body.Command;

  // the torque bounds the change of the yaw rate, the force that of the velocity
  Real yawRate = command.YawRate + lag * (last.YawRate - command.YawRate);  // in the mean
  if (std::abs(yawRate - body.Velocity.W) > body.Kind->MaxYawRateChange) {
    yawRate =
        body.Velocity.W + std::copysign(body.Kind->MaxYawRateChange, yawRate - body.Velocity.W);
    command.YawRate = last.YawRate = yawRate;
    body.IsLimited = true;
  }
  const SArc arc = FollowArcs(body.Pose, last, command, tick, lag);
  Real velocityX = arc.DX / tick;
  Real velocityY = arc.DY / tick;
  Real path = (lag * last.ComputeSpeed() + (1.0 - lag) * command.ComputeSpeed()) * tick;
  body.NextPose = arc.End;
  const Real changeX = velocityX - body.Velocity.X;
  const Real changeY = velocityY - body.Velocity.Y;
  const Real squaredChange = changeX * changeX + changeY * changeY;
  if (squaredChange > body.Kind->MaxSpeedChange * body.Kind->MaxSpeedChange) {
    const Real share = body.Kind->MaxSpeedChange / std::sqrt(squaredChange);
    velocityX = body.Velocity.X + share * changeX;
    velocityY = body.Velocity.Y + share * changeY;
    path = std::sqrt(velocityX * velocityX + velocityY * velocityY) * tick;
    body.NextPose.X = body.Pose.X + velocityX * tick;
    body.NextPose.Y = body.Pose.Y + velocityY * tick;
    body.IsLimited = true;
  }
  body.NextVelocity = {velocityX, velocityY, yawRate};

  if (body.IsDisc) {
    m_discPairs.Place(slot, body.Pose.X, body.Pose.Y, body.BoundingRadius);
  } else {
    m_discPairs.LeaveOut(slot);
  }
  const Real speed =
      std::sqrt(body.Velocity.X * body.Velocity.X + body.Velocity.Y * body.Velocity.Y);
  return std::max(path, speed * tick);
}

// Finds the bodies that may touch something. Those that are connected with a grip, or with what a
// gripper may grip, are left to Box2D.
void CPlanarWorld::FindMeetings(CThreadPool& pool) {
  if (m_store.HaveObstaclesChanged()) {
    m_discPairs.SetObstacles(m_store.ListObstacles());
    m_crowd.ForgetObstacles();
  }
  ExtendLongestPath();
  if (m_store.GetSettings().Period.IsOn()) {
    CheckPeriod();
  }
  m_discPairs.Find(pool, GetReach());
  m_crowd.Start(m_discPairs, GetReach());
  if (m_grips.HasManipulators()) {
    ExcludeGrips();
  }
}

// Two bodies can meet on one side only, and an image of an obstacle is where a body may meet it.
void CPlanarWorld::CheckPeriod() const {
  const SPeriodicity& period = m_store.GetSettings().Period;
  const Real necessary = 4.0 * (m_store.GetWidestMovable() + kSolidReach * GetReach());
  for (const SPeriodicAxis* axis : {&period.X, &period.Y}) {
    if (axis->IsOn() && !(axis->Period > necessary)) {
      THROW_ARGOSEXCEPTION(
          "a periodic arena must be wider than four times what a body and its "
          "path in a tick need, "
          << necessary << " m here; found " << axis->Period << " m");
    }
  }
}

void CPlanarWorld::ExcludeGrips() {
  for (const SActiveBody& active : m_active.GetBodies()) {
    const SDrivenBody& body = m_active.GetRobot(active);
    if (body.NumGrips > 0) {
      ExcludeNear(body.Pose, 0.0);
    }
  }
  for (const SPassiveBody& body : m_store.GetPassive()) {
    if (body.NumGrips > 0) {
      ExcludeNear(body.Pose, 0.0);
    }
  }
  // a robot whose gripper seeks a body reaches as far as the gripper
  m_grips.ForEachSeeking([&](UInt32 slot, Real seek) {
    const SDrivenBody& body = m_store.GetDriven(slot);
    ExcludeNear(body.Pose, body.BoundingRadius + GetReach() + seek);
  });
}

// Excludes all bodies in a circle that may be nearer than its radius. A robot that has a body in
// Box2D keeps it a little longer.
void CPlanarWorld::ExcludeNear(const SPlanarPose& pose, Real radius) {
  const Real margin = kGuardMargin * m_store.GetMetresPerUnit();
  m_discPairs.ForNear(pose.X, pose.Y, radius + margin, [&](UInt32 place) {
    const CDiscPairs::SDisc& disc = m_discPairs.GetDiscs()[place];
    const Real dx = disc.X - pose.X;
    const Real dy = disc.Y - pose.Y;
    const Real near = radius + disc.Radius + GetReach();
    if (dx * dx + dy * dy <= near * near || m_store.GetDriven(disc.Number).IsActive()) {
      m_crowd.Exclude(place);
    }
  });
  CCrowdSolids& solids = m_crowd.GetSolids();
  solids.ForNear(pose.X, pose.Y, radius, [&](UInt32 item) { m_crowd.Exclude(item); });
}

// by the present speeds of bodies that turn or have no drive, and by what turrets move
void CPlanarWorld::ExtendLongestPath() {
  for (const SActiveBody& active : m_active.GetBodies()) {
    const SDrivenBody& body = m_active.GetRobot(active);
    const Real speed = std::hypot(body.Velocity.X, body.Velocity.Y) +
                       (body.IsDisc ? 0.0 : std::abs(body.Velocity.W) * body.BoundingRadius);
    m_longestPath = std::max(m_longestPath, speed * GetTick());
  }
  for (const SPassiveBody& body : m_store.GetPassive()) {
    const Real speed = std::hypot(body.Velocity.X, body.Velocity.Y) +
                       std::abs(body.Velocity.W) * body.BoundingRadius;
    m_longestPath = std::max(m_longestPath, speed * GetTick());
  }
  m_longestPath = std::max(m_longestPath, m_grips.ComputeLongestSwing());
}

bool CPlanarWorld::IsAnyAwake() const {
  const std::vector<SPassiveBody>& passive = m_store.GetPassive();
  return !m_active.GetBodies().empty() ||
         std::any_of(passive.begin(), passive.end(), [](const SPassiveBody& body) {
           return body.Body->IsEnabled() && body.Body->IsAwake();
         });
}

UInt32 CPlanarWorld::ChooseSubsteps() const {
  SSubstepNeeds needs;
  needs.ForMotion = std::max({m_active.ComputeNeededSubsteps(), ComputeSubstepsOfPassive(),
                              m_grips.ComputeNeededSubsteps()});
  needs.IsHolding = m_grips.IsHoldingAny();
  if (m_substepPolicy.UsesWeakestDrive()) {
    needs.WeakestDrive = m_active.ComputeWeakestDrive();
  }
  return m_substepPolicy.ChooseSubsteps(needs);
}

// Substeps of a tick in which no passive body moves or turns too far in one.
float CPlanarWorld::ComputeSubstepsOfPassive() const {
  const float tick = static_cast<float>(GetTick());
  float needed = 0.0F;
  for (const SPassiveBody& body : m_store.GetPassive()) {
    if (body.Body->IsEnabled() && body.Body->IsAwake()) {
      const float distance = body.Body->GetLinearVelocity().Length() * tick;
      const float turn = std::abs(body.Body->GetAngularVelocity()) * tick;
      needed = std::max({needed, distance / (static_cast<float>(kMaxStepShare) * body.Extent),
                         turn / static_cast<float>(kMaxStepTurn)});
    }
  }
  return needed;
}

void CPlanarWorld::StepBox2D(UInt32 substeps) {
  const float duration = static_cast<float>(GetTick() / substeps);
  const int iterations = m_substepPolicy.ChooseIterations(substeps, m_grips.IsHoldingAny());
  b2World& world = m_store.GetWorld();
  float deepestOverlap = 0.0F;
  float greatestImpulse = 0.0F;
  for (UInt32 substep = 0; substep < substeps; ++substep) {
    m_active.SetMotors(substep, substeps);
    m_grips.SetTurretMotors(substep, substeps);
    world.Step(duration, iterations, kPositionIterations);
    deepestOverlap = std::max(deepestOverlap, m_overlaps.Resolve(world));
    m_active.AccountMotors();
    m_grips.AlignTurrets();
    greatestImpulse = std::max(
        {greatestImpulse, m_overlaps.GetGreatestImpulse(), m_grips.ComputeGreatestImpulse()});
  }
  m_substepPolicy.FinishTick(deepestOverlap, greatestImpulse / duration);
}

void CPlanarWorld::FinishPassive() {
  for (SPassiveBody& body : m_store.GetPassive()) {
    if (!body.Body->IsEnabled()) {
      body.Moved = body.Moved || body.WasReleased;
      body.WasReleased = false;
      Wrap(body.Pose);
      continue;
    }
    const b2Vec2 position = body.Body->GetPosition();
    const float angle = body.Body->GetAngle();
    const bool moved = position.x != body.X || position.y != body.Y || angle != body.Angle;
    // a released body may be in another engine's region
    body.Moved = moved || body.WasReleased;
    body.WasReleased = false;
    if (moved) {
      body.X = position.x;
      body.Y = position.y;
      body.Angle = angle;
      body.Pose.X = m_store.ToMetres(position.x);
      body.Pose.Y = m_store.ToMetres(position.y);
      body.Pose.SetYaw(angle);
    }
    // also of a body that friction has stopped before it moved
    const b2Vec2 velocity = body.Body->GetLinearVelocityFromLocalPoint(b2Vec2_zero);
    body.Velocity = {m_store.ToMetres(velocity.x), m_store.ToMetres(velocity.y),
                     static_cast<Real>(body.Body->GetAngularVelocity())};
  }
}

}  // namespace argos
