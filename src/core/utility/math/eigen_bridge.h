#ifndef ARGOS3_CORE_UTILITY_MATH_EIGEN_BRIDGE_H
#define ARGOS3_CORE_UTILITY_MATH_EIGEN_BRIDGE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

#include <Eigen/Geometry>

namespace argos {

template <UInt32 ROWS, UInt32 COLS>
class CMatrix;

/*
 * Conversions between the public maths types and Eigen's, by value; they compile to moves. This is
 * the only public header that needs Eigen's folder of headers.
 */

inline Eigen::Matrix<Real, 2, 1> ToEigen(const CVector2& vector) {
  return {vector.GetX(), vector.GetY()};
}

inline Eigen::Matrix<Real, 3, 1> ToEigen(const CVector3& vector) {
  return {vector.GetX(), vector.GetY(), vector.GetZ()};
}

inline Eigen::Quaternion<Real> ToEigen(const CQuaternion& quaternion) {
  return {quaternion.GetW(), quaternion.GetX(), quaternion.GetY(), quaternion.GetZ()};
}

inline CVector2 FromEigen(const Eigen::Matrix<Real, 2, 1>& vector) {
  return {vector.x(), vector.y()};
}

inline CVector3 FromEigen(const Eigen::Matrix<Real, 3, 1>& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

inline CQuaternion FromEigen(const Eigen::Quaternion<Real>& quaternion) {
  return {quaternion.w(), quaternion.x(), quaternion.y(), quaternion.z()};
}

// Eigen requires a matrix with one column to be column-major; the layout is the same
template <UInt32 ROWS, UInt32 COLS>
using TEigenMatrix = Eigen::Matrix<Real, static_cast<int>(ROWS), static_cast<int>(COLS),
                                   COLS == 1 && ROWS != 1 ? Eigen::ColMajor : Eigen::RowMajor>;

/** An Eigen view of a matrix; it refers to the matrix and copies nothing. */
template <UInt32 ROWS, UInt32 COLS>
Eigen::Map<TEigenMatrix<ROWS, COLS>> AsEigen(CMatrix<ROWS, COLS>& matrix) {
  return Eigen::Map<TEigenMatrix<ROWS, COLS>>(matrix.GetValues());
}
template <UInt32 ROWS, UInt32 COLS>
Eigen::Map<const TEigenMatrix<ROWS, COLS>> AsEigen(const CMatrix<ROWS, COLS>& matrix) {
  return Eigen::Map<const TEigenMatrix<ROWS, COLS>>(matrix.GetValues());
}

}  // namespace argos

#endif
