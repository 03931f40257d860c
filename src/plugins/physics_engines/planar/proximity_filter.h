#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PROXIMITY_FILTER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PROXIMITY_FILTER_H

#include <argos3/plugins/simulator/physics_engines/planar/disc_pairs.h>

#include <vector>

namespace argos {

/**
 * Marks the discs that can meet something during a tick, or nearly can.
 *
 * The reach of a disc is the radius of a circle, around its centre at the start of the tick, that
 * it does not leave in the tick. Discs whose circles are apart cannot meet.
 */
class CProximityFilter {
 public:
  /** Whether a disc can meet nothing; nothing, but something is within the margin; something. */
  enum EMark : UInt8 { Free, Guarded, Active };

  /** Sets up to which distance from a meeting discs are marked Guarded, m. */
  void SetMargin(Real margin) { m_margin = margin; }
  void SetObstacles(const std::vector<SFootprint>& obstacles) { m_pairs.SetObstacles(obstacles); }

  /** Allocates for a number of discs. */
  void Reserve(size_t numDiscs);
  /** Starts a tick: no disc is placed, all are marked Free. */
  void Clear(size_t numDiscs);
  /** @param number < numDiscs of Clear(). */
  void Place(UInt32 number, Real x, Real y, Real reach) { m_pairs.Place(number, x, y, reach); }
  /** Marks every disc that may meet a disc or an obstacle. */
  void MarkAll(CThreadPool& pool);
  /** After MarkAll(): marks every disc that may meet another body, given as a circle. */
  void MarkNear(Real x, Real y, Real reach) { MarkNear(x, y, reach, nullptr); }
  /** The same. @param met  receives the numbers of the discs that may meet it, unless null. */
  void MarkNear(Real x, Real y, Real reach, std::vector<UInt32>* met);
  EMark GetMark(UInt32 number) const {
    ARGOS_ASSERT(number < m_marks.size(), "there is no disc with the number " << number);
    return static_cast<EMark>(m_marks[number]);
  }

 private:
  void Raise(UInt32 number, Real distance, Real reach);

  Real m_margin = 0.0;  // m
  CDiscPairs m_pairs;  // radii are reaches
  std::vector<UInt8> m_marks;  // EMark, by number
};

}  // namespace argos

#endif
