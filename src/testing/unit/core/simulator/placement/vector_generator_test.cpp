#include <argos3/core/simulator/placement/vector_generator.h>
#include <argos3/core/utility/configuration/configuration_document.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace vector_generator_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

/** A generator and the objects that it needs. */
class CGenerator {
 public:
  explicit CGenerator(const std::string& xml) : m_rng(1234) {
    m_document.Parse(xml, "test.argos");
    m_generator = CreateVectorGenerator(m_document.GetRoot(), m_rng);
  }
  CVectorGenerator* operator->() { return m_generator.get(); }

 private:
  CConfigurationDocument m_document;
  CRandom::CRNG m_rng;
  std::unique_ptr<CVectorGenerator> m_generator;
};

void CheckFails(const std::string& xml, const std::string& text) {
  CAPTURE(xml);
  CHECK_THROWS_WITH(CGenerator(xml), Contains(text) && Contains("test.argos:1"));
}

}  // namespace

TEST_CASE("vector generator: constant always returns the same vector",
          "[core][space][distribute]") {
  CGenerator constant("<position method='constant' values='1,-2,0.5' />");
  CHECK(constant->Next(false) == CVector3(1.0, -2.0, 0.5));
  CHECK(constant->Next(true) == CVector3(1.0, -2.0, 0.5));
  CHECK_FALSE(constant->CanRetry());
}

TEST_CASE("vector generator: uniform has the moments of independent uniform components",
          "[core][space][distribute]") {
  CGenerator uniform("<position method='uniform' min='-1,2,7' max='3,2.5,7' />");
  constexpr int kDraws = 100000;
  const Real min[3] = {-1.0, 2.0, 7.0};
  const Real max[3] = {3.0, 2.5, 7.0};
  Real sum[3] = {};
  Real squares[3] = {};
  Real product = 0.0;
  bool inside = true;
  for (int i = 0; i < kDraws; ++i) {
    const CVector3 draw = uniform->Next(false);
    for (UInt32 axis = 0; axis < 3; ++axis) {
      inside = inside && draw[axis] >= min[axis] && draw[axis] <= max[axis];
      sum[axis] += draw[axis];
      const Real centred = draw[axis] - 0.5 * (min[axis] + max[axis]);
      squares[axis] += centred * centred;
    }
    product += (draw.GetX() - 1.0) * (draw.GetY() - 2.25);
  }
  CHECK(inside);
  CHECK(uniform->CanRetry());
  for (UInt32 axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    const Real width = max[axis] - min[axis];
    // standard errors for U(0,1): sqrt(1/12/n) of the mean, sqrt(1/180/n) of the second moment; the
    // fixed seed passes, and 5 of them are exceeded once in 1.7 million other seeds
    CHECK_THAT(sum[axis] / kDraws, WithinAbs(0.5 * (min[axis] + max[axis]),
                                             5.0 * width * std::sqrt(1.0 / 12.0 / kDraws) + 1e-9));
    CHECK_THAT(
        squares[axis] / kDraws,
        WithinAbs(width * width / 12.0, 5.0 * width * width * std::sqrt(1.0 / 180.0 / kDraws)));
  }
  // components are uncorrelated: the standard error of the mean
  // product is sigma_x sigma_y / sqrt(n)
  CHECK_THAT(product / kDraws, WithinAbs(0.0, 5.0 * 4.0 * 0.5 / 12.0 / std::sqrt(kDraws)));
}

