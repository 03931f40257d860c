// The contacts of solids: general points, two for faces.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solver.h>

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr size_t kTouchGrain = 512;
// of a solid and the parts of bodies in keys
constexpr UInt32 kSolidBit = UInt32(1) << 31;
constexpr UInt32 kDrivenBit = UInt32(1) << 30;
constexpr UInt32 kPartBits = 15;

const SCrowdDisc kStill;  // something immovable

}  // namespace

// Puts the parts of a solid at its present pose.
void CCrowdSolver::PlaceParts(UInt32 member) {
  const CCrowdSolids::SSolid& solid = GetSolid(member);
  const SPlanarSolid& shape = *solid.Shape;
  const SCrowdPosition& position = m_positions[member];
  const Real turnCos = std::cos(position.Turn);
  const Real turnSin = std::sin(position.Turn);
  const Real cosine = solid.Cos * turnCos - solid.Sin * turnSin;
  const Real sine = solid.Sin * turnCos + solid.Cos * turnSin;
  const Real x = position.X - cosine * shape.CentreX + sine * shape.CentreY;
  const Real y = position.Y - sine * shape.CentreX - cosine * shape.CentreY;
  for (size_t i = 0; i < shape.Parts.size(); ++i) {
    m_parts[solid.FirstPart + i] = PlaceFootprint(shape.Parts[i], x, y, cosine, sine);
  }
}

// The step of a disc in a substep relative to the solid next to it.
SPlanarVector CCrowdSolver::ComputeStep(const CCrowdClusters::STouch& pair, float duration) const {
  const SCrowdDisc& disc = m_discs[pair.A];
  const SCrowdDisc& solid = m_discs[pair.B];
  const SCrowdPosition& place = m_positions[pair.A];
  const SCrowdPosition& centre = m_positions[pair.B];
  const auto leverX = static_cast<float>(m_tick.Period.X.Shorten(place.X - centre.X));
  const auto leverY = static_cast<float>(m_tick.Period.Y.Shorten(place.Y - centre.Y));
  return {static_cast<Real>((disc.VX - solid.VX + solid.W * leverY) * duration),
          static_cast<Real>((disc.VY - solid.VY - solid.W * leverX) * duration)};
}

// A part of the second body of a pair, where it is next to the first one.
SFootprint CCrowdSolver::GetPartNear(const CCrowdClusters::STouch& pair) const {
  const SFootprint& part = m_parts[pair.PartB];
  if (!m_tick.Period.IsOn()) {
    return part;
  }
  const SCrowdPosition& a = m_positions[pair.A];
  const SCrowdPosition& b = m_positions[pair.B];
  const SPlanarVector image = FindNearestImage(m_tick.Period, b.X, b.Y, a.X, a.Y);
  return Displace(part, image.X, image.Y);
}

// @return the number of points, at most two; they are next to the first body.
int CCrowdSolver::FindPoints(const CCrowdClusters::STouch& pair, float duration,
                             SSeparation* points) const {
  if (pair.PartA == CCrowdSolids::kNone) {
    const SCrowdPosition& position = m_positions[pair.A];
    points[0] =
        SeparateFromFootprint(position.X, position.Y, static_cast<Real>(m_discs[pair.A].Radius),
                              ComputeStep(pair, duration), GetPartNear(pair));
    return 1;
  }
  if (pair.B != CCrowdSolids::kNone) {
    return argos::FindContacts(m_parts[pair.PartA], GetPartNear(pair), points);
  }
  const SFootprint& obstacle = pair.PartB < CCrowdSolids::kFirstOfTick
                                   ? m_discPairs->GetObstacle(pair.PartB)
                                   : m_solids->GetObstacle(pair.PartB);
  return argos::FindContacts(m_parts[pair.PartA], obstacle, points);
}

