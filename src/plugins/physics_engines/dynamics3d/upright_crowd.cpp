#include <argos3/plugins/simulator/physics_engines/dynamics3d/upright_crowd.h>

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// pairs, islands and bodies that a thread takes together; pairs for which threads are worth their
// start
constexpr size_t kPairGrain = 256;
constexpr size_t kIslandGrain = 8;
constexpr size_t kManyPairs = 512;
// a contact matters if it may occur within that many substeps at the present speeds, or is nearer
// than this, m: drives and other contacts change speeds
constexpr Real kUprightForesight = 1.5;
constexpr Real kNearContact = 1e-3;

// Of small islands until they converge; the next substep goes on with large ones.
UInt32 ChooseUprightSweeps(size_t contacts) {
  const size_t most = kMaxUprightContactSweeps / std::max<size_t>(contacts, 1);
  return static_cast<UInt32>(std::clamp<size_t>(most, kFewUprightSweeps, kMaxUprightSweeps));
}

// Of islands with bodies of unequal masses.
UInt32 ChooseUnequalSweeps(size_t contacts) {
  const size_t most = kMaxUnequalContactSweeps / std::max<size_t>(contacts, 1);
  return static_cast<UInt32>(std::clamp<size_t>(most, kFewUnequalSweeps, kMaxUnequalSweeps));
}

bool IsAtRest(const SUprightBody& body) {
  return body.VX == 0.0 && body.VY == 0.0 && body.W == 0.0;
}

}  // namespace

template <typename VISIT>
void CUprightCrowd::ForEach(CThreadPool* pool, size_t count, size_t grain, VISIT&& visit) {
  const auto run = [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      visit(i);
    }
  };
  if (pool != nullptr) {
    pool->ParallelFor(count, grain, run);
  } else {
    run(0, count, 0);
  }
}

bool CUprightCrowd::Step(Real substep, CThreadPool* pool) {
  CThreadPool* const threads = m_pairs.size() >= kManyPairs ? pool : nullptr;
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    if (m_isOut[i] == 0) {
      StartUprightSubstep(m_bodies[i], m_supports.data() + m_bodies[i].FirstSupport, *m_ground,
                          substep);
    }
  }
  m_contacts.resize(2 * m_pairs.size());
  m_numContacts.assign(m_pairs.size(), 0);
  ForEach(threads, m_pairs.size(), kPairGrain, [&](size_t pair) {
    if (m_isOut[m_pairs[pair].A] == 0) {
      FindContacts(static_cast<UInt32>(pair), substep);
    }
  });
  SortIntoIslands();
  ForEach(threads, m_islands.size(), kIslandGrain,
          [&](size_t island) { SolveIsland(m_islands[island], substep); });
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    if (m_isOut[i] == 0 && RunsAway(m_bodies[i], substep)) {
      m_tips[i] = std::max<UInt8>(m_tips[i], 1);
    }
  }
  const bool givesBack = GiveBack();
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    if (m_isOut[i] == 0 && !IsAtRest(m_bodies[i])) {
      Move(m_bodies[i], substep);
      PlaceParts(m_bodies[i], m_bodies[i].OffsetX, m_bodies[i].OffsetY);
    }
  }
  return givesBack;
}

