#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/core/utility/math/matrix/matrix.h>
#include <argos3/core/utility/math/matrix/rotationmatrix2.h>
#include <argos3/core/utility/math/matrix/rotationmatrix3.h>
#include <argos3/core/utility/math/matrix/squarematrix.h>
#include <argos3/core/utility/math/matrix/transformationmatrix2.h>
#include <argos3/core/utility/math/matrix/transformationmatrix3.h>
#include <argos3/core/utility/math/transforms.h>

#include <catch2/catch.hpp>

#include <sstream>
#include <type_traits>

namespace matrix_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using namespace argos;

namespace {

// tolerance of a few roundings of numbers of about 1 to 10
constexpr Real kRounding = 1e-14;

template <UInt32 ROWS, UInt32 COLS>
CMatrix<ROWS, COLS> Make(const Real (&values)[ROWS * COLS]) {
  return CMatrix<ROWS, COLS>(values);
}

// the Frobenius norm of the difference of two matrices of the same size
template <typename MATRIX, typename OTHER>
Real Difference(const MATRIX& a, const OTHER& b) {
  return (AsEigen(a) - AsEigen(b)).norm();
}

static_assert(std::is_trivially_copyable_v<CMatrix<2, 3> > &&
              sizeof(CMatrix<2, 3>) == 6 * sizeof(Real));
static_assert(sizeof(CTransformationMatrix3) == 16 * sizeof(Real));

}  // namespace

TEST_CASE("matrix: entries are stored row by row", "[core][math]") {
  CMatrix<2, 3> matrix;
  CHECK(matrix == Make<2, 3>({0, 0, 0, 0, 0, 0}));
  const Real values[] = {1, 2, 3, 4, 5, 6};
  matrix.Set(values);
  const CMatrix<2, 3>& constant = matrix;
  CHECK(constant(0, 2) == 3.0);
  CHECK(constant(1, 0) == 4.0);
  CHECK(constant(4) == 5.0);
  matrix(1, 2) = 7.0;
  matrix(0) = 8.0;
  CHECK(matrix == Make<2, 3>({8, 2, 3, 4, 5, 7}));
  CMatrix<2, 3> copy(matrix);
  CHECK(copy == matrix);
  copy.SetZero();
  CHECK_FALSE(copy == matrix);
  copy = matrix;
  CHECK(copy == matrix);
#ifndef NDEBUG
  CHECK_THROWS_WITH(matrix(2, 0), Contains("(2,0)") && Contains("2x3"));
  CHECK_THROWS_WITH(constant(0, 3), Contains("(0,3)"));
  CHECK_THROWS_AS(matrix(6), CARGoSException);
#endif
}

TEST_CASE("matrix: blocks and transposition", "[core][math]") {
  const CMatrix<3, 4> matrix = Make<3, 4>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  CMatrix<2, 2> block;
  matrix.GetSubMatrix(block, 1, 2);
  CHECK(block == Make<2, 2>({7, 8, 11, 12}));
  CMatrix<3, 1> column;
  matrix.GetSubMatrix(column, 0, 3);
  CHECK(column == Make<3, 1>({4, 8, 12}));
  CHECK(matrix.GetTransposed() == Make<4, 3>({1, 5, 9, 2, 6, 10, 3, 7, 11, 4, 8, 12}));
  CHECK(matrix.GetTransposed().GetTransposed() == matrix);
#ifndef NDEBUG
  CHECK_THROWS_WITH(matrix.GetSubMatrix(block, 2, 0), Contains("2x2") && Contains("3x4"));
#endif
}

