#include <argos3/plugins/simulator/physics_engines/kinematics2d/push_solver.h>

#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// N; assumed where no body has friction or a drive
constexpr Real kMinForce = 1e-3;
// greatest change of targets after which the last solution helps, and greatest motion of what is
// held, as shares of the greatest motion
constexpr Real kSameTarget = 0.01;
constexpr Real kHeld = 1e-3;

STwist ToTwist(const Real* values) {
  return {values[kAxisX], values[kAxisY], values[kAxisTurn]};
}

}  // namespace

// The motion of the pushed body along the normal, relative to the pushing one, as their targets
// are, m.
Real CPushSolver::ComputePlannedMotion(const SContact& contact) const {
  const STwist& pushed = m_bodies[contact.Pushed].Target;
  Real moved = Dot(contact.Normal, pushed.GetStep()) + contact.LeverPushed * pushed.Turn;
  if (contact.Pushing != kNone) {
    const STwist& pushing = m_bodies[contact.Pushing].Target;
    moved -= Dot(contact.Normal, pushing.GetStep()) + contact.LeverPushing * pushing.Turn;
  }
  return moved;
}

void CPushSolver::Clear() {
  m_bodies.clear();
  m_parents.clear();
  m_contacts.clear();
  m_contactsByKey.clear();
  m_isRecalled = false;
}

UInt32 CPushSolver::AddBody(const STwist& target, Real force, Real torque, Real squaredGyration,
                            UInt32 key) {
  const auto number = static_cast<UInt32>(m_bodies.size());
  SBody& body = m_bodies.emplace_back();
  body.Key = key;
  body.Target = body.Twist = target;
  body.Force = force;
  body.Torque = torque;
  body.SquaredGyration = squaredGyration;
  m_parents.push_back(number);
  return number;
}

// Lists all contacts by the keys of their bodies, and then by numbers.
void CPushSolver::ListContacts() {
  m_contactsByKey.clear();
  for (UInt32 i = 0; i < m_contacts.size(); ++i) {
    const SRequirement& contact = m_contacts[i];
    const UInt64 pushing = contact.Pushing != kNone ? m_bodies[contact.Pushing].Key : kNone;
    m_contactsByKey.push_back({pushing << 32 | m_bodies[contact.Pushed].Key, i, 0.0});
  }
  std::sort(m_contactsByKey.begin(), m_contactsByKey.end(),
            [](const SKnownContact& a, const SKnownContact& b) {
              return a.Bodies != b.Bodies ? a.Bodies < b.Bodies : a.Number < b.Number;
            });
}

void CPushSolver::Remember() {
  m_knownBodies.clear();
  for (const SBody& body : m_bodies) {
    if (body.Key != kNone) {
      m_knownBodies.push_back({body.Key, body.NumContacts, body.Target, body.Twist, body.Used});
    }
  }
  std::sort(m_knownBodies.begin(), m_knownBodies.end(),
            [](const SKnownBody& a, const SKnownBody& b) { return a.Key < b.Key; });
  if (m_contactsByKey.size() != m_contacts.size()) {
    ListContacts();
  }
  for (SKnownContact& contact : m_contactsByKey) {
    contact.Force = m_contacts[contact.Number].Force;
  }
  std::swap(m_knownContacts, m_contactsByKey);
}

// @return its place in the list of known bodies, kNone if it is not in it.
UInt32 CPushSolver::FindKnown(UInt32 key) const {
  const auto known =
      std::lower_bound(m_knownBodies.begin(), m_knownBodies.end(), key,
                       [](const SKnownBody& body, UInt32 searched) { return body.Key < searched; });
  return known != m_knownBodies.end() && known->Key == key
             ? static_cast<UInt32>(known - m_knownBodies.begin())
             : kNone;
}

void CPushSolver::Recall() {
  if (m_isRecalled || m_knownBodies.empty()) {
    return;
  }
  m_isRecalled = true;
  for (SBody& body : m_bodies) {
    body.Known = FindKnown(body.Key);
  }
  RecallContacts();
}

