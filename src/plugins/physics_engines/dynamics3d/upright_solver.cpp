#include <argos3/plugins/simulator/physics_engines/dynamics3d/upright_solver.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/impulse_blocks.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

using EKind = SUprightBody::EKind;
constexpr UInt32 kNone = SUprightContact::kNone;

// share of the tolerance below which a change does not matter to others
constexpr Real kSlight = 0.1;
// the search goes on while the energy of changes grows by no more than this factor
constexpr Real kGrowth = 1.02;

// Changes of the impulses of all supports of a body, whose directions are the same.
struct SDriveChange {
  Real First = 0.0, Second = 0.0;  // N s
  Real Turn = 0.0;  // N m s

  void Set(SUprightSupport& support, const SPair2& next) {
    const Real first = next.X - support.Impulse1;
    const Real second = next.Y - support.Impulse2;
    First += first;
    Second += second;
    Turn += first * support.Lever1 + second * support.Lever2;
    support.Impulse1 = next.X;
    support.Impulse2 = next.Y;
  }
};

void PushBy(SUprightBody& body, const SUprightSupport& at, const SDriveChange& change) {
  const Real x = change.First * at.EX - change.Second * at.EY;
  const Real y = change.First * at.EY + change.Second * at.EX;
  body.Push(x, y, change.Turn);
  body.DriveX += x;
  body.DriveY += y;
  body.DriveTurn += change.Turn;
}

void SetImpulse(SUprightSupport& support, Real first, Real second) {
  support.Impulse1 = first;
  support.Impulse2 = second;
}

// The velocity of the centre of mass along the directions of a support, m/s.
SPair2 GetOwnSpeed(const SUprightBody& body, const SUprightSupport& at) {
  return {body.VX * at.EX + body.VY * at.EY, body.VY * at.EX - body.VX * at.EY};
}

// The speed of a support against the floor, m/s.
SPair2 GetSlip(const SUprightBody& body, const SPair2& own, const SUprightSupport& at) {
  return {own.X + body.W * at.Lever1, own.Y + body.W * at.Lever2};
}

// Shortens a pair of impulses to the friction that a support has. @return false if it is enough.
bool LimitToGrip(SPair2& impulse, Real grip) {
  const Real square = impulse.X * impulse.X + impulse.Y * impulse.Y;
  if (square <= grip * grip) {
    return false;
  }
  const Real scale = grip / std::sqrt(square);
  impulse.X *= scale;
  impulse.Y *= scale;
  return true;
}

}  // namespace

inline void CUprightSolver::Apply(const SUprightContact& contact, Real normal, Real tangent) const {
  const Real x = normal * contact.NX - tangent * contact.NY;
  const Real y = normal * contact.NY + tangent * contact.NX;
  m_bodies[contact.A].Push(-x, -y,
                           -(normal * contact.NormalLeverA + tangent * contact.TangentLeverA));
  if (contact.B != kNone) {
    m_bodies[contact.B].Push(x, y, normal * contact.NormalLeverB + tangent * contact.TangentLeverB);
  }
}

void CUprightSolver::Prepare(const SIsland& island) const {
  for (const UInt32 number : island.Contacts) {
    SUprightContact& contact = m_contacts[number];
    const SUprightBody& a = m_bodies[contact.A];
    Real mass = a.InverseMass;
    Real normal = a.InverseInertia * contact.NormalLeverA * contact.NormalLeverA;
    Real tangent = a.InverseInertia * contact.TangentLeverA * contact.TangentLeverA;
    if (contact.B != kNone) {
      const SUprightBody& b = m_bodies[contact.B];
      mass += b.InverseMass;
      normal += b.InverseInertia * contact.NormalLeverB * contact.NormalLeverB;
      tangent += b.InverseInertia * contact.TangentLeverB * contact.TangentLeverB;
    }
    contact.InverseMass = mass + normal;
    contact.InverseTangentMass = mass + tangent;
    contact.Mass = 1.0 / contact.InverseMass;
    contact.TangentMass = 1.0 / contact.InverseTangentMass;
    contact.StepNormal = contact.StepTangent = 0.0;
    contact.LastSweep = 0;
    Apply(contact, contact.Normal, contact.Tangent);
  }
}

