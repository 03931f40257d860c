#include <argos3/core/utility/math/matrix/transformationmatrix2.h>

#include <argos3/core/utility/math/eigen_bridge.h>

namespace argos {

void CTransformationMatrix2::SetFromComponents(const CRotationMatrix2& rotation,
                                               const CVector2& translation) {
  SetIdentityMatrix();
  SetRotationMatrix(rotation);
  SetTranslationVector(translation);
}

void CTransformationMatrix2::SetFromValues(Real value0, Real value1, Real value2, Real value3,
                                           Real value4, Real value5, Real value6, Real value7,
                                           Real value8) {
  const Real values[] = {value0, value1, value2, value3, value4, value5, value6, value7, value8};
  Set(values);
}

void CTransformationMatrix2::SetRotationMatrix(const CRotationMatrix2& rotation) {
  AsEigen(*this).topLeftCorner<2, 2>() = AsEigen(rotation);
}

void CTransformationMatrix2::SetTranslationVector(const CVector2& translation) {
  (*this)(0, 2) = translation.GetX();
  (*this)(1, 2) = translation.GetY();
}

CRotationMatrix2 CTransformationMatrix2::GetRotationMatrix() const {
  CRotationMatrix2 rotation;
  GetSubMatrix(rotation, 0, 0);
  return rotation;
}

CVector2 CTransformationMatrix2::GetTranslationVector() const {
  return CVector2((*this)(0, 2), (*this)(1, 2));
}

}  // namespace argos
