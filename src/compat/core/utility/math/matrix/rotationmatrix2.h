#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_ROTATIONMATRIX2_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_ROTATIONMATRIX2_H

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/matrix/squarematrix.h>
#include <argos3/core/utility/math/vector2.h>

namespace argos {

/** A rotation in the plane; entries set as numbers are not checked. */
class CRotationMatrix2 : public CSquareMatrix<2> {
 public:
  /** The identity. */
  CRotationMatrix2() { SetIdentityMatrix(); }

  CRotationMatrix2(const CMatrix<2, 2>& matrix) : CSquareMatrix<2>(matrix) {}

  /** Counter-clockwise. */
  CRotationMatrix2(const CRadians& angle) { SetFromAngle(angle); }

  /** Entries row by row. */
  CRotationMatrix2(Real value0, Real value1, Real value2, Real value3) {
    SetFromValues(value0, value1, value2, value3);
  }

  void SetFromMatrix(const CMatrix<2, 2>& matrix) { CMatrix<2, 2>::operator=(matrix); }
  void SetFromAngle(const CRadians& angle);
  void SetFromValues(Real value0, Real value1, Real value2, Real value3);

  using CMatrix<2, 2>::operator*;
  CVector2 operator*(const CVector2& vector) const;
};

}  // namespace argos

#endif
