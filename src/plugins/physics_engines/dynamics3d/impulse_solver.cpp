#include <argos3/plugins/simulator/physics_engines/dynamics3d/impulse_solver.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

using TTriple = std::array<Real, 3>;

// sweeps from which on the tolerance grows
constexpr Real kManySweeps = 25.0;

CVector3 CrossOf(CVector3 a, const CVector3& b) {
  return a.CrossProduct(b);
}

TTriple Times(const SSymmetric3& matrix, const TTriple& v) {
  const CVector3 product = matrix * CVector3(v[0], v[1], v[2]);
  return {product.GetX(), product.GetY(), product.GetZ()};
}

Real Clamped(Real value, Real limit) {
  return std::clamp(value, -limit, limit);
}

// A grip that would bear more than its limit bears the limit.
TTriple Shortened(const TTriple& impulses, Real limit) {
  const Real length = CVector3(impulses[0], impulses[1], impulses[2]).Length();
  const Real scale = length > limit ? limit / length : 1.0;
  return {scale * impulses[0], scale * impulses[1], scale * impulses[2]};
}

TTriple SolveBall(const CImpulseSolver::SBlock& block, SSymmetric3 k, TTriple errors) {
  k.XX += block.Softness;
  k.YY += block.Softness;
  k.ZZ += block.Softness;
  for (size_t i = 0; i < 3; ++i) {
    errors[i] += block.Softness * block.Impulses[i];
  }
  const TTriple change = Times(k.Inverted(), errors);
  const TTriple& now = block.Impulses;
  return Shortened({now[0] - change[0], now[1] - change[1], now[2] - change[2]}, block.ForceLimit);
}

// The impulses of a block for which its speeds, which are now off their targets by these errors,
// obey its law.
TTriple SolveLaw(const CImpulseSolver::SBlock& block, const SSymmetric3& k, const TTriple& errors) {
  using EKind = CImpulseSolver::EKind;
  const TTriple& now = block.Impulses;
  TTriple next{};
  if (block.Kind == EKind::Ball) {
    return SolveBall(block, k, errors);
  }
  Real limit = block.ForceLimit;
  if (block.Kind == EKind::Drive) {
    next[0] = Clamped(now[0] - errors[0] / k.XX, block.TorqueLimit);
  } else {
    const Real soft = block.Softness * (now[0] - block.Settled);
    next[0] = std::max(0.0, now[0] - (errors[0] + soft) / (k.XX + block.Softness));
    limit = block.Friction * next[0];
  }
  if (!(limit > 0.0)) {
    return {next[0], 0.0, 0.0};
  }
  const Real change = next[0] - now[0];
  const SPair2 b{k.YY * now[1] + k.YZ * now[2] - errors[1] - k.XY * change,
                 k.YZ * now[1] + k.ZZ * now[2] - errors[2] - k.XZ * change};
  const SPair2 friction = SolveFriction(k.YY, k.YZ, k.ZZ, b, limit);
  return {next[0], friction.X, friction.Y};
}

}  // namespace

void CImpulseSolver::Reserve(size_t bodies, size_t blocks) {
  Bodies.reserve(bodies + 1);
  Rotors.reserve(4 * bodies);
  Blocks.reserve(blocks);
  m_mixing.Start(4 * bodies + 3 * blocks);
}

void CImpulseSolver::Clear() {
  Bodies.clear();
  Bodies.emplace_back();
  Rotors.clear();
  Blocks.clear();
}

void CImpulseSolver::Prepare() {
  for (SRotor& rotor : Rotors) {
    rotor.AxisPerInertia = Bodies[rotor.Body].InverseInertia * rotor.Axis;
    rotor.Resistance = rotor.Axis.DotProduct(rotor.AxisPerInertia) + rotor.InverseInertia;
    rotor.IsAlone = true;
    const Real impulse = Clamped(rotor.Impulse, rotor.Limit);
    rotor.Impulse = 0.0;
    Turn(rotor, impulse);
  }
  for (SBlock& block : Blocks) {
    PrepareBlock(block);
    Apply(block, block.Impulses);
  }
}

