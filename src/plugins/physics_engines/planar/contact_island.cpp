#include <argos3/plugins/simulator/physics_engines/planar/contact_island.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// @return the share of the last direction that the next one contains: 0, a restart of the method,
// if the energy of the change has grown.
template <typename NUMBER>
NUMBER ComputeShare(NUMBER energy, NUMBER before) {
  constexpr NUMBER kGrowth = NUMBER(1.02);
  return energy < kGrowth * before ? std::min(NUMBER(1), energy / before) : NUMBER(0);
}

}  // namespace

template <typename NUMBER>
template <typename VISIT>
void CContactIsland<NUMBER>::ForAll(VISIT&& visit) {
  for (SIslandBody<NUMBER>& body : m_bodies) {
    visit(body.Velocity);
    visit(body.Impulse);
  }
  for (SIslandContact<NUMBER>& contact : m_contacts) {
    visit(contact.Impulse);
  }
}

template <typename NUMBER>
UInt32 CContactIsland<NUMBER>::Solve(NUMBER tolerance, UInt32 mostSweeps) {
  ForAll([](auto& searched) { searched.Start(); });
  NUMBER before = NUMBER(0);
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

template <typename NUMBER>
void CContactIsland<NUMBER>::SweepDrives(SChange& change) {
  NUMBER greatest = change.Velocity;
  NUMBER energy = change.Energy;
  for (SIslandBody<NUMBER>& body : m_bodies) {
    NUMBER* const velocity = body.Velocity.Now;
    NUMBER* const impulse = body.Impulse.Now;
    NUMBER x = impulse[kAxisX] + (body.Target[kAxisX] - velocity[kAxisX]) * body.Mass;
    NUMBER y = impulse[kAxisY] + (body.Target[kAxisY] - velocity[kAxisY]) * body.Mass;
    const NUMBER squared = x * x + y * y;
    if (squared > body.Most * body.Most) {
      const NUMBER scale = body.Most / std::sqrt(squared);
      x *= scale;
      y *= scale;
    }
    const NUMBER turn = std::clamp(
        impulse[kAxisTurn] + (body.Target[kAxisTurn] - velocity[kAxisTurn]) * body.Inertia,
        -body.AngularMost, body.AngularMost);
    const NUMBER changeX = x - impulse[kAxisX];
    const NUMBER changeY = y - impulse[kAxisY];
    const NUMBER changeTurn = turn - impulse[kAxisTurn];
    impulse[kAxisX] = x;
    impulse[kAxisY] = y;
    impulse[kAxisTurn] = turn;
    const NUMBER changeVX = body.InverseMass * changeX;
    const NUMBER changeVY = body.InverseMass * changeY;
    const NUMBER changeW = body.InverseInertia * changeTurn;
    velocity[kAxisX] += changeVX;
    velocity[kAxisY] += changeVY;
    velocity[kAxisTurn] += changeW;
    greatest = std::max({greatest, std::abs(changeVX), std::abs(changeVY)});
    energy += changeVX * changeX + changeVY * changeY + changeW * changeTurn;
  }
  change = {greatest, energy};
}

template <typename NUMBER>
void CContactIsland<NUMBER>::SweepContacts(SChange& change) {
  NUMBER greatest = change.Velocity;
  NUMBER energy = change.Energy;
  for (SIslandContact<NUMBER>& contact : m_contacts) {
    SIslandBody<NUMBER>& bodyA = m_bodies[contact.A];
    SIslandBody<NUMBER>& bodyB = m_bodies[contact.B];
    NUMBER* const a = bodyA.Velocity.Now;
    NUMBER* const b = bodyB.Velocity.Now;
    NUMBER* const impulse = contact.Impulse.Now;
    const NUMBER x = b[kAxisX] - a[kAxisX];
    const NUMBER y = b[kAxisY] - a[kAxisY];
    const NUMBER approach = a[kAxisTurn] * contact.NormalLeverA -
                            b[kAxisTurn] * contact.NormalLeverB - (x * contact.NX + y * contact.NY);
    const NUMBER normal =
        std::max(NUMBER(0), impulse[kAxisNormal] + (approach - contact.Approach) * contact.Mass);
    const NUMBER changeN = normal - impulse[kAxisNormal];
    if (normal == NUMBER(0) && impulse[kAxisTangent] == NUMBER(0) && changeN == NUMBER(0)) {
      continue;
    }
    NUMBER tangent = 0;
    if (contact.Friction > 0) {
      // of B's surface past A's
      const NUMBER slip = y * contact.NX - x * contact.NY + b[kAxisTurn] * contact.TangentLeverB -
                          a[kAxisTurn] * contact.TangentLeverA;
      const NUMBER most = contact.Friction * normal;
      tangent = std::clamp(impulse[kAxisTangent] - slip * contact.TangentMass, -most, most);
    }
    const NUMBER changeT = tangent - impulse[kAxisTangent];
    impulse[kAxisNormal] = normal;
    impulse[kAxisTangent] = tangent;
    const NUMBER impulseX = changeN * contact.NX - changeT * contact.NY;
    const NUMBER impulseY = changeN * contact.NY + changeT * contact.NX;
    a[kAxisX] -= bodyA.InverseMass * impulseX;
    a[kAxisY] -= bodyA.InverseMass * impulseY;
    a[kAxisTurn] -=
        bodyA.InverseInertia * (changeN * contact.NormalLeverA + changeT * contact.TangentLeverA);
    b[kAxisX] += bodyB.InverseMass * impulseX;
    b[kAxisY] += bodyB.InverseMass * impulseY;
    b[kAxisTurn] +=
        bodyB.InverseInertia * (changeN * contact.NormalLeverB + changeT * contact.TangentLeverB);
    const NUMBER speedN = changeN * contact.InverseMass;
    const NUMBER speedT = changeT * contact.InverseTangentMass;
    greatest = std::max({greatest, std::abs(speedN), std::abs(speedT)});
    energy += speedN * changeN + speedT * changeT;
  }
  change = {greatest, energy};
}

// Velocities are linear in impulses, so that the direction of the search has those as well.
template <typename NUMBER>
void CContactIsland<NUMBER>::StepOn(NUMBER share) {
  ForAll([share](auto& searched) { searched.StepOn(share); });
}

template class CContactIsland<float>;
template class CContactIsland<double>;

}  // namespace argos
