#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_PUSH_SOLVER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_PUSH_SOLVER_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace argos {

/** How a body moves in a tick: m, and rad about its origin. */
struct STwist {
  Real X = 0.0;
  Real Y = 0.0;
  Real Turn = 0.0;
};

/**
 * Finds out how bodies that rub on the ground move when they are pushed.
 *
 * Quasi-static: bodies have no momentum. What pushes moves as it wants, with a force up to a bound;
 * friction resists with a force and a torque up to theirs; bodies do not go into each other or into
 * what stands fast. Forces are found by sweeps over contacts and frictions (projected
 * Gauss-Seidel), as a solver of rigid bodies does, of bodies that begin every tick at rest and are
 * so light that friction alone counts.
 */
class CPushSolver {
 public:
  static constexpr UInt32 kNobody = std::numeric_limits<UInt32>::max();
  static constexpr Real kUnlimited = std::numeric_limits<Real>::infinity();

  /** Where a body is pushed. The normal is of unit length and looks at the one that is pushed. */
  struct SContact {
    UInt32 Pushing = kNobody; /**< number of a body, or kNobody: something that is not moved */
    UInt32 Pushed = 0; /**< number of a body */
    Real NormalX = 0.0, NormalY = 0.0;
    Real LeverPushing = 0.0, LeverPushed = 0.0; /**< of the normal about the bodies' origins, m */
    /** By how much more than the one that pushes the pushed one is to move along the normal, m. */
    Real Need = 0.0;
    Real Cap = kUnlimited; /**< bound of the force for that, N */
    /** By how much it must move in any case, so that they do not overlap, m; <= Need. */
    Real Least = 0.0;
  };

  /** Forgets all bodies and contacts. */
  void Clear();
  /**
   * Adds a body.
   * @param twist            what it does if nothing is in its way.
   * @param force, torque    bounds of its friction, N and N m.
   * @param squaredGyration  moment of inertia over mass, m^2.
   * @return its number.
   */
  UInt32 AddBody(const STwist& twist, Real force, Real torque, Real squaredGyration);
  void AddContact(const SContact& contact);
  void Solve();
  const STwist& GetTwist(UInt32 body) const { return m_bodies[body].Twist; }

 private:
  struct SBody {
    STwist Twist;
    Real Force, Torque;  // N, N m
    Real SquaredGyration;  // m^2
    Real Give, TurnGive;  // m/N, rad/(N m): how it yields
    Real UsedX, UsedY, UsedTorque;  // of friction, N, N m
  };
  struct SForce : SContact {
    Real Give;  // m/N, of both
    Real Force;  // N
  };

  void Prepare();
  void GuessFriction();
  Real SolveContacts();
  Real SolveContact(SForce& contact);
  Real ComputeMotion(const SContact& contact) const;
  void AddForce(SForce& contact, Real change);
  void KeepApart();
  void SolveFriction(SBody& body);
  static void Push(SBody& body, Real x, Real y, Real torque);

  std::vector<SBody> m_bodies;
  std::vector<SForce> m_contacts;
  Real m_greatestNeed = 0.0;  // m
};

}  // namespace argos

#endif