TEST_CASE("matrix: arithmetic", "[core][math]") {
  CMatrix<2, 2> a = Make<2, 2>({1, 2, 3, 4});
  const CMatrix<2, 2> b = Make<2, 2>({5, 6, 7, 8});
  CHECK(a + b == Make<2, 2>({6, 8, 10, 12}));
  CHECK(b - a == Make<2, 2>({4, 4, 4, 4}));
  CHECK(-a == Make<2, 2>({-1, -2, -3, -4}));
  CHECK(a * b == Make<2, 2>({19, 22, 43, 50}));
  CHECK(Make<2, 3>({1, 2, 3, 4, 5, 6}) * Make<3, 1>({1, 0, -1}) == Make<2, 1>({-2, -2}));
  CHECK(Make<3, 1>({1, 2, 3}) * Make<1, 2>({1, 10}) == Make<3, 2>({1, 10, 2, 20, 3, 30}));
  CHECK((a += b) == Make<2, 2>({6, 8, 10, 12}));
  CHECK((a -= b) == Make<2, 2>({1, 2, 3, 4}));
  CHECK((a *= 2.0) == Make<2, 2>({2, 4, 6, 8}));
  CHECK((a *= b) == Make<2, 2>({38, 44, 86, 100}));
  // product with itself: no entry is overwritten before it has been read
  a = Make<2, 2>({1, 2, 3, 4});
  CHECK((a *= a) == Make<2, 2>({7, 10, 15, 22}));
}

TEST_CASE("matrix: text form has two decimals and leaves the format of the stream unchanged",
          "[core][math]") {
  std::ostringstream out;
  out << Make<2, 2>({1, -0.126, 100, 0}) << 0.126;
  CHECK(out.str() == "| 1.00 -0.13 |\n| 100.00 0.00 |\n0.126");
}

TEST_CASE("square matrix: identity", "[core][math]") {
  CSquareMatrix<3> matrix;
  CHECK_FALSE(matrix.IsIdentityMatrix());
  matrix.SetIdentityMatrix();
  CHECK(matrix.IsIdentityMatrix());
  CHECK(matrix == Make<3, 3>({1, 0, 0, 0, 1, 0, 0, 0, 1}));
  matrix(0, 1) = 1e-300;
  CHECK_FALSE(matrix.IsIdentityMatrix());
}

TEST_CASE("square matrix: determinants, cofactors and inverses of whole numbers", "[core][math]") {
  const CSquareMatrix<1> one = Make<1, 1>({4});
  CHECK(one.GetDeterminant() == 4.0);
  CHECK(one.GetCofactorMatrix()(0) == 1.0);
  CHECK(one.GetInverse()(0) == 0.25);

  const CSquareMatrix<2> two = Make<2, 2>({1, 2, 3, 4});
  CHECK(two.GetDeterminant() == -2.0);
  CHECK(two.GetCofactorMatrix() == Make<2, 2>({4, -3, -2, 1}));
  CHECK(two.GetInverse() == Make<2, 2>({-2, 1, 1.5, -0.5}));
  CHECK(two.GetTransposed() == Make<2, 2>({1, 3, 2, 4}));

  const CSquareMatrix<3> three = Make<3, 3>({1, 2, 3, 0, 1, 4, 5, 6, 0});
  CHECK(three.GetDeterminant() == 1.0);
  CHECK(three.GetCofactorMatrix() == Make<3, 3>({-24, 20, -5, 18, -15, 4, 5, -4, 1}));
  CHECK(three.GetInverse() == three.GetCofactorMatrix().GetTransposed());

  // triangular: the product of the diagonal
  const CSquareMatrix<5> five =
      Make<5, 5>({2, 1, 0, 3, 1, 0, 3, 1, 1, 1, 0, 0, 1, 5, 2, 0, 0, 0, 4, 1, 0, 0, 0, 0, 0.5});
  CHECK_THAT(five.GetDeterminant(), WithinAbs(12.0, kRounding));
}

TEST_CASE("square matrix: a matrix times its inverse is the identity", "[core][math]") {
  const CSquareMatrix<4> matrix = Make<4, 4>({2, 1, 0, 3, 1, 3, 1, 1, 0, 2, 1, 5, 1, 0, 0, 4});
  CSquareMatrix<4> identity;
  identity.SetIdentityMatrix();
  CHECK_THAT(Difference(matrix * matrix.GetInverse(), identity), WithinAbs(0.0, kRounding));
  // Cramer: A cof(A)^T = det(A) I
  const CMatrix<4, 4> product = matrix * matrix.GetCofactorMatrix().GetTransposed();
  CHECK_THAT(Difference(product, identity *= matrix.GetDeterminant()), WithinAbs(0.0, 1e-13));
}

