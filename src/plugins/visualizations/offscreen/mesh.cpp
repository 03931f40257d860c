#include <argos3/plugins/simulator/visualizations/offscreen/mesh.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace argos {

namespace {

constexpr float kNoEdge = 0.5f;

std::array<float, 2> UnitCircle(int i, int segments) {
  const double angle = 2.0 * std::numbers::pi * i / segments;
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

void AddTriangle(SMesh& mesh, std::size_t a, std::size_t b, std::size_t c) {
  for (const std::size_t index : {a, b, c}) {
    mesh.Indices.push_back(static_cast<std::uint32_t>(index));
  }
}

// a face is given by its outward axis and the sign along it
void AddBoxFace(SMesh& mesh, int axis, float sign) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const std::size_t first = mesh.Vertices.size();
  for (int corner = 0; corner < 4; ++corner) {
    const float cornerU = corner == 1 || corner == 2 ? 1.0f : 0.0f;
    const float cornerV = corner >= 2 ? 1.0f : 0.0f;
    SMeshVertex vertex{};
    vertex.Position[axis] = 0.5f * sign;
    vertex.Position[u] = (cornerU - 0.5f) * sign;
    vertex.Position[v] = cornerV - 0.5f;
    vertex.Position[2] += 0.5f;
    vertex.Normal[axis] = sign;
    vertex.Edge = {cornerU, cornerV};
    mesh.Vertices.push_back(vertex);
  }
  AddTriangle(mesh, first, first + 1, first + 2);
  AddTriangle(mesh, first, first + 2, first + 3);
}

SMesh MakeBox() {
  SMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    AddBoxFace(mesh, axis, 1.0f);
    AddBoxFace(mesh, axis, -1.0f);
  }
  return mesh;
}

void AddCap(SMesh& mesh, float z, int segments) {
  const float up = z > 0.5f ? 1.0f : -1.0f;
  const std::size_t center = mesh.Vertices.size();
  mesh.Vertices.push_back({{0.0f, 0.0f, z}, {0.0f, 0.0f, up}, {kNoEdge, kNoEdge}});
  for (int i = 0; i <= segments; ++i) {
    const auto [x, y] = UnitCircle(i % segments, segments);
    mesh.Vertices.push_back({{0.5f * x, 0.5f * y, z}, {0.0f, 0.0f, up}, {1.0f, kNoEdge}});
  }
  for (std::size_t i = 1; i <= static_cast<std::size_t>(segments); ++i) {
    AddTriangle(mesh, center, center + (up > 0.0f ? i : i + 1), center + (up > 0.0f ? i + 1 : i));
  }
}

SMesh MakeCylinder(int segments) {
  SMesh mesh;
  for (int i = 0; i <= segments; ++i) {
    const auto [x, y] = UnitCircle(i % segments, segments);
    for (const float z : {0.0f, 1.0f}) {
      mesh.Vertices.push_back({{0.5f * x, 0.5f * y, z}, {x, y, 0.0f}, {kNoEdge, z}});
    }
  }
  for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(segments); i += 2) {
    AddTriangle(mesh, i, i + 2, i + 3);
    AddTriangle(mesh, i, i + 3, i + 1);
  }
  AddCap(mesh, 1.0f, segments);
  AddCap(mesh, 0.0f, segments);
  return mesh;
}

// a grid of (rows + 1) x (columns + 1) vertices that were added row by row, rows going up outside
void AddGrid(SMesh& mesh, int rows, int columns) {
  const std::size_t stride = static_cast<std::size_t>(columns) + 1;
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
    for (std::size_t column = 0; column < static_cast<std::size_t>(columns); ++column) {
      const std::size_t corner = row * stride + column;
      AddTriangle(mesh, corner, corner + 1, corner + stride + 1);
      AddTriangle(mesh, corner, corner + stride + 1, corner + stride);
    }
  }
}

SMesh MakeSphere(int segments) {
  SMesh mesh;
  const int rows = std::max(2, segments / 2);
  for (int row = 0; row <= rows; ++row) {
    const double latitude = std::numbers::pi * (static_cast<double>(row) / rows - 0.5);
    const float ringRadius = static_cast<float>(std::cos(latitude));
    const float z = static_cast<float>(std::sin(latitude));
    for (int i = 0; i <= segments; ++i) {
      const auto [x, y] = UnitCircle(i % segments, segments);
      const std::array<float, 3> normal = {ringRadius * x, ringRadius * y, z};
      mesh.Vertices.push_back(
          {{0.5f * normal[0], 0.5f * normal[1], 0.5f * z}, normal, {kNoEdge, kNoEdge}});
    }
  }
  AddGrid(mesh, rows, segments);
  return mesh;
}

// the centre line, of radius 0.5; rows run around the tube from its outer side over its top
SMesh MakeRing(int segments) {
  SMesh mesh;
  const int rows = std::max(4, segments / 3);
  for (int row = 0; row <= rows; ++row) {
    const auto [outward, up] = UnitCircle(row % rows, rows);
    for (int i = 0; i <= segments; ++i) {
      const auto [x, y] = UnitCircle(i % segments, segments);
      mesh.Vertices.push_back(
          {{0.5f * x, 0.5f * y, 0.0f}, {outward * x, outward * y, up}, {kNoEdge, kNoEdge}});
    }
  }
  AddGrid(mesh, rows, segments);
  return mesh;
}

}  // namespace

SMesh MakeMesh(EMeshKind kind, int segments) {
  switch (kind) {
    case EMeshKind::Box:
      return MakeBox();
    case EMeshKind::Cylinder:
      return MakeCylinder(segments);
    case EMeshKind::Sphere:
      return MakeSphere(segments);
    case EMeshKind::Ring:
      return MakeRing(segments);
    case EMeshKind::Count:
      break;
  }
  return SMesh();
}

}  // namespace argos
