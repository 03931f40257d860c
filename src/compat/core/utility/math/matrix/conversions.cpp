// Conversions of vectors and quaternions to matrices. The headers of the former declare them, with
// forward declarations of the latter.

#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/core/utility/math/matrix/rotationmatrix3.h>

namespace argos {

CVector2::operator CMatrix<1, 2>() const {
  const Real values[] = {m_x, m_y};
  return CMatrix<1, 2>(values);
}

CVector2::operator CMatrix<2, 1>() const {
  const Real values[] = {m_x, m_y};
  return CMatrix<2, 1>(values);
}

CVector3::operator CMatrix<1, 3>() const {
  const Real values[] = {m_x, m_y, m_z};
  return CMatrix<1, 3>(values);
}

CVector3::operator CMatrix<3, 1>() const {
  const Real values[] = {m_x, m_y, m_z};
  return CMatrix<3, 1>(values);
}

CQuaternion::operator CRotationMatrix3() const {
  const Eigen::Matrix<Real, 3, 3, Eigen::RowMajor> matrix = ToEigen(*this).toRotationMatrix();
  return CRotationMatrix3(CMatrix<3, 3>(matrix.data()));
}

}  // namespace argos
