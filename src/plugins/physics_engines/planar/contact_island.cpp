#include <argos3/plugins/simulator/physics_engines/planar/contact_island.h>

#include <argos3/plugins/simulator/physics_engines/planar/island_newton.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// Sweeps before the first steps of Newton's method, and between these, which grow by factors of 2:
// where Newton's method fails, the contacts that slide and the drives at their bounds are not known
// yet.
constexpr UInt32 kFirstSeries = 2;
constexpr UInt32 kSecondSeries = 8;
constexpr UInt32 kLongestSeries = 64;
constexpr UInt32 kNewtonSteps = 6;
// where motors of turrets and drives at their bounds are searched, too
constexpr UInt32 kGripSteps = 12;
// A step may make the last change so many times as great, because the way to the solution of such
// equations is often uphill. Else it is taken back, and the next one is shorter.
constexpr double kWorse = 6.0;
constexpr double kDamping = 1e-2;
constexpr double kMinDamping = 1e-3;
constexpr double kLessDamping = 0.3;
constexpr double kMoreDamping = 10.0;

// @return the share of the last direction that the next one contains: 0, a restart of the method,
// if the energy of the change has grown.
template <typename NUMBER>
NUMBER ComputeShare(NUMBER energy, NUMBER before) {
  constexpr NUMBER kGrowth = NUMBER(1.02);
  return energy < kGrowth * before ? std::min(NUMBER(1), energy / before) : NUMBER(0);
}

}  // namespace

// A motor within its bounds keeps the rate of the turret against A, so that both are one body; else
// its torque is given, and the turret turns by itself.
template <typename NUMBER>
SGripChange<NUMBER> SolveGrip(const SIslandGrip<NUMBER>& grip, const SGripMotion<NUMBER>& a,
                              const SGripMotion<NUMBER>& b) {
  const NUMBER* const impulse = grip.Impulse.Now;
  NUMBER rest[2];  // that is to be stopped, m/s
  ComputeGripSpeeds(grip, a, b, rest);
  for (const int axis : {kAxisAlong, kAxisAcross}) {
    rest[axis] += grip.Bias[axis] + grip.Softness[axis] * impulse[axis];
  }
  const NUMBER inverseMasses = a.InverseMass + b.InverseMass;
  const NUMBER arm = grip.InverseArmInertia;
  // solves both axes, with shares of the turning of A and of the turret
  const auto solve = [&](const NUMBER* speeds, auto&& turn) {
    const auto give = [&](int i, int j) {
      return turn(i, j) + b.InverseInertia * grip.HeldLever[i] * grip.HeldLever[j] +
             (i == j ? inverseMasses + grip.Softness[i] : NUMBER(0));
    };
    const NUMBER xx = give(0, 0);
    const NUMBER xy = give(0, 1);
    const NUMBER yy = give(1, 1);
    const NUMBER scale = NUMBER(-1) / (xx * yy - xy * xy);
    return SGripChange<NUMBER>{scale * (yy * speeds[0] - xy * speeds[1]),
                               scale * (xx * speeds[1] - xy * speeds[0]), NUMBER(0)};
  };
  const auto turnApart = [&](int i, int j) {
    return a.InverseInertia * grip.BaseLever[i] * grip.BaseLever[j] +
           arm * grip.ArmLever[i] * grip.ArmLever[j];
  };
  if (!grip.HasTurret()) {
    return solve(rest, turnApart);
  }
  const NUMBER both = a.InverseInertia + arm;
  const NUMBER late = grip.MotorRate + a.Turn - grip.ArmRate.Now[0];  // rad/s
  NUMBER coupling[2];  // of the motor's impulse with the speeds
  NUMBER speeds[2];
  for (const int axis : {kAxisAlong, kAxisAcross}) {
    coupling[axis] = a.InverseInertia * grip.BaseLever[axis] - arm * grip.ArmLever[axis];
    speeds[axis] = rest[axis] + coupling[axis] * late / both;
  }
  const NUMBER shared = a.InverseInertia * arm / both;
  SGripChange<NUMBER> change = solve(speeds, [&](int i, int j) {
    return shared * (grip.BaseLever[i] + grip.ArmLever[i]) * (grip.BaseLever[j] + grip.ArmLever[j]);
  });
  change.Motor = (late - coupling[0] * change.Along - coupling[1] * change.Across) / both;
  const NUMBER motor = impulse[kAxisMotor] + change.Motor;
  if (std::abs(motor) > grip.MotorMost) {
    const NUMBER bound = std::clamp(motor, -grip.MotorMost, grip.MotorMost) - impulse[kAxisMotor];
    speeds[0] = rest[0] + coupling[0] * bound;
    speeds[1] = rest[1] + coupling[1] * bound;
    change = solve(speeds, turnApart);
    change.Motor = bound;
  }
  return change;
}

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
  for (SIslandGrip<NUMBER>& grip : m_grips) {
    visit(grip.Impulse);
    visit(grip.ArmRate);
  }
}

