#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd.h>

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// discs in a run of a thread
constexpr size_t kRobotGrain = 1024;
// Greatest way on which a disc is pushed out of an overlap in a tick, in radii of the smallest
// movable body.
constexpr Real kMostAllowance = 0.5;

}  // namespace

void CCrowd::Reserve(size_t discs) {
  m_clusters.Reserve(discs);
  m_solver.Reserve(discs);
  m_lines.reserve(discs);
  m_pairMemory.Reserve(m_store.GetDriven().capacity(), 2 * discs);
  m_wallMemory.Reserve(m_store.GetDriven().capacity(), discs);
}

void CCrowd::Forget(UInt32 slot) {
  m_pairMemory.Forget(slot);
  m_wallMemory.Forget(slot);
}

void CCrowd::ExpectOverlaps() {
  m_allowance = kMostAllowance * m_store.GetMetresPerUnit();
}

void CCrowd::AddLine(CDiscPairs& discPairs, UInt32 place, const SCrowdLine& line) {
  discPairs.AddObstaclePair(place, kFirstLine + static_cast<UInt32>(m_lines.size()));
  m_lines.push_back(line);
}

void CCrowd::Advance(CThreadPool& pool, const CDiscPairs& discPairs, Real longestPath, Real reach) {
  m_clusters.Build(discPairs, 2.0 * (m_store.GetWidestMovable() + reach));
  const size_t count = m_clusters.GetMembers().size();
  SCrowdTick tick;
  tick.Duration = m_store.GetSettings().Tick;
  tick.LeastSubsteps = m_store.GetSettings().Substeps;
  tick.RefineInCrowds = m_store.GetSettings().RefineInCrowds;
  tick.SmallestRadius = kSmallestRadiusInUnits * m_store.GetMetresPerUnit();
  tick.LongestPath = longestPath + m_allowance;
  m_solver.Start(tick, count);
  pool.ParallelFor(count, kRobotGrain,
                   [this](size_t begin, size_t end, UInt32) { FillIn(begin, end); });
  m_solver.Solve(pool, m_clusters, discPairs, m_lines, m_pairMemory, m_wallMemory);
  pool.ParallelFor(count, kRobotGrain,
                   [this](size_t begin, size_t end, UInt32) { TakeResults(begin, end); });
  m_solver.Remember(m_clusters, m_store.GetDriven().size(), m_pairMemory, m_wallMemory);
  m_allowance = std::min(2.0 * m_solver.GetDeepest(), kMostAllowance * m_store.GetMetresPerUnit());
}

void CCrowd::FillIn(size_t begin, size_t end) {
  const SPlanarSettings& settings = m_store.GetSettings();
  const Real lag = settings.VelocityLag;
  for (size_t i = begin; i < end; ++i) {
    const UInt32 member = static_cast<UInt32>(i);
    const SDrivenBody& body = m_store.GetDriven(m_clusters.GetMembers()[i].Number);
    m_solver.GetPosition(member) = {body.Pose.X, body.Pose.Y, 0.0};
    SCrowdDisc& disc = m_solver.GetDisc(member);
    disc.VX = static_cast<float>(body.Velocity.X);
    disc.VY = static_cast<float>(body.Velocity.Y);
    disc.W = static_cast<float>(body.Velocity.W);
    disc.InverseMass = static_cast<float>(1.0 / body.Kind->Mass);
    disc.InverseInertia = static_cast<float>(1.0 / body.Kind->Inertia);
    disc.Radius = static_cast<float>(body.BoundingRadius);
    SCrowdDrive& drive = m_solver.GetDrive(member);
    drive = SCrowdDrive();
    SPlanarVelocity target = body.NextVelocity;
    if (body.IsLimited) {
      const SArc arc = FollowArcs(body.Pose, body.Command, body.NextCommand, settings.Tick, lag);
      target = {arc.DX / settings.Tick, arc.DY / settings.Tick,
                lag * body.Command.YawRate + (1.0 - lag) * body.NextCommand.YawRate};
    }
    drive.TargetX = static_cast<float>(target.X);
    drive.TargetY = static_cast<float>(target.Y);
    drive.TargetW = static_cast<float>(target.W);
    drive.InTick = static_cast<float>(body.Kind->Mass * body.Kind->MaxSpeedChange);
    drive.AngularInTick = static_cast<float>(body.Kind->Inertia * body.Kind->MaxYawRateChange);
  }
}

void CCrowd::TakeResults(size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i) {
    const UInt32 member = static_cast<UInt32>(i);
    if (!m_solver.IsPushed(member)) {
      continue;  // it moves exactly as planned
    }
    SDrivenBody& body = m_store.GetDriven(m_clusters.GetMembers()[i].Number);
    const SCrowdPosition& position = m_solver.GetPosition(member);
    const SCrowdDisc& disc = m_solver.GetDisc(member);
    body.NextPose = body.Pose;
    body.NextPose.X = position.X;
    body.NextPose.Y = position.Y;
    Turn(body.NextPose, std::cos(0.5 * position.Turn), std::sin(0.5 * position.Turn));
    body.NextVelocity = {static_cast<Real>(disc.VX), static_cast<Real>(disc.VY),
                         static_cast<Real>(disc.W)};
  }
}

}  // namespace argos
