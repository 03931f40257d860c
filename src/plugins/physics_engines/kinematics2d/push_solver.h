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
  /**
   * Adds a contact. Its normal is of unit length and looks at the body @p pushed.
   * @param pushing, pushed  numbers; @p pushing may be kNobody: something that the solver does not
   *                         move.
   * @param leverPushing, leverPushed  of the normal about the bodies' origins, m.
   * @param need  by how much more than the one that pushes must the pushed one move along the
   * normal in this tick, m.
   * @param cap   bound of the force, N.
   */
  void AddContact(UInt32 pushing, UInt32 pushed, Real normalX, Real normalY, Real leverPushing,
                  Real leverPushed, Real need, Real cap);
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
  struct SContact {
    UInt32 Pushing, Pushed;
    Real NormalX, NormalY;
    Real LeverPushing, LeverPushed;  // m
    Real Need;  // m
    Real Cap;  // N
    Real Give;  // m/N, of both
    Real Force;  // N
  };

  void Prepare();
  void GuessFriction();
  Real SolveContacts();
  Real SolveContact(SContact& contact);
  void SolveFriction(SBody& body);
  static void Push(SBody& body, Real x, Real y, Real torque);

  std::vector<SBody> m_bodies;
  std::vector<SContact> m_contacts;
  Real m_greatestNeed = 0.0;  // m
};

}  // namespace argos

#endif
