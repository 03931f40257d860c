#ifndef ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_MATRIX_H
#define ARGOS3_COMPAT_CORE_UTILITY_MATH_MATRIX_MATRIX_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <ios>
#include <ostream>
#include <string>

namespace argos {

/**
 * A matrix of fixed size, stored row by row. The layout is a plain array, and this header needs no
 * other library; AsEigen() of eigen_bridge.h maps it without a copy.
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

  /** All entries, row by row. */
  Real* GetValues() { return m_pfValues; }
  const Real* GetValues() const { return m_pfValues; }

  /** @param values  row by row, (ROWS * COLS). */
  void Set(const Real* values) { std::copy_n(values, ROWS * COLS, m_pfValues); }

  void SetZero() { std::fill_n(m_pfValues, ROWS * COLS, 0.0); }

  CMatrix<COLS, ROWS> GetTransposed() const {
    CMatrix<COLS, ROWS> result;
    for (UInt32 row = 0; row < ROWS; ++row) {
      for (UInt32 col = 0; col < COLS; ++col) {
        result(col, row) = (*this)(row, col);
      }
    }
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
    for (UInt32 i = 0; i < SMROWS; ++i) {
      std::copy_n(m_pfValues + (row + i) * COLS + col, SMCOLS, &sub(i, 0));
    }
  }

  /** Exact comparison. */
  bool operator==(const CMatrix<ROWS, COLS>& other) const {
    return std::equal(m_pfValues, m_pfValues + ROWS * COLS, other.m_pfValues);
  }

  CMatrix<ROWS, COLS>& operator+=(const CMatrix<ROWS, COLS>& other) {
    for (UInt32 i = 0; i < ROWS * COLS; ++i) {
      m_pfValues[i] += other.m_pfValues[i];
    }
    return *this;
  }

  CMatrix<ROWS, COLS>& operator-=(const CMatrix<ROWS, COLS>& other) {
    for (UInt32 i = 0; i < ROWS * COLS; ++i) {
      m_pfValues[i] -= other.m_pfValues[i];
    }
    return *this;
  }

  CMatrix<ROWS, COLS>& operator*=(Real factor) {
    for (Real& value : m_pfValues) {
      value *= factor;
    }
    return *this;
  }

  /** this = this * other. */
  CMatrix<ROWS, COLS>& operator*=(const CMatrix<COLS, COLS>& other) {
    return *this = *this * other;
  }

  CMatrix<ROWS, COLS> operator+(const CMatrix<ROWS, COLS>& other) const {
    return CMatrix(*this) += other;
  }
  CMatrix<ROWS, COLS> operator-(const CMatrix<ROWS, COLS>& other) const {
    return CMatrix(*this) -= other;
  }

  CMatrix<ROWS, COLS> operator-() const {
    CMatrix<ROWS, COLS> result;
    for (UInt32 i = 0; i < ROWS * COLS; ++i) {
      result(i) = -m_pfValues[i];
    }
    return result;
  }

  template <UInt32 OTRCOLS>
  CMatrix<ROWS, OTRCOLS> operator*(const CMatrix<COLS, OTRCOLS>& other) const {
    CMatrix<ROWS, OTRCOLS> result;
    for (UInt32 row = 0; row < ROWS; ++row) {
      for (UInt32 col = 0; col < OTRCOLS; ++col) {
        Real sum = 0.0;
        for (UInt32 i = 0; i < COLS; ++i) {
          sum += (*this)(row, i) * other(i, col);
        }
        result(row, col) = sum;
      }
    }
    return result;
  }

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
