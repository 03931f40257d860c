#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_DISC_SWARM_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_DISC_SWARM_H

#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/ghost_lines.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/half_planes.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_handle.h>
#include <argos3/plugins/simulator/physics_engines/planar/cell_lists.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <span>
#include <vector>

namespace argos {

class CThreadPool;
struct SBodyDescription;

/** Thrown if a wheel speed is not a number; nothing has moved then. */
struct SBadKinematicWheels {
  CKinematics2DModel* Owner;
  Real Left, Right;  // m/s
};

/**
 * The robots of an engine that are discs: nearly all of most swarms.
 *
 * Their state lies in arrays by slot. A tick is Plan(), which says where the wheels want each
 * robot, and sorts the robots by cells of a grid; then Step(), which finds out who may meet
 * something, and moves those as far as there is room. Both spread over the threads of a pool.
 * Whoever meets nothing is where its wheels want it, exactly.
 *
 * What a robot does depends on what was around it at the start of the tick or of a round, never on
 * who was dealt with first: so results do not depend on threads.
 */
class CDiscSwarm {
 public:
  /** Allocates the arrays for so many. */
  void Reserve(size_t discs);
  /** The same for what ghosts need. */
  void ReserveForGhosts(size_t discs) { m_ghostLines.Reserve(discs); }
  size_t GetSize() const { return m_x.size(); }
  /** @param wheels  speeds of the left and right wheel, m/s; must stay valid. */
  void Add(const SKinematicOwner& owner, const SBodyDescription& description,
           const SPlanarPose& pose, const Real* wheels);
  /** Takes one out; the last one gets its slot. */
  void Remove(UInt32 slot);
  void SetPose(UInt32 slot, const SPlanarPose& pose);

  /** Where wheels lead in a time, s. @throws SBadKinematicWheels */
  void Plan(CThreadPool& pool, Real duration);
  /** The grid in which Plan() has sorted them: nobody reaches farther than half an edge. */
  const CFramedGrid& GetGrid() const { return m_grid; }
  /** How far a ghost may be that a disc meets in a tick, s, of so many substeps: see the world. */
  Real ComputeGhostReach(Real tick, UInt32 substeps) const;
  /** After the first Plan() of a tick: tells of ghosts. @param substeps  of the tick. */
  void MeetGhosts(std::span<const SGhostDisc> ghosts, UInt32 substeps);
  /** Then: moves those who are in each other's way, or in that of walls or solids. */
  void Step(CThreadPool& pool, const CCellLists& walls, const CCellLists& solids);
  /** After Step(): takes over where discs are now. @param slot in [begin, end). */
  void Commit(UInt32 slot) {
    m_x[slot] = m_nextX[slot];
    m_y[slot] = m_nextY[slot];
    m_halfCos[slot] = m_nextHalfCos[slot];
    m_halfSin[slot] = m_nextHalfSin[slot];
  }

  SPlanarPose GetPose(UInt32 slot) const {
    return {m_x[slot], m_y[slot], m_halfCos[slot], m_halfSin[slot]};
  }
  Real GetRadius(UInt32 slot) const { return m_radius[slot]; }
  /** What the wheels want of this tick, m. */
  SStep GetWanted(UInt32 slot) const { return {m_stepX[slot], m_stepY[slot]}; }
  /** The most that it pushes with, N. */
  Real GetMaxForce(UInt32 slot) const { return m_maxForce[slot]; }
  const SKinematicOwner& GetOwner(UInt32 slot) const { return m_owner[slot]; }
  /**
   * After Plan(): calls visit(slot), in any order, for every disc whose reach comes within
   * @p reach (m) of a point, and for some others. One thread only.
   */
  template <typename VISIT>
  void ForDiscsNear(Real x, Real y, Real reach, VISIT&& visit) const;

