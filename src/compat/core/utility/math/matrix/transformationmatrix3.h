#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_TRANSFORMATIONMATRIX3_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_TRANSFORMATIONMATRIX3_H

#include <argos3/core/utility/math/matrix/rotationmatrix3.h>
#include <argos3/core/utility/math/matrix/squarematrix.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** A rotation followed by a translation in space, in homogeneous coordinates. */
class CTransformationMatrix3 : public CSquareMatrix<4> {
 public:
  /** The identity. */
  CTransformationMatrix3() { SetIdentityMatrix(); }

  CTransformationMatrix3(const CMatrix<4, 4>& matrix) : CSquareMatrix<4>(matrix) {}

  CTransformationMatrix3(const CRotationMatrix3& rotation, const CVector3& translation) {
    SetFromComponents(rotation, translation);
  }

  /** Entries row by row. */
  CTransformationMatrix3(Real value0, Real value1, Real value2, Real value3, Real value4,
                         Real value5, Real value6, Real value7, Real value8, Real value9,
                         Real value10, Real value11, Real value12, Real value13, Real value14,
                         Real value15) {
    SetFromValues(value0, value1, value2, value3, value4, value5, value6, value7, value8, value9,
                  value10, value11, value12, value13, value14, value15);
  }

  void SetFromMatrix(const CMatrix<4, 4>& matrix) { CMatrix<4, 4>::operator=(matrix); }

  /** Sets the whole matrix, the last row included. */
  void SetFromComponents(const CRotationMatrix3& rotation, const CVector3& translation);

  void SetFromValues(Real value0, Real value1, Real value2, Real value3, Real value4, Real value5,
                     Real value6, Real value7, Real value8, Real value9, Real value10, Real value11,
                     Real value12, Real value13, Real value14, Real value15);

  /** These two change one part and keep the other. */
  void SetRotationMatrix(const CRotationMatrix3& rotation);
  void SetTranslationVector(const CVector3& translation);

  CRotationMatrix3 GetRotationMatrix() const;
  CVector3 GetTranslationVector() const;

  using CMatrix<4, 4>::operator*;

  /** Applies the rotation, then the translation. */
  CVector3 operator*(const CVector3& vector) const;

  CTransformationMatrix3 operator*(const CTransformationMatrix3& other) const;
};

}  // namespace argos

#endif
