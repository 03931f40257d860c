#include <argos3/core/utility/math/matrix/rotationmatrix2.h>

#include <argos3/core/utility/math/eigen_bridge.h>

namespace argos {

void CRotationMatrix2::SetFromAngle(const CRadians& angle) {
  Real sine = 0.0;
  Real cosine = 1.0;
  SinCos(angle, sine, cosine);
  SetFromValues(cosine, -sine, sine, cosine);
}

void CRotationMatrix2::SetFromValues(Real value0, Real value1, Real value2, Real value3) {
  const Real values[] = {value0, value1, value2, value3};
  Set(values);
}

CVector2 CRotationMatrix2::operator*(const CVector2& vector) const {
  const Eigen::Matrix<Real, 2, 1> result = AsEigen(*this) * ToEigen(vector);
  return FromEigen(result);
}

}  // namespace argos
