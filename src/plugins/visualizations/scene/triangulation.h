#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_TRIANGULATION_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_TRIANGULATION_H

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace argos {

/**
 * Cuts a simple polygon, convex or not, into triangles.
 *
 * @param corners  in order, either way round.
 * @return indices of corners, three per triangle, n - 2 triangles; empty for less than three
 *         corners. A polygon that intersects itself gives some set of triangles between its
 *         corners.
 *
 * Ear clipping, O(n^2) for convex polygons and O(n^3) at worst.
 * Source: G. H. Meisters, Polygons have ears, The American Mathematical Monthly 82 (1975).
 */
std::vector<std::size_t> Triangulate(const std::vector<Eigen::Vector2d>& corners);

}  // namespace argos

#endif
