#include <argos3/core/utility/math/matrix/squarematrix.h>

#include <Eigen/LU>

namespace argos::detail {

namespace {

// Eigen has closed forms for the fixed sizes up to 4, and a decomposition for the rest
template <int DIM>
using TMatrix = Eigen::Matrix<Real, DIM, DIM, Eigen::RowMajor>;

template <int DIM>
Real ComputeDeterminantOf(const Real* values, int dim) {
  return Eigen::Map<const TMatrix<DIM>>(values, dim, dim).determinant();
}

template <int DIM>
void ComputeInverseOf(const Real* values, int dim, Real* inverse) {
  Eigen::Map<TMatrix<DIM>>(inverse, dim, dim) =
      Eigen::Map<const TMatrix<DIM>>(values, dim, dim).inverse();
}

}  // namespace

Real ComputeDeterminant(const Real* values, UInt32 dim) {
  switch (dim) {
    case 1:
      return values[0];
    case 2:
      return ComputeDeterminantOf<2>(values, 2);
    case 3:
      return ComputeDeterminantOf<3>(values, 3);
    case 4:
      return ComputeDeterminantOf<4>(values, 4);
    default:
      return ComputeDeterminantOf<Eigen::Dynamic>(values, static_cast<int>(dim));
  }
}

void ComputeInverse(const Real* values, UInt32 dim, Real* inverse) {
  switch (dim) {
    case 1:
      inverse[0] = 1.0 / values[0];
      break;
    case 2:
      ComputeInverseOf<2>(values, 2, inverse);
      break;
    case 3:
      ComputeInverseOf<3>(values, 3, inverse);
      break;
    case 4:
      ComputeInverseOf<4>(values, 4, inverse);
      break;
    default:
      ComputeInverseOf<Eigen::Dynamic>(values, static_cast<int>(dim), inverse);
      break;
  }
}

}  // namespace argos::detail