void CImpulseSolver::PrepareBlock(SBlock& block) {
  const SBody& first = Bodies[block.First];
  const SBody& second = Bodies[block.Second];
  SRotor* const rotor = block.Rotor != kNone ? &Rotors[block.Rotor] : nullptr;
  // the speed of the point per spin of the rotor against its body
  CVector3 rim;
  if (rotor != nullptr) {
    rim = CrossOf(rotor->Axis, block.RotorArm);
    rotor->IsAlone = false;
  }
  for (size_t i = 0; i < 3; ++i) {
    const CVector3& direction = block.Directions[i];
    block.FirstTurns[i] = CrossOf(block.FirstArm, direction);
    block.SecondTurns[i] = CrossOf(block.SecondArm, direction);
    if (block.Kind == EKind::Drive) {
      block.FirstTurns[i] = i == 0 ? direction : CVector3();
      block.SecondTurns[i] = CVector3();
    }
    if (rotor != nullptr) {
      block.RotorTurns[i] = rim.DotProduct(direction);
      block.FirstTurns[i] -= rotor->Axis * block.RotorTurns[i];
    }
    block.FirstSpins[i] = first.InverseInertia * block.FirstTurns[i];
    block.SecondSpins[i] = second.InverseInertia * block.SecondTurns[i];
  }
  const Real mass = first.InverseMass + second.InverseMass;
  const Real spin = rotor != nullptr ? rotor->InverseInertia : 0.0;
  const auto resist = [&](size_t i, size_t j) {
    return block.FirstTurns[i].DotProduct(block.FirstSpins[j]) +
           block.SecondTurns[i].DotProduct(block.SecondSpins[j]) +
           spin * block.RotorTurns[i] * block.RotorTurns[j];
  };
  const bool turns = block.Kind == EKind::Drive;
  block.Resistance = {(turns ? 0.0 : mass) + resist(0, 0),
                      mass + resist(1, 1),
                      mass + resist(2, 2),
                      resist(0, 1),
                      resist(0, 2),
                      resist(1, 2)};
  block.DrivenResistance = block.Resistance;
  if (block.Softness == 0.0) {
    block.Softness = kSoftness * block.Resistance.XX;
  }
  if (block.Patch > 0.0) {
    const auto resistTurn = [&](const CVector3& axis) {
      return axis.DotProduct(first.InverseInertia * axis + second.InverseInertia * axis);
    };
    block.SpinResistance = resistTurn(block.Directions[0]);
    block.RollResistance =
        std::max(resistTurn(block.Directions[1]), resistTurn(block.Directions[2]));
  }
  if (rotor != nullptr) {
    for (size_t i = 0; i < 3; ++i) {
      block.RotorCoupling[i] =
          rotor->InverseInertia * block.RotorTurns[i] - rotor->Axis.DotProduct(block.FirstSpins[i]);
    }
    const TTriple& c = block.RotorCoupling;
    block.DrivenResistance.AddDyad(CVector3(c[0], c[1], c[2]), -1.0 / rotor->Resistance);
  }
}

// What two solids that touch in a point press on is a patch: its friction stops them from spinning
// against each other, and the pressure, which moves ahead of its middle, from rolling.
void CImpulseSolver::RubPatch(SBlock& block) {
  SBody& first = Bodies[block.First];
  SBody& second = Bodies[block.Second];
  const CVector3& normal = block.Directions[0];
  const CVector3 turn = first.Turn - second.Turn;
  const Real spin = turn.DotProduct(normal);
  const Real spinImpulse = Clamped(block.SpinImpulse - spin / block.SpinResistance,
                                   block.Friction * block.Patch * block.Impulses[0]);
  CVector3 rollImpulse = block.RollImpulse - (turn - normal * spin) / block.RollResistance;
  const Real most = block.RollArm * block.Impulses[0];
  const Real square = rollImpulse.SquareLength();
  if (square > most * most) {
    rollImpulse *= most / std::sqrt(square);
  }
  const CVector3 change =
      normal * (spinImpulse - block.SpinImpulse) + rollImpulse - block.RollImpulse;
  block.SpinImpulse = spinImpulse;
  block.RollImpulse = rollImpulse;
  first.Turn += first.InverseInertia * change;
  second.Turn -= second.InverseInertia * change;
}

