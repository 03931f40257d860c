#include <argos3/plugins/simulator/physics_engines/kinematics2d/push_solver.h>

#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// N; assumed where no body has friction or a drive
constexpr Real kLeastForce = 1e-3;

}  // namespace

// These are on the path of all sweeps.

inline void CPushSolver::Push(SBody& body, Real x, Real y, Real torque) {
  body.Twist.X += body.Give * x;
  body.Twist.Y += body.Give * y;
  body.Twist.Turn += body.TurnGive * torque;
}

// The motion of the pushed body along the normal, relative to the pushing one, m.
inline Real CPushSolver::ComputeMotion(const SContact& contact) const {
  const STwist& pushed = m_bodies[contact.Pushed].Twist;
  Real moved =
      contact.NormalX * pushed.X + contact.NormalY * pushed.Y + contact.LeverPushed * pushed.Turn;
  if (contact.Pushing != kNone) {
    const STwist& pushing = m_bodies[contact.Pushing].Twist;
    moved -= contact.NormalX * pushing.X + contact.NormalY * pushing.Y +
             contact.LeverPushing * pushing.Turn;
  }
  return moved;
}

inline void CPushSolver::AddForce(SForce& contact, Real change) {
  contact.Force += change;
  Push(m_bodies[contact.Pushed], change * contact.NormalX, change * contact.NormalY,
       change * contact.LeverPushed);
  if (contact.Pushing != kNone) {
    Push(m_bodies[contact.Pushing], -change * contact.NormalX, -change * contact.NormalY,
         -change * contact.LeverPushing);
  }
}

// @return the change, m.
inline Real CPushSolver::SolveContact(SForce& contact) {
  const Real force =
      std::max(0.0, contact.Force + (contact.Least - ComputeMotion(contact)) * contact.Mass);
  const Real change = force - contact.Force;
  AddForce(contact, change);
  return std::abs(change) * contact.Give;
}

// Friction, or a drive, exerts the force that makes the body move as its target, up to its bounds.
// @return the change, m.
inline Real CPushSolver::AimAtTarget(SBody& body) {
  Real change = 0.0;
  if (body.Force > 0.0) {
    Real x = body.Used.X - (body.Twist.X - body.Target.X) * body.Mass;
    Real y = body.Used.Y - (body.Twist.Y - body.Target.Y) * body.Mass;
    const Real squaredLength = x * x + y * y;
    if (squaredLength > body.Force * body.Force) {
      const Real scale = body.Force / std::sqrt(squaredLength);
      x *= scale;
      y *= scale;
    }
    change = body.Give * (std::abs(x - body.Used.X) + std::abs(y - body.Used.Y));
    Push(body, x - body.Used.X, y - body.Used.Y, 0.0);
    body.Used.X = x;
    body.Used.Y = y;
  }
  if (body.Torque > 0.0 && body.TurnGive > 0.0) {
    const Real torque =
        std::clamp(body.Used.Turn - (body.Twist.Turn - body.Target.Turn) / body.TurnGive,
                   -body.Torque, body.Torque);
    const Real added = torque - body.Used.Turn;
    change = std::max(change, body.TurnGive * std::abs(added) * std::sqrt(body.SquaredGyration));
    Push(body, 0.0, 0.0, added);
    body.Used.Turn = torque;
  }
  return change;
}

void CPushSolver::Clear() {
  m_bodies.clear();
  m_contacts.clear();
}

UInt32 CPushSolver::AddBody(const STwist& target, Real force, Real torque, Real squaredGyration) {
  const auto number = static_cast<UInt32>(m_bodies.size());
  SBody& body = m_bodies.emplace_back();
  body.Target = body.Twist = target;
  body.Force = force;
  body.Torque = torque;
  body.SquaredGyration = squaredGyration;
  body.Parent = number;
  return number;
}

void CPushSolver::AddContact(const SContact& contact) {
  CheckNumber(contact.Pushed);
  if (contact.Pushing != kNone) {
    CheckNumber(contact.Pushing);
    const UInt32 a = FindRoot(contact.Pushing);
    const UInt32 b = FindRoot(contact.Pushed);
    m_bodies[std::max(a, b)].Parent = std::min(a, b);
  }
  SForce& force = m_contacts.emplace_back();
  static_cast<SContact&>(force) = contact;
}

