#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd.h>

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/drive_motion.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// discs in a chunk of a thread
constexpr size_t kRobotGrain = 1024;
// parts of other bodies that a solid can meet in a tick, in a crowd
constexpr size_t kTouchesOfSolid = 12;
// Greatest way on which a disc is pushed out of an overlap in a tick, in radii of the smallest
// movable body.
constexpr Real kMaxAllowance = 0.5;

}  // namespace

void CCrowd::Reserve(size_t discs, size_t solids, size_t grips) {
  m_clusters.Reserve(discs + solids);
  m_solver.Reserve(discs + solids);
  m_grips.reserve(grips);
  m_gripTouches.reserve(kTouchesOfSolid * grips);
  m_clusters.ReserveGrips(grips);
  m_solver.ReserveGrips(grips);
  if (solids > 0) {
    const size_t touches = kTouchesOfSolid * solids;
    m_solids.Reserve(solids, touches);
    m_clusters.ReserveTouches(touches);
    m_solver.ReserveForSolids(discs, solids, touches);
    m_memory.Touches.Reserve(2 * touches);
  } else if (grips > 0) {
    m_solver.ReserveForSolids(discs, 0, 0);
  }
  m_lines.reserve(discs);
  m_memory.Pairs.Reserve(m_store.GetDriven().capacity(), 2 * discs);
  m_memory.Walls.Reserve(m_store.GetDriven().capacity(), discs);
}

void CCrowd::Forget(UInt32 slot) {
  m_memory.Pairs.Forget(slot);
  m_memory.Walls.Forget(slot);
  m_memory.Touches.Clear();
  m_gripTouches.clear();
}

void CCrowd::ExpectOverlaps() {
  m_allowance = kMaxAllowance * m_store.GetSettings().SmallestRadius;
}

void CCrowd::Start(CDiscPairs& discPairs, Real reach) {
  m_lines.clear();
  m_grips.clear();
  m_longestGrip = 0.0;
  m_solids.Find(m_store, discPairs, reach, kSolidReach * reach);
  m_clusters.Unite(discPairs, m_solids);
}

void CCrowd::AddGrip(CDiscPairs& discPairs, const SCrowdGrip& grip) {
  m_grips.push_back(grip);
  const SPlanarVector way = {grip.Pivot.X + grip.Arm.X - grip.Point.X,
                             grip.Pivot.Y + grip.Arm.Y - grip.Point.Y};
  m_longestGrip = std::max(m_longestGrip, std::hypot(way.X, way.Y));
  for (const UInt32 item : {grip.Holder, grip.Held}) {
    if (!m_solids.IsSolid(item)) {
      discPairs.SetNear(item);
    }
  }
}

void CCrowd::AddLine(CDiscPairs& discPairs, UInt32 place, const SCrowdLine& line) {
  discPairs.AddObstaclePair(place, kFirstLine + static_cast<UInt32>(m_lines.size()));
  m_lines.push_back(line);
}

void CCrowd::Advance(CThreadPool& pool, const CDiscPairs& discPairs, Real longestPath, Real reach) {
  m_clusters.Unite(m_grips);
  const Real pairReach = 2.0 * (m_store.GetWidestMovable() + kSolidReach * reach);
  m_clusters.Build(std::max(pairReach, m_longestGrip), m_store.GetSettings().Period);
  const size_t count = m_clusters.GetMembers().size();
  SCrowdTick tick;
  tick.Duration = m_store.GetSettings().Tick;
  tick.LeastSubsteps = m_store.GetSettings().Substeps;
  tick.RefineInCrowds = m_store.GetSettings().RefineInCrowds;
  tick.SmallestRadius = m_store.GetSettings().SmallestRadius;
  tick.LongestPath = longestPath + m_allowance;
  tick.Period = m_store.GetSettings().Period;
  m_solver.Start(tick, count);
  pool.ParallelFor(count, kRobotGrain,
                   [this](size_t begin, size_t end, UInt32) { FillIn(begin, end); });
  m_solver.Solve(pool, m_clusters, discPairs, m_solids, m_lines, m_memory, m_grips);
  pool.ParallelFor(count, kRobotGrain,
                   [this](size_t begin, size_t end, UInt32) { TakeResults(begin, end); });
  m_solver.Remember(m_store.GetDriven().size(), m_memory);
  FindGripTouches();
  m_allowance =
      std::min(2.0 * m_solver.GetDeepest(), kMaxAllowance * m_store.GetSettings().SmallestRadius);
}