TTriple CImpulseSolver::ComputeErrors(const SBlock& block) const {
  const SBody& first = Bodies[block.First];
  const SBody& second = Bodies[block.Second];
  const CVector3 velocity = first.Velocity - second.Velocity;
  const Real spin = block.Rotor != kNone ? Rotors[block.Rotor].Spin : 0.0;
  TTriple errors;
  for (size_t i = 0; i < 3; ++i) {
    errors[i] = block.FirstTurns[i].DotProduct(first.Turn) -
                block.SecondTurns[i].DotProduct(second.Turn) + block.RotorTurns[i] * spin -
                block.Targets[i];
    if (i > 0 || block.Kind != EKind::Drive) {
      errors[i] += block.Directions[i].DotProduct(velocity);
    }
  }
  return errors;
}

void CImpulseSolver::Apply(const SBlock& block, const TTriple& change) {
  SBody& first = Bodies[block.First];
  SBody& second = Bodies[block.Second];
  CVector3 push = block.Directions[1] * change[1] + block.Directions[2] * change[2];
  if (block.Kind != EKind::Drive) {
    push += block.Directions[0] * change[0];
  }
  first.Velocity += push * first.InverseMass;
  second.Velocity -= push * second.InverseMass;
  for (size_t i = 0; i < 3; ++i) {
    first.Turn += block.FirstSpins[i] * change[i];
    second.Turn -= block.SecondSpins[i] * change[i];
  }
  if (block.Rotor != kNone) {
    SRotor& rotor = Rotors[block.Rotor];
    rotor.Spin +=
        rotor.InverseInertia * (block.RotorTurns[0] * change[0] + block.RotorTurns[1] * change[1] +
                                block.RotorTurns[2] * change[2]);
  }
}

void CImpulseSolver::Turn(SRotor& rotor, Real change) {
  rotor.Impulse += change;
  rotor.Spin += rotor.InverseInertia * change;
  Bodies[rotor.Body].Turn -= rotor.AxisPerInertia * change;
}

// A motor that is not at its limit keeps its speed whatever the block does; else it adds its limit.
Real CImpulseSolver::SolveBlock(SBlock& block) {
  TTriple errors = ComputeErrors(block);
  const SSymmetric3* resistance = &block.Resistance;
  TTriple next;
  Real torque = 0.0;
  if (block.Rotor != kNone) {
    SRotor& rotor = Rotors[block.Rotor];
    const Real slow = rotor.Spin - rotor.Axis.DotProduct(Bodies[rotor.Body].Turn) - rotor.Target;
    const TTriple& c = block.RotorCoupling;
    TTriple driven;
    for (size_t i = 0; i < 3; ++i) {
      driven[i] = errors[i] - c[i] * slow / rotor.Resistance;
    }
    next = SolveLaw(block, block.DrivenResistance, driven);
    torque = -slow;
    for (size_t i = 0; i < 3; ++i) {
      torque -= c[i] * (next[i] - block.Impulses[i]);
    }
    torque /= rotor.Resistance;
    const Real possible = Clamped(rotor.Impulse + torque, rotor.Limit) - rotor.Impulse;
    if (possible != torque) {
      torque = possible;
      for (size_t i = 0; i < 3; ++i) {
        errors[i] += c[i] * torque;
      }
      next = SolveLaw(block, *resistance, errors);
    }
    Turn(rotor, torque);
  } else {
    next = SolveLaw(block, *resistance, errors);
  }
  const Real diagonal[3] = {block.Resistance.XX, block.Resistance.YY, block.Resistance.ZZ};
  Real greatest = 0.0;
  for (size_t i = 0; i < 3; ++i) {
    block.Changes[i] = next[i] - block.Impulses[i];
    greatest = std::max(greatest, std::abs(block.Changes[i]) * diagonal[i]);
  }
  Apply(block, block.Changes);
  block.Impulses = next;
  if (block.Patch > 0.0) {
    RubPatch(block);
  }
  return greatest;
}

