#include <argos3/plugins/simulator/visualizations/scene/triangulation.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace triangulation_test {

using namespace argos;
using Catch::WithinAbs;

namespace {

typedef std::vector<Eigen::Vector2d> TCorners;

double TriangleArea(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return 0.5 * ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
}

// Gauss' formula
double PolygonArea(const TCorners& corners) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    area += 0.5 * (a.x() * b.y() - b.x() * a.y());
  }
  return std::abs(area);
}

}  // namespace

TEST_CASE("triangulation: triangles do not overlap and cover the polygon",
          "[visualizations][offscreen]") {
  const TCorners square = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  const TCorners arrow = {{0.0, 0.0}, {-1.0, 1.0}, {2.0, 0.0}, {-1.0, -1.0}};
  const TCorners letterU = {{0.0, 0.0}, {3.0, 0.0}, {3.0, 3.0}, {2.0, 3.0},
                            {2.0, 1.0}, {1.0, 1.0}, {1.0, 3.0}, {0.0, 3.0}};
  const TCorners withCornerOnSide = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}};
  TCorners corners = GENERATE_COPY(as<TCorners>(), square, arrow, letterU, withCornerOnSide);
  if (GENERATE(false, true)) {
    std::reverse(corners.begin(), corners.end());
  }
  const std::vector<std::size_t> triangles = Triangulate(corners);
  REQUIRE(triangles.size() == 3 * (corners.size() - 2));
  double area = 0.0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const double part =
        TriangleArea(corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]);
    // counter-clockwise ones whose areas add up to the polygon's cannot overlap
    CHECK(part >= 0.0);
    area += part;
  }
  // 1e-12: roundings of a few areas of about 1
  CHECK_THAT(area, WithinAbs(PolygonArea(corners), 1e-12));
}

TEST_CASE("triangulation: polygons without area, and those that intersect themselves, terminate",
          "[visualizations][offscreen]") {
  CHECK(Triangulate({}).empty());
  CHECK(Triangulate({{0.0, 0.0}, {1.0, 0.0}}).empty());
  CHECK(Triangulate({{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}}).size() == 6);
  CHECK(Triangulate({{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}}).size() == 6);
}

}  // namespace triangulation_test
