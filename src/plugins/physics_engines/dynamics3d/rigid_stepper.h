#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_STEPPER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_STEPPER_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_finder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/impulse_solver.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_grips.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/weight_start.h>

#include <array>
#include <vector>

namespace argos {

class CThreadPool;
struct SRigidSettings;

/**
 * Moves the bodies of all islands by a substep, except of those that ODE steps: finds the impulses
 * with CImpulseSolver, then moves the parts in ODE.
 *
 * Islands are independent: several threads share them, and the result does not depend on threads.
 */
class CRigidStepper {
 public:
  struct SSubstep {
    const std::vector<SRigidBody*>& Active;  // by SRigidBody::ActiveNumber
    CContactFinder& Contacts;  // after Find()
    CRigidGrips& Grips;
    CVector3 Gravity;  // m/s^2
    Real Length = 0.0;  // s
  };

  explicit CRigidStepper(const SRigidSettings& settings) : m_settings(settings) {}

  /** Allocates for a number of active bodies. */
  void Reserve(size_t bodies);
  /** @param pool  null: in this thread. */
  void Step(const SSubstep& substep, CThreadPool* pool);

 private:
  // what belongs to an island in the lists below
  struct SIsland {
    UInt32 Number = 0;
    std::array<UInt32, 3> Starts{};  // in each list, by EList
  };
  enum EList { kBodies, kContacts, kHolds };
  // a body in the solver
  struct SMember {
    SRigidBody* Body = nullptr;
    CVector3 Centre;  // of mass of all parts, m
    CVector3 Offset;  // of that from the one of the main part, frame of the body, m
    bool IsPushed = false;  // by an add-on
  };
  // arguments of CImpulseSolver::Solve()
  struct SEffort {
    UInt32 Sweeps;
    Real Tolerance;  // m/s
    bool Extrapolates;
  };
  // of a thread
  struct SWorkspace {
    CImpulseSolver Solver;
    std::vector<SMember> Members;  // by number in the solver
    CWeightStart Weights;

    // for an island of usual size: one may be the first that is not solved in the plane
    void Reserve() {
      constexpr size_t kBodies = 32;
      constexpr size_t kBlocks = 8 * kBodies;
      Solver.Reserve(kBodies, kBlocks);
      Weights.Reserve(kBodies, kBlocks);
      Members.reserve(kBodies + 1);
    }
  };

  void Sort(const SSubstep& substep);
  void ListIslands(const SSubstep& substep);
  template <typename VALUE, typename PLACE, typename GET>
  void Distribute(EList list, size_t count, PLACE&& placeOf, GET&& get, std::vector<VALUE>& sorted);
  void StepIsland(const SSubstep& substep, size_t island, SWorkspace& space);
  void StartFromWeights(const SSubstep& substep, size_t island, SWorkspace& space) const;
  SEffort ChooseEffort(const SSubstep& substep, size_t island, const CImpulseSolver& solver) const;
  bool AreObjects(size_t island) const;
  bool IsTumbling(size_t island, Real& fastest) const;
  void AddBody(const SSubstep& substep, SRigidBody& body, SWorkspace& space) const;
  void AddRotors(const SRigidBody& body, Real length, UInt32 number, SWorkspace& space) const;
  void AddContact(const SSubstep& substep, const SRigidContact& contact, SWorkspace& space) const;
  void AddHold(const SSubstep& substep, const CRigidGrips::SHold& hold, SWorkspace& space) const;
  static void AddDrive(const SSubstep& substep, const SRigidBody& body, SWorkspace& space);
  void StoreForces(const SSubstep& substep, size_t island, SWorkspace& space);
  void Rest(const SSubstep& substep, size_t island, SWorkspace& space) const;
  static void Move(const SSubstep& substep, UInt32 number, const SWorkspace& space);

  const SRigidSettings& m_settings;
  std::vector<SIsland> m_islands;  // one more than there are
  std::vector<UInt32> m_places;  // by number of island: in m_islands
  std::vector<SRigidBody*> m_bodies;  // by island
  std::vector<UInt32> m_contacts;  // by island
  std::vector<CRigidGrips::SHold*> m_holds;  // by island
  std::vector<CRigidGrips::SHold*> m_allHolds;  // in the order of CRigidGrips
  std::vector<SWorkspace> m_spaces;  // by thread
};

}  // namespace argos

#endif
