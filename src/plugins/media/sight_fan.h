#ifndef ARGOS3_PLUGINS_MEDIA_SIGHT_FAN_H
#define ARGOS3_PLUGINS_MEDIA_SIGHT_FAN_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/simulator/media/line_of_sight.h>

#include <vector>

namespace argos {

struct SDiscList;
struct SIndexedShape;

/**
 * Tests many lines of sight from one point at once; for the sources of media. The results are those
 * of CLineOfSight::IsClear().
 *
 * One query of the index returns all solids in reach. The lines are sorted by direction, so a solid
 * is compared only with those that may meet the circle around it. A line is blocked if a solid
 * crosses it well outside the bodies at its ends, clear if no solid comes near it, and in the rare
 * cases between the two, where roundings decide, CLineOfSight is asked.
 *
 * Does not allocate beyond Reserve().
 */
class CSightFan {
 public:
  /** An end of a line: a point of a body. */
  struct SEnd {
    Real X, Y, Z; /**< m, world frame */
    Real Reach; /**< m; no solid of the body is farther from the point, seen from above */
    CLineOfSight::SEnd Body;
  };

  /** @return SEnd::Reach. */
  static Real ComputeReach(const CLineOfSight& sight, const CLineOfSight::SEnd& body, Real x,
                           Real y);

  /** Reserves memory for that many lines. */
  void Reserve(size_t num);
  /** Removes all lines. @param eye  where they meet; must exist until Trace(). */
  void Start(const SEnd& eye);
  /**
   * Adds a line. @param end  must exist until Trace().
   * @param toEnd  true if the line starts at the eye: as in CLineOfSight::IsClear(), exchanging the
   * ends changes roundings.
   */
  void Add(const SEnd& end, bool toEnd);
  /** Tests all lines. */
  void Trace(const CLineOfSight& sight);
  /** @param number  of a line, in the order of Add(). */
  bool IsClear(size_t number) const { return m_isClear[number] != 0; }

 private:
  enum class EState : UInt8 { Clear, Doubtful, Blocked };  // says how much is in the way
  // it has no constructors, so that arrays are resized for free
  struct SAdded {
    const SEnd* End;
    bool ToEnd;
  };
  struct SLine {
    Real DX, DY;  // lead from the eye to the end, m
    Real SquareLength;  // m^2, seen from above
    // m^2; a point whose dot product with (DX, DY) is between these is outside the bodies at the
    // ends by more than a rounding
    Real First, Last;
    Real DZ;  // m, from the eye to the end
    UInt32 Body;  // body at the end
    UInt32 Number;
    EState State;
  };
  struct SCircle;
  struct SCircles;

  void SortLines();
  void TraceIndex(const CBodyIndex& index);
  void TraceDiscs(const SDiscList& discs);
  void TraceShape(const SIndexedShape& shape);
  template <typename TEST>
  void TraceCircle(const SCircle& circle, UInt32 body, TEST&& test);
  template <typename TEST>
  void TraceDirections(Real from, Real to, UInt32 body, TEST&& test);
  template <typename TEST>
  void TraceLines(UInt32 first, UInt32 last, UInt32 body, TEST&& test);
  static EState TraceDisc(const SCircle& circle, const SLine& line);
  EState TraceLine(const SIndexedShape& shape, const SCircle& circle, const SLine& line) const;
  EState TraceBox(const SIndexedShape& box, const SLine& line) const;
  EState CheckHeights(const SIndexedShape& shape, const SLine& line, Real first, Real inside,
                      Real last) const;
  UInt32 BucketOf(Real direction) const;

  const SEnd* m_eye = nullptr;
  std::vector<SAdded> m_added;
  std::vector<SLine> m_lines;  // are sorted by direction
  std::vector<UInt32> m_bucketStart;  // (buckets + 1): ranges in m_lines
  std::vector<UInt32> m_buckets;  // (lines), scratch
  std::vector<UInt8> m_isClear;  // has the order of Add()
  UInt32 m_numBuckets = 1;
  Real m_bucketsPerQuadrant = 0.25;
  size_t m_numOpen = 0;  // lines that are not blocked
};

}  // namespace argos

#endif