// @return the change of a speed, m/s. @param energy  to which that of the changes is added.
inline Real CUprightSolver::SolveContact(SUprightContact& contact, Real& energy) const {
  const SUprightBody& a = m_bodies[contact.A];
  Real x = -a.VX;
  Real y = -a.VY;
  Real normalTurn = -contact.NormalLeverA * a.W;
  Real tangentTurn = -contact.TangentLeverA * a.W;
  if (contact.B != kNone) {
    const SUprightBody& b = m_bodies[contact.B];
    x += b.VX;
    y += b.VY;
    normalTurn += contact.NormalLeverB * b.W;
    tangentTurn += contact.TangentLeverB * b.W;
  }
  const Real approach = -(x * contact.NX + y * contact.NY + normalTurn);
  const Real normal = std::max(0.0, contact.Normal + (approach - contact.Approach) * contact.Mass);
  const Real changeN = normal - contact.Normal;
  if (normal == 0.0 && changeN == 0.0 && contact.Tangent == 0.0) {
    return 0.0;
  }
  contact.Normal = normal;
  const Real slip = y * contact.NX - x * contact.NY + tangentTurn;
  const Real most = contact.Friction * normal;
  const Real tangent = std::clamp(contact.Tangent - slip * contact.TangentMass, -most, most);
  const Real changeT = tangent - contact.Tangent;
  contact.Tangent = tangent;
  Apply(contact, changeN, changeT);
  const Real speedN = changeN * contact.InverseMass;
  const Real speedT = changeT * contact.InverseTangentMass;
  energy += changeN * speedN + changeT * speedT;
  return std::max(std::abs(speedN), std::abs(speedT));
}

// The friction that stops an object, if its feet can bear it.
bool CUprightSolver::HoldFeet(SUprightBody& body, SUprightSupport* feet) const {
  Real load = 0.0;
  Real grip = 0.0;
  Real lever1 = 0.0;
  Real lever2 = 0.0;
  for (UInt32 i = 0; i < body.NumSupports; ++i) {
    load += feet[i].Load;
    grip += feet[i].Grip;
    lever1 += feet[i].Load * feet[i].Lever1;
    lever2 += feet[i].Load * feet[i].Lever2;
  }
  lever1 /= load;
  lever2 /= load;
  const Real x = body.DriveX - body.VX * body.Mass;
  const Real y = body.DriveY - body.VY * body.Mass;
  const Real turn = body.DriveTurn - body.W * body.Inertia - x * lever1 - y * lever2;
  // a part of the force that grows with the distance from the middle makes the rest of the torque
  Real square = 0.0;
  for (UInt32 i = 0; i < body.NumSupports; ++i) {
    const Real d1 = feet[i].Lever1 - lever1;
    const Real d2 = feet[i].Lever2 - lever2;
    square += feet[i].Load / load * (d1 * d1 + d2 * d2);
  }
  const Real rate = turn / square;
  for (UInt32 i = 0; i < body.NumSupports; ++i) {
    const Real forceX = x + rate * (feet[i].Lever1 - lever1);
    const Real forceY = y + rate * (feet[i].Lever2 - lever2);
    if (!(forceX * forceX + forceY * forceY <= grip * grip)) {
      return false;
    }
  }
  for (UInt32 i = 0; i < body.NumSupports; ++i) {
    const Real share = feet[i].Load / load;
    SetImpulse(feet[i], share * (x + rate * (feet[i].Lever1 - lever1)),
               share * (y + rate * (feet[i].Lever2 - lever2)));
  }
  body.DriveX = x;
  body.DriveY = y;
  body.DriveTurn = body.DriveTurn - body.W * body.Inertia;
  body.VX = body.VY = body.W = 0.0;
  return true;
}