void CUprightCrowd::FindContacts(UInt32 number, Real substep) {
  SPair& pair = m_pairs[number];
  const SUprightBody& a = m_bodies[pair.A];
  Real x = a.VX;
  Real y = a.VY;
  Real rim = std::abs(a.W) * a.Sweep;
  if (pair.B != kNone) {
    const SUprightBody& b = m_bodies[pair.B];
    x -= b.VX;
    y -= b.VY;
    rim += std::abs(b.W) * b.Sweep;
  }
  const SFootprint& own = m_footprints[pair.PartA];
  const SFootprint& other =
      pair.B != kNone ? m_footprints[pair.PartB] : m_fixedFootprints[pair.PartB];
  const Real near = kNearContact + kUprightForesight * substep * (std::sqrt(x * x + y * y) + rim);
  if (own.Radius > 0.0 && other.Radius > 0.0) {
    const Real dx = own.X - other.X;
    const Real dy = own.Y - other.Y;
    const Real reach = own.Radius + other.Radius + near;
    if (dx * dx + dy * dy > reach * reach) {
      pair.Normals = pair.Tangents = {};
      return;
    }
  }
  SSeparation points[2];
  const int count = ::argos::FindContacts(own, other, points);
  for (UInt32 i = 0; i < 2; ++i) {
    if (i < static_cast<UInt32>(count) && points[i].Gap + pair.Margin <= near) {
      AddContact(number, i, points[i], substep);
    } else {
      pair.Normals[i] = pair.Tangents[i] = 0.0;
    }
  }
}

void CUprightCrowd::AddContact(UInt32 number, UInt32 point, const SSeparation& at, Real substep) {
  const SPair& pair = m_pairs[number];
  SUprightContact& contact = m_contacts[2 * number + m_numContacts[number]++];
  contact.A = pair.A;
  contact.B = pair.B;
  contact.Source = 2 * number + point;
  contact.NX = at.NormalX;
  contact.NY = at.NormalY;
  const Real gap = at.Gap + pair.Margin;
  const auto lever = [&](const SUprightBody& body, Real back, Real& normal, Real& tangent) {
    const Real armX = at.PointX - back * at.NormalX - body.Pose.X;
    const Real armY = at.PointY - back * at.NormalY - body.Pose.Y;
    normal = armX * at.NormalY - armY * at.NormalX;
    tangent = armX * at.NormalX + armY * at.NormalY;
  };
  lever(m_bodies[pair.A], at.Gap, contact.NormalLeverA, contact.TangentLeverA);
  if (pair.B != kNone) {
    lever(m_bodies[pair.B], 0.0, contact.NormalLeverB, contact.TangentLeverB);
  }
  contact.Approach = gap / substep;
  if (gap < 0.0) {
    const Real depth = std::max(0.0, -gap - m_settings.SurfaceLayer);
    contact.Approach =
        -std::min(m_settings.ErrorReduction * depth / substep, m_settings.MaxCorrectingSpeed);
  }
  contact.Friction = pair.Friction;
  contact.Low = pair.Low;
  contact.High = pair.High;
  contact.Normal = pair.Normals[point] * substep;
  contact.Tangent = pair.Tangents[point] * substep;
}

// Bodies at rest without contacts are in no island.
void CUprightCrowd::SortIntoIslands() {
  const UInt32 count = static_cast<UInt32>(m_bodies.size());
  ResetForest(m_islandOf, count);
  m_islandNumber.assign(count, kNone);
  for (UInt32 pair = 0; pair < m_pairs.size(); ++pair) {
    const SPair& of = m_pairs[pair];
    if (m_numContacts[pair] == 0) {
      continue;
    }
    // marks the island as one with contacts
    m_islandNumber[of.A] = 0;
    if (of.B != kNone) {
      m_islandNumber[of.B] = 0;
      Connect(m_islandOf, of.A, of.B);
    }
  }
  m_islands.clear();
  for (UInt32 i = 0; i < count; ++i) {
    const bool isOfObject = m_bodies[i].Kind == SUprightBody::EKind::Object;
    const bool rests = m_islandNumber[i] == kNone && isOfObject && IsAtRest(m_bodies[i]);
    const UInt32 root = FindRootOf(m_islandOf, i);
    if (m_isOut[i] != 0 || rests) {
      m_islandNumber[i] = kNone;
      continue;
    }
    if (root == i) {
      m_islandNumber[i] = static_cast<UInt32>(m_islands.size());
      m_islands.emplace_back();
    }
    ++m_islands[m_islandNumber[root]].EndBody;
  }
  for (UInt32 pair = 0; pair < m_pairs.size(); ++pair) {
    if (m_numContacts[pair] > 0) {
      m_islands[m_islandNumber[FindRootOf(m_islandOf, m_pairs[pair].A)]].EndContact +=
          m_numContacts[pair];
    }
  }
  FillIslands();
}

