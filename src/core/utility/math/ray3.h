#ifndef ARGOS3_CORE_UTILITY_MATH_RAY3_H
#define ARGOS3_CORE_UTILITY_MATH_RAY3_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector3.h>

#include <ostream>

namespace argos {

class CPlane;

/** A directed line segment in space, in m. */
class CRay3 {
 public:
  /** From the origin to the origin. */
  constexpr CRay3() = default;

  constexpr CRay3(const CVector3& start, const CVector3& end) : m_start(start), m_end(end) {}

  /** @param direction must have length 1. */
  constexpr CRay3(const CVector3& start, const CVector3& direction, Real length)
      : m_start(start), m_end(start + direction * length) {}

  constexpr CVector3& GetStart() { return m_start; }
  constexpr const CVector3& GetStart() const { return m_start; }
  constexpr CVector3& GetEnd() { return m_end; }
  constexpr const CVector3& GetEnd() const { return m_end; }
  constexpr void SetStart(const CVector3& start) { m_start = start; }
  constexpr void SetEnd(const CVector3& end) { m_end = end; }

  /** Moves the end along the ray; the ray must have a direction. */
  void SetLength(Real length) { m_end = m_start + (m_end - m_start).Normalize() * length; }

  constexpr void Set(const CVector3& start, const CVector3& end) { *this = CRay3(start, end); }

  constexpr void Set(const CVector3& start, const CVector3& direction, Real length) {
    *this = CRay3(start, direction, length);
  }

  /** Gives the unit vector from start to end; NaN if the two are equal. */
  void GetDirection(CVector3& buffer) const { buffer = (m_end - m_start).Normalize(); }

  /** Gives the unit vector from end to start; NaN if the two are equal. */
  void GetInverseDirection(CVector3& buffer) const { buffer = (m_start - m_end).Normalize(); }

  Real GetLength() const { return Distance(m_start, m_end); }

  /** Gives end - start, and returns the buffer. */
  constexpr CVector3& ToVector(CVector3& buffer) const {
    buffer = m_end - m_start;
    return buffer;
  }

  /** Gives start + t (end - start). */
  constexpr void GetPoint(CVector3& point, Real t) const {
    point = m_start + t * (m_end - m_start);
  }

  /** Returns the distance of the point at t from the start, t * length. */
  Real GetDistance(Real t) const { return t * GetLength(); }

  /** @return true if the segment meets the plane, ends included; only then sets the point. */
  bool Intersects(const CPlane& plane, CVector3& point) const;

 private:
  CVector3 m_start;
  CVector3 m_end;
};

/** Writes "start -> end". */
std::ostream& operator<<(std::ostream& os, const CRay3& ray);

}  // namespace argos

#endif