// @return the number of points, which begin at twice the number of the first touch.
UInt32 CCrowdSolver::FindTouches(const SCrowdRange& range, const SSubstep& substep,
                                 SPatchState& state) {
  const Real most = 2.0 * kSolidReach * m_tick.LongestPath / substep.Count;
  const Real touchingGap = kTouchingGap * m_tick.SmallestRadius;
  UInt32 next = 2 * range.First;
  for (UInt32 i = range.First; i < range.End; ++i) {
    const auto& pair = m_clusters->GetTouches()[i];
    SSeparation points[2];
    const int count = FindPoints(pair, substep.Duration, points);
    for (UInt32 point = 0; point < 2; ++point) {
      SContactForce& force = m_touchForces[2 * i + point];
      STouch& touch = m_touches[next];
      if (static_cast<int>(point) >= count || !MakeTouch(pair, points[point], most, touch, state)) {
        force = SContactForce();
        continue;
      }
      const Real gap = points[point].Gap;
      touch.Point = 2 * i + point;
      touch.Approach = gap > 0.0 ? static_cast<float>(gap) / substep.Duration : 0.0F;
      touch.Normal = force.Steady * substep.Duration;
      const float bound = touch.Friction * force.Steady;
      touch.Tangent = std::clamp(force.Tangent, -bound, bound) * substep.Duration;
      if (touch.Normal > 0.0F || gap < touchingGap) {
        RaiseFlag(m_isTouching[pair.A]);
        if (pair.B != CCrowdSolids::kNone) {
          RaiseFlag(m_isTouching[pair.B]);
        }
      }
      ++next;
    }
  }
  return next - 2 * range.First;
}

// @return false if the gap is too wide.
bool CCrowdSolver::MakeTouch(const CCrowdClusters::STouch& pair, const SSeparation& point,
                             Real most, STouch& touch, SPatchState& state) const {
  if (point.Gap > most) {
    return false;
  }
  state.Deepest = std::max(state.Deepest, static_cast<float>(-point.Gap));
  touch.A = pair.A;
  touch.B = pair.B;
  touch.NX = static_cast<float>(point.NormalX);
  touch.NY = static_cast<float>(point.NormalY);
  const auto leverOf = [&](UInt32 member, float& normal, float& tangent) {
    const Real x = m_tick.Period.X.Shorten(point.PointX - m_positions[member].X);
    const Real y = m_tick.Period.Y.Shorten(point.PointY - m_positions[member].Y);
    normal = static_cast<float>(x * point.NormalY - y * point.NormalX);
    tangent = static_cast<float>(x * point.NormalX + y * point.NormalY);
    const SCrowdDisc& body = m_discs[member];
    touch.Mass += body.InverseMass + body.InverseInertia * normal * normal;
    touch.TangentMass += body.InverseMass + body.InverseInertia * tangent * tangent;
  };
  touch.Mass = touch.TangentMass = 0.0F;
  leverOf(pair.A, touch.NormalLeverA, touch.TangentLeverA);
  touch.Friction = kDiscFriction;
  touch.NormalLeverB = touch.TangentLeverB = 0.0F;
  if (pair.B != CCrowdSolids::kNone) {
    leverOf(pair.B, touch.NormalLeverB, touch.TangentLeverB);
  } else {
    touch.Friction = pair.PartB < CCrowdSolids::kFirstOfTick ? kWallFriction : 0.0F;
  }
  touch.Mass = 1.0F / touch.Mass;
  touch.TangentMass = 1.0F / touch.TangentMass;
  return true;
}

void CCrowdSolver::WarmStartTouches(UInt32 first, UInt32 count) {
  for (UInt32 i = first; i < first + count; ++i) {
    if (m_touches[i].Normal > 0.0F) {
      ApplyImpulse(m_touches[i], m_touches[i].Normal, m_touches[i].Tangent);
    }
  }
}

void CCrowdSolver::ApplyImpulse(const STouch& touch, float normal, float tangent) {
  const float x = normal * touch.NX - tangent * touch.NY;
  const float y = normal * touch.NY + tangent * touch.NX;
  SCrowdDisc& a = m_discs[touch.A];
  a.VX -= a.InverseMass * x;
  a.VY -= a.InverseMass * y;
  a.W -= a.InverseInertia * (normal * touch.NormalLeverA + tangent * touch.TangentLeverA);
  if (touch.B != CCrowdSolids::kNone) {
    SCrowdDisc& b = m_discs[touch.B];
    b.VX += b.InverseMass * x;
    b.VY += b.InverseMass * y;
    b.W += b.InverseInertia * (normal * touch.NormalLeverB + tangent * touch.TangentLeverB);
  }
}

float CCrowdSolver::SolveTouch(STouch& touch) {
  const SCrowdDisc& a = m_discs[touch.A];
  const SCrowdDisc& b = touch.B != CCrowdSolids::kNone ? m_discs[touch.B] : kStill;
  const float x = b.VX - a.VX;
  const float y = b.VY - a.VY;
  const float approach =
      a.W * touch.NormalLeverA - b.W * touch.NormalLeverB - (x * touch.NX + y * touch.NY);
  const float normal = std::max(0.0F, touch.Normal + (approach - touch.Approach) * touch.Mass);
  const float changeN = normal - touch.Normal;
  touch.Normal = normal;
  if (normal == 0.0F && touch.Tangent == 0.0F && changeN == 0.0F) {
    return 0.0F;
  }
  const float slip =
      y * touch.NX - x * touch.NY + b.W * touch.TangentLeverB - a.W * touch.TangentLeverA;
  const float most = touch.Friction * normal;
  const float tangent = std::clamp(touch.Tangent - slip * touch.TangentMass, -most, most);
  const float changeT = tangent - touch.Tangent;
  touch.Tangent = tangent;
  ApplyImpulse(touch, changeN, changeT);
  return std::max(std::abs(changeN) / touch.Mass, std::abs(changeT) / touch.TangentMass);
}