// Contacts of the same bodies are told apart by the order in which they were added.
void CPushSolver::RecallContacts() {
  ListContacts();
  auto known = m_knownContacts.begin();
  for (const SKnownContact& contact : m_contactsByKey) {
    while (known != m_knownContacts.end() && known->Bodies < contact.Bodies) {
      ++known;
    }
    if (known != m_knownContacts.end() && known->Bodies == contact.Bodies) {
      m_contacts[contact.Number].KnownForce = known->Force;
      ++known;
    }
  }
}

UInt32 CPushSolver::AddContact(const SContact& contact) {
  CheckNumber(contact.Pushed);
  if (contact.Pushing != kNone) {
    CheckNumber(contact.Pushing);
    Connect(m_parents, contact.Pushing, contact.Pushed);
  }
  for (const UInt32 side : {contact.Pushing, contact.Pushed}) {
    if (side != kNone) {
      ++m_bodies[side].NumContacts;
    }
  }
  m_contacts.push_back({contact});
  return static_cast<UInt32>(m_contacts.size() - 1);
}

const CPushSolver::SContact& CPushSolver::GetContact(UInt32 contact) const {
  CheckContact(contact);
  return m_contacts[contact];
}

void CPushSolver::SetContact(UInt32 contact, const SContact& replacement) {
  CheckContact(contact);
  static_cast<SContact&>(m_contacts[contact]) = replacement;
}

void CPushSolver::SortByIslands() {
  m_bodyOrder.clear();
  m_contactOrder.clear();
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    m_bodyOrder.push_back({FindRootOf(m_parents, i), i});
  }
  for (UInt32 i = 0; i < m_contacts.size(); ++i) {
    m_contactOrder.push_back({FindRootOf(m_parents, m_contacts[i].Pushed), i});
  }
  for (std::vector<SMember>* const order : {&m_bodyOrder, &m_contactOrder}) {
    // as where there is one island
    if (!std::is_sorted(order->begin(), order->end())) {
      std::sort(order->begin(), order->end());
    }
  }
}

// @param body,contact  the first ones of the island; then those behind it.
CPushSolver::SIsland CPushSolver::TakeIsland(size_t& body, size_t& contact) const {
  const UInt32 root = m_bodyOrder[body].Root;
  const auto bodies = TakeTree(m_bodyOrder, root, body);
  return {bodies, TakeTree(m_contactOrder, root, contact), 0.0};
}

// @return the number of sweeps.
UInt32 CPushSolver::Iterate(const SIsland& island, UInt32 mostSweeps) {
  const Real tolerance = kPushTolerance * island.Need;
  const UInt32 sweeps =
      CPushParts::IsLarge(m_islandBodies)
          ? m_parts.Solve(m_islandBodies, m_islandContacts, tolerance, mostSweeps)
          : CContactIsland<Real>(m_islandBodies, m_islandContacts).Solve(tolerance, mostSweeps);
  for (size_t i = 0; i < island.Bodies.size(); ++i) {
    const SIslandBody<Real>& moved = m_islandBodies[i];
    SBody& body = m_bodies[island.Bodies[i].Number];
    body.Twist = ToTwist(moved.Velocity.Now);
    body.Used = ToTwist(moved.Impulse.Now);
  }
  for (size_t i = 0; i < island.Contacts.size(); ++i) {
    m_contacts[island.Contacts[i].Number].Force = m_islandContacts[i].Impulse.Now[kAxisNormal];
  }
  return sweeps;
}

// The mass of a body is free to choose. It is so large that a small share of the strongest drive,
// at each of its contacts, would accelerate the body from rest to the greatest need: then few
// sweeps are necessary also where many robots touch one object.
// @return false if nothing pushes.
bool CPushSolver::Prepare(SIsland& island) {
  Real drive = 0.0;
  Real friction = kMinForce;
  for (const SMember& member : island.Bodies) {
    SBody& body = m_bodies[member.Number];
    const bool isDriven = body.Target.X != 0.0 || body.Target.Y != 0.0 || body.Target.Turn != 0.0;
    Real& strongest = isDriven ? drive : friction;
    strongest = std::max(strongest, body.Force);
    body.Start = body.Twist;
    body.Give = body.TurnGive = 0.0;
  }
  Real need = 0.0;
  for (const SMember& member : island.Contacts) {
    const SRequirement& contact = m_contacts[member.Number];
    need = std::max(need, contact.Least - ComputePlannedMotion(contact));
    CountContact(contact.Pushed, contact.LeverPushed);
    if (contact.Pushing != kNone) {
      CountContact(contact.Pushing, contact.LeverPushing);
    }
  }
  island.Need = need;
  if (!(need > 0.0)) {
    return false;
  }
  if (IsKnown(island)) {
    StartFromKnown(island);
  }
  SetUp(island, need / (kPushSlack * (drive > 0.0 ? drive : friction)));
  return true;
}

