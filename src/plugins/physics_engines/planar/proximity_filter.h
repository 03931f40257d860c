#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PROXIMITY_FILTER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PROXIMITY_FILTER_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/core/utility/spatial/planar_grid.h>
#include <argos3/plugins/simulator/physics_engines/planar/cell_lists.h>

#include <vector>

namespace argos {

/**
 * Broad phase for discs: finds the discs that can meet something during a tick.
 *
 * The reach of a disc is the radius of a circle, around its centre at the start of the tick, that
 * it does not leave in the tick. Discs whose circles are apart cannot meet.
 *
 * Pairs are found in a grid that is filled each tick by counting sort. It has about two cells for
 * each disc, which are so wide that two discs that can meet are in the same or in adjoining cells.
 */
class CProximityFilter {
 public:
  /** Whether a disc can meet nothing; nothing, but something is within the margin; something. */
  enum EMark : UInt8 { Free, Guarded, Active };

  /** Sets up to which distance from a meeting discs are marked Guarded, m. */
  void SetMargin(Real margin) { m_margin = margin; }
  void SetObstacles(const std::vector<SFootprint>& obstacles);

  /** Allocates for a number of discs. */
  void Reserve(size_t numDiscs);
  /** Starts a tick: no disc is placed, all are marked Free. */
  void Clear(size_t numDiscs);
  /** @param number < numDiscs of Clear(). */
  void Place(UInt32 number, Real x, Real y, Real reach) {
    CheckNumber(number);
    m_placeOf[number] = static_cast<UInt32>(m_discs.size());
    m_discs.push_back({x, y, reach, number});
  }
  /** Changes the reach of a disc that was placed; before MarkAll(). */
  void SetReach(UInt32 number, Real reach) { GetDisc(number).Reach = reach; }
  /** Adds to the reach of a disc that was placed; before MarkAll(). */
  void Extend(UInt32 number, Real reach) { GetDisc(number).Reach += reach; }
  /** Marks every disc that may meet a disc or an obstacle. */
  void MarkAll();
  /** After MarkAll(): marks every disc that may meet another body, given as a circle. */
  void MarkNear(Real x, Real y, Real reach) { MarkNear(x, y, reach, nullptr); }
  /** The same. @param met  receives the numbers of the discs that may meet it, unless null. */
  void MarkNear(Real x, Real y, Real reach, std::vector<UInt32>* met);
  EMark GetMark(UInt32 number) const {
    CheckNumber(number);
    return static_cast<EMark>(m_marks[number]);
  }

 private:
  struct SDisc {
    Real X, Y, Reach;  // m
    UInt32 Number;
  };

  void CheckNumber([[maybe_unused]] UInt32 number) const {
    ARGOS_ASSERT(number < m_marks.size(), "there is no disc with the number " << number);
  }
  SDisc& GetDisc(UInt32 number) {
    CheckNumber(number);
    const UInt32 place = m_placeOf[number];
    ARGOS_ASSERT(place < m_discs.size() && m_discs[place].Number == number,
                 "disc " << number << " was not placed in this tick");
    return m_discs[place];
  }
  void Sort();
  void MarkPairs();
  void MarkPair(const SDisc& a, const SDisc& b);
  void MarkAtObstacles(const SDisc& disc);
  void Raise(UInt32 number, EMark mark) {
    if (m_marks[number] < mark) {
      m_marks[number] = mark;
    }
  }

  Real m_margin = 0.0;  // m
  Real m_maxReach = 0.0;  // m, of the discs
  std::vector<SDisc> m_discs;  // as placed
  std::vector<UInt32> m_placeOf;  // in m_discs, by number
  std::vector<UInt8> m_marks;  // EMark, by number
  CFramedGrid m_grid;
  CCountingSort m_sort;  // of the discs by cell
  std::vector<SDisc> m_sorted;  // in order of cells

  std::vector<SFootprint> m_obstacles;
  CFramedGrid m_obstacleGrid;
  CCellLists m_obstacleCells;
};

}  // namespace argos

#endif
