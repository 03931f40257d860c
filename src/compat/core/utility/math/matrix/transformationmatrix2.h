#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_TRANSFORMATIONMATRIX2_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_TRANSFORMATIONMATRIX2_H

#include <argos3/core/utility/math/matrix/rotationmatrix2.h>
#include <argos3/core/utility/math/matrix/squarematrix.h>
#include <argos3/core/utility/math/vector2.h>

namespace argos {

/** A rotation followed by a translation in the plane, in homogeneous coordinates. */
class CTransformationMatrix2 : public CSquareMatrix<3> {
 public:
  /** The identity. */
  CTransformationMatrix2() { SetIdentityMatrix(); }

  CTransformationMatrix2(const CMatrix<3, 3>& matrix) : CSquareMatrix<3>(matrix) {}

  CTransformationMatrix2(const CRotationMatrix2& rotation, const CVector2& translation) {
    SetFromComponents(rotation, translation);
  }

  /** Entries row by row. */
  CTransformationMatrix2(Real value0, Real value1, Real value2, Real value3, Real value4,
                         Real value5, Real value6, Real value7, Real value8) {
    SetFromValues(value0, value1, value2, value3, value4, value5, value6, value7, value8);
  }

  void SetFromMatrix(const CMatrix<3, 3>& matrix) { CMatrix<3, 3>::operator=(matrix); }

  /** Sets the whole matrix, the last row included. */
  void SetFromComponents(const CRotationMatrix2& rotation, const CVector2& translation);

  void SetFromValues(Real value0, Real value1, Real value2, Real value3, Real value4, Real value5,
                     Real value6, Real value7, Real value8);

  /** These two change one part and keep the other. */
  void SetRotationMatrix(const CRotationMatrix2& rotation);
  void SetTranslationVector(const CVector2& translation);

  CRotationMatrix2 GetRotationMatrix() const;
  CVector2 GetTranslationVector() const;
};

}  // namespace argos

#endif