float CCrowdSolver::SweepTouches(UInt32 first, UInt32 count, bool backwards) {
  float greatest = 0.0F;
  for (UInt32 i = 0; i < count; ++i) {
    greatest = std::max(greatest, SolveTouch(m_touches[first + (backwards ? count - 1 - i : i)]));
  }
  return greatest;
}

void CCrowdSolver::TakeTouchForces(UInt32 first, UInt32 count, float perSecond) {
  for (UInt32 i = first; i < first + count; ++i) {
    const STouch& touch = m_touches[i];
    m_touchForces[touch.Point].Take(touch.Normal * perSecond, touch.Tangent * perSecond);
    if (touch.Normal > 0.0F) {
      for (const UInt32 body : {touch.A, touch.B}) {
        if (body != CCrowdSolids::kNone) {
          RaiseFlag(m_isPushed[body]);
          RaiseFlag(m_isLoaded[body]);
        }
      }
    }
  }
}

// Friction slows a body that slides on without being pushed evenly, and stops it at a point in the
// substep: its way is that of a constant deceleration. What friction holds stays where it is.
void CCrowdSolver::MoveSolid(UInt32 member, const SSubstep& substep) {
  SCrowdDisc& disc = m_discs[member];
  SCrowdDrive& drive = m_drives[member];
  SCrowdPosition& position = m_positions[member];
  const float duration = substep.Duration;
  const auto radius = static_cast<float>(GetSolid(member).Shape->Radius);
  const float fastest = static_cast<float>(kSolidReach * m_tick.LongestPath / m_tick.Duration);
  disc.W = std::clamp(disc.W, -fastest / radius, fastest / radius);
  float wayX = disc.VX * duration;
  float wayY = disc.VY * duration;
  float turn = disc.W * duration;
  if (drive.IsFriction) {
    const float slow = m_tolerance / duration;
    if (drive.HoldsPlace() && disc.VX * disc.VX + disc.VY * disc.VY < slow * slow) {
      disc.VX = disc.VY = wayX = wayY = 0.0F;
    }
    if (drive.HoldsYaw() && std::abs(disc.W) * radius < slow) {
      disc.W = turn = 0.0F;
    }
    if (m_isLoaded[member] == 0 && drive.Most > 0.0F) {
      const float share = std::sqrt(drive.X * drive.X + drive.Y * drive.Y) / drive.Most;
      const float lost = 0.5F * duration * std::min(1.0F, share) * disc.InverseMass;
      wayX -= lost * drive.X;
      wayY -= lost * drive.Y;
    }
    if (m_isLoaded[member] == 0 && drive.AngularMost > 0.0F) {
      const float share = std::abs(drive.Angular) / drive.AngularMost;
      turn -= 0.5F * duration * std::min(1.0F, share) * disc.InverseInertia * drive.Angular;
    }
  }
  m_isLoaded[member] = 0;
  if (wayX != 0.0F || wayY != 0.0F || turn != 0.0F) {
    m_isPushed[member] |= drive.IsFriction ? 1 : 0;
    position.X += static_cast<Real>(wayX);
    position.Y += static_cast<Real>(wayY);
    position.Turn += static_cast<Real>(turn);
    PlaceParts(member);
  }
}

float CCrowdSolver::PushTouchesApart(const SCrowdRange& range) {
  float deepest = 0.0F;
  for (UInt32 i = range.First; i < range.End; ++i) {
    const auto& pair = m_clusters->GetTouches()[i];
    SSeparation points[2];
    const int count = FindPoints(pair, 0.0F, points);
    const auto isDeep = [this](const SSeparation& point) {
      return point.Gap < -static_cast<Real>(m_tolerance);
    };
    // two points share the push: both act on one face
    const auto numDeep = static_cast<Real>(std::count_if(points, points + count, isDeep));
    for (int point = 0; point < count; ++point) {
      if (isDeep(points[point])) {
        deepest = std::max(deepest, static_cast<float>(-points[point].Gap));
        PushPoint(pair, points[point], 1.0 / numDeep);
      }
    }
  }
  return deepest;
}