template <typename NUMBER>
void CContactIsland<NUMBER>::Start() {
  ForAll([](auto& searched) { searched.Start(); });
}

template <typename NUMBER>
UInt32 CContactIsland<NUMBER>::Solve(NUMBER tolerance, UInt32 mostSweeps) {
  m_tolerance = tolerance;
  m_mostSweeps = mostSweeps;
  m_sweeps = 0;
  CIslandNewton<NUMBER> newton(m_bodies, m_contacts, m_grips);
  NUMBER change = SweepUntil(newton.Fits() ? kFirstSeries : mostSweeps);
  for (UInt32 series = kSecondSeries; !IsDone(change);
       series = std::min(2 * series, kLongestSeries)) {
    change = StepByNewton(newton, change);
    if (!IsDone(change)) {
      change = SweepUntil(m_sweeps + series);
    }
  }
  m_change = change;
  return m_sweeps;
}

// The conjugate gradient method, until so many sweeps are made. @return the greatest change of a
// velocity in the last one, m/s.
template <typename NUMBER>
NUMBER CContactIsland<NUMBER>::SweepUntil(UInt32 end) {
  Start();
  NUMBER before = NUMBER(0);
  for (;;) {
    SChange change;
    SweepDrives(change);
    SweepContacts(change);
    if (!m_grips.empty()) {
      SweepGrips(change);
    }
    ++m_sweeps;
    if (IsDone(change.Velocity) || m_sweeps >= end) {
      return change.Velocity;
    }
    StepOn(ComputeShare(change.Energy, before));
    before = change.Energy;
  }
}

// @param change  in the last sweep, m/s. @return the same of the last one that is kept.
template <typename NUMBER>
NUMBER CContactIsland<NUMBER>::StepByNewton(CIslandNewton<NUMBER>& newton, NUMBER change) {
  Start();
  NUMBER damping = NUMBER(kDamping);
  const UInt32 steps = m_grips.empty() ? kNewtonSteps : kGripSteps;
  for (UInt32 step = 0; step < steps && m_sweeps < m_mostSweeps; ++step) {
    SChange next;
    SweepDrives(next);
    SolveTurrets();
    if (!newton.Step(damping)) {
      break;
    }
    SweepDrives(next);
    SolveTurrets();
    next = SChange();
    SweepContacts(next);
    if (!m_grips.empty()) {
      SweepGrips(next);
    }
    ++m_sweeps;
    if (next.Velocity <= NUMBER(kWorse) * change) {
      change = next.Velocity;
      if (change <= m_tolerance) {
        return change;
      }
      Start();
      damping = std::max(NUMBER(kMinDamping), NUMBER(kLessDamping) * damping);
    } else {
      ForAll([](auto& searched) { searched.Return(); });
      damping *= NUMBER(kMoreDamping);
    }
  }
  ForAll([](auto& searched) { searched.Return(); });
  return change;
}

