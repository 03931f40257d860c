#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_WEIGHT_START_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_WEIGHT_START_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/impulse_solver.h>

#include <vector>

namespace argos {

/**
 * Gives new contacts of bodies that stand on each other the impulses that bear the weights.
 *
 * From the highest body down, each hands on what it bears to the contacts below it, so that the
 * sweeps of CImpulseSolver need not carry the weight down from body to body. Contacts that are far
 * from level bear nothing, and friction is left out: what leans is left to the sweeps.
 */
class CWeightStart {
 public:
  /** Allocates for an island of that many bodies and contacts. */
  void Reserve(size_t bodies, size_t contacts);
  /** To be filled before Apply(): heights of the centres of mass of the solver's bodies, m. */
  std::vector<Real>& GetHeights() { return m_heights; }
  /**
   * Sets the normal impulses of contacts, before CImpulseSolver::Prepare(), and that the contacts
   * have given way to them.
   * @param fall  the speed downwards that gravity adds in the substep, m/s, > 0.
   */
  void Apply(CImpulseSolver& solver, Real fall);

 private:
  // what presses on a body: an impulse downwards, N s, times the arms from its centre, N m s
  struct SLoad {
    Real Push = 0.0;
    Real MomentX = 0.0, MomentY = 0.0;
  };
  // a contact of the body above it
  struct SBearer {
    UInt32 Block = 0;
    UInt32 Below = 0;
    CVector3 Arm, ArmBelow;  // from the centres of both bodies, m
  };

  template <typename USE>
  void ForEachBearer(const CImpulseSolver& solver, USE&& use) const;
  void ListBearers(const CImpulseSolver& solver);
  void HandDown(CImpulseSolver& solver, UInt32 body);

  std::vector<Real> m_heights;
  std::vector<UInt32> m_order;  // bodies, the highest first
  std::vector<SLoad> m_loads;  // by body
  std::vector<UInt32> m_starts;  // by body: in m_bearers
  std::vector<SBearer> m_bearers;  // by body
};

}  // namespace argos

#endif