// Bodies that friction holds stay where they are, unless both do. @param share  of the overlap.
void CCrowdSolver::PushPoint(const CCrowdClusters::STouch& pair, const SSeparation& point,
                             Real share) {
  struct SPushed {
    UInt32 Member;
    Real Lever, InverseMass, InverseInertia;
  };
  Real give = 0.0;
  const auto prepare = [&](UInt32 member, bool isHeld) {
    SPushed body = {member, 0.0, 0.0, 0.0};
    if (member != CCrowdSolids::kNone && !isHeld) {
      const Real x = m_tick.Period.X.Shorten(point.PointX - m_positions[member].X);
      const Real y = m_tick.Period.Y.Shorten(point.PointY - m_positions[member].Y);
      body.Lever = x * point.NormalY - y * point.NormalX;
      body.InverseMass = static_cast<Real>(m_discs[member].InverseMass);
      body.InverseInertia =
          IsSolid(member) ? static_cast<Real>(m_discs[member].InverseInertia) : 0.0;
      give += body.InverseMass + body.InverseInertia * body.Lever * body.Lever;
    }
    return body;
  };
  const auto isHeld = [this](UInt32 member) {
    return member == CCrowdSolids::kNone ||
           (m_drives[member].IsFriction && m_drives[member].HoldsPlace() &&
            m_drives[member].HoldsYaw());
  };
  const bool areHeld = isHeld(pair.A) && isHeld(pair.B);
  const SPushed a = prepare(pair.A, !areHeld && isHeld(pair.A));
  const SPushed b = prepare(pair.B, !areHeld && isHeld(pair.B));
  if (!(give > 0.0)) {
    return;
  }
  const Real push =
      share * std::min(-point.Gap, kMaxCrowdCorrection * m_tick.SmallestRadius) / give;
  for (const auto& [body, sign] : {std::pair(a, -1.0), std::pair(b, 1.0)}) {
    if (body.Member != CCrowdSolids::kNone && body.InverseMass > 0.0) {
      Push(body.Member, sign * push * body.InverseMass * point.NormalX,
           sign * push * body.InverseMass * point.NormalY);
      if (IsSolid(body.Member)) {
        m_positions[body.Member].Turn += sign * push * body.InverseInertia * body.Lever;
        PlaceParts(body.Member);
      }
    }
  }
}

CTouchMemory::SKey CCrowdSolver::MakeKey(UInt32 number, UInt32 point) const {
  const CCrowdClusters::STouch& touch = m_clusters->GetTouches()[number];
  UInt32 parts = point;
  const auto nameOf = [&](UInt32 member, UInt32 part) {
    if (member == CCrowdSolids::kNone) {
      return part;
    }
    if (!IsSolid(member)) {
      return m_clusters->GetMembers()[member].Number;
    }
    const CCrowdSolids::SSolid& solid = GetSolid(member);
    parts = (parts << kPartBits) + part - solid.FirstPart;
    return solid.Slot | kSolidBit | (solid.Kind == EPlanarKind::Driven ? kDrivenBit : 0);
  };
  CTouchMemory::SKey key{};
  key.A = nameOf(touch.A, touch.PartA);
  key.B = nameOf(touch.B, touch.PartB);
  key.Parts = parts;
  return key;
}

void CCrowdSolver::LookUpTouchForces(CThreadPool& pool, const CTouchMemory& memory) {
  const size_t count = m_clusters->GetTouches().size();
  m_touches.resize(2 * count);
  m_touchForces.assign(2 * count, SContactForce());
  if (!memory.IsEmpty()) {
    pool.ParallelFor(count, kTouchGrain, [&](size_t begin, size_t end, UInt32) {
      for (size_t i = begin; i < end; ++i) {
        for (UInt32 point = 0; point < 2; ++point) {
          m_touchForces[2 * i + point] = memory.Find(MakeKey(static_cast<UInt32>(i), point));
        }
      }
    });
  }
}

void CCrowdSolver::RememberTouches(CTouchMemory& memory) const {
  memory.Clear();
  for (UInt32 i = 0; i < m_touchForces.size(); ++i) {
    const bool isOfTick = m_clusters->GetTouches()[i / 2].B == CCrowdSolids::kNone &&
                          m_clusters->GetTouches()[i / 2].PartB >= CCrowdSolids::kFirstOfTick;
    if (m_touchForces[i].Normal > 0.0F && !isOfTick) {
      memory.Collect(MakeKey(i / 2, i % 2), m_touchForces[i]);
    }
  }
  memory.Finish();
}

}  // namespace argos
