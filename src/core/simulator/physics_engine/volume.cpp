#include <argos3/core/simulator/physics_engine/volume.h>

#include <cmath>
#include <utility>

namespace argos {

namespace {

// Twice the signed area of the triangle (start, end, point): positive on the left of the side.
// The two regions on either side of a border have it in opposite directions. The ends are put in
// one order first, so the two results are exactly opposite and no point is lost between the
// regions.
Real SideOf(const CVector2& start, const CVector2& end, Real x, Real y) {
  const bool swapped =
      end.GetX() < start.GetX() || (end.GetX() == start.GetX() && end.GetY() < start.GetY());
  const CVector2& a = swapped ? end : start;
  const CVector2& b = swapped ? start : end;
  const Real side = (b.GetX() - a.GetX()) * (y - a.GetY()) - (b.GetY() - a.GetY()) * (x - a.GetX());
  return swapped ? -side : side;
}

Real TwiceSignedArea(const std::vector<CVector2>& vertices) {
  Real area = 0.0;
  for (size_t i = 0; i < vertices.size(); ++i) {
    area += vertices[i].CrossProduct(vertices[(i + 1) % vertices.size()]);
  }
  return area;
}

std::vector<CVector2> ReadVertices(TConfigurationNode& sides) {
  std::vector<CVector2> vertices;
  TConfigurationNodeIterator vertex("vertex");
  for (vertex = vertex.begin(&sides); vertex != vertex.end(); ++vertex) {
    CVector2 point;
    GetNodeAttribute(*vertex, "point", point);
    vertices.push_back(point);
  }
  // existing files close triangles by repeating the first vertex
  if (vertices.size() > 1 && vertices.front() == vertices.back()) {
    vertices.pop_back();
  }
  return vertices;
}

void CheckPolygon(const std::vector<CVector2>& vertices, const std::string& location) {
  if (vertices.size() < 3) {
    THROW_ARGOSEXCEPTION(location << ": <sides>: " << vertices.size()
                                  << " different <vertex> given; a region needs at least 3");
  }
  const Real area = TwiceSignedArea(vertices);
  if (area < 0.0) {
    THROW_ARGOSEXCEPTION(location << ": <sides>: the vertices run clockwise; list them "
                                     "counter-clockwise, seen from above");
  }
  // each vertex must be on the left of each side: this also finds polygons that wind twice
  for (size_t i = 0; i < vertices.size(); ++i) {
    const CVector2& start = vertices[i];
    const CVector2& end = vertices[(i + 1) % vertices.size()];
    const Real length = Distance(start, end);
    if (!(length > 0.0)) {
      THROW_ARGOSEXCEPTION(location << ": <sides>: the vertex \"" << start
                                    << "\" is given twice in a row");
    }
    for (const CVector2& vertex : vertices) {
      // the rounding of coordinates typed in decimal must not make straight sides bent
      const Real tolerance = 1e-9 * length * (length + Distance(start, vertex));
      if (SideOf(start, end, vertex.GetX(), vertex.GetY()) < -tolerance) {
        THROW_ARGOSEXCEPTION(location << ": <sides>: the polygon is not convex: vertex \"" << vertex
                                      << "\" is on the outer side of the side from \"" << start
                                      << "\" to \"" << end << '"');
      }
    }
  }
  if (!(area > 0.0)) {
    THROW_ARGOSEXCEPTION(location << ": <sides>: all vertices lie on one line");
  }
}

std::unique_ptr<SHorizontalFace> ReadFace(TConfigurationNode& node, const char* tag) {
  if (!NodeExists(node, tag)) {
    return nullptr;
  }
  auto face = std::make_unique<SHorizontalFace>();
  GetNodeAttribute(GetNode(node, tag), "height", face->Height);
  return face;
}

}  // namespace

void SVolume::Init(TConfigurationNode& node) {
  auto top = ReadFace(node, "top");
  auto bottom = ReadFace(node, "bottom");
  if (top && bottom && !(bottom->Height <= top->Height)) {
    THROW_ARGOSEXCEPTION(node.GetLocation() << ": <boundaries>: the bottom, at " << bottom->Height
                                            << " m, is above the top, at " << top->Height << " m");
  }
  std::vector<std::unique_ptr<SVerticalFace>> sides;
  if (NodeExists(node, "sides")) {
    TConfigurationNode& sidesNode = GetNode(node, "sides");
    const std::vector<CVector2> vertices = ReadVertices(sidesNode);
    CheckPolygon(vertices, sidesNode.GetLocation());
    for (size_t i = 0; i < vertices.size(); ++i) {
      sides.push_back(std::make_unique<SVerticalFace>());
      sides.back()->BaseSegment = CRay2(vertices[i], vertices[(i + 1) % vertices.size()]);
    }
  }

  m_top = std::move(top);
  m_bottom = std::move(bottom);
  m_sides = std::move(sides);
  TopFace = m_top.get();
  BottomFace = m_bottom.get();
  SideFaces.clear();
  for (const auto& side : m_sides) {
    SideFaces.push_back(side.get());
  }
}

bool SVolume::Contains(const CVector3& point) const {
  // written so that NaN is outside
  if ((TopFace != nullptr && !(point.GetZ() <= TopFace->Height)) ||
      (BottomFace != nullptr && !(point.GetZ() >= BottomFace->Height))) {
    return false;
  }
  for (const SVerticalFace* face : SideFaces) {
    if (!(SideOf(face->BaseSegment.GetStart(), face->BaseSegment.GetEnd(), point.GetX(),
                 point.GetY()) >= 0.0)) {
      return false;
    }
  }
  return true;
}

}  // namespace argos