// Solves the turning of a drive. @return the change of its impulse, N m s.
template <typename NUMBER>
inline NUMBER SolveTurn(SIslandBody<NUMBER>& body) {
  NUMBER& velocity = body.Velocity.Now[kAxisTurn];
  NUMBER& impulse = body.Impulse.Now[kAxisTurn];
  const NUMBER turn = std::clamp(impulse + (body.Target[kAxisTurn] - velocity) * body.Inertia,
                                 -body.AngularMost, body.AngularMost);
  const NUMBER change = turn - impulse;
  impulse = turn;
  velocity += body.InverseInertia * change;
  return change;
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
    const NUMBER changeX = x - impulse[kAxisX];
    const NUMBER changeY = y - impulse[kAxisY];
    impulse[kAxisX] = x;
    impulse[kAxisY] = y;
    const NUMBER changeVX = body.InverseMass * changeX;
    const NUMBER changeVY = body.InverseMass * changeY;
    velocity[kAxisX] += changeVX;
    velocity[kAxisY] += changeVY;
    const NUMBER changeTurn = SolveTurn(body);
    greatest = std::max({greatest, std::abs(changeVX), std::abs(changeVY)});
    energy +=
        changeVX * changeX + changeVY * changeY + body.InverseInertia * changeTurn * changeTurn;
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
    ChangeImpulse(bodyA, bodyB, contact, normal, tangent);
    const NUMBER speedN = changeN * contact.InverseMass;
    const NUMBER speedT = changeT * contact.InverseTangentMass;
    greatest = std::max({greatest, std::abs(speedN), std::abs(speedT)});
    energy += speedN * changeN + speedT * changeT;
  }
  change = {greatest, energy};
}

// Solves the motor of each turret together with the turning of the robot's drive: exactly if only
// one of the two is at its bound, or none.
template <typename NUMBER>
void CContactIsland<NUMBER>::SolveTurrets() {
  constexpr int kPasses = 3;
  for (SIslandGrip<NUMBER>& grip : m_grips) {
    if (!grip.HasTurret()) {
      continue;
    }
    SIslandBody<NUMBER>& body = m_bodies[grip.A];
    // as if the robot turned as its drive aims
    SGripMotion<NUMBER> a = GetGripMotion(body);
    a.Turn = body.Target[kAxisTurn];
    a.InverseInertia = NUMBER(0);
    ApplyGripChange(m_bodies, grip, {NUMBER(0), NUMBER(0), SolveGripMotor(grip, a)});
    for (int pass = 0; pass < kPasses; ++pass) {
      SolveTurn(body);
      const NUMBER motor = SolveGripMotor(grip, GetGripMotion(body));
      ApplyGripChange(m_bodies, grip, {NUMBER(0), NUMBER(0), motor});
    }
    SolveTurn(body);
  }
}

template <typename NUMBER>
void CContactIsland<NUMBER>::SweepGrips(SChange& change) {
  for (SIslandGrip<NUMBER>& grip : m_grips) {
    const SIslandBody<NUMBER>& a = m_bodies[grip.A];
    const SIslandBody<NUMBER>& b = m_bodies[grip.B];
    const SGripChange<NUMBER> step = SolveGrip(grip, GetGripMotion(a), GetGripMotion(b));
    ApplyGripChange(m_bodies, grip, step);
    const NUMBER changes[2] = {step.Along, step.Across};
    for (const int axis : {kAxisAlong, kAxisAcross}) {
      const NUMBER speed =
          changes[axis] * ComputeGripCompliance(grip, a.InverseMass + b.InverseMass,
                                                a.InverseInertia, b.InverseInertia, axis);
      change.Velocity = std::max(change.Velocity, std::abs(speed));
      change.Energy += speed * changes[axis];
    }
    change.Energy += step.Motor * step.Motor * (a.InverseInertia + grip.InverseArmInertia);
  }
}

// Velocities are linear in impulses, so that the direction of the search has those as well.
template <typename NUMBER>
void CContactIsland<NUMBER>::StepOn(NUMBER share) {
  ForAll([share](auto& searched) { searched.StepOn(share); });
}

template SGripChange<float> SolveGrip(const SIslandGrip<float>&, const SGripMotion<float>&,
                                      const SGripMotion<float>&);
template SGripChange<double> SolveGrip(const SIslandGrip<double>&, const SGripMotion<double>&,
                                       const SGripMotion<double>&);
template class CContactIsland<float>;
template class CContactIsland<double>;

}  // namespace argos
