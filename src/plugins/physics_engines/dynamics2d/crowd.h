#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_CROWD_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/contact_memory.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_clusters.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solver.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>

#include <vector>

namespace argos {

class CThreadPool;

/**
 * The robots that are discs and may touch only each other and immovable things in a tick: nearly
 * all that touch anything in most swarms.
 *
 * They are solved by CCrowdSolver. The clusters in which there is something else, a movable object,
 * a robot that is no disc or a grip, are excluded: Box2D solves them.
 */
class CCrowd {
 public:
  explicit CCrowd(CPlanarStore& store) : m_store(store) {}

  void Reserve(size_t discs);
  /** Forgets what is known of the robot in a slot, before another one gets it. */
  void Forget(UInt32 slot);
  /** Forgets the forces at obstacles, because these have changed. */
  void ForgetObstacles() { m_wallMemory.Clear(); }
  /** A robot may overlap others: it was added. */
  void ExpectOverlaps();
  /** How much farther than on its way a disc may be moved in this tick because it overlaps, m. */
  Real GetAllowance() const { return m_allowance; }

  /** Starts a tick, after CDiscPairs::Find(). */
  void Start(const CDiscPairs& discPairs) {
    m_lines.clear();
    m_clusters.Unite(discPairs);
  }
  /** Leaves the cluster of a disc to Box2D. */
  void Exclude(UInt32 place) { m_clusters.Exclude(place); }
  bool IsExcluded(UInt32 place) { return m_clusters.IsExcluded(place); }
  bool HasExcluded() const { return m_clusters.HasExcluded(); }
  /** Adds a line that a disc does not cross. */
  void AddLine(CDiscPairs& discPairs, UInt32 place, const SCrowdLine& line);
  /**
   * Corrects the planned states of the robots that touch something.
   * @param longestPath  of any robot in the tick, m; the reach of the pairs is no less.
   */
  void Advance(CThreadPool& pool, const CDiscPairs& discPairs, Real longestPath, Real reach);

 private:
  void FillIn(size_t begin, size_t end);
  void TakeResults(size_t begin, size_t end);

  CPlanarStore& m_store;
  CCrowdClusters m_clusters;
  CCrowdSolver m_solver;
  CContactMemory m_pairMemory, m_wallMemory;
  std::vector<SCrowdLine> m_lines;  // of this tick
  Real m_allowance = 0.0;  // m
};

}  // namespace argos

#endif
