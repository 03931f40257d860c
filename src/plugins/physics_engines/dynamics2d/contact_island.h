#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CONTACT_ISLAND_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CONTACT_ISLAND_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <algorithm>
#include <initializer_list>
#include <span>

namespace argos {

/** A value that is searched: what it is, was before the last sweep, and where it moved. */
template <int COUNT>
struct SSearched {
  float Now[COUNT] = {}, Before[COUNT] = {}, Step[COUNT] = {};

  void Start(std::initializer_list<float> values) {
    std::copy(values.begin(), values.end(), Now);
    std::copy(values.begin(), values.end(), Before);
  }

  /** Adds a share of the step before; the change of the last sweep and that are the next one. */
  void StepOn(float share) {
    for (int i = 0; i < COUNT; ++i) {
      const float further = share * Step[i];
      Step[i] = further + (Now[i] - Before[i]);
      Before[i] = Now[i] += further;
    }
  }
};

/** A body of an island; without values: something immovable. */
struct SIslandBody {
  enum { kX, kY, kTurn };
  SSearched<4> Velocity;  // m/s, rad/s
  SSearched<4> Impulse;  // of the drive, N s, N m s
  // the drive: see SCrowdDrive
  float Target[4] = {};  // m/s, rad/s
  float Most = 0.0F, AngularMost = 0.0F;  // N s, N m s
  float InverseMass = 0.0F, InverseInertia = 0.0F;  // 1/kg, 1/(kg m^2)
  float Mass = 0.0F, Inertia = 0.0F;  // kg, kg m^2
};

/** A contact point of an island. */
struct SIslandContact {
  enum { kNormal, kTangent };
  SSearched<2> Impulse;  // N s
  UInt32 A = 0, B = 0;  // numbers of bodies in the island
  float NX = 0.0F, NY = 0.0F;  // normal, from A to B
  // of the normal and of the tangent about the centres of mass, m
  float NormalLeverA = 0.0F, TangentLeverA = 0.0F, NormalLeverB = 0.0F, TangentLeverB = 0.0F;
  float Approach = 0.0F;  // greatest speed of approach, m/s
  float Mass = 0.0F, InverseMass = 0.0F;  // that resists along the normal, kg, 1/kg
  float TangentMass = 0.0F, InverseTangentMass = 0.0F;  // along the tangent
  float Friction = 0.0F;  // coefficient
};

/**
 * Solves the contacts of bodies that press each other, whose masses may differ by orders of
 * magnitude: a nonsmooth nonlinear conjugate gradient method, whose steps are sweeps of projected
 * Gauss-Seidel over drives and contacts (M. Silcowitz-Hansen, S. Niebe, K. Erleben, A Nonsmooth
 * Nonlinear Conjugate Gradient Method for Interactive Contact Force Problems, 2010).
 */
class CContactIsland {
 public:
  CContactIsland(std::span<SIslandBody> bodies, std::span<SIslandContact> contacts)
      : m_bodies(bodies), m_contacts(contacts) {}
  /**
   * Sweeps until the velocities change no more than a tolerance, m/s. The last thing is a sweep, so
   * that no impulse exceeds its bounds. @return the number of sweeps.
   */
  UInt32 Solve(float tolerance, UInt32 mostSweeps);

 private:
  /** What a sweep changed. */
  struct SChange {
    float Velocity = 0.0F;  // the greatest, m/s
    float Energy = 0.0F;  // of impulses, J: forces and torques of light and heavy bodies add up
  };

  void SweepDrives(SChange& change);
  void SweepContacts(SChange& change);
  void StepOn(float share);

  std::span<SIslandBody> m_bodies;
  std::span<SIslandContact> m_contacts;
};

}  // namespace argos

#endif