// @return true if it is as in the last solution, in which nothing was pushed on.
bool CPushSolver::IsKnown(const SIsland& island) const {
  return std::all_of(island.Bodies.begin(), island.Bodies.end(),
                     [&](const SMember& member) {
                       return WasHeld(m_bodies[member.Number], island.Need);
                     }) &&
         std::all_of(island.Contacts.begin(), island.Contacts.end(), [&](const SMember& member) {
           return m_contacts[member.Number].KnownForce >= 0.0;
         });
}

// For bodies that were pushed on, the last solution is no initial guess: their contacts have
// turned, and if the sweeps did not converge, the next solution would continue the error.
bool CPushSolver::WasHeld(const SBody& body, Real need) const {
  if (body.Known == kNone) {
    return false;
  }
  const SKnownBody& known = m_knownBodies[body.Known];
  const auto computeLength = [&body](Real x, Real y, Real turn) {
    return std::hypot(x, y) + std::abs(turn) * std::sqrt(body.SquaredGyration);
  };
  const Real moved = computeLength(known.Twist.X, known.Twist.Y, known.Twist.Turn);
  const Real change = computeLength(known.Target.X - body.Target.X, known.Target.Y - body.Target.Y,
                                    known.Target.Turn - body.Target.Turn);
  return known.NumContacts == body.NumContacts && moved <= kHeld * need &&
         change <= kSameTarget * need;
}

void CPushSolver::StartFromKnown(const SIsland& island) {
  for (const SMember& member : island.Bodies) {
    SBody& body = m_bodies[member.Number];
    const SKnownBody& known = m_knownBodies[body.Known];
    body.Start = body.Twist = known.Twist;
    body.Used = known.Used;
  }
  for (const SMember& member : island.Contacts) {
    SRequirement& contact = m_contacts[member.Number];
    contact.Force = contact.KnownForce;
  }
}

// The "velocities" of the island are motions in the tick, its "impulses" forces.
void CPushSolver::SetUp(const SIsland& island, Real give) {
  m_islandBodies.clear();
  for (const SMember& member : island.Bodies) {
    SBody& body = m_bodies[member.Number];
    const Real count = std::max(1.0, body.Give);
    body.TurnGive = body.Torque == kUnlimited
                        ? 0.0
                        : give / std::max(count * body.SquaredGyration, body.TurnGive);
    body.Give = give / count;
    body.Place = static_cast<UInt32>(m_islandBodies.size());
    SIslandBody<Real>& moved = m_islandBodies.emplace_back();
    moved.Velocity.Set({body.Twist.X, body.Twist.Y, body.Twist.Turn});
    moved.Impulse.Set({body.Used.X, body.Used.Y, body.Used.Turn});
    moved.Target[kAxisX] = body.Target.X;
    moved.Target[kAxisY] = body.Target.Y;
    moved.Target[kAxisTurn] = body.Target.Turn;
    moved.Most = body.Force;
    moved.InverseMass = body.Give;
    moved.Mass = 1.0 / body.Give;
    if (body.TurnGive > 0.0) {
      moved.AngularMost = body.Torque;
      moved.InverseInertia = body.TurnGive;
      moved.Inertia = 1.0 / body.TurnGive;
    }
  }
  m_islandBodies.emplace_back();
  SetUpContacts(island);
}