UInt32 CPushSolver::FindRoot(UInt32 body) {
  while (m_bodies[body].Parent != body) {
    m_bodies[body].Parent = m_bodies[m_bodies[body].Parent].Parent;
    body = m_bodies[body].Parent;
  }
  return body;
}

void CPushSolver::SortByIslands() {
  m_bodyOrder.clear();
  m_contactOrder.clear();
  for (UInt32 i = 0; i < m_bodies.size(); ++i) {
    m_bodyOrder.push_back({FindRoot(i), i});
  }
  for (UInt32 i = 0; i < m_contacts.size(); ++i) {
    m_contactOrder.push_back({FindRoot(m_contacts[i].Pushed), i});
  }
  std::sort(m_bodyOrder.begin(), m_bodyOrder.end());
  std::sort(m_contactOrder.begin(), m_contactOrder.end());
}

void CPushSolver::Solve() {
  SortByIslands();
  const auto takeIsland = [](const std::vector<SMember>& order, size_t first, UInt32 island) {
    size_t end = first;
    while (end < order.size() && order[end].Island == island) {
      ++end;
    }
    return std::span(order).subspan(first, end - first);
  };
  size_t contact = 0;
  for (size_t body = 0; body < m_bodyOrder.size();) {
    const UInt32 number = m_bodyOrder[body].Island;
    const SIsland island = {takeIsland(m_bodyOrder, body, number),
                            takeIsland(m_contactOrder, contact, number), 0.0};
    body += island.Bodies.size();
    contact += island.Contacts.size();
    if (!island.Contacts.empty()) {
      SolveIsland(island);
    }
  }
}

void CPushSolver::SolveIsland(SIsland island) {
  Prepare(island);
  if (!(island.Need > 0.0)) {
    return;
  }
  UInt32 sweeps = Iterate(island, kPushSweeps);
  while (sweeps < kPushSweeps && !IsSteady(island)) {
    StartFromResult(island);
    sweeps += Iterate(island, kPushSweeps - sweeps);
  }
}

// The mass of a body is free to choose. It is so large that a small share of the strongest drive,
// at each of its contacts, would accelerate the body from rest to the greatest need: then few
// sweeps are necessary also where many robots touch one object.
void CPushSolver::Prepare(SIsland& island) {
  Real drive = 0.0;
  Real friction = kLeastForce;
  for (const SMember& member : island.Bodies) {
    SBody& body = m_bodies[member.Number];
    const bool isDriven = body.Target.X != 0.0 || body.Target.Y != 0.0 || body.Target.Turn != 0.0;
    Real& strongest = isDriven ? drive : friction;
    strongest = std::max(strongest, body.Force);
    body.Start = body.Twist = body.Target;
    body.Used = body.Step = STwist();
    body.Give = body.TurnGive = 0.0;
  }
  for (const SMember& member : island.Contacts) {
    const SForce& contact = m_contacts[member.Number];
    island.Need = std::max(island.Need, contact.Least - ComputeMotion(contact));
    CountContact(contact.Pushed, contact.LeverPushed);
    if (contact.Pushing != kNone) {
      CountContact(contact.Pushing, contact.LeverPushing);
    }
  }
  const Real give = island.Need / (kPushSlack * (drive > 0.0 ? drive : friction));
  for (const SMember& member : island.Bodies) {
    SBody& body = m_bodies[member.Number];
    const Real count = std::max(1.0, body.Give);
    body.TurnGive = body.Torque == kUnlimited
                        ? 0.0
                        : give / std::max(count * body.SquaredGyration, body.TurnGive);
    body.Give = give / count;
    body.Mass = 1.0 / body.Give;
  }
  for (const SMember& member : island.Contacts) {
    SForce& contact = m_contacts[member.Number];
    const SBody& pushed = m_bodies[contact.Pushed];
    contact.Give = pushed.Give + contact.LeverPushed * contact.LeverPushed * pushed.TurnGive;
    if (contact.Pushing != kNone) {
      const SBody& pushing = m_bodies[contact.Pushing];
      contact.Give += pushing.Give + contact.LeverPushing * contact.LeverPushing * pushing.TurnGive;
    }
    contact.Mass = 1.0 / contact.Give;
    contact.Force = contact.Step = 0.0;
  }
}

// Before the compliances of a body are known, they hold the number of its contacts and the sum of
// the squares of their levers.
void CPushSolver::CountContact(UInt32 body, Real lever) {
  m_bodies[body].Give += 1.0;
  m_bodies[body].TurnGive += lever * lever;
}

