#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_PUSH_SOLVER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_PUSH_SOLVER_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace argos {

/** The motion of a body in a tick: m, and rad about its origin. */
struct STwist {
  Real X = 0.0;
  Real Y = 0.0;
  Real Turn = 0.0;
};

/**
 * Computes how bodies with ground friction move when they are pushed.
 *
 * Quasi-static: bodies have no momentum. A pusher moves as planned, with a bounded force; friction
 * resists with a bounded force and torque; bodies do not penetrate each other or fixed obstacles.
 * Forces are found by sweeps over contacts and frictions (projected Gauss-Seidel), as in a solver
 * for rigid bodies that start every tick at rest and whose inertia is negligible against friction.
 */
class CPushSolver {
 public:
  static constexpr UInt32 kNone = std::numeric_limits<UInt32>::max();
  static constexpr Real kUnlimited = std::numeric_limits<Real>::infinity();

  /** A contact in which a body is pushed. The normal has unit length and points to that body. */
  struct SContact {
    UInt32 Pushing = kNone; /**< number of a body; kNone: an obstacle that does not move */
    UInt32 Pushed = 0; /**< number of a body */
    Real NormalX = 0.0, NormalY = 0.0;
    Real LeverPushing = 0.0, LeverPushed = 0.0; /**< of the normal about the bodies' origins, m */
    /** Wanted motion of the pushed body along the normal, relative to the pushing one, m. */
    Real Need = 0.0;
    Real Cap = kUnlimited; /**< bound of the force for Need, N */
    /** Motion that is required in any case to prevent an overlap, m; <= Need. */
    Real Least = 0.0;
  };

  /** Removes all bodies and contacts. */
  void Clear();
  /**
   * Adds a body.
   * @param twist            its motion without contacts.
   * @param force, torque    bounds of its friction, N and N m.
   * @param squaredGyration  moment of inertia over mass, m^2.
   * @return its number.
   */
  UInt32 AddBody(const STwist& twist, Real force, Real torque, Real squaredGyration);
  void AddContact(const SContact& contact);
  void Solve();
  const STwist& GetTwist(UInt32 body) const {
    CheckNumber(body);
    return m_bodies[body].Twist;
  }

 private:
  struct SBody {
    STwist Twist;
    Real Force, Torque;  // N, N m
    Real SquaredGyration;  // m^2
    Real Give, TurnGive;  // m/N, rad/(N m): compliance
    Real UsedX, UsedY, UsedTorque;  // of friction, N, N m
  };
  struct SForce : SContact {
    Real Give;  // m/N, of both
    Real Force;  // N
  };

  void CheckNumber([[maybe_unused]] UInt32 body) const {
    ARGOS_ASSERT(body < m_bodies.size(), "the solver has no body with the number " << body);
  }
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
