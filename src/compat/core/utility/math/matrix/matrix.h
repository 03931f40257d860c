#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_MATRIX_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_MATRIX_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <Eigen/Core>

#include <algorithm>
#include <ios>
#include <ostream>
#include <string>

namespace argos {

/**
 * A matrix of fixed size, stored row by row. The layout is a plain array and contains no Eigen
 * type, so libraries built with different vector instructions agree on it; AsEigen() maps it
 * without a copy.
 */
template <UInt32 ROWS, UInt32 COLS>
class CMatrix {
 public:
  /** All zeros. */
  CMatrix() { SetZero(); }

  /** @param values  row by row, (ROWS * COLS). */
  CMatrix(const Real* values) { Set(values); }

  CMatrix(const CMatrix<ROWS, COLS>& other) = default;
  CMatrix<ROWS, COLS>& operator=(const CMatrix<ROWS, COLS>& other) = default;

  /** @throws CARGoSException if the row or column is out of range, in builds without NDEBUG. */
  Real& operator()(UInt32 row, UInt32 col) { return m_pfValues[ComputeIndex(row, col)]; }
  Real operator()(UInt32 row, UInt32 col) const { return m_pfValues[ComputeIndex(row, col)]; }

  /**
   * @param index  row * COLS + column. @throws CARGoSException if it is out of range, in builds
   *   without NDEBUG.
   */
  Real operator()(UInt32 index) const { return m_pfValues[CheckIndex(index)]; }
  Real& operator()(UInt32 index) { return m_pfValues[CheckIndex(index)]; }

  /** @param values  row by row, (ROWS * COLS). */
  void Set(const Real* values) { std::copy_n(values, ROWS * COLS, m_pfValues); }

  void SetZero() { std::fill_n(m_pfValues, ROWS * COLS, 0.0); }

  CMatrix<COLS, ROWS> GetTransposed() const {
    CMatrix<COLS, ROWS> result;
    result.AsEigen() = AsEigen().transpose();
    return result;
  }

  /**
   * Copies the block whose first entry is at (row, col).
   *
   * @throws CARGoSException if the block does not fit, in builds without NDEBUG.
   */
  template <UInt32 SMROWS, UInt32 SMCOLS>
  void GetSubMatrix(CMatrix<SMROWS, SMCOLS>& sub, UInt32 row, UInt32 col) const {
    static_assert(SMROWS <= ROWS && SMCOLS <= COLS, "a block cannot be larger than its matrix");
    ARGOS_ASSERT(row <= ROWS - SMROWS && col <= COLS - SMCOLS,
                 "A block of " << SMROWS << "x" << SMCOLS << " entries at (" << row << "," << col
                               << ") does not fit a " << ROWS << "x" << COLS << " matrix.");
    sub.AsEigen() = AsEigen().template block<SMROWS, SMCOLS>(row, col);
  }

  /** Exact comparison. */
  bool operator==(const CMatrix<ROWS, COLS>& other) const { return AsEigen() == other.AsEigen(); }

  CMatrix<ROWS, COLS>& operator+=(const CMatrix<ROWS, COLS>& other) {
    AsEigen() += other.AsEigen();
    return *this;
  }

  CMatrix<ROWS, COLS>& operator-=(const CMatrix<ROWS, COLS>& other) {
    AsEigen() -= other.AsEigen();
    return *this;
  }

  CMatrix<ROWS, COLS>& operator*=(Real factor) {
    AsEigen() *= factor;
    return *this;
  }

  /** this = this * other. */
  CMatrix<ROWS, COLS>& operator*=(const CMatrix<COLS, COLS>& other) {
    AsEigen() *= other.AsEigen();
    return *this;
  }

  CMatrix<ROWS, COLS> operator+(const CMatrix<ROWS, COLS>& other) const {
    return CMatrix(*this) += other;
  }
  CMatrix<ROWS, COLS> operator-(const CMatrix<ROWS, COLS>& other) const {
    return CMatrix(*this) -= other;
  }

  CMatrix<ROWS, COLS> operator-() const {
    CMatrix<ROWS, COLS> result;
    result.AsEigen() = -AsEigen();
    return result;
  }

  template <UInt32 OTRCOLS>
  CMatrix<ROWS, OTRCOLS> operator*(const CMatrix<COLS, OTRCOLS>& other) const {
    CMatrix<ROWS, OTRCOLS> result;
    result.AsEigen().noalias() = AsEigen() * other.AsEigen();
    return result;
  }

  // Eigen requires a matrix with one column to be column-major; the layout is the same
  using TEigen = Eigen::Matrix<Real, static_cast<int>(ROWS), static_cast<int>(COLS),
                               COLS == 1 && ROWS != 1 ? Eigen::ColMajor : Eigen::RowMajor>;

  /** Returns an Eigen view of this matrix. */
  Eigen::Map<TEigen> AsEigen() { return Eigen::Map<TEigen>(m_pfValues); }
  Eigen::Map<const TEigen> AsEigen() const { return Eigen::Map<const TEigen>(m_pfValues); }

 protected:
  Real m_pfValues[ROWS * COLS];

 private:
  static UInt32 ComputeIndex(UInt32 row, UInt32 col) {
    ARGOS_ASSERT(row < ROWS && col < COLS, "There is no entry (" << row << "," << col << ") in a "
                                                                 << ROWS << "x" << COLS
                                                                 << " matrix.");
    return row * COLS + col;
  }

  static UInt32 CheckIndex(UInt32 index) {
    ARGOS_ASSERT(index < ROWS * COLS,
                 "There is no entry " << index << " in a " << ROWS << "x" << COLS << " matrix.");
    return index;
  }
};

/** Writes each row as "| a b c |" on its own line, with two decimals. */
template <UInt32 ROWS, UInt32 COLS>
std::ostream& operator<<(std::ostream& os, const CMatrix<ROWS, COLS>& matrix) {
  const std::ios_base::fmtflags flags = os.flags();
  const std::streamsize precision = os.precision();
  os.setf(std::ios_base::fixed, std::ios_base::floatfield);
  os.precision(2);
  for (UInt32 row = 0; row < ROWS; ++row) {
    os << "| ";
    for (UInt32 col = 0; col < COLS; ++col) {
      os << matrix(row, col) << " ";
    }
    os << "|\n";
  }
  os.flags(flags);
  os.precision(precision);
  return os;
}

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/angles.h>
#endif

#endif
