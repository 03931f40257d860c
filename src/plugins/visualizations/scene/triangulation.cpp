#include <argos3/plugins/simulator/visualizations/scene/triangulation.h>

#include <algorithm>
#include <numeric>

namespace argos {

namespace {

// twice the signed area of a triangle
double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

bool IsInside(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
              const Eigen::Vector2d& c) {
  return Cross(a, b, point) >= 0.0 && Cross(b, c, point) >= 0.0 && Cross(c, a, point) >= 0.0;
}

// @param left  the corners that are not cut yet, counter-clockwise. @param i  one of these.
bool IsEar(const std::vector<Eigen::Vector2d>& corners, const std::vector<std::size_t>& left,
           std::size_t i) {
  const std::size_t before = left[(i + left.size() - 1) % left.size()];
  const std::size_t after = left[(i + 1) % left.size()];
  const Eigen::Vector2d& a = corners[before];
  const Eigen::Vector2d& b = corners[left[i]];
  const Eigen::Vector2d& c = corners[after];
  if (Cross(a, b, c) < 0.0) {
    return false;
  }
  for (const std::size_t other : left) {
    const Eigen::Vector2d& point = corners[other];
    if (point != a && point != b && point != c && IsInside(point, a, b, c)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<std::size_t> Triangulate(const std::vector<Eigen::Vector2d>& corners) {
  std::vector<std::size_t> triangles;
  if (corners.size() < 3) {
    return triangles;
  }
  // corners that are not cut yet, counter-clockwise
  std::vector<std::size_t> left(corners.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  double area = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    area += Cross(corners[0], corners[i], corners[i + 1]);
  }
  if (area < 0.0) {
    std::reverse(left.begin(), left.end());
  }
  std::size_t ear = 0;
  std::size_t tried = 0;
  while (left.size() > 2) {
    // if none is an ear, the polygon intersects itself: any corner is cut
    if (IsEar(corners, left, ear) || tried == left.size()) {
      const std::size_t before = (ear + left.size() - 1) % left.size();
      const std::size_t after = (ear + 1) % left.size();
      triangles.insert(triangles.end(), {left[before], left[ear], left[after]});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
      tried = 0;
      ear = ear % left.size();
    } else {
      ++tried;
      ear = (ear + 1) % left.size();
    }
  }
  return triangles;
}

}  // namespace argos
