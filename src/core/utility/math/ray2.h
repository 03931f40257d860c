#ifndef ARGOS3_CORE_UTILITY_MATH_RAY2_H
#define ARGOS3_CORE_UTILITY_MATH_RAY2_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector2.h>

#include <ostream>

namespace argos {

/** A directed line segment in the plane, in m. */
class CRay2 {
 public:
  /** From the origin to the origin. */
  constexpr CRay2() = default;

  constexpr CRay2(const CVector2& start, const CVector2& end) : m_start(start), m_end(end) {}

  /** @param direction must have length 1. */
  constexpr CRay2(const CVector2& start, const CVector2& direction, Real length)
      : m_start(start), m_end(start + direction * length) {}

  constexpr const CVector2& GetStart() const { return m_start; }
  constexpr const CVector2& GetEnd() const { return m_end; }
  constexpr void SetStart(const CVector2& start) { m_start = start; }
  constexpr void SetEnd(const CVector2& end) { m_end = end; }
  constexpr void Set(const CVector2& start, const CVector2& end) { *this = CRay2(start, end); }

  constexpr void Set(const CVector2& start, const CVector2& direction, Real length) {
    *this = CRay2(start, direction, length);
  }

  /** Gives the unit vector from start to end; NaN if the two are equal. */
  void GetDirection(CVector2& buffer) const { buffer = (m_end - m_start).Normalize(); }

  /** Gives the unit vector from end to start; NaN if the two are equal. */
  void GetInverseDirection(CVector2& buffer) const { buffer = (m_start - m_end).Normalize(); }

  Real GetLength() const { return Distance(m_start, m_end); }

  /** Gives end - start. */
  constexpr void ToVector(CVector2& buffer) const { buffer = m_end - m_start; }

  /** Gives start + t (end - start). */
  constexpr void GetPoint(CVector2& point, Real t) const {
    point = m_start + t * (m_end - m_start);
  }

  /** Returns the distance of the point at t from the start, t * length. */
  Real GetDistance(Real t) const { return t * GetLength(); }

  /**
   * @return true if the two segments have a point in common, ends included.
   *
   * Segments whose directions differ by less than 1e-10 rad count as parallel and do not intersect,
   * even if they overlap.
   */
  bool Intersects(const CRay2& other) const;

 private:
  CVector2 m_start;
  CVector2 m_end;
};

/** Writes "start -> end". */
std::ostream& operator<<(std::ostream& os, const CRay2& ray);

}  // namespace argos

#endif