void CCrowd::FillIn(size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i) {
    const UInt32 member = static_cast<UInt32>(i);
    const CCrowdClusters::SMember& body = m_clusters.GetMembers()[i];
    if (m_solids.IsSolid(body.Item)) {
      FillInSolid(member, m_solids.GetSolid(body.Item));
    } else {
      FillInDriven(member, m_store.GetDriven(body.Number));
    }
  }
}

void CCrowd::FillInDriven(UInt32 member, const SDrivenBody& body) {
  const SPlanarSettings& settings = m_store.GetSettings();
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
  const SPlanarVelocity target = ComputeTarget(body, settings);
  drive.TargetX = static_cast<float>(target.X);
  drive.TargetY = static_cast<float>(target.Y);
  drive.TargetW = static_cast<float>(target.W);
  drive.InTick = static_cast<float>(body.Kind->Mass * body.Kind->MaxSpeedChange);
  drive.AngularInTick = static_cast<float>(body.Kind->Inertia * body.Kind->MaxYawRateChange);
}

// The solver moves the centre of mass.
void CCrowd::FillInSolid(UInt32 member, const CCrowdSolids::SSolid& solid) {
  const SPlanarSolid& shape = *solid.Shape;
  SCrowdDisc& disc = m_solver.GetDisc(member);
  SCrowdDrive& drive = m_solver.GetDrive(member);
  if (solid.Kind == EPlanarKind::Driven) {
    FillInDriven(member, m_store.GetDriven(solid.Slot));
  } else {
    const Real tick = m_store.GetSettings().Tick;
    const SPlanarVelocity& velocity = m_store.GetPassive()[solid.Slot].Velocity;
    disc.VX = static_cast<float>(velocity.X);
    disc.VY = static_cast<float>(velocity.Y);
    disc.W = static_cast<float>(velocity.W);
    drive = SCrowdDrive();
    drive.IsFriction = true;
    drive.InTick = static_cast<float>(shape.Friction.Force * tick);
    drive.AngularInTick = static_cast<float>(shape.Friction.Torque * tick);
  }
  disc.InverseMass = static_cast<float>(1.0 / shape.Mass);
  disc.InverseInertia = static_cast<float>(1.0 / shape.Inertia);
  disc.Radius = static_cast<float>(shape.NarrowestHalf);
  const auto leverX = static_cast<float>(solid.Cos * shape.CentreX - solid.Sin * shape.CentreY);
  const auto leverY = static_cast<float>(solid.Sin * shape.CentreX + solid.Cos * shape.CentreY);
  disc.VX -= disc.W * leverY;
  disc.VY += disc.W * leverX;
  drive.TargetX -= drive.TargetW * leverY;
  drive.TargetY += drive.TargetW * leverX;
  m_solver.GetPosition(member) = {solid.X, solid.Y, 0.0};
}

void CCrowd::FindGripTouches() {
  m_gripTouches.clear();
  if (m_grips.empty()) {
    return;
  }
  const auto slotOf = [this](UInt32 member) {
    if (member == CCrowdSolids::kNone) {
      return CCrowdSolids::kNone;
    }
    const CCrowdClusters::SMember& body = m_clusters.GetMembers()[member];
    if (!m_solids.IsSolid(body.Item)) {
      return body.Number;
    }
    const CCrowdSolids::SSolid& solid = m_solids.GetSolid(body.Item);
    return solid.Kind == EPlanarKind::Driven ? solid.Slot : CCrowdSolids::kNone;
  };
  const auto add = [this](UInt32 slot, UInt32 other) {
    if (slot != CCrowdSolids::kNone && m_store.GetDriven()[slot].NumGrips > 0) {
      m_gripTouches.push_back({slot, other});
    }
  };
  m_solver.ForForces([&](UInt32 a, UInt32 b) {
    add(slotOf(a), slotOf(b));
    add(slotOf(b), slotOf(a));
  });
}

