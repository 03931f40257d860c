#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_ENCOUNTERS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_ENCOUNTERS_H

#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <vector>

namespace argos {

/**
 * Finds out which of the discs can meet something during a tick.
 *
 * A disc's reach is the radius of a circle, around its centre at the tick's start, that it does not
 * leave in the tick. Discs whose circles are apart cannot meet.
 *
 * Pairs are found in a grid that is filled anew each tick by counting sort; its cells are as many
 * as there are discs, about, and at least so wide that whatever can be met is in an adjoining cell.
 */
class CEncounters {
 public:
  /** What a disc may meet: nothing; nothing, but it is not far off; something. */
  enum EMark : UInt8 { Alone, Around, Near };

  /** What is less than this from being met is around, m. */
  void SetMargin(Real margin) { m_margin = margin; }
  void SetObstacles(const std::vector<SFootprint>& obstacles);

  /** Makes room for that many discs. */
  void Reserve(size_t numDiscs);
  /** Starts a tick: no disc is placed, all are alone. */
  void Clear(size_t numDiscs);
  /** @param number < numDiscs of Clear(). */
  void Place(UInt32 number, Real x, Real y, Real reach) {
    m_placeOf[number] = static_cast<UInt32>(m_discs.size());
    m_discs.push_back({x, y, reach, number});
  }
  /** Changes the reach of a disc that was placed; before MarkAll(). */
  void SetReach(UInt32 number, Real reach) { m_discs[m_placeOf[number]].Reach = reach; }
  /** Adds to the reach of a disc that was placed; before MarkAll(). */
  void Extend(UInt32 number, Real reach) { m_discs[m_placeOf[number]].Reach += reach; }
  /** Marks every disc that may meet a disc or an obstacle. */
  void MarkAll();
  /** Then: marks every disc that may meet another body, a circle that is not among the discs. */
  void MarkNear(Real x, Real y, Real reach) { MarkNear(x, y, reach, nullptr); }
  /** The same. @param met  gets the numbers of those that may meet it; not if null. */
  void MarkNear(Real x, Real y, Real reach, std::vector<UInt32>* met);
  EMark GetMark(UInt32 number) const { return static_cast<EMark>(m_marks[number]); }

 private:
  struct SDisc {
    Real X, Y, Reach;  // m
    UInt32 Number;
  };
  /** A grid of equal squares over a rectangle; what is outside belongs to the border cells. */
  struct SGrid {
    Real MinX = 0.0, MinY = 0.0, InverseEdge = 1.0;  // m, 1/m
    int NumI = 1, NumJ = 1;

    void Cover(Real minX, Real minY, Real maxX, Real maxY, Real minEdge, Real maxCells);
    int CellI(Real x) const { return Clamp((x - MinX) * InverseEdge, NumI); }
    int CellJ(Real y) const { return Clamp((y - MinY) * InverseEdge, NumJ); }
    size_t NumCells() const { return static_cast<size_t>(NumI) * static_cast<size_t>(NumJ); }
    static int Clamp(Real cell, int count) {
      return cell > 0.0 ? (cell < count ? static_cast<int>(cell) : count - 1) : 0;
    }
  };

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
  SGrid m_grid;
  std::vector<UInt32> m_cellOf;  // (discs) as placed
  std::vector<UInt32> m_start;  // (cells + 1) into m_sorted
  std::vector<SDisc> m_sorted;  // in order of cells

  std::vector<SFootprint> m_obstacles;
  SGrid m_obstacleGrid;
  std::vector<UInt32> m_obstacleStart;  // (cells + 1) into m_obstacleItems
  std::vector<UInt32> m_obstacleItems;  // numbers of obstacles, in order of cells
};

}  // namespace argos

#endif
