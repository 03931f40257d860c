#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_CONTACT_ISLAND_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_CONTACT_ISLAND_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <algorithm>
#include <initializer_list>
#include <span>

namespace argos {

/** Of the motion of a body, and of its drive's impulse. */
enum EIslandAxis { kAxisX, kAxisY, kAxisTurn };
/** Of the impulse of a contact. */
enum EContactAxis { kAxisNormal, kAxisTangent };

/** A value that is searched: what it is, was before the last sweep, and where it moved. */
template <typename NUMBER, int COUNT>
struct SSearched {
  NUMBER Now[COUNT] = {}, Before[COUNT] = {}, Step[COUNT] = {};

  void Set(std::initializer_list<NUMBER> values) { std::copy(values.begin(), values.end(), Now); }
  /** Begins a search at what it is now. */
  void Start() {
    std::copy_n(Now, COUNT, Before);
    std::fill_n(Step, COUNT, NUMBER(0));
  }
  /** Goes back to where the search began. */
  void Return() { std::copy_n(Before, COUNT, Now); }
  /** Adds a share of the step before; the change of the last sweep and that are the next one. */
  void StepOn(NUMBER share) {
    for (int i = 0; i < COUNT; ++i) {
      const NUMBER further = share * Step[i];
      Step[i] = further + (Now[i] - Before[i]);
      Before[i] = Now[i] += further;
    }
  }
};

/** A body of an island; without values: something immovable. */
template <typename NUMBER>
struct SIslandBody {
  SSearched<NUMBER, 4> Velocity;  // m/s, rad/s
  SSearched<NUMBER, 4> Impulse;  // of the drive, N s, N m s
  // the drive: what it aims at, and the bounds of its impulses
  NUMBER Target[4] = {};  // m/s, rad/s
  NUMBER Most = NUMBER(0), AngularMost = NUMBER(0);  // N s, N m s
  NUMBER InverseMass = NUMBER(0), InverseInertia = NUMBER(0);  // 1/kg, 1/(kg m^2)
  NUMBER Mass = NUMBER(0), Inertia = NUMBER(0);  // kg, kg m^2
};

/** A contact point of an island. */
template <typename NUMBER>
struct SIslandContact {
  SSearched<NUMBER, 2> Impulse;  // N s
  UInt32 A = 0, B = 0;  // numbers of bodies in the island
  NUMBER NX = NUMBER(0), NY = NUMBER(0);  // normal, from A to B
  // of the normal and of the tangent about the centres of mass, m
  NUMBER NormalLeverA = NUMBER(0), TangentLeverA = NUMBER(0), NormalLeverB = NUMBER(0),
         TangentLeverB = NUMBER(0);
  NUMBER Approach = NUMBER(0);  // greatest speed of approach, m/s
  NUMBER Mass = NUMBER(0), InverseMass = NUMBER(0);  // that resists along the normal, kg, 1/kg
  NUMBER TangentMass = NUMBER(0), InverseTangentMass = NUMBER(0);  // along the tangent
  NUMBER Friction = NUMBER(0);  // coefficient
};

/** Of the impulse of a grip. */
enum EGripAxis { kAxisAlong, kAxisAcross, kAxisMotor };

/**
 * A grip of an island: a point of B is held at the end of an arm of A, by a spring along the arm,
 * rigidly across it, and free to rotate. The arm may be on a turret of A, which has no mass of its
 * own, but an inertia, and is turned against A by a motor of bounded torque.
 */
template <typename NUMBER>
struct SIslandGrip {
  SSearched<NUMBER, 3> Impulse;  // N s, of the motor N m s
  SSearched<NUMBER, 1> ArmRate;  // of the turret, rad/s
  UInt32 A = 0, B = 0;  // numbers of bodies in the island
  NUMBER NX = NUMBER(1), NY = NUMBER(0);  // the axis along the arm
  // of the two axes: about the centre of mass of A (of the turret's pivot; without a turret of the
  // point), about the pivot, about the centre of mass of B; m
  NUMBER BaseLever[2] = {}, ArmLever[2] = {}, HeldLever[2] = {};
  NUMBER Softness[2] = {};  // 1/kg
  NUMBER Bias[2] = {};  // speed that is to be stopped in addition, m/s
  NUMBER InverseArmInertia = NUMBER(0);  // of the turret, 1/(kg m^2); 0: there is none
  NUMBER MotorRate = NUMBER(0);  // that the motor aims at, against A, rad/s
  NUMBER MotorMost = NUMBER(0);  // N m s

