#include <argos3/plugins/simulator/physics_engines/dynamics2d/contact_island.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr auto kX = SIslandBody::kX;
constexpr auto kY = SIslandBody::kY;
constexpr auto kTurn = SIslandBody::kTurn;
constexpr auto kNormal = SIslandContact::kNormal;
constexpr auto kTangent = SIslandContact::kTangent;

// @return the share of the last direction that the next one contains: 0, a restart of the method,
// if the energy of the change has grown.
float ComputeShare(float energy, float before) {
  constexpr float kGrowth = 1.02F;
  return energy < kGrowth * before ? std::min(1.0F, energy / before) : 0.0F;
}

}  // namespace

UInt32 CContactIsland::Solve(float tolerance, UInt32 mostSweeps) {
  float before = 0.0F;
  for (UInt32 sweep = 1;; ++sweep) {
    SChange change;
    SweepDrives(change);
    SweepContacts(change);
    if (change.Velocity <= tolerance || sweep == mostSweeps) {
      return sweep;
    }
    StepOn(ComputeShare(change.Energy, before));
    before = change.Energy;
  }
}

void CContactIsland::SweepDrives(SChange& change) {
  float greatest = change.Velocity;
  float energy = change.Energy;
  for (SIslandBody& body : m_bodies) {
    float* const velocity = body.Velocity.Now;
    float* const impulse = body.Impulse.Now;
    float x = impulse[kX] + (body.Target[kX] - velocity[kX]) * body.Mass;
    float y = impulse[kY] + (body.Target[kY] - velocity[kY]) * body.Mass;
    const float squared = x * x + y * y;
    if (squared > body.Most * body.Most) {
      const float scale = body.Most / std::sqrt(squared);
      x *= scale;
      y *= scale;
    }
    const float turn =
        std::clamp(impulse[kTurn] + (body.Target[kTurn] - velocity[kTurn]) * body.Inertia,
                   -body.AngularMost, body.AngularMost);
    const float changeX = x - impulse[kX];
    const float changeY = y - impulse[kY];
    const float changeTurn = turn - impulse[kTurn];
    impulse[kX] = x;
    impulse[kY] = y;
    impulse[kTurn] = turn;
    const float changeVX = body.InverseMass * changeX;
    const float changeVY = body.InverseMass * changeY;
    const float changeW = body.InverseInertia * changeTurn;
    velocity[kX] += changeVX;
    velocity[kY] += changeVY;
    velocity[kTurn] += changeW;
    greatest = std::max({greatest, std::abs(changeVX), std::abs(changeVY)});
    energy += changeVX * changeX + changeVY * changeY + changeW * changeTurn;
  }
  change = {greatest, energy};
}

void CContactIsland::SweepContacts(SChange& change) {
  float greatest = change.Velocity;
  float energy = change.Energy;
  for (SIslandContact& contact : m_contacts) {
    SIslandBody& bodyA = m_bodies[contact.A];
    SIslandBody& bodyB = m_bodies[contact.B];
    float* const a = bodyA.Velocity.Now;
    float* const b = bodyB.Velocity.Now;
    float* const impulse = contact.Impulse.Now;
    const float x = b[kX] - a[kX];
    const float y = b[kY] - a[kY];
    const float approach = a[kTurn] * contact.NormalLeverA - b[kTurn] * contact.NormalLeverB -
                           (x * contact.NX + y * contact.NY);
    const float normal =
        std::max(0.0F, impulse[kNormal] + (approach - contact.Approach) * contact.Mass);
    const float changeN = normal - impulse[kNormal];
    if (normal == 0.0F && impulse[kTangent] == 0.0F && changeN == 0.0F) {
      continue;
    }
    // of B's surface past A's
    const float slip = y * contact.NX - x * contact.NY + b[kTurn] * contact.TangentLeverB -
                       a[kTurn] * contact.TangentLeverA;
    const float most = contact.Friction * normal;
    const float tangent = std::clamp(impulse[kTangent] - slip * contact.TangentMass, -most, most);
    const float changeT = tangent - impulse[kTangent];
    impulse[kNormal] = normal;
    impulse[kTangent] = tangent;
    const float impulseX = changeN * contact.NX - changeT * contact.NY;
    const float impulseY = changeN * contact.NY + changeT * contact.NX;
    a[kX] -= bodyA.InverseMass * impulseX;
    a[kY] -= bodyA.InverseMass * impulseY;
    a[kTurn] -=
        bodyA.InverseInertia * (changeN * contact.NormalLeverA + changeT * contact.TangentLeverA);
    b[kX] += bodyB.InverseMass * impulseX;
    b[kY] += bodyB.InverseMass * impulseY;
    b[kTurn] +=
        bodyB.InverseInertia * (changeN * contact.NormalLeverB + changeT * contact.TangentLeverB);
    const float speedN = changeN * contact.InverseMass;
    const float speedT = changeT * contact.InverseTangentMass;
    greatest = std::max({greatest, std::abs(speedN), std::abs(speedT)});
    energy += speedN * changeN + speedT * changeT;
  }
  change = {greatest, energy};
}

// Velocities are linear in impulses, so that the direction of the search has those as well.
void CContactIsland::StepOn(float share) {
  for (SIslandBody& body : m_bodies) {
    body.Velocity.StepOn(share);
    body.Impulse.StepOn(share);
  }
  for (SIslandContact& contact : m_contacts) {
    contact.Impulse.StepOn(share);
  }
}

}  // namespace argos
