#ifndef ARGOS3_CORE_UTILITY_MATH_PLANAR_VECTOR_H
#define ARGOS3_CORE_UTILITY_MATH_PLANAR_VECTOR_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cmath>

namespace argos {

/**
 * A vector or a point of the plane, for the insides of engines and of the body index: an aggregate
 * without default values, so that an array of them costs nothing until it is filled. CVector2 is
 * the one of the public interfaces.
 */
struct SPlanarVector {
  Real X, Y;
};

constexpr SPlanarVector operator+(const SPlanarVector& a, const SPlanarVector& b) {
  return {a.X + b.X, a.Y + b.Y};
}
constexpr SPlanarVector operator-(const SPlanarVector& a, const SPlanarVector& b) {
  return {a.X - b.X, a.Y - b.Y};
}
constexpr SPlanarVector operator-(const SPlanarVector& a) {
  return {-a.X, -a.Y};
}
constexpr SPlanarVector operator*(Real factor, const SPlanarVector& a) {
  return {factor * a.X, factor * a.Y};
}
constexpr Real Dot(const SPlanarVector& a, const SPlanarVector& b) {
  return a.X * b.X + a.Y * b.Y;
}
/** The z component of the cross product: positive if @p b is to the left of @p a. */
constexpr Real Cross(const SPlanarVector& a, const SPlanarVector& b) {
  return a.X * b.Y - a.Y * b.X;
}
constexpr Real SquareLength(const SPlanarVector& a) {
  return Dot(a, a);
}
/** @param angle  rad, counterclockwise. */
inline SPlanarVector Rotate(const SPlanarVector& a, Real angle) {
  const Real cosine = std::cos(angle);
  const Real sine = std::sin(angle);
  return {cosine * a.X - sine * a.Y, sine * a.X + cosine * a.Y};
}

}  // namespace argos

#endif