  bool HasTurret() const { return InverseArmInertia > NUMBER(0); }
};

/** What a grip needs to know of a body. */
template <typename NUMBER>
struct SGripMotion {
  NUMBER X, Y, Turn;  // m/s, rad/s
  NUMBER InverseMass, InverseInertia;
};

/** What one solution of a grip changes: its impulses. */
template <typename NUMBER>
struct SGripChange {
  NUMBER Along = NUMBER(0), Across = NUMBER(0), Motor = NUMBER(0);  // N s, N m s
};

/** The speeds at which the held point leaves the end of the arm, along it and across, m/s. */
template <typename NUMBER>
void ComputeGripSpeeds(const SIslandGrip<NUMBER>& grip, const SGripMotion<NUMBER>& a,
                       const SGripMotion<NUMBER>& b, NUMBER* speeds) {
  const NUMBER x = b.X - a.X;
  const NUMBER y = b.Y - a.Y;
  speeds[kAxisAlong] = x * grip.NX + y * grip.NY;
  speeds[kAxisAcross] = y * grip.NX - x * grip.NY;
  for (const int axis : {kAxisAlong, kAxisAcross}) {
    speeds[axis] += b.Turn * grip.HeldLever[axis] - a.Turn * grip.BaseLever[axis] -
                    grip.ArmRate.Now[0] * grip.ArmLever[axis];
  }
}

/** The change of impulses that satisfies a grip and the motor of its turret together. */
template <typename NUMBER>
SGripChange<NUMBER> SolveGrip(const SIslandGrip<NUMBER>& grip, const SGripMotion<NUMBER>& a,
                              const SGripMotion<NUMBER>& b);

/** The change of the impulse of the motor alone. */
template <typename NUMBER>
NUMBER SolveGripMotor(const SIslandGrip<NUMBER>& grip, const SGripMotion<NUMBER>& a) {
  const NUMBER* const impulse = grip.Impulse.Now;
  const NUMBER change =
      (grip.MotorRate + a.Turn - grip.ArmRate.Now[0]) / (a.InverseInertia + grip.InverseArmInertia);
  return std::clamp(impulse[kAxisMotor] + change, -grip.MotorMost, grip.MotorMost) -
         impulse[kAxisMotor];
}

/** How much an impulse of each axis of a grip changes its own speed, 1/kg. */
template <typename NUMBER>
NUMBER ComputeGripCompliance(const SIslandGrip<NUMBER>& grip, NUMBER inverseMasses,
                             NUMBER inverseInertiaA, NUMBER inverseInertiaB, int axis) {
  // the motor makes one body of A and its turret
  const NUMBER both = inverseInertiaA + grip.InverseArmInertia;
  const NUMBER inverseInertia =
      grip.HasTurret() ? inverseInertiaA * grip.InverseArmInertia / both : inverseInertiaA;
  const NUMBER lever = grip.BaseLever[axis] + grip.ArmLever[axis];
  return inverseMasses + grip.Softness[axis] + inverseInertia * lever * lever +
         inverseInertiaB * grip.HeldLever[axis] * grip.HeldLever[axis];
}

/** Applies a change of impulses: calls apply(body A or B, x, y, turn), N s, N m s. */
template <typename NUMBER, typename APPLY>
void ApplyGripChange(SIslandGrip<NUMBER>& grip, const SGripChange<NUMBER>& change, APPLY&& apply) {
  NUMBER* const impulse = grip.Impulse.Now;
  impulse[kAxisAlong] += change.Along;
  impulse[kAxisAcross] += change.Across;
  impulse[kAxisMotor] += change.Motor;
  const NUMBER x = change.Along * grip.NX - change.Across * grip.NY;
  const NUMBER y = change.Along * grip.NY + change.Across * grip.NX;
  const auto turnOf = [&](const NUMBER* levers) {
    return change.Along * levers[kAxisAlong] + change.Across * levers[kAxisAcross];
  };
  apply(grip.A, -x, -y, -turnOf(grip.BaseLever) - change.Motor);
  apply(grip.B, x, y, turnOf(grip.HeldLever));
  grip.ArmRate.Now[0] += grip.InverseArmInertia * (change.Motor - turnOf(grip.ArmLever));
}

template <typename NUMBER>
SGripMotion<NUMBER> GetGripMotion(const SIslandBody<NUMBER>& body) {
  const NUMBER* const velocity = body.Velocity.Now;
  return {velocity[kAxisX], velocity[kAxisY], velocity[kAxisTurn], body.InverseMass,
          body.InverseInertia};
}

/** Changes the impulses of a grip, and so the velocities of its bodies. */
template <typename NUMBER>
void ApplyGripChange(std::span<SIslandBody<NUMBER>> bodies, SIslandGrip<NUMBER>& grip,
                     const SGripChange<NUMBER>& change) {
  ApplyGripChange(grip, change, [&](UInt32 number, NUMBER x, NUMBER y, NUMBER turn) {
    SIslandBody<NUMBER>& body = bodies[number];
    body.Velocity.Now[kAxisX] += body.InverseMass * x;
    body.Velocity.Now[kAxisY] += body.InverseMass * y;
    body.Velocity.Now[kAxisTurn] += body.InverseInertia * turn;
  });
}

/** Changes the impulses of a contact, and so the velocities of its bodies. */
template <typename NUMBER>
void ChangeImpulse(SIslandBody<NUMBER>& bodyA, SIslandBody<NUMBER>& bodyB,
                   SIslandContact<NUMBER>& contact, NUMBER normal, NUMBER tangent) {
  NUMBER* const a = bodyA.Velocity.Now;
  NUMBER* const b = bodyB.Velocity.Now;
  NUMBER* const impulse = contact.Impulse.Now;
  const NUMBER changeN = normal - impulse[kAxisNormal];
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
}

template <typename NUMBER>
class CIslandNewton;

/**
 * Solves the contacts of bodies in a plane that press each other, and grips, where masses may
 * differ by orders of magnitude.
 *
 * Series of a nonsmooth nonlinear conjugate gradient method, whose steps are sweeps of projected
 * Gauss-Seidel over drives and contacts (M. Silcowitz-Hansen, S. Niebe, K. Erleben, A Nonsmooth
 * Nonlinear Conjugate Gradient Method for Interactive Contact Force Problems, 2010). Between them,
 * small islands take steps of Newton's method from there (CIslandNewton), each with a sweep, as
 * long as they do not lead away from the solution.
 *
 * @tparam NUMBER  float or double.
 */
template <typename NUMBER>
class CContactIsland {
 public:
  CContactIsland(std::span<SIslandBody<NUMBER>> bodies, std::span<SIslandContact<NUMBER>> contacts,
                 std::span<SIslandGrip<NUMBER>> grips = {})
      : m_bodies(bodies), m_contacts(contacts), m_grips(grips) {}
  /**
   * Sweeps until the velocities change no more than a tolerance, m/s. The last thing is a sweep, so
   * that no impulse exceeds its bounds. @return the number of sweeps.
   */
  UInt32 Solve(NUMBER tolerance, UInt32 mostSweeps);
  /** After Solve(): the greatest change of a velocity in the last sweep, m/s. */
  NUMBER GetChange() const { return m_change; }

 private:
  /** What a sweep changed. */
  struct SChange {
    NUMBER Velocity = NUMBER(0);  // the greatest, m/s
    NUMBER Energy =
        NUMBER(0);  // of impulses, J: forces and torques of light and heavy bodies add up
  };

  template <typename VISIT>
  void ForAll(VISIT&& visit);
  void Start();
  NUMBER SweepUntil(UInt32 end);
  NUMBER StepByNewton(CIslandNewton<NUMBER>& newton, NUMBER change);
  bool IsDone(NUMBER change) const { return change <= m_tolerance || m_sweeps >= m_mostSweeps; }
  void SweepDrives(SChange& change);
  void SweepContacts(SChange& change);
  void SolveTurrets();
  void SweepGrips(SChange& change);
  void StepOn(NUMBER share);

  std::span<SIslandBody<NUMBER>> m_bodies;
  std::span<SIslandContact<NUMBER>> m_contacts;
  std::span<SIslandGrip<NUMBER>> m_grips;
  NUMBER m_tolerance = NUMBER(0);  // m/s
  NUMBER m_change = NUMBER(0);  // m/s
  UInt32 m_sweeps = 0, m_mostSweeps = 0;
};

}  // namespace argos

#endif
