#ifndef ARGOS3_PLUGINS_MEDIA_LINE_OF_SIGHT_H
#define ARGOS3_PLUGINS_MEDIA_LINE_OF_SIGHT_H

#include <argos3/core/utility/math/ray3.h>

#include <vector>

namespace argos {

class CBodyIndex;
class CEmbodiedEntity;
class CPhysicsEngine;
class CSpace;

/**
 * Tests lines of sight between bodies, as of the last rebuild of the body index.
 *
 * Queries are safe on several threads at once. Create an object for each phase; that is cheap.
 */
class CLineOfSight {
 public:
  /** A body at an end of a line, and its number in the index, adjacent in memory. */
  struct SEnd {
    const CEmbodiedEntity* Body;
    UInt32 Number;
  };

  explicit CLineOfSight(CSpace& space);

  /**
   * True if no third body is between a point of the body @p start and one of the body @p end.
   *
   * Only the part of the segment outside both bodies counts, so robots that touch or overlap see
   * each other, and exchanging the ends changes nothing but rounding.
   */
  bool IsClear(const CRay3& segment, const SEnd& start, const SEnd& end) const;
  bool IsClear(const CRay3& segment, const CEmbodiedEntity& start,
               const CEmbodiedEntity& end) const {
    return IsClear(segment, MakeEnd(start), MakeEnd(end));
  }
  static SEnd MakeEnd(const CEmbodiedEntity& body);

  /** For callers that test many lines at once. */
  const CBodyIndex& GetIndex() const { return m_index; }
  /** @return true if bodies occlude that are not in the index. */
  bool HasBodiesOutsideIndex() const { return !m_engines.empty(); }

 private:
  bool IsClearOutsideIndex(const CRay3& segment, const CEmbodiedEntity* start,
                           const CEmbodiedEntity* end) const;

  const CBodyIndex& m_index;
  // engines with bodies that are not in the index; usually none
  std::vector<const CPhysicsEngine*> m_engines;
};

}  // namespace argos

#endif
