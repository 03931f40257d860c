#include <argos3/plugins/simulator/physics_engines/kinematics2d/push_solver.h>

#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// N; assumed friction, for the compliance of bodies without friction
constexpr Real kLeastForce = 1e-3;
// change in a sweep at which the solver stops, as a share of the greatest need
constexpr Real kSettled = 1e-9;

}  // namespace

void CPushSolver::Clear() {
  m_bodies.clear();
  m_contacts.clear();
  m_greatestNeed = 0.0;
}

UInt32 CPushSolver::AddBody(const STwist& twist, Real force, Real torque, Real squaredGyration) {
  m_bodies.push_back({twist, force, torque, squaredGyration, 0.0, 0.0, 0.0, 0.0, 0.0});
  const Real wanted =
      std::hypot(twist.X, twist.Y) + std::abs(twist.Turn) * std::sqrt(squaredGyration);
  m_greatestNeed = std::max(m_greatestNeed, wanted);
  return static_cast<UInt32>(m_bodies.size() - 1);
}

void CPushSolver::AddContact(const SContact& contact) {
  CheckNumber(contact.Pushed);
  if (contact.Pushing != kNone) {
    CheckNumber(contact.Pushing);
  }
  m_contacts.push_back({contact, 0.0, 0.0});
  m_greatestNeed = std::max(m_greatestNeed, contact.Need);
}

void CPushSolver::Prepare() {
  for (SBody& body : m_bodies) {
    const Real force = std::max(body.Force, kLeastForce);
    body.Give = m_greatestNeed / (kPushSlack * force);
    body.TurnGive = body.Give / body.SquaredGyration;
  }
  for (SForce& contact : m_contacts) {
    const SBody& pushed = m_bodies[contact.Pushed];
    contact.Give = pushed.Give + contact.LeverPushed * contact.LeverPushed * pushed.TurnGive;
    if (contact.Pushing != kNone) {
      const SBody& pushing = m_bodies[contact.Pushing];
      contact.Give += pushing.Give + contact.LeverPushing * contact.LeverPushing * pushing.TurnGive;
    }
  }
}

// Assumes that pushed bodies slide in the direction of the push, with full friction. Then the
// forces are right from the start; otherwise they converge within few sweeps.
void CPushSolver::GuessFriction() {
  for (const SForce& contact : m_contacts) {
    SBody& body = m_bodies[contact.Pushed];
    Real weight = std::max(0.0, contact.Need);
    if (contact.Pushing != kNone) {
      const SBody& pushing = m_bodies[contact.Pushing];
      weight = std::max(0.0, -contact.NormalX * pushing.UsedX - contact.NormalY * pushing.UsedY);
    }
    body.UsedX -= weight * contact.NormalX;
    body.UsedY -= weight * contact.NormalY;
    body.UsedTorque -= weight * contact.LeverPushed;
  }
  for (SBody& body : m_bodies) {
    const Real length = std::hypot(body.UsedX, body.UsedY);
    if (length > 0.0) {
      const Real scale = body.Force / length;
      body.UsedX *= scale;
      body.UsedY *= scale;
      body.UsedTorque = std::clamp(body.UsedTorque * scale, -body.Torque, body.Torque);
      Push(body, body.UsedX, body.UsedY, body.UsedTorque);
    } else {
      body.UsedTorque = 0.0;
    }
  }
  for (int sweep = 0; sweep < kPushIterations && SolveContacts() > kSettled * m_greatestNeed;
       ++sweep) {
  }
}

// @return the greatest change, m.
Real CPushSolver::SolveContacts() {
  Real change = 0.0;
  for (SForce& contact : m_contacts) {
    change = std::max(change, SolveContact(contact));
  }
  return change;
}

void CPushSolver::Solve() {
  if (!(m_greatestNeed > 0.0)) {
    return;
  }
  Prepare();
  GuessFriction();
  for (int sweep = 0; sweep < kPushIterations; ++sweep) {
    for (SBody& body : m_bodies) {
      SolveFriction(body);
    }
    // contacts last, so that no overlap remains in the end
    if (SolveContacts() < kSettled * m_greatestNeed) {
      break;
    }
  }
  KeepApart();
}

// Enforces Least of all contacts, so that the order of opposing pushes has no effect.
void CPushSolver::KeepApart() {
  Real missing = HUGE_VAL;
  for (int sweep = 0; sweep < kPushIterations && missing > kSettled * m_greatestNeed; ++sweep) {
    missing = 0.0;
    for (SForce& contact : m_contacts) {
      const Real shortOf = contact.Least - ComputeMotion(contact);
      if (shortOf > 0.0) {
        AddForce(contact, shortOf / contact.Give);
        missing = std::max(missing, shortOf);
      }
    }
  }
}

void CPushSolver::Push(SBody& body, Real x, Real y, Real torque) {
  body.Twist.X += body.Give * x;
  body.Twist.Y += body.Give * y;
  body.Twist.Turn += body.TurnGive * torque;
}

// Friction exerts the force that keeps the body at its place, up to its bounds.
void CPushSolver::SolveFriction(SBody& body) {
  if (body.Force > 0.0) {
    Real x = body.UsedX - body.Twist.X / body.Give;
    Real y = body.UsedY - body.Twist.Y / body.Give;
    const Real length = std::sqrt(x * x + y * y);
    if (length > body.Force) {
      x *= body.Force / length;
      y *= body.Force / length;
    }
    Push(body, x - body.UsedX, y - body.UsedY, 0.0);
    body.UsedX = x;
    body.UsedY = y;
  }
  if (body.Torque > 0.0) {
    const Real torque =
        std::clamp(body.UsedTorque - body.Twist.Turn / body.TurnGive, -body.Torque, body.Torque);
    Push(body, 0.0, 0.0, torque - body.UsedTorque);
    body.UsedTorque = torque;
  }
}

// @return the change, m.
Real CPushSolver::SolveContact(SForce& contact) {
  const Real force = std::clamp(
      contact.Force + (contact.Need - ComputeMotion(contact)) / contact.Give, 0.0, contact.Cap);
  const Real change = force - contact.Force;
  AddForce(contact, change);
  return std::abs(change) * contact.Give;
}

// The motion of the pushed body along the normal, relative to the pushing one, m.
Real CPushSolver::ComputeMotion(const SContact& contact) const {
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

void CPushSolver::AddForce(SForce& contact, Real change) {
  contact.Force += change;
  Push(m_bodies[contact.Pushed], change * contact.NormalX, change * contact.NormalY,
       change * contact.LeverPushed);
  if (contact.Pushing != kNone) {
    Push(m_bodies[contact.Pushing], -change * contact.NormalX, -change * contact.NormalY,
         -change * contact.LeverPushing);
  }
}

}  // namespace argos