void CCrowd::TakeResults(size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i) {
    const UInt32 member = static_cast<UInt32>(i);
    const CCrowdClusters::SMember& body = m_clusters.GetMembers()[i];
    if (m_solids.IsSolid(body.Item)) {
      const CCrowdSolids::SSolid& solid = m_solids.GetSolid(body.Item);
      TakeSolid(member, solid);
      if (solid.Kind == EPlanarKind::Driven) {
        TakePull(member, m_store.GetDriven(solid.Slot));
      }
      continue;
    }
    TakePull(member, m_store.GetDriven(body.Number));
    if (m_solver.IsPushed(member)) {  // else it moves exactly as planned
      TakeDriven(member, m_store.GetDriven(body.Number));
    }
  }
}

void CCrowd::TakePull(UInt32 member, SDrivenBody& body) {
  const SCrowdDrive& drive = m_solver.GetDrive(member);
  if (body.NumGrips > 0 && drive.Most > 0.0F) {
    body.PullX = drive.X / drive.Most;
    body.PullY = drive.Y / drive.Most;
  }
}

void CCrowd::TakeDriven(UInt32 member, SDrivenBody& body) {
  const SCrowdPosition& position = m_solver.GetPosition(member);
  const SCrowdDisc& disc = m_solver.GetDisc(member);
  body.NextPose = body.Pose;
  body.NextPose.X = position.X;
  body.NextPose.Y = position.Y;
  Turn(body.NextPose, std::cos(0.5 * position.Turn), std::sin(0.5 * position.Turn));
  body.NextVelocity = {static_cast<Real>(disc.VX), static_cast<Real>(disc.VY),
                       static_cast<Real>(disc.W)};
}

void CCrowd::TakeSolid(UInt32 member, const CCrowdSolids::SSolid& solid) {
  const SPlanarSolid& shape = *solid.Shape;
  const SCrowdDisc& disc = m_solver.GetDisc(member);
  const SCrowdPosition& position = m_solver.GetPosition(member);
  SPassiveBody* const passive =
      solid.Kind == EPlanarKind::Passive ? &m_store.GetPassive()[solid.Slot] : nullptr;
  if (passive != nullptr) {
    // as far as the solver goes; a deep overlap takes several ticks
    passive->IsFresh = passive->IsFresh && m_solver.IsPushed(member);
    passive->Velocity = SPlanarVelocity();
  }
  const bool hasMoved = position.X != solid.X || position.Y != solid.Y || position.Turn != 0.0;
  if (!m_solver.IsPushed(member) || (passive != nullptr && !hasMoved)) {
    return;
  }
  SPlanarPose pose = passive != nullptr ? passive->Pose : m_store.GetDriven(solid.Slot).Pose;
  Turn(pose, std::cos(0.5 * position.Turn), std::sin(0.5 * position.Turn));
  const Real cosine = pose.HalfCos * pose.HalfCos - pose.HalfSin * pose.HalfSin;
  const Real sine = 2.0 * pose.HalfSin * pose.HalfCos;
  const Real leverX = cosine * shape.CentreX - sine * shape.CentreY;
  const Real leverY = sine * shape.CentreX + cosine * shape.CentreY;
  pose.X = position.X - leverX;
  pose.Y = position.Y - leverY;
  const Real turnRate = static_cast<Real>(disc.W);
  const SPlanarVelocity velocity = {static_cast<Real>(disc.VX) + turnRate * leverY,
                                    static_cast<Real>(disc.VY) - turnRate * leverX, turnRate};
  if (passive != nullptr) {
    passive->Pose = pose;
    passive->Velocity = velocity;
    passive->Moved = true;
  } else {
    m_store.GetDriven(solid.Slot).NextPose = pose;
    m_store.GetDriven(solid.Slot).NextVelocity = velocity;
  }
}

}  // namespace argos