TEST_CASE("square matrix: a singular matrix has cofactors but no inverse", "[core][math]") {
  const CSquareMatrix<3> singular = Make<3, 3>({1, 2, 3, 2, 4, 6, 0, 1, 1});
  CHECK(singular.GetDeterminant() == 0.0);
  CHECK(singular.GetCofactorMatrix() == Make<3, 3>({-2, -2, 2, 1, 1, -1, 0, 0, 0}));
  CHECK_THROWS_WITH(singular.GetInverse(),
                    Contains("determinant 0") && Contains("| 2.00 4.00 6.00 |"));
}

TEST_CASE("2D rotation matrix: is constructed from an angle and rotates vectors", "[core][math]") {
  CHECK(CRotationMatrix2().IsIdentityMatrix());
  const CRotationMatrix2 left(CRadians::PI_OVER_TWO);
  CHECK_THAT(Difference(left, Make<2, 2>({0, -1, 1, 0})), WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(left * CVector2(2, 1), CVector2(-1, 2)), WithinAbs(0.0, kRounding));
  const CVector2 vector(0.4, -0.3);
  CHECK_THAT(
      Distance(CRotationMatrix2(CRadians(1.1)) * vector, CVector2(vector).Rotate(CRadians(1.1))),
      WithinAbs(0.0, kRounding));

  CRotationMatrix2 matrix(1, 2, 3, 4);
  CHECK(matrix == Make<2, 2>({1, 2, 3, 4}));
  CHECK(CRotationMatrix2(Make<2, 2>({1, 2, 3, 4})) == matrix);
  matrix.SetFromAngle(CRadians::PI_OVER_TWO);
  CHECK(matrix == left);
  matrix.SetFromValues(5, 6, 7, 8);
  CHECK(matrix(1, 0) == 7.0);
  matrix.SetFromMatrix(left);
  CHECK(matrix == left);
  // products add angles
  CHECK_THAT(Difference(CRotationMatrix2(CRadians(0.3)) * CRotationMatrix2(CRadians(0.4)),
                        CRotationMatrix2(CRadians(0.7))),
             WithinAbs(0.0, kRounding));
}

TEST_CASE("3D rotation matrix: angles z, y, x mean Rz Ry Rx", "[core][math]") {
  CHECK(CRotationMatrix3().IsIdentityMatrix());
  const CRadians z(0.5);
  const CRadians y(-0.8);
  const CRadians x(1.9);
  const CRotationMatrix3 matrix(z, y, x);
  const CVector3 vector(0.4, -0.3, 1.2);
  CHECK_THAT(Distance(matrix * vector, CVector3(vector).RotateX(x).RotateY(y).RotateZ(z)),
             WithinAbs(0.0, kRounding));
  CRotationMatrix3 same;
  same.SetFromAngles(z, y, x);
  CHECK(same == matrix);
  // CQuaternion uses the opposite order
  CQuaternion quaternion;
  quaternion.FromEulerAngles(z, y, x);
  const CRotationMatrix3 other = quaternion;
  CHECK(Difference(matrix, other) > 0.1);
  CHECK_THAT(Distance(other * vector, CVector3(vector).RotateZ(z).RotateY(y).RotateX(x)),
             WithinAbs(0.0, kRounding));
  // for rotations about one axis both orders agree
  const CRotationMatrix3 aboutZ = CQuaternion(z, CVector3::Z);
  CHECK_THAT(Difference(aboutZ, CRotationMatrix3(z, CRadians::ZERO, CRadians::ZERO)),
             WithinAbs(0.0, kRounding));
}

TEST_CASE("3D rotation matrix: construction from numbers and conversion to a quaternion",
          "[core][math]") {
  CRotationMatrix3 matrix(1, 2, 3, 4, 5, 6, 7, 8, 9);
  CHECK(matrix == Make<3, 3>({1, 2, 3, 4, 5, 6, 7, 8, 9}));
  CHECK(CRotationMatrix3(Make<3, 3>({1, 2, 3, 4, 5, 6, 7, 8, 9})) == matrix);
  matrix.SetFromValues(0, -1, 0, 1, 0, 0, 0, 0, 1);
  CHECK(matrix * CVector3::X == CVector3::Y);
  const CQuaternion quaternion = matrix;
  CHECK_THAT((quaternion - CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z)).Length(),
             WithinAbs(0.0, kRounding));
  CRotationMatrix3 other;
  other.SetFromMatrix(matrix);
  CHECK(other == matrix);
  const CRotationMatrix3 halfTurn = matrix * other;
  CHECK(halfTurn == CRotationMatrix3(-1, 0, 0, 0, -1, 0, 0, 0, 1));
}

