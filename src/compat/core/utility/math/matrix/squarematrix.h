#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_SQUAREMATRIX_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_SQUAREMATRIX_H

#include <argos3/core/utility/math/matrix/matrix.h>

namespace argos {

namespace detail {

/** @param values  a square matrix, row by row, (dim * dim). */
Real ComputeDeterminant(const Real* values, UInt32 dim);

/** @param inverse  result, row by row, (dim * dim); meaningless if the determinant is 0. */
void ComputeInverse(const Real* values, UInt32 dim, Real* inverse);

}  // namespace detail

template <UInt32 DIM>
class CSquareMatrix : public CMatrix<DIM, DIM> {
 public:
  /** All zeros. */
  CSquareMatrix() = default;

  CSquareMatrix(const CMatrix<DIM, DIM>& matrix) : CMatrix<DIM, DIM>(matrix) {}

  void SetIdentityMatrix() {
    this->SetZero();
    for (UInt32 i = 0; i < DIM; ++i) {
      (*this)(i, i) = 1.0;
    }
  }

  /** Exact comparison. */
  bool IsIdentityMatrix() const {
    CSquareMatrix<DIM> identity;
    identity.SetIdentityMatrix();
    return *this == identity;
  }

  Real GetDeterminant() const { return detail::ComputeDeterminant(this->GetValues(), DIM); }

  /** Returns the matrix of (-1)^(i+j) times the determinant without row i and column j. */
  CSquareMatrix<DIM> GetCofactorMatrix() const {
    CSquareMatrix<DIM> result;
    for (UInt32 row = 0; row < DIM; ++row) {
      for (UInt32 col = 0; col < DIM; ++col) {
        const Real minor = ComputeMinor(row, col);
        result(row, col) = (row + col) % 2 == 0 ? minor : -minor;
      }
    }
    return result;
  }

  CSquareMatrix<DIM> GetTransposed() const { return CMatrix<DIM, DIM>::GetTransposed(); }

  /** @throws CARGoSException if the determinant is 0 or not a number. */
  CSquareMatrix<DIM> GetInverse() const {
    const Real determinant = GetDeterminant();
    if (!(determinant < 0.0 || determinant > 0.0)) {
      THROW_ARGOSEXCEPTION("A matrix with determinant " << determinant << " has no inverse:\n"
                                                        << *this);
    }
    CSquareMatrix<DIM> result;
    detail::ComputeInverse(this->GetValues(), DIM, result.GetValues());
    return result;
  }

 private:
  Real ComputeMinor(UInt32 row, UInt32 col) const {
    if constexpr (DIM == 1) {
      return 1.0;
    } else {
      CSquareMatrix<DIM - 1> rest;
      for (UInt32 i = 0; i + 1 < DIM; ++i) {
        for (UInt32 j = 0; j + 1 < DIM; ++j) {
          rest(i, j) = (*this)(i < row ? i : i + 1, j < col ? j : j + 1);
        }
      }
      return rest.GetDeterminant();
    }
  }
};

}  // namespace argos

#endif
