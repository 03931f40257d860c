#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_MESH_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_MESH_H

#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <array>
#include <cstdint>
#include <vector>

namespace argos {

/** One corner of a mesh, in the layout of the vertex buffer. */
struct SMeshVertex {
  std::array<float, 3> Position; /**< mesh's frame */
  std::array<float, 3> Normal; /**< unit, outward */
  /**
   * Coordinates over a face, for the lines drawn along edges: such a line is where a coordinate is
   * 0 or 1; a coordinate that has no edges stays at 0.5.
   */
  std::array<float, 2> Edge;
};

/** Triangles of a mesh, counter-clockwise seen from outside. */
struct SMesh {
  std::vector<SMeshVertex> Vertices;
  std::vector<std::uint32_t> Indices; /**< three per triangle */
};

/**
 * A unit solid of EMeshKind with Param = 1 (cylinder) or a tube of radius 0 (ring).
 *
 * The vertex shader applies the parameter: it scales the top of a cylinder, and grows the tube of a
 * ring along the normals.
 *
 * @param segments  corners around the z axis, >= 3; a box has none.
 */
SMesh MakeMesh(EMeshKind kind, int segments);

}  // namespace argos

#endif