 private:
  /** A disc in the order of the grid's cells. */
  struct SPlace {
    Real X, Y;  // m, at the start of the tick
    float Reach;  // m: it does not leave this circle in the tick; rounded up
    UInt32 Slot;
  };
  /** One that may meet something. */
  struct SMover {
    UInt32 Place, Cell;
  };
  /** What is known of a mover besides its place. */
  struct SWish {
    Real X, Y;  // m: where its wheels want it, from the start
    Real Radius;  // m
    Real Path;  // m: it may not go farther
    Real Depth;  // m: deepest overlap
  };
  void PlanRun(size_t begin, size_t end, Real duration);
  void Bin(size_t begin, size_t end, bool alone);
  bool IsGridBad() const;
  Real GetGreatestReach() const {
    return std::max(m_maxRadius, static_cast<Real>(m_maxReach.load(std::memory_order_relaxed)));
  }
  void LayGrid();
  void Sort(CThreadPool& pool);
  void FindMovers(size_t beginCell, size_t endCell, const CCellLists& walls,
                  const CCellLists& solids);
  bool MayMeetSomething(UInt32 place, UInt32 cell, const CCellLists& walls,
                        const CCellLists& solids) const;
  bool TakeRound(CThreadPool& pool, size_t numLeft, const CCellLists& walls,
                 const CCellLists& solids);
  size_t DropArrived(size_t numLeft);
  bool StepOne(const SMover& mover, const CCellLists& walls, const CCellLists& solids,
               const std::vector<SStep>& done, std::vector<SStep>& next);
  bool LimitByDiscs(const SMover& mover, const std::vector<SStep>& done, Real bound,
                    CHalfPlanes& planes);
  bool LimitByFootprints(const SMover& mover, const CCellLists& lists, UInt32 firstId,
                         const SStep& done, Real bound, CHalfPlanes& planes);
  bool LimitByGhosts(const SMover& mover, const SStep& done, Real bound, CHalfPlanes& planes);
  void Finish(const SMover& mover);
  template <typename VISIT>
  bool ForPlacesAround(UInt32 cell, VISIT&& visit) const;

  // by slot; state
  std::vector<Real> m_x, m_y, m_halfCos, m_halfSin;  // m; of half the heading
  std::vector<Real> m_allowance;  // m: how far one that overlaps may be pushed in the next tick
  // fixed
  std::vector<const Real*> m_wheels;  // m/s, (left, right), of the robot's wheels; not owned
  std::vector<Real> m_inverseInterwheel;  // 1/m
  std::vector<Real> m_radius;  // m
  std::vector<Real> m_maxForce;  // N
  std::vector<SKinematicOwner> m_owner;
  // written by Plan()
  std::vector<Real> m_stepX, m_stepY;  // m
  std::vector<Real> m_nextX, m_nextY, m_nextHalfCos, m_nextHalfSin;
  std::vector<float> m_reach;  // m

  CFramedGrid m_grid;
  SPlanarArea m_areaOfGrid;
  UInt32 m_ticksOfGrid = 0;
  size_t m_discsOfGrid = 0;  // how many there were when it was laid
  Real m_reachOfGrid = 0.0;  // m: how far they reached then
  Real m_maxRadius = 0.0;  // m, of all that ever were there
  std::atomic<float> m_maxReach{0.0F};  // m
  std::atomic<UInt32> m_firstBad{std::numeric_limits<UInt32>::max()};  // slot
  CCountingSort m_sort;  // of the slots by cell; within a cell in any order
  std::vector<SPlace> m_places;  // in order of cells
  // by place, of movers only
  std::vector<SWish> m_wishes;
  std::vector<SStep> m_done, m_next;  // m: how far each has got, before and after a round
  std::vector<SMover> m_movers;  // in any order
  std::atomic<UInt32> m_numMovers{0};
  CGhostLines m_ghostLines;  // of this tick
};

template <typename VISIT>
void CDiscSwarm::ForDiscsNear(Real x, Real y, Real reach, VISIT&& visit) const {
  if (m_places.empty()) {
    return;
  }
  const Real widest = reach + static_cast<Real>(m_maxReach.load(std::memory_order_relaxed));
  m_grid.ForRows(m_grid.CellsAround(x, y, widest), [&](UInt32 first, UInt32 last) {
    const UInt32 end = m_sort.End(last);
    for (UInt32 place = m_sort.Begin(first); place < end; ++place) {
      const SPlace& disc = m_places[place];
      const Real dx = disc.X - x;
      const Real dy = disc.Y - y;
      const Real near = reach + static_cast<Real>(disc.Reach);
      if (dx * dx + dy * dy <= near * near) {
        visit(disc.Slot);
      }
    }
  });
}

}  // namespace argos

#endif