// The impulses with which both wheels have their target, if motors and friction can bear them.
bool CUprightSolver::HoldWheels(SUprightBody& body, SUprightSupport* wheels) const {
  SUprightSupport& left = wheels[0];
  SUprightSupport& right = wheels[1];
  const Real x = body.DriveX + (body.TargetX - body.VX) * body.Mass;
  const Real y = body.DriveY + (body.TargetY - body.VY) * body.Mass;
  const Real turn = body.DriveTurn + (body.TargetW - body.W) * body.Inertia;
  const Real first = x * left.EX + y * left.EY;
  const Real second = 0.5 * (y * left.EX - x * left.EY);
  const Real rest = turn - second * (left.Lever2 + right.Lever2);
  const Real ofRight = (rest - left.Lever1 * first) / (right.Lever1 - left.Lever1);
  const Real impulses[2] = {first - ofRight, ofRight};
  for (UInt32 i = 0; i < 2; ++i) {
    const Real grip = wheels[i].Grip;
    if (!(std::abs(impulses[i] + wheels[i].Own) <= wheels[i].Motor &&
          impulses[i] * impulses[i] + second * second <= grip * grip)) {
      return false;
    }
  }
  for (UInt32 i = 0; i < 2; ++i) {
    SetImpulse(wheels[i], impulses[i], second);
    wheels[i].Spin = wheels[i].Target;
  }
  body.DriveX = x;
  body.DriveY = y;
  body.DriveTurn = turn;
  body.VX = body.TargetX;
  body.VY = body.TargetY;
  body.W = body.TargetW;
  return true;
}

void CUprightSolver::SolvePlanarDrive(SUprightBody& body) const {
  Real x = body.DriveX + (body.TargetX - body.VX) * body.Mass;
  Real y = body.DriveY + (body.TargetY - body.VY) * body.Mass;
  const Real square = x * x + y * y;
  if (square > body.ForceLimit * body.ForceLimit) {
    const Real scale = body.ForceLimit / std::sqrt(square);
    x *= scale;
    y *= scale;
  }
  const Real turn = std::clamp(body.DriveTurn + (body.TargetW - body.W) * body.Inertia,
                               -body.TorqueLimit, body.TorqueLimit);
  body.Push(x - body.DriveX, y - body.DriveY, turn - body.DriveTurn);
  body.DriveX = x;
  body.DriveY = y;
  body.DriveTurn = turn;
}

// A step of the projected gradient for all feet at once, so that none has an advantage: what is
// pushed at its middle would turn. The same share of both slips, so that friction is opposite to
// the slip when that does not change any more.
void CUprightSolver::SolveFeet(SUprightBody& body, SUprightSupport* feet) const {
  const SPair2 own = GetOwnSpeed(body, feet[0]);
  SDriveChange change;
  for (UInt32 i = 0; i < body.NumSupports; ++i) {
    SUprightSupport& foot = feet[i];
    const SPair2 slip = GetSlip(body, own, foot);
    SPair2 next{foot.Impulse1 - foot.Share * slip.X, foot.Impulse2 - foot.Share * slip.Y};
    LimitToGrip(next, foot.Grip);
    change.Set(foot, next);
  }
  PushBy(body, feet[0], change);
}

// The same for both wheels at once, so that none has an advantage: a robot that is pushed from
// behind would turn. A motor that is not at its limit keeps its speed; else the wheel rolls as fast
// as the floor lets it.
void CUprightSolver::SolveWheels(SUprightBody& body, SUprightSupport* wheels) const {
  const SPair2 own = GetOwnSpeed(body, wheels[0]);
  SDriveChange change;
  for (UInt32 i = 0; i < 2; ++i) {
    SUprightSupport& at = wheels[i];
    const SPair2 speed = GetSlip(body, own, at);
    SPair2 next{at.Impulse1 - at.Share * (speed.X - at.Target), at.Impulse2 - at.Share * speed.Y};
    // the impulse of the motor is that of the floor, and what changes the spin
    const Real motor = next.X + at.Own;
    const bool isWeak = std::abs(motor) > at.Motor;
    const Real most = std::copysign(at.Motor, motor);
    at.Spin = at.Target;
    if (isWeak) {
      next.X = most - (speed.X - at.StartSpin) * at.Rim;
      at.Spin = speed.X;
    }
    if (LimitToGrip(next, at.Grip) && isWeak) {
      at.Spin = at.StartSpin + (most - next.X) / at.Rim;
    }
    change.Set(at, next);
  }
  PushBy(body, wheels[0], change);
}

