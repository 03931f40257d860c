#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_DISC_SWARM_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_DISC_SWARM_H

#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/simulator/physics_engine/drive_source.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/ghost_lines.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/half_planes.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_handle.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/seam_pairs.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/substep.h>
#include <argos3/plugins/simulator/physics_engines/planar/cell_lists.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/slot_generations.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace argos {

class CThreadPool;
struct SArcBlock;
struct SBodyDescription;

/**
 * The robots of an engine that are discs: nearly all of most swarms.
 *
 * Their state is in arrays by slot. In a tick, Plan() computes where the drive moves each robot,
 * and sorts the robots by cells of a grid; then Step() finds the active discs, which may touch
 * something, and moves them as far as there is space. Both use the threads of a pool. All other
 * discs reach exactly the end of their arcs.
 *
 * The motion of a robot depends on its neighbours at the start of the tick or of a round, never on
 * the order of processing: so results do not depend on threads.
 */
class CDiscSwarm {
 public:
  /** Allocates the arrays for so many robots. */
  void Reserve(size_t discs);
  /** Allocates what ghosts need. */
  void ReserveForGhosts(size_t discs) { m_ghostLines.Reserve(discs); }
  size_t GetSize() const { return m_x.size(); }
  void Add(const SKinematicOwner& owner, const SBodyDescription& description,
           const SPlanarPose& pose, const CDriveSource& drive);
  /** Removes a robot; the last one gets its slot. */
  void Remove(const SKinematicHandle& handle);
  void SetPose(const SKinematicHandle& handle, const SPlanarPose& pose);
  /** @return true if the robot of the handle is still in its slot. */
  bool IsCurrent(const SKinematicHandle& handle) const {
    return m_generations.IsCurrent(handle.Slot, handle.Generation);
  }

  /** Sets what a robot was told in the last tick. */
  void SetLastCommand(const SKinematicHandle& handle, const SDriveCommand& command);
  SDriveCommand GetLastCommand(const SKinematicHandle& handle) const;

  /** Computes the steps that drives command. @throws SBadDriveCommand */
  void Plan(CThreadPool& pool, const SSubstep& substep);
  /** Joins sides of the area: all discs are to be inside of it before Plan(). */
  void SetPeriod(const SPeriodicity& period) { m_period = period; }
  /** Puts a disc that has left the area inside. */
  void Wrap(UInt32 slot) {
    CheckSlot(slot);
    m_x[slot] = m_period.X.Wrap(m_x[slot]);
    m_y[slot] = m_period.Y.Wrap(m_y[slot]);
  }
  /** The grid in which Plan() has sorted the discs; their reach is at most half an edge. */
  const CFramedGrid& GetGrid() const { return m_grid; }
  /** See CKinematicWorld::ComputeGhostReach(). */
  Real ComputeGhostReach(Real tick, UInt32 substeps) const;
  /** After the first Plan() of a tick: sets its ghosts. @param substeps  of the tick. */
  void FindGhosts(std::span<const SGhostDisc> ghosts, UInt32 substeps);
  /** Then: moves the discs that may touch each other, ghosts, walls or solids. */
  void Step(CThreadPool& pool, const CCellLists& walls, const CCellLists& solids);
  /** After Step(): makes the computed pose of a disc its pose. */
  void Commit(UInt32 slot) {
    CheckSlot(slot);
    m_x[slot] = m_nextX[slot];
    m_y[slot] = m_nextY[slot];
    m_halfCos[slot] = m_nextHalfCos[slot];
    m_halfSin[slot] = m_nextHalfSin[slot];
  }

  SPlanarPose GetPose(UInt32 slot) const {
    CheckSlot(slot);
    return {m_x[slot], m_y[slot], m_halfCos[slot], m_halfSin[slot]};
  }
  /** The pose of the image of a disc that is nearest to a point. */
  SPlanarPose GetPoseNear(UInt32 slot, Real x, Real y) const {
    SPlanarPose pose = GetPose(slot);
    pose.X += m_period.X.RoundToPeriods(x - pose.X);
    pose.Y += m_period.Y.RoundToPeriods(y - pose.Y);
    return pose;
  }
  Real GetRadius(UInt32 slot) const {
    CheckSlot(slot);
    return m_radius[slot];
  }
  /** The step of this substep that the drive commands, m. */
  SPlanarVector GetPlannedStep(UInt32 slot) const {
    CheckSlot(slot);
    return {m_stepX[slot], m_stepY[slot]};
  }
  /** After Plan(): how far PushBack() may move a disc, m. */
  Real GetRoomBack(UInt32 slot) const;
  /** Between Plan() and Step(): moves a disc by a step, in place of the one that was planned. */
  void PushBack(UInt32 slot, const SPlanarVector& step);
  /** After Plan(): the radius of the largest circle that a disc does not leave in the tick, m. */
  Real GetMaxReach() const { return static_cast<Real>(m_maxReach.load(std::memory_order_relaxed)); }
  /** Its greatest pushing force, N. */
  Real GetMaxForce(UInt32 slot) const;
  const SKinematicOwner& GetOwner(UInt32 slot) const {
    CheckSlot(slot);
    return m_owner[slot];
  }
  /**
   * After Plan(): calls visit(slot), in any order, for every disc whose reach is within @p reach
   * (m) of a point. One thread only.
   */
  template <typename VISIT>
  void ForDiscsNear(Real x, Real y, Real reach, VISIT&& visit) const;