// From numbers to ranges of the lists, which are filled in the order of bodies and pairs.
void CUprightCrowd::FillIslands() {
  UInt32 bodies = 0;
  UInt32 contacts = 0;
  for (SIsland& island : m_islands) {
    const UInt32 numBodies = island.EndBody;
    const UInt32 numContacts = island.EndContact;
    island = {bodies, bodies, contacts, contacts};
    bodies += numBodies;
    contacts += numContacts;
  }
  m_bodyOrder.resize(bodies);
  m_contactOrder.resize(contacts);
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    const UInt32 number = m_isOut[i] == 0 ? m_islandNumber[FindRootOf(m_islandOf, i)] : kNone;
    if (number != kNone) {
      m_bodyOrder[m_islands[number].EndBody++] = i;
    }
  }
  for (UInt32 pair = 0; pair < m_pairs.size(); ++pair) {
    for (UInt32 i = 0; i < m_numContacts[pair]; ++i) {
      SIsland& island = m_islands[m_islandNumber[FindRootOf(m_islandOf, m_pairs[pair].A)]];
      m_contactOrder[island.EndContact++] = 2 * pair + i;
    }
  }
}

// the heaviest body over the lightest one
Real CUprightCrowd::MeasureUnequal(std::span<const UInt32> bodies) const {
  Real heaviest = 0.0;
  Real lightest = HUGE_VAL;
  for (const UInt32 number : bodies) {
    heaviest = std::max(heaviest, m_bodies[number].Mass);
    lightest = std::min(lightest, m_bodies[number].Mass);
  }
  return heaviest / lightest;
}

void CUprightCrowd::SolveIsland(const SIsland& island, Real substep) {
  CUprightSolver solver(m_bodies, m_supports, m_contacts);
  const CUprightSolver::SIsland of{
      {m_bodyOrder.data() + island.FirstBody, island.EndBody - island.FirstBody},
      {m_contactOrder.data() + island.FirstContact, island.EndContact - island.FirstContact}};
  solver.Prepare(of);
  const bool isSmall = of.Contacts.size() <= kSmallUprightIsland;
  const Real unequal = MeasureUnequal(of.Bodies);
  if (unequal > kUnequalMasses) {
    solver.Solve(of, ChooseUnequalSweeps(of.Contacts.size()), kUprightTolerance / unequal);
  } else {
    solver.Solve(of, ChooseUprightSweeps(of.Contacts.size()),
                 isSmall ? kUprightTolerance : kUprightCrowdTolerance);
  }
  for (const UInt32 number : of.Contacts) {
    const SUprightContact& contact = m_contacts[number];
    SPair& pair = m_pairs[contact.Source / 2];
    pair.Normals[contact.Source % 2] = contact.Normal / substep;
    pair.Tangents[contact.Source % 2] = contact.Tangent / substep;
    const Real x = contact.Normal * contact.NX - contact.Tangent * contact.NY;
    const Real y = contact.Normal * contact.NY + contact.Tangent * contact.NX;
    const auto add = [&](SUprightBody& body, Real sign) {
      body.LowX += sign * x * contact.Low;
      body.LowY += sign * y * contact.Low;
      body.HighX += sign * x * contact.High;
      body.HighY += sign * y * contact.High;
      if (contact.Normal > 0.0) {
        body.Highest = std::max(body.Highest, contact.Low);
        body.Lowest = std::min(body.Lowest, contact.High);
      }
    };
    add(m_bodies[contact.A], -1.0);
    if (contact.B != kNone) {
      add(m_bodies[contact.B], 1.0);
    }
  }
  for (const UInt32 number : of.Bodies) {
    SUprightBody& body = m_bodies[number];
    if (!BalanceUpright(body, m_supports.data() + body.FirstSupport, *m_ground, substep)) {
      m_tips[number] = 2;
    }
  }
}

