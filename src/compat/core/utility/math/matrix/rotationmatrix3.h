#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_ROTATIONMATRIX3_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_ROTATIONMATRIX3_H

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/matrix/squarematrix.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * A rotation in space; entries set as numbers are not checked.
 *
 * Euler angles are applied as R = Rz Ry Rx: about fixed axes, x first. CQuaternion uses the
 * opposite order.
 */
class CRotationMatrix3 : public CSquareMatrix<3> {
 public:
  /** The identity. */
  CRotationMatrix3() { SetIdentityMatrix(); }

  CRotationMatrix3(const CMatrix<3, 3>& matrix) : CSquareMatrix<3>(matrix) {}

  CRotationMatrix3(const CRadians& z, const CRadians& y, const CRadians& x) {
    SetFromAngles(z, y, x);
  }

  /** Entries row by row. */
  CRotationMatrix3(Real value0, Real value1, Real value2, Real value3, Real value4, Real value5,
                   Real value6, Real value7, Real value8) {
    SetFromValues(value0, value1, value2, value3, value4, value5, value6, value7, value8);
  }

  void SetFromMatrix(const CMatrix<3, 3>& matrix) { CMatrix<3, 3>::operator=(matrix); }
  void SetFromAngles(const CRadians& z, const CRadians& y, const CRadians& x);
  void SetFromValues(Real value0, Real value1, Real value2, Real value3, Real value4, Real value5,
                     Real value6, Real value7, Real value8);

  /**
   * Returns the quaternion of the same rotation, with w >= 0 unless the angle is close to half a
   * turn.
   */
  operator CQuaternion() const;

  using CMatrix<3, 3>::operator*;
  CVector3 operator*(const CVector3& vector) const;
};

}  // namespace argos

#endif
