#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_IMPULSE_SOLVER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_IMPULSE_SOLVER_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/impulse_blocks.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/sweep_mixing.h>

#include <array>
#include <vector>

namespace argos {

/**
 * Finds the impulses of contacts, grips and motors among the bodies of one island in a substep.
 *
 * Block Gauss-Seidel: sweeps over the blocks, each of which is solved exactly with the others
 * fixed, from the impulses of the last substep on, until speeds no longer change. A contact obeys
 * Coulomb's law with its cone: the friction is at most mu times the present normal impulse,
 * opposite to the sliding. A wheel or turret is a rotor: it moves with its robot, except for its
 * spin, so that no joint has to hold it. Its motor is solved together with the block it acts on.
 *
 * From sweep to sweep the impulses are extrapolated, so that towers and rows of bodies converge in
 * tens of sweeps instead of hundreds.
 *
 * Source: K. Erleben, Velocity-based shock propagation for multibody dynamics animation, ACM TOG
 * 26 (2007) (sweeps); J. J. Moreau, Numerical aspects of the sweeping process, CMAME 177 (1999).
 */
class CImpulseSolver {
 public:
  static constexpr UInt32 kNone = static_cast<UInt32>(-1);
  /** The number of the body that cannot move. */
  static constexpr UInt32 kGround = 0;
  /** Makes the distribution of forces on redundant contacts and balls unique: the most even one. */
  static constexpr Real kSoftness = 1e-3;

  struct SBody {
    CVector3 Velocity;  // of the centre of mass, m/s
    CVector3 Turn;  // rad/s
    Real InverseMass = 0.0;  // 1/kg
    SSymmetric3 InverseInertia;  // world frame, 1/(kg m^2)
  };

  /** A part of a body that spins about an axis of it. */
  struct SRotor {
    UInt32 Body = kGround;
    CVector3 Axis;  // world frame, of length 1
    Real InverseInertia = 0.0;  // about the axis, 1/(kg m^2)
    Real Spin = 0.0;  // rad/s about the axis, against the world
    Real Target = 0.0;  // rad/s against the body, of its motor
    Real Limit = 0.0;  // N m s, of its motor in a substep
    Real Impulse = 0.0;  // N m s, of its motor
    CVector3 AxisPerInertia;  // set by Prepare(), as the rest
    Real Resistance = 0.0;  // change of the spin against the body for an impulse of 1
    bool IsAlone = true;  // no block acts on it
    Real Start = 0.0;  // its impulse before the sweep
  };

  enum class EKind {
    Contact, /**< along x at least the target; along y and z friction */
    Ball, /**< x, y and z equal the targets */
    Drive /**< along y and z a bounded force at the centre of mass, x is a bounded torque */
  };

  /** Three impulses at right angles: on the first body, and opposite on the second one. */
  struct SBlock {
    EKind Kind = EKind::Contact;
    UInt32 First = kGround;
    UInt32 Second = kGround;
    UInt32 Rotor = kNone;  // of the first body, on which the impulses act
    std::array<CVector3, 3> Directions;  // world frame; of a contact: the normal, to the first
    CVector3 FirstArm;  // from the centre of mass to the point, m
    CVector3 SecondArm;
    CVector3 RotorArm;  // from a point of the rotor's axis to the point, m
    std::array<Real, 3> Targets{};  // relative speeds, m/s, rad/s
    // of a contact along the normal, of a ball: m/s for 1 N s; 0: kSoftness of its resistance
    Real Softness = 0.0;
    Real Settled = 0.0;  // N s, of a contact: normal impulse for which softness makes no speed
    Real Friction = 0.0;  // of a contact: coefficient
    // m, of a contact: radius of the patch on which it rubs against spinning about the normal, and
    // how far the pressure moves ahead of its middle against rolling
    Real Patch = 0.0;
    Real RollArm = 0.0;
    Real ForceLimit = 0.0;  // N s, of a drive or a ball
    Real TorqueLimit = 0.0;  // N m s, of a drive
    std::array<Real, 3> Impulses{};  // N s; at the start: of the last substep
    // set by Prepare(): speeds as functions of the motion, and changes of it by impulses of 1
    std::array<CVector3, 3> FirstTurns;
    std::array<CVector3, 3> SecondTurns;
    std::array<CVector3, 3> FirstSpins;
    std::array<CVector3, 3> SecondSpins;
    std::array<Real, 3> RotorTurns{};
    std::array<Real, 3> RotorCoupling{};  // change of the rotor's spin against its body
    SSymmetric3 Resistance;  // changes of the three speeds for impulses of 1
    SSymmetric3 DrivenResistance;  // with a motor that keeps its speed
    std::array<Real, 3> Changes{};  // of the impulses in the last sweep
    // of the patch, about the normal and across it: changes of the turn for an impulse of 1
    Real SpinResistance = 0.0, RollResistance = 0.0;
    Real SpinImpulse = 0.0;  // N m s
    CVector3 RollImpulse;  // N m s
  };

  /** Allocates for an island of that many bodies and blocks. */
  void Reserve(size_t bodies, size_t blocks);
  /** Removes everything but the ground. */
  void Clear();
  /** Sets what follows from the masses, and applies the impulses of the last substep. */
  void Prepare();
  /**
   * Sweeps until no impulse changes a speed by more than a tolerance, which grows with the cube of
   * the sweeps: 9 times as much after 50, 65 after 100, 4000 after 400.
   * @param tolerance m/s. @param extrapolates  from sweep to sweep: each costs half more.
   * @return the number of sweeps.
   */
  UInt32 Solve(UInt32 maxSweeps, Real tolerance, bool extrapolates = true);

  std::vector<SBody> Bodies;  // the first one is the ground
  std::vector<SRotor> Rotors;
  std::vector<SBlock> Blocks;

 private:
  void PrepareBlock(SBlock& block);
  Real Sweep();
  void Extrapolate();
  Real SolveBlock(SBlock& block);
  void RubPatch(SBlock& block);
  Real SolveRotor(SRotor& rotor);
  std::array<Real, 3> ComputeErrors(const SBlock& block) const;
  void Apply(const SBlock& block, const std::array<Real, 3>& change);
  void Turn(SRotor& rotor, Real change);

  CSweepMixing m_mixing;
};

}  // namespace argos

#endif