// @return the change of its velocity, m/s.
Real CUprightSolver::SolveDrive(SUprightBody& body) const {
  const Real x = body.VX;
  const Real y = body.VY;
  const Real turn = body.W;
  SUprightSupport* const supports = m_supports.data() + body.FirstSupport;
  if (body.Kind == EKind::PlanarDrive) {
    SolvePlanarDrive(body);
  } else if (body.Kind == EKind::Wheels && !HoldWheels(body, supports)) {
    SolveWheels(body, supports);
  } else if (body.Kind == EKind::Object && !HoldFeet(body, supports)) {
    SolveFeet(body, supports);
  }
  return std::max(
      {std::abs(body.VX - x), std::abs(body.VY - y), std::abs(body.W - turn) * body.Extent});
}

CUprightSolver::SChange CUprightSolver::Sweep(const SIsland& island, const SSweep& sweep) const {
  Real greatest = 0.0;
  Real energy = 0.0;
  for (const UInt32 number : island.Bodies) {
    SUprightBody& body = m_bodies[number];
    if (sweep.IsDue(body)) {
      const Real change = SolveDrive(body);
      sweep.Mark(body, change);
      greatest = std::max(greatest, change);
    }
  }
  for (const UInt32 number : island.Contacts) {
    SUprightContact& contact = m_contacts[number];
    SUprightBody& a = m_bodies[contact.A];
    SUprightBody* const b = contact.B != kNone ? &m_bodies[contact.B] : nullptr;
    if (!sweep.IsDue(a) && (b == nullptr || !sweep.IsDue(*b))) {
      continue;
    }
    contact.LastSweep = sweep.Number;
    contact.LastNormal = contact.Normal;
    contact.LastTangent = contact.Tangent;
    const Real change = SolveContact(contact, energy);
    greatest = std::max(greatest, change);
    sweep.Mark(a, change);
    if (b != nullptr) {
      sweep.Mark(*b, change);
    }
  }
  return {greatest, energy};
}

UInt32 CUprightSolver::Solve(const SIsland& island, UInt32 maxSweeps, Real tolerance) const {
  for (const UInt32 number : island.Bodies) {
    m_bodies[number].LastSweep = 0;
  }
  Real last = 0.0;
  SSweep sweep{1, kSlight * tolerance};
  for (; sweep.Number < maxSweeps; ++sweep.Number) {
    const SChange change = Sweep(island, sweep);
    if (change.Speed <= tolerance) {
      break;
    }
    // what the last sweeps leave must obey the laws
    if (4 * sweep.Number > 3 * maxSweeps) {
      continue;
    }
    const bool goesOn = last > 0.0 && change.Energy < kGrowth * last;
    StepOn(island, sweep, goesOn ? std::min(1.0, change.Energy / last) : 0.0);
    last = change.Energy;
  }
  return sweep.Number;
}

// Adds a share of the last direction; the next sweep makes impulses obey their laws again.
void CUprightSolver::StepOn(const SIsland& island, const SSweep& sweep, Real share) const {
  for (const UInt32 number : island.Contacts) {
    SUprightContact& contact = m_contacts[number];
    if (contact.LastSweep != sweep.Number) {
      contact.StepNormal = contact.StepTangent = 0.0;
      continue;
    }
    const Real normal = share * contact.StepNormal;
    const Real tangent = share * contact.StepTangent;
    contact.StepNormal = normal + contact.Normal - contact.LastNormal;
    contact.StepTangent = tangent + contact.Tangent - contact.LastTangent;
    if (normal != 0.0 || tangent != 0.0) {
      contact.Normal += normal;
      contact.Tangent += tangent;
      Apply(contact, normal, tangent);
      const Real change = (std::abs(normal) + std::abs(tangent)) * contact.InverseMass;
      sweep.Mark(m_bodies[contact.A], change);
      if (contact.B != kNone) {
        sweep.Mark(m_bodies[contact.B], change);
      }
    }
  }
}

}  // namespace argos