// @return the change of its speed, in the unit of speeds of blocks for an arm of 1 m.
Real CImpulseSolver::SolveRotor(SRotor& rotor) {
  const Real slow = rotor.Spin - rotor.Axis.DotProduct(Bodies[rotor.Body].Turn) - rotor.Target;
  const Real next = Clamped(rotor.Impulse - slow / rotor.Resistance, rotor.Limit);
  const Real change = next - rotor.Impulse;
  Turn(rotor, change);
  return std::abs(change) * rotor.Resistance;
}

// @return the greatest change of a speed, m/s.
Real CImpulseSolver::Sweep() {
  Real greatest = 0.0;
  for (SRotor& rotor : Rotors) {
    rotor.Start = rotor.Impulse;
    if (rotor.IsAlone) {
      greatest = std::max(greatest, SolveRotor(rotor));
    }
  }
  for (SBlock& block : Blocks) {
    greatest = std::max(greatest, SolveBlock(block));
  }
  return greatest;
}

// The next sweep makes the impulses obey their laws again.
void CImpulseSolver::Extrapolate() {
  size_t i = 0;
  for (const SRotor& rotor : Rotors) {
    m_mixing.GetResult()[i] = rotor.Impulse;
    m_mixing.GetChange()[i] = rotor.Impulse - rotor.Start;
    m_mixing.GetWeights()[i++] = rotor.Resistance;
  }
  for (const SBlock& block : Blocks) {
    const Real diagonal[3] = {block.Resistance.XX, block.Resistance.YY, block.Resistance.ZZ};
    for (size_t j = 0; j < 3; ++j) {
      m_mixing.GetResult()[i] = block.Impulses[j];
      m_mixing.GetChange()[i] = block.Changes[j];
      m_mixing.GetWeights()[i++] = diagonal[j];
    }
  }
  const std::vector<Real>* const proposed = m_mixing.Propose();
  if (proposed == nullptr) {
    return;
  }
  const Real* step = proposed->data();
  for (SRotor& rotor : Rotors) {
    Turn(rotor, *step++);
  }
  for (SBlock& block : Blocks) {
    const TTriple further = {step[0], step[1], step[2]};
    step += 3;
    for (size_t j = 0; j < 3; ++j) {
      block.Impulses[j] += further[j];
    }
    Apply(block, further);
  }
}

UInt32 CImpulseSolver::Solve(UInt32 maxSweeps, Real tolerance, bool extrapolates) {
  if (extrapolates) {
    m_mixing.Start(Rotors.size() + 3 * Blocks.size());
  }
  for (UInt32 sweep = 1; sweep < maxSweeps; ++sweep) {
    const Real change = Sweep();
    // what converges slowly are forces of redundant contacts against each other, which hardly move
    // bodies; the next substep continues
    const Real late = static_cast<Real>(sweep) / kManySweeps;
    if (change <= tolerance * (1.0 + late * late * late)) {
      return sweep;
    }
    // the last sweeps, if they do not converge, must not be left with an extrapolation that fails
    if (extrapolates && 4 * sweep < 3 * maxSweeps) {
      Extrapolate();
    }
  }
  Sweep();
  return maxSweeps;
}

}  // namespace argos
