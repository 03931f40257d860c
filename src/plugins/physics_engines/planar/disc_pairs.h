#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_DISC_PAIRS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_DISC_PAIRS_H

#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/core/utility/spatial/planar_grid.h>
#include <argos3/plugins/simulator/physics_engines/planar/cell_lists.h>

#include <vector>

namespace argos {

class CThreadPool;

/**
 * Broad phase for discs: finds the discs that can meet each other or an obstacle during a tick.
 *
 * A disc does not leave the circle of its radius + the reach around its centre at the start of the
 * tick. Discs whose circles are apart cannot meet.
 *
 * Pairs are found in a grid that is filled each tick by counting sort. It has about two cells for
 * each disc, which are so wide that two discs that can meet are in the same or in adjoining cells.
 * The place of a disc is its number in the order of the cells, row by row.
 */
class CDiscPairs {
 public:
  struct SDisc {
    Real X, Y, Radius;  // m
    UInt32 Number;
  };
  /** Two discs that can meet, by place; A < B. */
  struct SPair {
    UInt32 A, B;
  };
  /** A disc, by place, and an obstacle that it can meet, by number. */
  struct SObstaclePair {
    UInt32 Disc, Obstacle;
  };
  /** The pairs of a part of the cells. Parts depend on the number of discs, not on threads. */
  struct SPart {
    std::vector<SPair> Pairs;
    std::vector<SObstaclePair> ObstaclePairs;
  };

  /**
   * Joins sides: pairs across them are found, too. Before obstacles are set.
   * @param period  of the area in which all discs are; at least four times as wide as a disc with
   *                its reach.
   */
  void SetPeriod(const SPeriodicity& period) { m_period = period; }
  /** Their images near the seams have numbers behind theirs. */
  void SetObstacles(const std::vector<SFootprint>& obstacles);
  const SFootprint& GetObstacle(UInt32 number) const {
    ARGOS_ASSERT(number < m_obstacles.size(), "there is no obstacle " << number);
    return m_obstacles[number];
  }

  /** Allocates for a number of discs. */
  void Reserve(size_t numDiscs);
  /** Starts a tick: numbers below @p count are to be placed or left out. */
  void Start(size_t count);
  /** Safe on several threads for different numbers. */
  void Place(UInt32 number, Real x, Real y, Real radius) {
    CheckNumber(number);
    m_discs[number] = {x, y, radius, number};
  }
  void LeaveOut(UInt32 number) {
    CheckNumber(number);
    m_discs[number].Radius = kLeftOut;
  }
  /** Finds all pairs. @param reach of every disc, m. */
  void Find(CThreadPool& pool, Real reach);

  /** After Find(): the discs, by place. */
  const std::vector<SDisc>& GetDiscs() const { return m_sorted; }
  /** After Find(): the place of a number that is not left out. */
  UInt32 GetPlace(UInt32 number) const;
  const std::vector<SPart>& GetParts() const { return m_parts; }
  /** After Find(): adds an obstacle that a disc can meet. One thread. */
  void AddObstaclePair(UInt32 place, UInt32 obstacle) {
    m_parts.back().ObstaclePairs.push_back({place, obstacle});
    m_isNear[place] = 1;
  }
  /** After Find(): the disc can meet something else. One thread. */
  void SetNear(UInt32 place) { m_isNear[place] = 1; }
  /** Collects the numbers of the obstacles around a point in ascending order; perhaps others. */
  void FindObstaclesNear(Real x, Real y, Real radius, std::vector<UInt32>& numbers) const {
    m_obstacleCells.Find(m_obstacleGrid, x, y, radius, numbers);
  }
  /** After Find(): can the disc meet another one or an obstacle? */
  bool IsNear(UInt32 place) const {
    ARGOS_ASSERT(place < m_isNear.size(), "there is no disc at place " << place);
    return m_isNear[place] != 0;
  }
  /**
   * After Find(): calls visit(place) for every disc whose circle meets another one. One thread.
   * @param radius  of that circle, its reach included, m.
   */
  template <typename VISIT>
  void ForNear(Real x, Real y, Real radius, VISIT&& visit) const {
    if (!m_period.IsOn()) {
      ForNearHere(x, y, radius, visit);
      return;
    }
    ForImages(x, y, radius, [&](Real dx, Real dy) { ForNearHere(x + dx, y + dy, radius, visit); });
  }

 private:
  static constexpr Real kLeftOut = -1.0;

  // calls query(dx, dy) for each displacement of a circle to where discs may be
  template <typename QUERY>
  void ForImages(Real x, Real y, Real radius, QUERY&& query) const {
    const Real widest = radius + m_maxRadius + m_reach;
    const SPeriodicAxis& alongX = m_period.X;
    const SPeriodicAxis& alongY = m_period.Y;
    m_period.ForDisplacements(
        {x - widest, y - widest, x + widest, y + widest},
        {alongX.Min, alongY.Min, alongX.Min + alongX.Period, alongY.Min + alongY.Period}, query);
  }
  // without images
  template <typename VISIT>
  void ForNearHere(Real x, Real y, Real radius, VISIT&& visit) const {
    const Real widest = radius + m_maxRadius + m_reach;
    m_grid.ForRows(m_grid.CellsAround(x, y, widest), [&](UInt32 first, UInt32 last) {
      const UInt32 end = m_sort.End(last);
      for (UInt32 place = m_sort.Begin(first); place < end; ++place) {
        const SDisc& disc = m_sorted[place];
        const Real dx = disc.X - x;
        const Real dy = disc.Y - y;
        const Real near = radius + disc.Radius + m_reach;
        if (dx * dx + dy * dy <= near * near) {
          visit(place);
        }
      }
    });
  }

  void CheckNumber([[maybe_unused]] UInt32 number) const {
    ARGOS_ASSERT(number < m_discs.size(), "there is no disc with the number " << number);
  }
  void CoverDiscs(CThreadPool& pool);
  void Sort(CThreadPool& pool);
  void Divide();
  void FindPairs(size_t part);
  void FindObstacles(UInt32 place, SPart& part);
  void FindPairsAcrossSeams();
  void MarkNear(UInt32 place);

  /** What a chunk of discs extends over. */
  struct SExtent {
    SPlanarArea Area;
    Real MaxRadius;
  };

  SPeriodicity m_period;
  Real m_reach = 0.0;  // m
  Real m_maxRadius = 0.0;  // m, of the discs
  std::vector<SDisc> m_discs;  // by number
  std::vector<SExtent> m_extents;  // of the chunks of discs
  CFramedGrid m_grid;
  CCountingSort m_sort;  // of the discs by cell
  std::vector<SDisc> m_sorted;  // by place
  std::vector<UInt8> m_isNear;  // by place
  std::vector<SPart> m_parts;  // the last one: what was added
  std::vector<UInt32> m_firstCell;  // of each part, and the end of the last one

  std::vector<SFootprint> m_obstacles;
  CFramedGrid m_obstacleGrid;
  CCellLists m_obstacleCells;
};

}  // namespace argos

#endif
