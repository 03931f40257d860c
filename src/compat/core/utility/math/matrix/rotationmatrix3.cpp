#include <argos3/core/utility/math/matrix/rotationmatrix3.h>

#include <argos3/core/utility/math/eigen_bridge.h>

namespace argos {

namespace {

Eigen::AngleAxis<Real> MakeRotation(const CRadians& angle, const CVector3& axis) {
  return Eigen::AngleAxis<Real>(angle.GetValue(), ToEigen(axis));
}

}  // namespace

void CRotationMatrix3::SetFromAngles(const CRadians& z, const CRadians& y, const CRadians& x) {
  AsEigen(*this) = MakeRotation(z, CVector3::Z).toRotationMatrix() *
                   MakeRotation(y, CVector3::Y).toRotationMatrix() *
                   MakeRotation(x, CVector3::X).toRotationMatrix();
}

void CRotationMatrix3::SetFromValues(Real value0, Real value1, Real value2, Real value3,
                                     Real value4, Real value5, Real value6, Real value7,
                                     Real value8) {
  const Real values[] = {value0, value1, value2, value3, value4, value5, value6, value7, value8};
  Set(values);
}

CRotationMatrix3::operator CQuaternion() const {
  const Eigen::Matrix<Real, 3, 3> matrix = AsEigen(*this);
  return FromEigen(Eigen::Quaternion<Real>(matrix));
}

CVector3 CRotationMatrix3::operator*(const CVector3& vector) const {
  const Eigen::Matrix<Real, 3, 1> result = AsEigen(*this) * ToEigen(vector);
  return FromEigen(result);
}

}  // namespace argos