TEST_CASE("2D transformation matrix: has a rotation and a translation part", "[core][math]") {
  CHECK(CTransformationMatrix2().IsIdentityMatrix());
  const CRotationMatrix2 rotation(0, -1, 1, 0);
  CTransformationMatrix2 matrix(rotation, CVector2(5, 6));
  CHECK(matrix == Make<3, 3>({0, -1, 5, 1, 0, 6, 0, 0, 1}));
  CHECK(matrix.GetRotationMatrix() == rotation);
  CHECK(matrix.GetTranslationVector() == CVector2(5, 6));
  matrix.SetTranslationVector(CVector2(7, 8));
  matrix.SetRotationMatrix(CRotationMatrix2());
  CHECK(matrix == CTransformationMatrix2(1, 0, 7, 0, 1, 8, 0, 0, 1));
  matrix.SetFromValues(1, 2, 3, 4, 5, 6, 7, 8, 9);
  CHECK(CTransformationMatrix2(Make<3, 3>({1, 2, 3, 4, 5, 6, 7, 8, 9})) == matrix);
  matrix.SetFromComponents(rotation, CVector2(1, 2));
  CHECK(matrix == Make<3, 3>({0, -1, 1, 1, 0, 2, 0, 0, 1}));
  CTransformationMatrix2 other;
  other.SetFromMatrix(matrix);
  CHECK(other == matrix);
  // homogeneous coordinates: rotate, then shift
  CHECK(matrix * Make<3, 1>({3, 4, 1}) == Make<3, 1>({-3, 5, 1}));
}

TEST_CASE("3D transformation matrix: has a rotation and a translation part", "[core][math]") {
  CHECK(CTransformationMatrix3().IsIdentityMatrix());
  const CRotationMatrix3 rotation(0, -1, 0, 1, 0, 0, 0, 0, 1);
  CTransformationMatrix3 matrix(rotation, CVector3(5, 6, 7));
  CHECK(matrix == CTransformationMatrix3(0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1));
  CHECK(matrix.GetRotationMatrix() == rotation);
  CHECK(matrix.GetTranslationVector() == CVector3(5, 6, 7));
  CHECK(matrix * CVector3(1, 0, 0) == CVector3(5, 7, 7));
  matrix.SetTranslationVector(CVector3(1, 2, 3));
  matrix.SetRotationMatrix(CRotationMatrix3());
  CHECK(matrix * CVector3(1, 0, 0) == CVector3(2, 2, 3));
  matrix.SetFromValues(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
  CHECK(CTransformationMatrix3(
            Make<4, 4>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16})) == matrix);
  matrix.SetFromComponents(rotation, CVector3(1, 2, 3));
  CTransformationMatrix3 other;
  other.SetFromMatrix(matrix);
  CHECK(other == matrix);
  CHECK(other(3, 3) == 1.0);
}

TEST_CASE("3D transformation matrix: products are composed motions", "[core][math]") {
  const CQuaternion orientation(CRadians(0.9), CVector3(2, 3, 6) / 7.0);
  const CVector3 translation(1, -2, 0.5);
  const CTransformationMatrix3 a(orientation, translation);
  const CTransformationMatrix3 b(CQuaternion(CRadians(-0.4), CVector3::X), CVector3(0, 3, 1));
  const CVector3 point(0.2, 0.7, -1);
  CHECK_THAT(Distance(a * point, LocalToGlobal(point, translation, orientation)),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance((a * b) * point, a * (b * point)), WithinAbs(0.0, kRounding));
  const CTransformationMatrix3 inverse = a.GetInverse();
  CHECK_THAT(Distance(inverse * point, GlobalToLocal(point, translation, orientation)),
             WithinAbs(0.0, kRounding));
}

}  // namespace matrix_test