TEST_CASE("vector generator: gaussian has the moments of independent normal components",
          "[core][space][distribute]") {
  CGenerator gaussian("<position method='gaussian' mean='1,-2,5' std_dev='0.5,3,0' />");
  constexpr int kDraws = 100000;
  const Real mean[3] = {1.0, -2.0, 5.0};
  const Real deviation[3] = {0.5, 3.0, 0.0};
  Real sum[3] = {};
  Real squares[3] = {};
  int beyondTwo = 0;
  for (int i = 0; i < kDraws; ++i) {
    const CVector3 draw = gaussian->Next(false);
    for (UInt32 axis = 0; axis < 3; ++axis) {
      sum[axis] += draw[axis] - mean[axis];
      squares[axis] += (draw[axis] - mean[axis]) * (draw[axis] - mean[axis]);
    }
    beyondTwo += std::abs(draw.GetX() - 1.0) > 1.0 ? 1 : 0;
  }
  for (UInt32 axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    // standard errors: sigma / sqrt(n) of the mean, sigma^2 sqrt(2/n) of the variance; 5 of each
    CHECK_THAT(sum[axis] / kDraws, WithinAbs(0.0, 5.0 * deviation[axis] / std::sqrt(kDraws)));
    CHECK_THAT(squares[axis] / kDraws,
               WithinAbs(deviation[axis] * deviation[axis],
                         5.0 * deviation[axis] * deviation[axis] * std::sqrt(2.0 / kDraws)));
  }
  // P(|z| > 2) = 0.0455; the standard error of the share is sqrt(p (1 - p) / n)
  CHECK_THAT(static_cast<Real>(beyondTwo) / kDraws,
             WithinAbs(0.0455003, 5.0 * std::sqrt(0.0455003 * 0.9544997 / kDraws)));
  CHECK(gaussian->CanRetry());
}

TEST_CASE("vector generator: a grid starts at its highest corner and descends, x fastest",
          "[core][space][distribute]") {
  CGenerator grid(
      "<position method='grid' center='1,2,3' distances='0.5,2,0.25' layout='3,2,2' />");
  CHECK_FALSE(grid->CanRetry());
  for (int n = 0; n < 12; ++n) {
    CAPTURE(n);
    const int i[3] = {n % 3, n / 3 % 2, n / 6};
    const int layout[3] = {3, 2, 2};
    const Real centre[3] = {1.0, 2.0, 3.0};
    const Real distance[3] = {0.5, 2.0, 0.25};
    const CVector3 place = grid->Next(false);
    for (UInt32 axis = 0; axis < 3; ++axis) {
      // exact: all numbers are multiples of 1/8
      CHECK(place[axis] ==
            centre[axis] + (layout[axis] - 1) * distance[axis] / 2.0 - i[axis] * distance[axis]);
    }
  }
  CHECK_THROWS_WITH(grid->Next(false), Contains("3 x 2 x 2") && Contains("13"));
}

TEST_CASE("vector generator: a grid returns a refused place again", "[core][space][distribute]") {
  CGenerator grid("<position method='grid' center='0,0,0' distances='1,1,1' layout='3,1,1' />");
  CHECK(grid->Next(false) == CVector3(1.0, 0.0, 0.0));
  CHECK(grid->Next(true) == CVector3(1.0, 0.0, 0.0));
  CHECK(grid->Next(false) == CVector3(0.0, 0.0, 0.0));
}

TEST_CASE("vector generator: invalid settings are errors with the line",
          "[core][space][distribute]") {
  CheckFails("<position method='unifrom' min='0,0,0' max='1,1,1' />", "uniform");
  CheckFails("<position min='0,0,0' max='1,1,1' />", "method");
  CheckFails("<position method='uniform' min='0,0,0' />", "max");
  CheckFails("<position method='uniform' min='0,2,0' max='1,1,1' />", "must not exceed");
  CheckFails("<position method='gaussian' mean='0,0,0' />", "std_dev");
  CheckFails("<position method='constant' />", "values");
  CheckFails("<position method='grid' center='0,0,0' distances='1,1,1' layout='3,0,1' />", "3,0,1");
  CheckFails("<position method='grid' center='0,0,0' distances='1,1,1' layout='3,1' />", "layout");
  CheckFails("<position method='grid' center='0,0,0' distances='1,1,1' layout='3,1,1.5' />",
             "layout");
  CheckFails("<position method='grid' center='0,0,0' distances='1,1,1' layout='3,-1,1' />",
             "layout");
}

}  // namespace vector_generator_test