 private:
  /** A disc in the order of the grid's cells. */
  struct SPlace {
    Real X, Y;  // m, at the start of the tick
    float Reach;  // m; radius of a circle that it does not leave in the tick, rounded up
    UInt32 Slot;
  };
  /** A disc that may touch something in this tick. */
  struct SActiveDisc {
    static constexpr UInt32 kMaxNear = 9;
    UInt32 Place, Cell;
    UInt16 NumNear;  // more than kMaxNear: the discs around the cell are searched instead
    bool HasArrived;
    UInt32 Near[kMaxNear];  // places of the discs that it may touch, in their order
  };
  /** The target of an active disc, and its limits. */
  struct STarget {
    SPlanarVector Step;  // m, from the start of the tick
    Real Radius;  // m
    Real Depth;  // m, of the deepest overlap
  };
  void CheckSlot([[maybe_unused]] UInt32 slot) const {
    ARGOS_ASSERT(slot < GetSize(), "there is no disc in slot " << slot << " of " << GetSize());
  }
  // the places that Plan() has computed are of no use once a disc was added or removed
  void CheckPlaces() const {
    ARGOS_ASSERT(m_places.size() == GetSize(), "the places of " << m_places.size() << " discs are "
                                                                << "stale: there are "
                                                                << GetSize());
  }
  const SPlace& PlaceOf(const SActiveDisc& active) const {
    ARGOS_ASSERT(active.Place < m_places.size(), "there is no disc at place " << active.Place);
    CheckSlot(m_places[active.Place].Slot);
    return m_places[active.Place];
  }
  SDriveCommand ReadLastCommand(size_t slot) const {
    const Real left = m_drives[slot].HasWheels() ? 0.0 : m_lastLeft[slot];
    return {m_lastSpeed[slot], left, m_lastYawRate[slot]};
  }
  void PutAt(UInt32 slot, const SPlanarPose& pose);
  void PlanChunk(size_t begin, size_t end, const SSubstep& substep);
  float TakeSteps(const SArcBlock& block, size_t first, size_t count);
  void Bin(size_t begin, size_t end, bool alone);
  bool IsGridBad() const;
  Real GetGreatestReach() const {
    return std::max(m_maxRadius, static_cast<Real>(m_maxReach.load(std::memory_order_relaxed)));
  }
  void BuildGrid();
  void FindSeamPairs();
  // calls query(dx, dy) for each displacement of a circle to where discs may be
  template <typename QUERY>
  void ForImages(Real x, Real y, Real radius, QUERY&& query) const;
  template <typename VISIT>
  void ForPlacesHere(Real x, Real y, Real reach, VISIT&& visit) const;
  void Sort(CThreadPool& pool);
  void FindActive(size_t beginCell, size_t endCell, const CCellLists& walls,
                  const CCellLists& solids);
  void ReserveActive(size_t discs);
  void FindNear(SActiveDisc& active) const;
  bool MayTouchAny(const SActiveDisc& active, const CCellLists& walls,
                   const CCellLists& solids) const;
  bool StepRound(CThreadPool& pool, UInt8 round, size_t numLeft, const CCellLists& walls,
                 const CCellLists& solids);
  size_t DropArrived(size_t numLeft);
  bool MayMove(const SActiveDisc& active, UInt8 round) const;
  bool StepOne(SActiveDisc& active, const CCellLists& walls, const CCellLists& solids,
               const std::vector<SPlanarVector>& done, std::vector<SPlanarVector>& next);
  bool LimitByDiscs(const SActiveDisc& active, const std::vector<SPlanarVector>& done, Real bound,
                    CHalfPlanes& planes);
  bool LimitByFootprints(const SActiveDisc& active, const CCellLists& lists, UInt32 firstId,
                         const SPlanarVector& done, Real bound, CHalfPlanes& planes);
  bool LimitByGhosts(const SActiveDisc& active, const SPlanarVector& done, Real bound,
                     CHalfPlanes& planes);
  void Finish(const SActiveDisc& active);
  template <typename VISIT>
  bool ForPlacesAround(UInt32 cell, VISIT&& visit) const;
  template <typename VISIT>
  bool ForPlacesNear(const SActiveDisc& active, VISIT&& visit) const;
  // the greatest distance of an active disc from its start, m
  static Real PathOf(const SPlace& disc, const STarget& target) {
    return static_cast<Real>(disc.Reach) - target.Radius;
  }
  bool MayTouch(const SPlace& disc, const SPlace& other) const {
    const Real dx = other.X - disc.X;
    const Real dy = other.Y - disc.Y;
    const Real near = static_cast<Real>(disc.Reach) + static_cast<Real>(other.Reach);
    return dx * dx + dy * dy <= near * near;
  }

