#include <argos3/plugins/simulator/physics_engines/planar/island_newton.h>

#include <algorithm>
#include <cmath>

namespace argos {

template <typename NUMBER>
bool CIslandNewton<NUMBER>::Step(NUMBER damping) {
  FindCompliances();
  FindCompliancesOfTurrets();
  if (!ListUnknowns()) {
    return false;
  }
  PutAtBounds();
  FillMatrix(damping);
  AddTurrets();
  if (!SolveEquations()) {
    return false;
  }
  TakeImpulses();
  return true;
}

// A drive within its bounds lets nothing change; one at its bound turns with the velocity.
template <typename NUMBER>
void CIslandNewton<NUMBER>::FindCompliances() {
  constexpr auto kAmple = NUMBER(1.00001);  // slightly more than a bound, for rounding errors
  for (size_t i = 0; i < m_bodies.size(); ++i) {
    const SIslandBody<NUMBER>& body = m_bodies[i];
    const NUMBER* const velocity = body.Velocity.Now;
    const NUMBER* const impulse = body.Impulse.Now;
    // with which it would reach its target
    const NUMBER x = impulse[kAxisX] + (body.Target[kAxisX] - velocity[kAxisX]) * body.Mass;
    const NUMBER y = impulse[kAxisY] + (body.Target[kAxisY] - velocity[kAxisY]) * body.Mass;
    const NUMBER turn =
        impulse[kAxisTurn] + (body.Target[kAxisTurn] - velocity[kAxisTurn]) * body.Inertia;
    const NUMBER squared = x * x + y * y;
    SCompliance& compliance = m_compliances[i] = {};
    if (body.Most == NUMBER(0)) {
      compliance.XX = compliance.YY = body.InverseMass;
    } else if (squared > kAmple * body.Most * body.Most) {
      const NUMBER scale = body.InverseMass * body.Most / (squared * std::sqrt(squared));
      compliance.XX = body.InverseMass - scale * y * y;
      compliance.YY = body.InverseMass - scale * x * x;
      compliance.XY = scale * x * y;
    }
    if (body.AngularMost == NUMBER(0) || std::abs(turn) > kAmple * body.AngularMost) {
      compliance.Turn = body.InverseInertia;
    }
  }
}

// A motor within its bounds makes one body of its turret and the robot; at its bound, each turns by
// itself.
template <typename NUMBER>
void CIslandNewton<NUMBER>::FindCompliancesOfTurrets() {
  constexpr auto kAmple = NUMBER(1.00001);
  for (size_t i = 0; i < m_grips.size(); ++i) {
    const SIslandGrip<NUMBER>& grip = m_grips[i];
    SCompliance& compliance = m_compliances[grip.A];
    const NUMBER late =
        grip.MotorRate + m_bodies[grip.A].Velocity.Now[kAxisTurn] - grip.ArmRate.Now[0];
    const NUMBER both = compliance.Turn + grip.InverseArmInertia;
    m_turns[i] = grip.HasTurret() &&
                 (grip.MotorMost == NUMBER(0) ||
                  std::abs(grip.Impulse.Now[kAxisMotor] + late / both) > kAmple * grip.MotorMost);
    if (grip.HasTurret() && !m_turns[i]) {
      compliance.Turn *= grip.InverseArmInertia / both;
    }
  }
}

template <typename NUMBER>
NUMBER CIslandNewton<NUMBER>::ComputeApproach(const SIslandContact<NUMBER>& contact) const {
  const NUMBER* const a = m_bodies[contact.A].Velocity.Now;
  const NUMBER* const b = m_bodies[contact.B].Velocity.Now;
  return (a[kAxisX] - b[kAxisX]) * contact.NX + (a[kAxisY] - b[kAxisY]) * contact.NY +
         a[kAxisTurn] * contact.NormalLeverA - b[kAxisTurn] * contact.NormalLeverB;
}

// of B's surface past A's
template <typename NUMBER>
NUMBER CIslandNewton<NUMBER>::ComputeSlip(const SIslandContact<NUMBER>& contact) const {
  const NUMBER* const a = m_bodies[contact.A].Velocity.Now;
  const NUMBER* const b = m_bodies[contact.B].Velocity.Now;
  return (b[kAxisY] - a[kAxisY]) * contact.NX - (b[kAxisX] - a[kAxisX]) * contact.NY +
         b[kAxisTurn] * contact.TangentLeverB - a[kAxisTurn] * contact.TangentLeverA;
}

template <typename NUMBER>
bool CIslandNewton<NUMBER>::ListUnknowns() {
  m_count = 0;
  std::fill_n(m_firstSides.begin(), m_bodies.size(), kEnd);
  for (UInt32 i = 0; i < m_contacts.size(); ++i) {
    if (!AddUnknowns(i)) {
      return false;
    }
  }
  m_firstOfGrips = m_count;
  if (m_count + 2 * m_grips.size() > kMaxUnknowns) {
    return false;
  }
  for (UInt32 i = 0; i < m_grips.size(); ++i) {
    AddGrip(i);
  }
  return m_count > 0;
}

// Those of a contact. @return false if there are too many.
template <typename NUMBER>
bool CIslandNewton<NUMBER>::AddUnknowns(UInt32 number) {
  const SIslandContact<NUMBER>& contact = m_contacts[number];
  const NUMBER approach = ComputeApproach(contact) - contact.Approach;
  const NUMBER normal = contact.Impulse.Now[kAxisNormal] + approach * contact.Mass;
  if (!(normal > NUMBER(0))) {
    m_states[number] = EState::Open;
    return true;
  }
  if (m_count + 2 > kMaxUnknowns) {
    return false;
  }
  if (!(contact.Friction > NUMBER(0))) {
    m_states[number] = EState::Frictionless;
    AddUnknown(contact, true, NUMBER(0), approach, contact.InverseMass);
    return true;
  }
  const NUMBER slip = ComputeSlip(contact);
  const NUMBER tangent = contact.Impulse.Now[kAxisTangent] - slip * contact.TangentMass;
  if (std::abs(tangent) > contact.Friction * normal) {
    const bool isForward = tangent > NUMBER(0);
    m_states[number] = isForward ? EState::Slides : EState::SlidesBack;
    AddUnknown(contact, true, isForward ? contact.Friction : -contact.Friction, approach,
               contact.InverseMass);
  } else {
    m_states[number] = EState::Sticks;
    AddUnknown(contact, true, NUMBER(0), approach, contact.InverseMass);
    AddUnknown(contact, false, NUMBER(0), -slip, contact.InverseTangentMass);
  }
  return true;
}

// @param ratio  of the impulse along the tangent to that along the normal, which is unknown.
// @param speed  that it is to stop, m/s.
template <typename NUMBER>
void CIslandNewton<NUMBER>::AddUnknown(const SIslandContact<NUMBER>& contact, bool isNormal,
                                       NUMBER ratio, NUMBER speed, NUMBER compliance) {
  const NUMBER x = isNormal ? contact.NX : -contact.NY;
  const NUMBER y = isNormal ? contact.NY : contact.NX;
  const auto addSide = [&](UInt32 side, UInt32 body, NUMBER sign, NUMBER lever, NUMBER tangent) {
    m_sides[side] = {
        body,
        m_firstSides[body],
        {sign * x, sign * y, sign * lever},
        {sign * (x - ratio * y), sign * (y + ratio * x), sign * (lever + ratio * tangent)}};
    m_firstSides[body] = side;
  };
  const auto side = static_cast<UInt32>(2 * m_count);
  addSide(side, contact.A, NUMBER(1), isNormal ? contact.NormalLeverA : contact.TangentLeverA,
          contact.TangentLeverA);
  addSide(side + 1, contact.B, NUMBER(-1), isNormal ? contact.NormalLeverB : contact.TangentLeverB,
          contact.TangentLeverB);
  m_speeds[m_count] = speed;
  m_own[m_count++] = compliance;
}

// Two unknowns: what its point is to lose of its speed towards the arm's end.
template <typename NUMBER>
void CIslandNewton<NUMBER>::AddGrip(UInt32 number) {
  const SIslandGrip<NUMBER>& grip = m_grips[number];
  const SIslandBody<NUMBER>& a = m_bodies[grip.A];
  const SIslandBody<NUMBER>& b = m_bodies[grip.B];
  NUMBER speeds[2];
  ComputeGripSpeeds(grip, GetGripMotion(a), GetGripMotion(b), speeds);
  for (const int axis : {kAxisAlong, kAxisAcross}) {
    const NUMBER x = axis == kAxisAlong ? grip.NX : -grip.NY;
    const NUMBER y = axis == kAxisAlong ? grip.NY : grip.NX;
    const auto addSide = [&](UInt32 side, UInt32 body, NUMBER sign, NUMBER lever) {
      const SMotion motion = {sign * x, sign * y, sign * lever};
      m_sides[side] = {body, m_firstSides[body], motion, motion};
      m_firstSides[body] = side;
    };
    const auto side = static_cast<UInt32>(2 * m_count);
    addSide(side, grip.A, NUMBER(1),
            grip.BaseLever[axis] + (m_turns[number] ? NUMBER(0) : grip.ArmLever[axis]));
    addSide(side + 1, grip.B, NUMBER(-1), grip.HeldLever[axis]);
    m_speeds[m_count] =
        -speeds[axis] - grip.Bias[axis] - grip.Softness[axis] * grip.Impulse.Now[axis];
    m_own[m_count++] = ComputeGripCompliance(grip, a.InverseMass + b.InverseMass, a.InverseInertia,
                                             b.InverseInertia, axis);
  }
}

template <typename NUMBER>
void CIslandNewton<NUMBER>::Push(const SIslandContact<NUMBER>& contact, NUMBER normal,
                                 NUMBER tangent) {
  const NUMBER x = normal * contact.NX - tangent * contact.NY;
  const NUMBER y = normal * contact.NY + tangent * contact.NX;
  const auto push = [&](UInt32 body, NUMBER sign, NUMBER turn) {
    const SCompliance& compliance = m_compliances[body];
    SMotion& moved = m_moved[body];
    moved.X += sign * (compliance.XX * x + compliance.XY * y);
    moved.Y += sign * (compliance.XY * x + compliance.YY * y);
    moved.Turn += sign * compliance.Turn * turn;
  };
  push(contact.A, NUMBER(-1), normal * contact.NormalLeverA + tangent * contact.TangentLeverA);
  push(contact.B, NUMBER(1), normal * contact.NormalLeverB + tangent * contact.TangentLeverB);
}

// What is to be stopped after open contacts have lost their impulses, and those that slide have the
// friction of their present pressure.
template <typename NUMBER>
void CIslandNewton<NUMBER>::PutAtBounds() {
  std::fill_n(m_moved.begin(), m_bodies.size(), SMotion());
  bool any = false;
  for (size_t i = 0; i < m_contacts.size(); ++i) {
    const SIslandContact<NUMBER>& contact = m_contacts[i];
    const NUMBER normal = contact.Impulse.Now[kAxisNormal];
    const NUMBER tangent = contact.Impulse.Now[kAxisTangent];
    NUMBER changeN = NUMBER(0);
    NUMBER changeT = NUMBER(0);
    if (m_states[i] == EState::Open) {
      changeN = -normal;
      changeT = -tangent;
    } else if (m_states[i] == EState::Slides) {
      changeT = contact.Friction * normal - tangent;
    } else if (m_states[i] == EState::SlidesBack) {
      changeT = -contact.Friction * normal - tangent;
    }
    if (changeN != NUMBER(0) || changeT != NUMBER(0)) {
      Push(contact, changeN, changeT);
      any = true;
    }
  }
  for (size_t i = 0; any && i < 2 * m_count; ++i) {
    const SSide& side = m_sides[i];
    const SMotion& moved = m_moved[side.Body];
    m_speeds[i / 2] +=
        side.Speed.X * moved.X + side.Speed.Y * moved.Y + side.Speed.Turn * moved.Turn;
  }
}

// How an impulse of 1 slows what each row is to stop.
template <typename NUMBER>
void CIslandNewton<NUMBER>::FillMatrix(NUMBER damping) {
  for (size_t i = 0; i < m_count; ++i) {
    std::fill_n(m_matrix[i].begin(), m_count + kLanes, NUMBER(0));
    m_matrix[i][i] = damping * m_own[i];
    m_matrix[i][m_count] = m_speeds[i];
  }
  for (size_t body = 0; body < m_bodies.size(); ++body) {
    const SCompliance& compliance = m_compliances[body];
    if (compliance.XX == NUMBER(0) && compliance.YY == NUMBER(0) && compliance.Turn == NUMBER(0)) {
      continue;
    }
    for (UInt32 column = m_firstSides[body]; column != kEnd; column = m_sides[column].Next) {
      const SMotion& impulse = m_sides[column].Impulse;
      const NUMBER x = compliance.XX * impulse.X + compliance.XY * impulse.Y;
      const NUMBER y = compliance.XY * impulse.X + compliance.YY * impulse.Y;
      const NUMBER turn = compliance.Turn * impulse.Turn;
      for (UInt32 row = m_firstSides[body]; row != kEnd; row = m_sides[row].Next) {
        const SMotion& speed = m_sides[row].Speed;
        m_matrix[row / 2][column / 2] += speed.X * x + speed.Y * y + speed.Turn * turn;
      }
    }
  }
}

// What springs and turrets that turn by themselves add.
template <typename NUMBER>
void CIslandNewton<NUMBER>::AddTurrets() {
  for (size_t number = 0; number < m_grips.size(); ++number) {
    const SIslandGrip<NUMBER>& grip = m_grips[number];
    const size_t first = m_firstOfGrips + 2 * number;
    for (const int i : {kAxisAlong, kAxisAcross}) {
      m_matrix[first + i][first + i] += grip.Softness[i];
      for (const int j : {kAxisAlong, kAxisAcross}) {
        m_matrix[first + i][first + j] +=
            m_turns[number] ? grip.InverseArmInertia * grip.ArmLever[i] * grip.ArmLever[j]
                            : NUMBER(0);
      }
    }
  }
}

// Gaussian elimination in the order of contacts: because of the damping, elements of the diagonal
// are hardly ever too small.
template <typename NUMBER>
bool CIslandNewton<NUMBER>::SolveEquations() {
  constexpr auto kTooSmall = NUMBER(1e-4);
  for (size_t step = 0; step < m_count; ++step) {
    const auto& pivot = m_matrix[step];
    if (!(std::abs(pivot[step]) > kTooSmall * m_own[step])) {
      return false;
    }
    const NUMBER inverse = NUMBER(1) / pivot[step];
    for (size_t i = step + 1; i < m_count; ++i) {
      auto& row = m_matrix[i];
      const NUMBER share = row[step] * inverse;
      if (share == NUMBER(0)) {
        continue;
      }
      // what is left of the diagonal has no meaning any more
      for (size_t first = step / kLanes * kLanes; first <= m_count; first += kLanes) {
        for (size_t j = first; j < first + kLanes; ++j) {
          row[j] -= share * pivot[j];
        }
      }
    }
  }
  for (size_t i = m_count; i-- > 0;) {
    NUMBER sum = m_matrix[i][m_count];
    for (size_t j = i + 1; j < m_count; ++j) {
      sum -= m_matrix[i][j] * m_changes[j];
    }
    m_changes[i] = sum / m_matrix[i][i];
    if (!std::isfinite(m_changes[i])) {
      return false;
    }
  }
  return true;
}

// The new impulses, within their bounds.
template <typename NUMBER>
void CIslandNewton<NUMBER>::TakeImpulses() {
  size_t next = 0;
  for (size_t i = 0; i < m_contacts.size(); ++i) {
    SIslandContact<NUMBER>& contact = m_contacts[i];
    const NUMBER* const impulse = contact.Impulse.Now;
    const EState state = m_states[i];
    NUMBER normal = NUMBER(0);
    NUMBER tangent = NUMBER(0);
    if (state != EState::Open) {
      normal = std::max(NUMBER(0), impulse[kAxisNormal] + m_changes[next++]);
      const NUMBER most = contact.Friction * normal;
      if (state == EState::Sticks) {
        tangent = std::clamp(impulse[kAxisTangent] + m_changes[next++], -most, most);
      } else if (state != EState::Frictionless) {
        tangent = state == EState::Slides ? most : -most;
      }
    }
    ChangeImpulse(m_bodies[contact.A], m_bodies[contact.B], contact, normal, tangent);
  }
  for (SIslandGrip<NUMBER>& grip : m_grips) {
    const SGripChange<NUMBER> change = {m_changes[next], m_changes[next + 1], NUMBER(0)};
    next += 2;
    ApplyGripChange(m_bodies, grip, change);
  }
}

template class CIslandNewton<float>;
template class CIslandNewton<double>;

}  // namespace argos
