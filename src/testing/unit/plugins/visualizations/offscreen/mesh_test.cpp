#include <argos3/plugins/simulator/visualizations/offscreen/mesh.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace mesh_test {

using namespace argos;
using Catch::WithinAbs;
using Catch::WithinRel;

namespace {

Eigen::Vector3d ToVector(const std::array<float, 3>& values) {
  return {values[0], values[1], values[2]};
}

// Volume by the divergence theorem: the sum over triangles of the signed volume of the tetrahedron
// to the origin; positive if all triangles are counter-clockwise seen from outside.
double ComputeVolume(const SMesh& mesh) {
  double volume = 0.0;
  for (std::size_t i = 0; i < mesh.Indices.size(); i += 3) {
    const Eigen::Vector3d a = ToVector(mesh.Vertices[mesh.Indices[i]].Position);
    const Eigen::Vector3d b = ToVector(mesh.Vertices[mesh.Indices[i + 1]].Position);
    const Eigen::Vector3d c = ToVector(mesh.Vertices[mesh.Indices[i + 2]].Position);
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

// the deformation that the vertex shader applies to a ring
SMesh WithTube(SMesh mesh, float param) {
  for (SMeshVertex& vertex : mesh.Vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vertex.Position[axis] =
          vertex.Position[axis] * (1.0f - param) + 0.5f * param * vertex.Normal[axis];
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("mesh: solids have the volume of their shapes and outward faces",
          "[visualizations][offscreen][mesh]") {
  // tolerance of single precision
  CHECK_THAT(ComputeVolume(MakeMesh(EMeshKind::Box, 3)), WithinAbs(1.0, 1e-6));
  // a prism with n corners has n / (2 pi) sin(2 pi / n) of the circle's area: 0.16 % less for 64
  const double pi = std::numbers::pi;
  CHECK_THAT(ComputeVolume(MakeMesh(EMeshKind::Cylinder, 64)), WithinRel(pi / 4.0, 2e-3));
  CHECK_THAT(ComputeVolume(MakeMesh(EMeshKind::Sphere, 64)), WithinRel(pi / 6.0, 5e-3));
  // torus: 2 pi^2 R r^2 with R = 0.4 and r = 0.1; its tube has fewer segments
  const SMesh ring = WithTube(MakeMesh(EMeshKind::Ring, 64), 0.2f);
  CHECK_THAT(ComputeVolume(ring), WithinRel(2.0 * pi * pi * 0.4 * 0.01, 3e-2));
}

TEST_CASE("mesh: normals have length 1 and agree with the winding of the triangles",
          "[visualizations][offscreen][mesh]") {
  const auto kind =
      GENERATE(EMeshKind::Box, EMeshKind::Cylinder, EMeshKind::Sphere, EMeshKind::Ring);
  const int segments = GENERATE(6, 12, 64);
  CAPTURE(static_cast<int>(kind), segments);
  SMesh mesh = MakeMesh(kind, segments);
  if (kind == EMeshKind::Ring) {
    mesh = WithTube(mesh, 0.3f);
  }
  bool agree = true;
  for (std::size_t i = 0; i < mesh.Indices.size(); i += 3) {
    const SMeshVertex& first = mesh.Vertices[mesh.Indices[i]];
    const Eigen::Vector3d a = ToVector(first.Position);
    const Eigen::Vector3d b = ToVector(mesh.Vertices[mesh.Indices[i + 1]].Position);
    const Eigen::Vector3d c = ToVector(mesh.Vertices[mesh.Indices[i + 2]].Position);
    const Eigen::Vector3d across = (b - a).cross(c - a);
    // triangles at the poles of a sphere have no area
    if (across.norm() > 1e-9) {
      agree = agree && across.dot(ToVector(first.Normal)) > 0.0;
    }
  }
  CHECK(agree);
  bool unit = true;
  for (const SMeshVertex& vertex : mesh.Vertices) {
    unit = unit && std::abs(ToVector(vertex.Normal).norm() - 1.0) < 1e-6;
  }
  CHECK(unit);
}

TEST_CASE("mesh: boxes and cylinders stand on their base, spheres are centred",
          "[visualizations][offscreen][mesh]") {
  const auto bounds = [](EMeshKind kind) {
    Eigen::AlignedBox3d box;
    for (const SMeshVertex& vertex : MakeMesh(kind, 64).Vertices) {
      box.extend(ToVector(vertex.Position));
    }
    return box;
  };
  // 64 corners include the four on the axes, up to rounding in single precision
  for (const EMeshKind kind : {EMeshKind::Box, EMeshKind::Cylinder}) {
    CHECK((bounds(kind).min() - Eigen::Vector3d(-0.5, -0.5, 0.0)).norm() < 1e-6);
    CHECK((bounds(kind).max() - Eigen::Vector3d(0.5, 0.5, 1.0)).norm() < 1e-6);
  }
  CHECK((bounds(EMeshKind::Sphere).min() - Eigen::Vector3d(-0.5, -0.5, -0.5)).norm() < 1e-6);
  CHECK((bounds(EMeshKind::Sphere).max() - Eigen::Vector3d(0.5, 0.5, 0.5)).norm() < 1e-6);
}

TEST_CASE("mesh: few segments leave solids with a volume", "[visualizations][offscreen][mesh]") {
  // three meridians with the poles and the equator: two pyramids over a triangle in the circle
  const double triangle = 3.0 * std::sqrt(3.0) / 4.0 * 0.25;
  CHECK_THAT(ComputeVolume(MakeMesh(EMeshKind::Sphere, 3)),
             WithinRel(2.0 * triangle * 0.5 / 3.0, 1e-5));
  // at least four sides of the tube
  CHECK(ComputeVolume(WithTube(MakeMesh(EMeshKind::Ring, 6), 0.2f)) > 0.0);
}

}  // namespace mesh_test