// Finds forces that fit the start of all bodies. @return the number of sweeps.
UInt32 CPushSolver::Iterate(const SIsland& island, UInt32 mostSweeps) {
  // of an energy that counts as shrinking still
  constexpr Real kGrowth = 1.02;
  Real before = 0.0;
  for (UInt32 sweep = 1;; ++sweep) {
    Keep(island);
    // the last thing is a sweep, so that no force exceeds its bounds
    if (Sweep(island) <= kPushTolerance * island.Need || sweep == mostSweeps) {
      return sweep;
    }
    const Real energy = MeasureEnergy(island);
    // the method restarts if the energy of the change has grown
    StepOn(island, energy < kGrowth * before ? std::min(1.0, energy / before) : 0.0);
    before = energy;
  }
}

void CPushSolver::Keep(const SIsland& island) {
  for (const SMember& member : island.Bodies) {
    m_bodies[member.Number].Kept = m_bodies[member.Number].Used;
  }
  for (const SMember& member : island.Contacts) {
    m_contacts[member.Number].Kept = m_contacts[member.Number].Force;
  }
}

// Contacts are last, so that no overlap remains in the end. @return the greatest change, m.
Real CPushSolver::Sweep(const SIsland& island) {
  Real change = 0.0;
  for (const SMember& member : island.Bodies) {
    change = std::max(change, AimAtTarget(m_bodies[member.Number]));
  }
  for (const SMember& member : island.Contacts) {
    change = std::max(change, SolveContact(m_contacts[member.Number]));
  }
  return change;
}

// The sum of the squared changes of forces in a sweep, each times the compliance.
Real CPushSolver::MeasureEnergy(const SIsland& island) const {
  Real energy = 0.0;
  for (const SMember& member : island.Bodies) {
    const SBody& body = m_bodies[member.Number];
    const Real x = body.Used.X - body.Kept.X;
    const Real y = body.Used.Y - body.Kept.Y;
    const Real torque = body.Used.Turn - body.Kept.Turn;
    energy += body.Give * (x * x + y * y) + body.TurnGive * torque * torque;
  }
  for (const SMember& member : island.Contacts) {
    const SForce& contact = m_contacts[member.Number];
    energy += contact.Give * (contact.Force - contact.Kept) * (contact.Force - contact.Kept);
  }
  return energy;
}

// Makes the change of a sweep the direction, and adds a share of the direction before.
void CPushSolver::StepOn(const SIsland& island, Real share) {
  for (const SMember& member : island.Bodies) {
    SBody& body = m_bodies[member.Number];
    const STwist step = {share * body.Step.X, share * body.Step.Y, share * body.Step.Turn};
    body.Step = {step.X + body.Used.X - body.Kept.X, step.Y + body.Used.Y - body.Kept.Y,
                 step.Turn + body.Used.Turn - body.Kept.Turn};
    body.Used.X += step.X;
    body.Used.Y += step.Y;
    body.Used.Turn += step.Turn;
    Push(body, step.X, step.Y, step.Turn);
  }
  for (const SMember& member : island.Contacts) {
    SForce& contact = m_contacts[member.Number];
    const Real step = share * contact.Step;
    contact.Step = step + contact.Force - contact.Kept;
    AddForce(contact, step);
  }
}

bool CPushSolver::IsSteady(const SIsland& island) const {
  return std::all_of(island.Bodies.begin(), island.Bodies.end(), [&](const SMember& member) {
    const SBody& body = m_bodies[member.Number];
    const Real change =
        std::hypot(body.Twist.X - body.Start.X, body.Twist.Y - body.Start.Y) +
        std::abs(body.Twist.Turn - body.Start.Turn) * std::sqrt(body.SquaredGyration);
    return change <= kPushSteady * island.Need;
  });
}

// All forces stay, so that bodies first go on to change as before.
void CPushSolver::StartFromResult(const SIsland& island) {
  for (const SMember& member : island.Bodies) {
    SBody& body = m_bodies[member.Number];
    const STwist twist = body.Twist;
    body.Twist.X += twist.X - body.Start.X;
    body.Twist.Y += twist.Y - body.Start.Y;
    body.Twist.Turn += twist.Turn - body.Start.Turn;
    body.Start = twist;
  }
}

}  // namespace argos
