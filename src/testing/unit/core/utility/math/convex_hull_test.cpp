#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/math/convex_hull.h>
#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace convex_hull_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using namespace argos;

namespace {

// checks the properties of every hull; the tolerance is that of the class, for a set of size 10
void CheckHull(const std::vector<CVector3>& points, const CConvexHull& hull) {
  constexpr Real kTolerance = 1e-9;
  std::map<std::pair<UInt32, UInt32>, int> edges;
  std::set<UInt32> corners;
  for (const CConvexHull::SFace& face : hull.GetFaces()) {
    const CVector3& a = points[face.VertexIndices[0]];
    const CVector3& b = points[face.VertexIndices[1]];
    const CVector3& c = points[face.VertexIndices[2]];
    CHECK_THAT(face.Normal.Length(), WithinAbs(1.0, 1e-15 * 10));
    // counter-clockwise as seen from outside
    CHECK((b - a).CrossProduct(c - a).DotProduct(face.Normal) > 0.0);
    const Real farthest =
        std::max_element(points.begin(), points.end(), [&](const CVector3& p, const CVector3& q) {
          return p.DotProduct(face.Normal) < q.DotProduct(face.Normal);
        })->DotProduct(face.Normal);
    CHECK_THAT(farthest, WithinAbs(face.Direction, kTolerance));
    for (size_t i = 0; i < 3; ++i) {
      ++edges[{face.VertexIndices[i], face.VertexIndices[(i + 1) % 3]}];
      corners.insert(face.VertexIndices[i]);
    }
  }
  // the surface is closed (every edge occurs once in each direction)
  // and connected (Euler's formula)
  for (const auto& edge : edges) {
    CHECK(edge.second == 1);
    CHECK(edges.count({edge.first.second, edge.first.first}) == 1);
  }
  CHECK(corners.size() + hull.GetFaces().size() == edges.size() / 2 + 2);
}

// by the divergence theorem
Real ComputeVolume(const std::vector<CVector3>& points, const CConvexHull& hull) {
  Real volume = 0.0;
  for (const CConvexHull::SFace& face : hull.GetFaces()) {
    CVector3 cross = points[face.VertexIndices[0]];
    volume += cross.CrossProduct(points[face.VertexIndices[1]])
                  .DotProduct(points[face.VertexIndices[2]]) /
              6.0;
  }
  return volume;
}

std::vector<CVector3> MakeBox(const CVector3& size, const CVector3& offset) {
  std::vector<CVector3> points;
  for (UInt32 i = 0; i < 8; ++i) {
    points.push_back(offset + CVector3(i & 1 ? size.GetX() : 0.0, i & 2 ? size.GetY() : 0.0,
                                       i & 4 ? size.GetZ() : 0.0));
  }
  return points;
}

}  // namespace

TEST_CASE("convex hull: a tetrahedron is its own hull", "[core][math]") {
  const std::vector<CVector3> points{CVector3(0, 0, 0), CVector3(1, 0, 0), CVector3(0, 2, 0),
                                     CVector3(0, 0, 3)};
  const CConvexHull hull(points);
  CHECK(hull.GetFaces().size() == 4);
  CheckHull(points, hull);
  CHECK_THAT(ComputeVolume(points, hull), WithinAbs(1.0, 1e-15));
}

TEST_CASE("convex hull: a box gives twelve triangles, wherever it is placed", "[core][math]") {
  const CVector3 offset = GENERATE(CVector3(), CVector3(-1, -1, -1), CVector3(100, -200, 300));
  const std::vector<CVector3> points = MakeBox(CVector3(2, 3, 4), offset);
  const CConvexHull hull(points);
  CHECK(hull.GetFaces().size() == 12);
  CheckHull(points, hull);
  // differences of products of numbers of about 1e2, each rounded at 1e-16: 1e6 * 1e-16 a term
  CHECK_THAT(ComputeVolume(points, hull), WithinAbs(24.0, 1e-8));
}

TEST_CASE("convex hull: points inside, on faces, on edges and repeated points change nothing",
          "[core][math]") {
  std::vector<CVector3> points = MakeBox(CVector3(2, 2, 2), CVector3());
  const CVector3 extra[] = {CVector3(1, 1, 1), CVector3(1, 1, 2), CVector3(2, 1, 2),
                            CVector3(2, 2, 2), CVector3(1, 0, 0)};
  points.insert(points.begin() + GENERATE(0, 4, 8), std::begin(extra), std::end(extra));
  const CConvexHull hull(points);
  CheckHull(points, hull);
  CHECK_THAT(ComputeVolume(points, hull), WithinAbs(8.0, 1e-14));
}

TEST_CASE("convex hull: hulls of random points satisfy the properties of a hull", "[core][math]") {
  CRandomStream random(GENERATE(1, 2, 3, 4, 5), "test", "convex hull", "points");
  std::vector<CVector3> points;
  for (int i = 0; i < 60; ++i) {
    points.emplace_back(random.Uniform(-5, 5), random.Uniform(-5, 5), random.Uniform(-5, 5));
  }
  const CConvexHull hull(points);
  CheckHull(points, hull);
  // the order of the points does not matter
  std::vector<CVector3> reversed(points.rbegin(), points.rend());
  const CConvexHull reversedHull(reversed);
  CHECK(reversedHull.GetFaces().size() == hull.GetFaces().size());
  CHECK_THAT(ComputeVolume(reversed, reversedHull), WithinAbs(ComputeVolume(points, hull), 1e-10));
}

TEST_CASE("convex hull: coplanar points are refused", "[core][math]") {
  const CVector3 o;
  CHECK_THROWS_WITH(CConvexHull({}), Contains("at least 4"));
  CHECK_THROWS_WITH(CConvexHull({o, CVector3::X, CVector3::Y}), Contains("there are 3"));
  CHECK_THROWS_WITH(
      CConvexHull({o, CVector3::X, CVector3::Y, CVector3(3, 4, 0), CVector3(1, 1, 0)}),
      Contains("one plane"));
  CHECK_THROWS_WITH(CConvexHull({o, CVector3(1, 1, 1), CVector3(2, 2, 2), CVector3(3, 3, 3)}),
                    Contains("one plane"));
  CHECK_THROWS_WITH(CConvexHull({o, o, o, o}), Contains("one plane"));
}

}  // namespace convex_hull_test