  // by slot; state
  std::vector<Real> m_x, m_y, m_halfCos, m_halfSin;  // m; of half the heading
  std::vector<Real> m_allowance;  // m; how far an overlapping disc may be pushed in the next tick
  // of the command of the last tick
  std::vector<Real> m_lastSpeed;  // m/s, ahead
  std::vector<Real> m_lastLeft;  // m/s; of a robot on wheels 0, and not read
  std::vector<Real> m_lastYawRate;  // rad/s
  // fixed
  std::vector<CDriveSource> m_drives;
  std::vector<Real> m_radius;  // m
  std::vector<SKinematicOwner> m_owner;
  CSlotGenerations m_generations;
  // written by Plan()
  std::vector<Real> m_stepX, m_stepY;  // m
  std::vector<Real> m_nextX, m_nextY, m_nextHalfCos, m_nextHalfSin;
  std::vector<float> m_reach;  // m

  CFramedGrid m_grid;
  SPlanarArea m_areaOfGrid;
  UInt32 m_ticksOfGrid = 0;
  size_t m_discsOfGrid = 0;  // number of discs when it was built
  Real m_reachOfGrid = 0.0;  // m; greatest reach then
  Real m_maxRadius = 0.0;  // m, of all discs that ever were here
  std::atomic<float> m_maxReach{0.0F};  // m
  std::atomic<UInt32> m_firstBad{std::numeric_limits<UInt32>::max()};  // slot
  CCountingSort m_sort;  // of the slots by cell; within a cell in any order
  std::vector<SPlace> m_places;  // in order of cells
  // by place, for active discs only
  std::vector<STarget> m_targets;
  std::vector<SPlanarVector> m_done, m_next;  // m; steps made before and after a round
  // the last even and the last odd round in which the disc moved, or kNoRound
  std::vector<UInt8> m_movedIn[2];
  // in any order; not a vector, which would fill what no tick has needed yet
  std::unique_ptr<SActiveDisc[]> m_activeDiscs;
  size_t m_activeCapacity = 0;
  std::atomic<UInt32> m_numActive{0};
  CGhostLines m_ghostLines;  // of this tick
  SPeriodicity m_period;
  CSeamPairs m_seamPairs;  // of this tick
};

template <typename VISIT>
void CDiscSwarm::ForDiscsNear(Real x, Real y, Real reach, VISIT&& visit) const {
  if (m_places.empty()) {
    return;
  }
  CheckPlaces();
  const auto visitPlace = [&](UInt32 place) { visit(m_places[place].Slot); };
  if (m_period.IsOn()) {
    ForImages(x, y, reach,
              [&](Real dx, Real dy) { ForPlacesHere(x + dx, y + dy, reach, visitPlace); });
  } else {
    ForPlacesHere(x, y, reach, visitPlace);
  }
}

template <typename QUERY>
void CDiscSwarm::ForImages(Real x, Real y, Real radius, QUERY&& query) const {
  const Real far = radius + static_cast<Real>(m_maxReach.load(std::memory_order_relaxed));
  m_period.ForDisplacements({x - far, y - far, x + far, y + far},
                            {m_period.X.Min, m_period.Y.Min, m_period.X.Min + m_period.X.Period,
                             m_period.Y.Min + m_period.Y.Period},
                            query);
}

template <typename VISIT>
void CDiscSwarm::ForPlacesHere(Real x, Real y, Real reach, VISIT&& visit) const {
  const Real widest = reach + static_cast<Real>(m_maxReach.load(std::memory_order_relaxed));
  m_grid.ForRows(m_grid.CellsAround(x, y, widest), [&](UInt32 first, UInt32 last) {
    const UInt32 end = m_sort.End(last);
    for (UInt32 place = m_sort.Begin(first); place < end; ++place) {
      const SPlace& disc = m_places[place];
      const Real dx = disc.X - x;
      const Real dy = disc.Y - y;
      const Real near = reach + static_cast<Real>(disc.Reach);
      if (dx * dx + dy * dy <= near * near) {
        visit(place);
      }
    }
  });
}

}  // namespace argos

#endif
