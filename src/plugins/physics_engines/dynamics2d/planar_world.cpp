#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/memory/load_ahead.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/drive_motion.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_components.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// robots that a thread plans in a chunk
constexpr size_t kPlanGrain = 512;
// robots between prefetching and reading what is elsewhere in memory
constexpr size_t kPlanAhead = 8;
// slacks by which a ghost that matters may be farther than it can be met: of both bodies, and more
constexpr Real kGhostSlacks = 2.3;

}  // namespace

CPlanarWorld::CPlanarWorld(const SPlanarSettings& settings)
    : m_store(settings), m_grips(m_store), m_ghosts(m_store), m_crowd(m_store) {
  m_discPairs.SetPeriod(settings.Period);
}

void CPlanarWorld::AddDriven(const SPlanarOwner& owner, const SBodyDescription& description,
                             const SPlanarPose& pose, const CDriveSource& drive) {
  m_store.AddDriven(owner, description, pose, drive);
  m_crowd.ExpectOverlaps();
}

void CPlanarWorld::Remove(const SPlanarHandle& handle) {
  m_grips.Remove(handle);
  if (handle.Kind == EPlanarKind::Driven) {
    m_crowd.Forget(handle.Slot);
    m_crowd.Forget(static_cast<UInt32>(m_store.GetDriven().size() - 1));
  } else {
    m_crowd.ForgetSolids();
  }
  m_store.Remove(handle);
}

void CPlanarWorld::ReserveForTick() {
  const size_t robots = m_store.GetDriven().capacity();
  const size_t solids = m_store.GetPassive().capacity() + m_store.GetDrivenSolids().size();
  m_ties.Reserve(2 * m_grips.GetNumManipulators());
  m_ghosts.Reserve(robots + m_store.GetPassive().capacity());
  m_discPairs.Reserve(robots);
  m_crowd.Reserve(robots, m_store.HasSolids() ? solids : 0, m_grips.GetNumManipulators());
  m_longestOfChunk.reserve(robots / kPlanGrain + 1);
}

// the slack of the proximity filter, m
Real CPlanarWorld::GetSlack() const {
  return kProximitySlack * m_store.GetSettings().SmallestRadius;
}

Real CPlanarWorld::ComputeGhostReach() const {
  // a robot and the robot that approaches it may both move by the longest path
  return m_store.GetWidestMovable() + kGhostSlacks * GetSlack() +
         std::max(2.0 * m_longestPath, kStartSpeed * GetTick());
}

void CPlanarWorld::Advance(CThreadPool& pool) {
  for (SPassiveBody& body : m_store.GetPassive()) {
    body.Moved = false;
  }
  m_grips.StartTick();
  PlanDriven(pool);
  FindMeetings(pool);
  m_ghosts.Place(m_discPairs, m_crowd, GetReach(), m_longestPath);
  m_crowd.Advance(pool, m_discPairs, m_longestPath, GetReach());
  m_grips.FinishTick(m_crowd.GetGrips());
  FinishPassive();
}

// Computes the state of each robot at the end of the tick if nothing is in its way.
void CPlanarWorld::PlanDriven(CThreadPool& pool) {
  const size_t count = m_store.GetDriven().size();
  m_discPairs.Start(count);
  m_longestOfChunk.assign((count + kPlanGrain - 1) / kPlanGrain, 0.0);
  pool.ParallelFor(m_longestOfChunk.size(), 1, [&](size_t begin, size_t end, UInt32) {
    for (size_t chunk = begin; chunk < end; ++chunk) {
      m_longestOfChunk[chunk] =
          PlanChunk(chunk * kPlanGrain, std::min(count, (chunk + 1) * kPlanGrain));
    }
  });
  m_longestPath = 0.0;
  for (const Real longest : m_longestOfChunk) {
    m_longestPath = std::max(m_longestPath, longest);
  }
}

// @return the longest path of robots [begin, end), m.
Real CPlanarWorld::PlanChunk(size_t begin, size_t end) {
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

// Finds the bodies that may touch something, and makes grips.
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
    m_grips.MakeGrips(m_discPairs, m_crowd.GetSolids());
    if (m_grips.IsHoldingAny()) {
      m_ties.Settle(m_store, m_grips, m_crowd.GetGripTouches());
      m_grips.AddTo(m_discPairs, m_crowd);
    }
  }
}

// Two bodies can meet on one side only, and an image of an obstacle is where a body may meet it.
void CPlanarWorld::CheckPeriod() const {
  const Real necessary = 4.0 * (m_store.GetWidestMovable() + kSolidReach * GetReach());
  RequirePeriod(m_store.GetSettings().Period, necessary);
}

// by the present speeds of bodies that have no drive, and by what grips move
void CPlanarWorld::ExtendLongestPath() {
  for (const SPassiveBody& body : m_store.GetPassive()) {
    const Real speed = std::hypot(body.Velocity.X, body.Velocity.Y) +
                       std::abs(body.Velocity.W) * body.BoundingRadius;
    m_longestPath = std::max(m_longestPath, speed * GetTick());
  }
  m_longestPath = std::max(m_longestPath, m_grips.ComputeLongestPath());
}

// A released body may be in another engine's region.
void CPlanarWorld::FinishPassive() {
  for (SPassiveBody& body : m_store.GetPassive()) {
    body.Moved = body.Moved || body.WasReleased;
    body.WasReleased = false;
    Wrap(body.Pose);
  }
}

}  // namespace argos
