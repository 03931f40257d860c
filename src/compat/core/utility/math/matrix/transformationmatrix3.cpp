#include <argos3/core/utility/math/matrix/transformationmatrix3.h>

#include <argos3/core/utility/math/eigen_bridge.h>

namespace argos {

void CTransformationMatrix3::SetFromComponents(const CRotationMatrix3& rotation,
                                               const CVector3& translation) {
  SetIdentityMatrix();
  SetRotationMatrix(rotation);
  SetTranslationVector(translation);
}

void CTransformationMatrix3::SetFromValues(Real value0, Real value1, Real value2, Real value3,
                                           Real value4, Real value5, Real value6, Real value7,
                                           Real value8, Real value9, Real value10, Real value11,
                                           Real value12, Real value13, Real value14, Real value15) {
  const Real values[] = {value0, value1, value2,  value3,  value4,  value5,  value6,  value7,
                         value8, value9, value10, value11, value12, value13, value14, value15};
  Set(values);
}

void CTransformationMatrix3::SetRotationMatrix(const CRotationMatrix3& rotation) {
  AsEigen(*this).topLeftCorner<3, 3>() = AsEigen(rotation);
}

void CTransformationMatrix3::SetTranslationVector(const CVector3& translation) {
  AsEigen(*this).topRightCorner<3, 1>() = ToEigen(translation);
}

CRotationMatrix3 CTransformationMatrix3::GetRotationMatrix() const {
  CRotationMatrix3 rotation;
  GetSubMatrix(rotation, 0, 0);
  return rotation;
}

CVector3 CTransformationMatrix3::GetTranslationVector() const {
  return CVector3((*this)(0, 3), (*this)(1, 3), (*this)(2, 3));
}

CVector3 CTransformationMatrix3::operator*(const CVector3& vector) const {
  const Eigen::Matrix<Real, 3, 1> result = AsEigen(*this).topLeftCorner<3, 3>() * ToEigen(vector) +
                                           AsEigen(*this).topRightCorner<3, 1>();
  return FromEigen(result);
}

CTransformationMatrix3 CTransformationMatrix3::operator*(
    const CTransformationMatrix3& other) const {
  return CMatrix<4, 4>::operator*<4>(other);
}

}  // namespace argos