// May the body leave the area in which it was expected to meet others?
bool CUprightCrowd::RunsAway(const SUprightBody& body, Real substep) const {
  const Real x = body.WayX + body.VX * substep;
  const Real y = body.WayY + body.VY * substep;
  const Real turned = body.Turned + std::abs(body.W) * substep;
  const Real way = std::sqrt(x * x + y * y);
  return (body.Kind != SUprightBody::EKind::Object && way > m_reach) ||
         way + turned * body.Sweep > GetReachOf(body.Sweep == 0.0);
}

// @return true if there are clusters that are not solved here any more.
bool CUprightCrowd::GiveBack() {
  bool any = false;
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    if (m_tips[i] != 0) {
      any = true;
      if (m_tips[i] == 2) {
        m_bodies[i].Rigid->TippingTime = kTippingTime;
      }
      UInt8& ofRoot = m_tips[FindRootOf(m_clusters, i)];
      ofRoot = std::max<UInt8>(ofRoot, 1);
    }
  }
  for (UInt32 i = 0; any && i < m_bodies.size(); ++i) {
    if (m_isOut[i] != 0 || m_tips[FindRootOf(m_clusters, i)] == 0) {
      continue;
    }
    SUprightBody& body = m_bodies[i];
    body.VX = body.StartX;
    body.VY = body.StartY;
    body.W = body.StartW;
    for (UInt32 j = 0; j < body.NumSupports; ++j) {
      SUprightSupport& support = m_supports[body.FirstSupport + j];
      support.Spin = body.Kind == SUprightBody::EKind::Wheels ? support.StartSpin : 0.0;
    }
    if (body.WayX != 0.0 || body.WayY != 0.0 || body.Turned != 0.0 || !body.Rigid->Asleep) {
      WakeRigidBody(*body.Rigid);
      StoreUpright(body, m_supports);
    }
    body.Rigid->IsUpright = false;
    m_isOut[i] = 1;
  }
  if (any) {
    std::fill(m_tips.begin(), m_tips.end(), UInt8(0));
  }
  return any;
}

void CUprightCrowd::Move(SUprightBody& body, Real substep) const {
  const Real x = body.VX * substep;
  const Real y = body.VY * substep;
  body.Pose.X += x;
  body.Pose.Y += y;
  body.WayX += x;
  body.WayY += y;
  if (body.W != 0.0) {
    const Real half = 0.5 * body.W * substep;
    Turn(body.Pose, std::cos(half), std::sin(half));
    body.Turned += std::abs(2.0 * half);
  }
}

// A cluster sleeps when all its bodies have been slow for a while.
void CUprightCrowd::EndTick() {
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    if (m_isOut[i] != 0) {
      continue;
    }
    SUprightBody& body = m_bodies[i];
    SRigidBody& rigid = *body.Rigid;
    const bool moves = !IsAtRest(body) || body.WayX != 0.0 || body.WayY != 0.0 ||
                       body.Turned != 0.0 || body.LeanX != 0.0 || body.LeanY != 0.0;
    if (moves) {
      if (rigid.Asleep) {
        WakeRigidBody(rigid);
      }
      StoreUpright(body, m_supports);
    }
    const bool isSlow = std::hypot(body.VX, body.VY) < kQuietSpeed && std::abs(body.W) < kQuietTurn;
    rigid.QuietTime = isSlow ? rigid.QuietTime + m_settings.Tick : 0.0;
    if (rigid.QuietTime < kQuietTime) {
      m_tips[FindRootOf(m_clusters, i)] = 1;
    }
  }
  for (UInt32 i = 0; m_settings.Sleep && i < m_bodies.size(); ++i) {
    if (m_isOut[i] == 0 && m_tips[FindRootOf(m_clusters, i)] == 0 && !m_bodies[i].Rigid->Asleep) {
      PutToSleep(*m_bodies[i].Rigid);
    }
  }
}

}  // namespace argos
