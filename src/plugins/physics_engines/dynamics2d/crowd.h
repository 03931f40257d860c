#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_clusters.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solver.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>

#include <vector>

namespace argos {

class CThreadPool;

/** A robot in a grip that pressed another robot, or something else: kNone. */
struct SGripTouch {
  UInt32 Slot, Other;
};

/**
 * The bodies that may touch something in a tick, nearly all of them: robots and movable objects.
 *
 * They are solved by CCrowdSolver. Bodies are items, see CCrowdSolids.
 */
class CCrowd {
 public:
  explicit CCrowd(CPlanarStore& store) : m_store(store) {}

  void Reserve(size_t discs, size_t solids, size_t grips);
  /** Forgets what is known of the robot in a slot, before another one gets it. */
  void Forget(UInt32 slot);
  /** Forgets the forces of solids, of which one was added or removed. */
  void ForgetSolids() { m_memory.Touches.Clear(); }
  /** Forgets the forces at obstacles, because these have changed. */
  void ForgetObstacles() {
    m_memory.Walls.Clear();
    m_memory.Touches.Clear();
  }
  /** A robot may overlap others: it was added. */
  void ExpectOverlaps();
  /** How much farther than on its way a disc may be moved in this tick because it overlaps, m. */
  Real GetAllowance() const { return m_allowance; }

  /**
   * Starts a tick, after CDiscPairs::Find().
   * @param reach  how far a disc may move in the tick, m.
   */
  void Start(CDiscPairs& discPairs, Real reach);
  CCrowdSolids& GetSolids() { return m_solids; }
  /** Adds a grip of this tick; the state of its last tick is part of it. */
  void AddGrip(CDiscPairs& discPairs, const SCrowdGrip& grip);
  /** After Advance(): the grips of the tick, in the order of AddGrip(). */
  const std::vector<SCrowdGrip>& GetGrips() const { return m_grips; }
  /**
   * What pressed the robots in grips in the last substep; see SGripTouch. Forgotten when a robot is
   * removed.
   */
  const std::vector<SGripTouch>& GetGripTouches() const { return m_gripTouches; }
  /** Adds a line that a disc does not cross. */
  void AddLine(CDiscPairs& discPairs, UInt32 place, const SCrowdLine& line);
  /**
   * Corrects the planned states of the robots that touch something.
   * @param longestPath  of any robot in the tick, m; the reach of the pairs is no less.
   */
  void Advance(CThreadPool& pool, const CDiscPairs& discPairs, Real longestPath, Real reach);

 private:
  void FillIn(size_t begin, size_t end);
  void FillInDriven(UInt32 member, const SDrivenBody& body);
  void FillInSolid(UInt32 member, const CCrowdSolids::SSolid& solid);
  void FindGripTouches();
  void TakeResults(size_t begin, size_t end);
  void TakePull(UInt32 member, SDrivenBody& body);
  void TakeDriven(UInt32 member, SDrivenBody& body);
  void TakeSolid(UInt32 member, const CCrowdSolids::SSolid& solid);

  CPlanarStore& m_store;
  CCrowdClusters m_clusters;
  CCrowdSolver m_solver;
  CCrowdSolids m_solids;
  SCrowdMemory m_memory;
  std::vector<SCrowdLine> m_lines;  // of this tick
  std::vector<SCrowdGrip> m_grips;  // of this tick
  Real m_longestGrip = 0.0;  // m, between the centres of bodies
  std::vector<SGripTouch> m_gripTouches;
  Real m_allowance = 0.0;  // m
};

}  // namespace argos

#endif