void CPushSolver::SetUpContacts(const SIsland& island) {
  const auto obstacle = static_cast<UInt32>(m_islandBodies.size() - 1);
  m_islandContacts.clear();
  for (const SMember& member : island.Contacts) {
    const SRequirement& contact = m_contacts[member.Number];
    SIslandContact<Real>& touch = m_islandContacts.emplace_back();
    touch.Impulse.Set({contact.Force, 0.0});
    touch.NX = contact.Normal.X;
    touch.NY = contact.Normal.Y;
    touch.Approach = -contact.Least;
    touch.A = contact.Pushing != kNone ? m_bodies[contact.Pushing].Place : obstacle;
    touch.B = m_bodies[contact.Pushed].Place;
    touch.NormalLeverA = contact.LeverPushing;
    touch.NormalLeverB = contact.LeverPushed;
    const auto add = [&touch](const SIslandBody<Real>& body, Real lever) {
      touch.InverseMass += body.InverseMass + lever * lever * body.InverseInertia;
    };
    add(m_islandBodies[touch.A], touch.NormalLeverA);
    add(m_islandBodies[touch.B], touch.NormalLeverB);
    touch.Mass = 1.0 / touch.InverseMass;
  }
}

// Before the compliances of a body are known, they hold the number of its contacts and the sum of
// the squares of their levers.
void CPushSolver::CountContact(UInt32 body, Real lever) {
  m_bodies[body].Give += 1.0;
  m_bodies[body].TurnGive += lever * lever;
}

bool CPushSolver::IsSteady(const SIsland& island, Real share) const {
  return std::all_of(island.Bodies.begin(), island.Bodies.end(), [&](const SMember& member) {
    const SBody& body = m_bodies[member.Number];
    const Real change =
        std::hypot(body.Twist.X - body.Start.X, body.Twist.Y - body.Start.Y) +
        std::abs(body.Twist.Turn - body.Start.Turn) * std::sqrt(body.SquaredGyration);
    return change <= share * island.Need;
  });
}

// All forces stay. Where a lever becomes shorter as a body turns, the torque of the contact holds
// the body against turning on: without that, the motion would change to and fro between turning and
// sliding, where it should be something of both.
// @param massShare  of its mass that a body keeps.
void CPushSolver::Restart(const SIsland& island, Real massShare) {
  for (const SMember& member : island.Bodies) {
    m_bodies[member.Number].Bend = 0.0;
  }
  for (const SMember& member : island.Contacts) {
    const SRequirement& contact = m_contacts[member.Number];
    m_bodies[contact.Pushed].Bend += contact.Force * std::max(0.0, -contact.BendPushed);
    if (contact.Pushing != kNone) {
      m_bodies[contact.Pushing].Bend += contact.Force * std::max(0.0, contact.BendPushing);
    }
  }
  for (const SMember& member : island.Bodies) {
    SBody& body = m_bodies[member.Number];
    SIslandBody<Real>& moved = m_islandBodies[body.Place];
    moved.Mass = massShare / body.Give;
    moved.InverseMass = 1.0 / moved.Mass;
    if (body.TurnGive > 0.0) {
      moved.Inertia = massShare / body.TurnGive + body.Bend;
      moved.InverseInertia = 1.0 / moved.Inertia;
    }
    body.Start = body.Twist;
    moved.Velocity.Set({body.Twist.X + moved.InverseMass * body.Used.X,
                        body.Twist.Y + moved.InverseMass * body.Used.Y,
                        body.Twist.Turn + moved.InverseInertia * body.Used.Turn});
  }
  SetUpContacts(island);
  for (SIslandContact<Real>& contact : m_islandContacts) {
    const Real force = contact.Impulse.Now[kAxisNormal];
    contact.Impulse.Now[kAxisNormal] = 0.0;
    ChangeImpulse(m_islandBodies[contact.A], m_islandBodies[contact.B], contact, force, 0.0);
  }
}

// All forces stay, so that bodies first go on to change as before.
void CPushSolver::StartFromResult(const SIsland& island) {
  for (const SMember& member : island.Bodies) {
    SBody& body = m_bodies[member.Number];
    const STwist& twist = body.Twist;
    Real* const moved = m_islandBodies[body.Place].Velocity.Now;
    moved[kAxisX] += twist.X - body.Start.X;
    moved[kAxisY] += twist.Y - body.Start.Y;
    moved[kAxisTurn] += twist.Turn - body.Start.Turn;
    body.Start = twist;
  }
}

}  // namespace argos
