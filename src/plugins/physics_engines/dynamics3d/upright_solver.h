#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_UPRIGHT_SOLVER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_UPRIGHT_SOLVER_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/upright_body.h>

#include <span>
#include <vector>

namespace argos {

/** A contact point of an upright body with another one, or with something that does not move. */
struct SUprightContact {
  static constexpr UInt32 kNone = ~UInt32(0);

  UInt32 A = 0, B = kNone;  // bodies; B is kNone for something immovable
  Real NX = 0.0, NY = 0.0;  // from A to B
  // of the normal and of the tangent about the centres of mass, m
  Real NormalLeverA = 0.0, TangentLeverA = 0.0, NormalLeverB = 0.0, TangentLeverB = 0.0;
  Real Approach = 0.0;  // greatest speed of approach, m/s; negative: they must part
  Real Friction = 0.0;
  Real Mass = 0.0, TangentMass = 0.0;  // that resist, kg; set by the solver
  Real InverseMass = 0.0, InverseTangentMass = 0.0;  // 1/kg
  Real Normal = 0.0, Tangent = 0.0;  // impulses, N s
  // the search: impulses before the sweep, and the direction in which they change
  Real LastNormal = 0.0, LastTangent = 0.0, StepNormal = 0.0, StepTangent = 0.0;
  UInt32 LastSweep = 0;  // in which it was solved
  UInt32 Source = 0;  // whose force it is: see CUprightCrowd
  Real Low = 0.0, High = 0.0;  // between which it acts above the floor, m
};

/**
 * Finds the impulses of contacts, drives and friction among upright bodies in a substep: a planar
 * problem, with three degrees of freedom for each body.
 *
 * Block Gauss-Seidel, as CImpulseSolver: sweeps over the drives of bodies, each of which is solved
 * in closed form while it holds its speed, and over contacts. The sweeps of an island are steps of
 * a nonsmooth nonlinear conjugate gradient method. All go in one direction, because
 * with alternating directions the method restarts more often and needs a quarter more sweeps.
 *
 * Source: M. Silcowitz-Hansen, S. Niebe, K. Erleben, A Nonsmooth Nonlinear Conjugate Gradient
 * Method for Interactive Contact Force Problems, 2010.
 */
class CUprightSolver {
 public:
  /** The bodies and contacts of an island, which no contact connects with others. */
  struct SIsland {
    std::span<const UInt32> Bodies;
    std::span<const UInt32> Contacts;
  };

  CUprightSolver(std::vector<SUprightBody>& bodies, std::vector<SUprightSupport>& supports,
                 std::vector<SUprightContact>& contacts)
      : m_bodies(bodies), m_supports(supports), m_contacts(contacts) {}

  /** Sets what follows from masses; applies the impulses with which contacts start. */
  void Prepare(const SIsland& island) const;
  /** @param tolerance m/s. @return the number of sweeps. */
  UInt32 Solve(const SIsland& island, UInt32 maxSweeps, Real tolerance) const;

 private:
  // Bodies that have hardly changed since the sweep before, and their contacts, are not due.
  struct SSweep {
    UInt32 Number = 1;
    Real Slight = 0.0;  // m/s: a change that does not matter to others

    bool IsDue(const SUprightBody& body) const { return body.LastSweep + 1 >= Number; }
    void Mark(SUprightBody& body, Real change) const {
      body.LastSweep = change > Slight ? Number : body.LastSweep;
    }
  };

  // What a sweep changed.
  struct SChange {
    Real Speed = 0.0;  // the greatest, m/s
    Real Energy = 0.0;  // of the impulses of contacts, J
  };

  SChange Sweep(const SIsland& island, const SSweep& sweep) const;
  Real SolveDrive(SUprightBody& body) const;
  bool HoldFeet(SUprightBody& body, SUprightSupport* feet) const;
  bool HoldWheels(SUprightBody& body, SUprightSupport* wheels) const;
  void SolvePlanarDrive(SUprightBody& body) const;
  void SolveFeet(SUprightBody& body, SUprightSupport* feet) const;
  void SolveWheels(SUprightBody& body, SUprightSupport* wheels) const;
  Real SolveContact(SUprightContact& contact, Real& energy) const;
  void Apply(const SUprightContact& contact, Real normal, Real tangent) const;
  void StepOn(const SIsland& island, const SSweep& sweep, Real share) const;

  std::vector<SUprightBody>& m_bodies;
  std::vector<SUprightSupport>& m_supports;
  std::vector<SUprightContact>& m_contacts;
};

}  // namespace argos

#endif
