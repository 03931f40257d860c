#include <argos3/core/simulator/geometry/volume.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace argos {

namespace {

// m; thickness of the solid that represents a wall
constexpr Real kWallThickness = 0.1;
// m; how far a wall without top or bottom reaches from z = 0
constexpr Real kWallReach = 100.0;

CVector2 ToPlane(const CVector3& point) {
  return CVector2(point.GetX(), point.GetY());
}

struct SVertex {
  CVector2 Point;
  SFace Face;  // face of the side that begins there
};

void ReadKind(TConfigurationNode& node, SFace& face) {
  GetNodeAttributeOrDefault(node, "wall", face.IsWall, face.IsWall);
  GetNodeAttributeOrDefault(node, "gate", face.Gate, face.Gate);
  if (face.IsWall && !face.Gate.empty()) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": <" << node.Value()
                         << ">: a face is a wall or a gate, not both: leave out wall=\"true\" or "
                            "gate=\""
                         << face.Gate << '"');
  }
}

std::vector<SVertex> ReadVertices(TConfigurationNode& sides) {
  std::vector<SVertex> vertices;
  TConfigurationNodeIterator it("vertex");
  for (it = it.begin(&sides); it != it.end(); ++it) {
    SVertex vertex;
    GetNodeAttribute(*it, "point", vertex.Point);
    ReadKind(*it, vertex.Face);
    vertices.push_back(vertex);
  }
  // some existing files repeat the first vertex at the end
  if (vertices.size() > 1 && vertices.front().Point == vertices.back().Point) {
    vertices.pop_back();
  }
  return vertices;
}

// each vertex must be on the left of each side
void CheckConvex(const TPolygon& vertices, const std::string& location) {
  for (size_t i = 0; i < vertices.size(); ++i) {
    const CVector2& start = vertices[i];
    const CVector2& end = vertices[(i + 1) % vertices.size()];
    const Real length = Distance(start, end);
    if (!(length > 0.0)) {
      THROW_ARGOSEXCEPTION(location << ": <sides>: the vertex \"" << start
                                    << "\" is given twice in a row");
    }
    for (const CVector2& vertex : vertices) {
      // tolerates the rounding of decimal coordinates on straight sides
      const Real tolerance = 1e-9 * length * (length + Distance(start, vertex));
      if (ComputeSide(start, end, vertex) < -tolerance) {
        THROW_ARGOSEXCEPTION(location << ": <sides>: the polygon is not convex: vertex \"" << vertex
                                      << "\" is on the outer side of the side from \"" << start
                                      << "\" to \"" << end
                                      << "\"; give several engines a convex part each");
      }
    }
  }
}

void CheckPolygon(const TPolygon& vertices, const std::string& location) {
  if (vertices.size() < 3) {
    THROW_ARGOSEXCEPTION(location << ": <sides>: " << vertices.size()
                                  << " different <vertex> given; a region needs at least 3");
  }
  if (const auto crossing = FindCrossing(vertices)) {
    const auto side = [&vertices](size_t i) {
      return "from \"" + ToString(vertices[i]) + "\" to \"" +
             ToString(vertices[(i + 1) % vertices.size()]) + '"';
    };
    THROW_ARGOSEXCEPTION(location << ": <sides>: the polygon crosses itself: the sides "
                                  << side(crossing->First) << " and " << side(crossing->Second)
                                  << " meet at \"" << crossing->Point
                                  << "\"; list the vertices in order along the border");
  }
  const Real area = ComputeTwiceArea(vertices);
  if (area < 0.0) {
    THROW_ARGOSEXCEPTION(location << ": <sides>: the vertices run clockwise; list them "
                                     "counter-clockwise, seen from above: "
                                  << ListCorners(TPolygon(vertices.rbegin(), vertices.rend())));
  }
  CheckConvex(vertices, location);
  for (size_t i = 0; i < vertices.size(); ++i) {
    if (std::count(vertices.begin(), vertices.end(), vertices[i]) > 1) {
      THROW_ARGOSEXCEPTION(location << ": <sides>: the vertex \"" << vertices[i]
                                    << "\" is given twice");
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
  ReadKind(GetNode(node, tag), *face);
  return face;
}

// @return true if the point is on the outer side of a face; written so that NaN is.
bool IsBehind(const SVerticalFace& face, const CVector2& point) {
  return !(ComputeSide(face.BaseSegment.GetStart(), face.BaseSegment.GetEnd(), point) >= 0.0);
}

// the corners of a solid seen from above, or the corners of the square around its disc
TPolygon ComputeFootprint(const SShapeDescription& shape, const CVector3& position,
                          const CQuaternion& orientation) {
  CVector3 base = shape.Offset;
  base.Rotate(orientation);
  base += position;
  const CQuaternion turn = orientation * shape.Orientation;
  CVector3 x = CVector3::X;
  CVector3 y = CVector3::Y;
  Real halfX = 0.5 * shape.Size.GetX();
  Real halfY = 0.5 * shape.Size.GetY();
  if (turn.GetX() == 0.0 && turn.GetY() == 0.0) {
    x.Rotate(turn);
    y.Rotate(turn);
  } else {
    // tilted: no point is farther from the centre of the base
    halfX = halfY = shape.Size.Length();
  }
  const CVector2 centre = ToPlane(base);
  const CVector2 along = ToPlane(x) * halfX;
  const CVector2 across = ToPlane(y) * halfY;
  return {centre - along - across, centre + along - across, centre + along + across,
          centre - along + across};
}

// @return true if the two convex polygons are apart by more than reach, along a side of the first.
bool IsSeparated(const TPolygon& first, const TPolygon& second, Real reach) {
  for (size_t i = 0; i < first.size(); ++i) {
    const CVector2& start = first[i];
    const CVector2& end = first[(i + 1) % first.size()];
    const Real limit = -reach * Distance(start, end);
    if (std::all_of(second.begin(), second.end(), [&](const CVector2& corner) {
          return ComputeSide(start, end, corner) < limit;
        })) {
      return true;
    }
  }
  return false;
}

}  // namespace

void SVolume::Init(TConfigurationNode& node) {
  auto top = ReadFace(node, "top");
  auto bottom = ReadFace(node, "bottom");
  if (top && bottom && !(bottom->Height < top->Height)) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": <boundaries>: the bottom, at " << bottom->Height << " m, is "
                         << (bottom->Height == top->Height ? "not below" : "above")
                         << " the top, at " << top->Height << " m");
  }
  std::vector<std::unique_ptr<SVerticalFace>> sides;
  if (NodeExists(node, "sides")) {
    TConfigurationNode& sidesNode = GetNode(node, "sides");
    const std::vector<SVertex> vertices = ReadVertices(sidesNode);
    TPolygon corners;
    for (const SVertex& vertex : vertices) {
      corners.push_back(vertex.Point);
    }
    CheckPolygon(corners, sidesNode.GetLocation());
    for (size_t i = 0; i < vertices.size(); ++i) {
      sides.push_back(std::make_unique<SVerticalFace>());
      static_cast<SFace&>(*sides.back()) = vertices[i].Face;
      sides.back()->BaseSegment = CRay2(corners[i], corners[(i + 1) % corners.size()]);
    }
  }

  m_top = std::move(top);
  m_bottom = std::move(bottom);
  m_sides = std::move(sides);
  TopFace = m_top.get();
  BottomFace = m_bottom.get();
  SideFaces.clear();
  m_borderSides.clear();
  for (const auto& side : m_sides) {
    SideFaces.push_back(side.get());
    m_borderSides.emplace_back(side->BaseSegment.GetStart(), side->BaseSegment.GetEnd());
  }
}

bool SVolume::HasWalls() const {
  return (TopFace != nullptr && TopFace->IsWall) || (BottomFace != nullptr && BottomFace->IsWall) ||
         std::ranges::any_of(SideFaces, &SVerticalFace::IsWall);
}

bool SVolume::Contains(const CVector3& point) const {
  // written so that NaN is outside
  if ((TopFace != nullptr && !(point.GetZ() <= TopFace->Height)) ||
      (BottomFace != nullptr && !(point.GetZ() >= BottomFace->Height))) {
    return false;
  }
  const CVector2 above = ToPlane(point);
  return std::all_of(m_borderSides.begin(), m_borderSides.end(),
                     [&above](const CBorderSide& side) { return side.Compute(above) >= 0.0; });
}

// The nearest segment of the sides with the point behind them, which distinguishes sides on one
// line.
const SFace* SVolume::FindExit(const CVector3& point) const {
  const SFace* exit = nullptr;
  Real nearest = HUGE_VAL;
  const auto consider = [&](const SFace& face, Real distance) {
    if (distance < nearest) {
      exit = &face;
      nearest = distance;
    }
  };
  if (BottomFace != nullptr && point.GetZ() < BottomFace->Height) {
    consider(*BottomFace, BottomFace->Height - point.GetZ());
  }
  if (TopFace != nullptr && point.GetZ() > TopFace->Height) {
    consider(*TopFace, point.GetZ() - TopFace->Height);
  }
  const CVector2 above = ToPlane(point);
  for (const SVerticalFace* face : SideFaces) {
    if (IsBehind(*face, above)) {
      consider(*face, Distance(FindNearest(face->BaseSegment, above), above));
    }
  }
  return exit;
}

Real SVolume::ComputeDistance(const CVector3& point) const {
  const Real height = std::max({0.0, GetLowest() - point.GetZ(), point.GetZ() - GetHighest()});
  const Real aside =
      SideFaces.empty() ? 0.0 : ::argos::ComputeDistance(GetCorners(), ToPlane(point));
  return std::hypot(height, aside);
}

bool SVolume::IsTouchedBy(const SBodyDescription& body, const CVector3& position,
                          const CQuaternion& orientation, Real reach) const {
  const SBoundingBox box = body.ComputeBoundingBox(position, orientation);
  if (box.MaxCorner.GetZ() < GetLowest() - reach || box.MinCorner.GetZ() > GetHighest() + reach) {
    return false;
  }
  if (SideFaces.empty()) {
    return true;
  }
  const TPolygon corners = GetCorners();
  return std::any_of(body.Shapes.begin(), body.Shapes.end(), [&](const SShapeDescription& shape) {
    const TPolygon footprint = ComputeFootprint(shape, position, orientation);
    return !IsSeparated(corners, footprint, reach) && !IsSeparated(footprint, corners, reach);
  });
}

std::vector<CVector2> SVolume::GetCorners() const {
  TPolygon corners;
  for (const SVerticalFace* face : SideFaces) {
    corners.push_back(face->BaseSegment.GetStart());
  }
  return corners;
}

Real SVolume::GetLowest() const {
  return BottomFace != nullptr ? BottomFace->Height : -HUGE_VAL;
}

Real SVolume::GetHighest() const {
  return TopFace != nullptr ? TopFace->Height : HUGE_VAL;
}

std::vector<SWallSlab> SVolume::DescribeWalls() const {
  std::vector<SWallSlab> walls;
  const Real lowest = BottomFace != nullptr ? BottomFace->Height : -kWallReach;
  const Real highest = TopFace != nullptr ? TopFace->Height : kWallReach;
  for (const SVerticalFace* face : SideFaces) {
    if (!face->IsWall) {
      continue;
    }
    const CRay2& base = face->BaseSegment;
    CVector2 along;
    base.GetDirection(along);
    const CVector2 outward(along.GetY(), -along.GetX());
    const CVector2 centre =
        (base.GetStart() + base.GetEnd()) * 0.5 + outward * (0.5 * kWallThickness);
    auto description = std::make_shared<SBodyDescription>();
    description->Shapes.push_back(
        SShapeDescription::Box(CVector3(base.GetLength(), kWallThickness, highest - lowest)));
    walls.push_back({std::move(description), CVector3(centre.GetX(), centre.GetY(), lowest),
                     CQuaternion(CRadians(std::atan2(along.GetY(), along.GetX())), CVector3::Z)});
  }
  return walls;
}

bool SVolume::HoldInside(CVector3& position, CVector3& velocity, Real radius, Real height) const {
  bool isHeld = false;
  const auto hold = [&](const CVector3& inward, Real depth) {
    position += inward * depth;
    velocity -= inward * std::min(0.0, velocity.DotProduct(inward));
    isHeld = true;
  };
  if (BottomFace != nullptr && BottomFace->IsWall && position.GetZ() < BottomFace->Height) {
    hold(CVector3::Z, BottomFace->Height - position.GetZ());
  }
  if (TopFace != nullptr && TopFace->IsWall && position.GetZ() + height > TopFace->Height) {
    hold(-CVector3::Z, position.GetZ() + height - TopFace->Height);
  }
  for (const SVerticalFace* face : SideFaces) {
    if (!face->IsWall) {
      continue;
    }
    const CVector2 above = ToPlane(position);
    const CVector2 nearest = FindNearest(face->BaseSegment, above);
    const bool isBeside =
        nearest == face->BaseSegment.GetStart() || nearest == face->BaseSegment.GetEnd();
    const bool isBehind = IsBehind(*face, above);
    const CVector2 away = above - nearest;
    const Real distance = away.Length();
    if (isBehind ? isBeside : distance >= radius) {
      continue;
    }
    CVector2 along;
    face->BaseSegment.GetDirection(along);
    const CVector2 inward =
        isBeside && distance > 0.0 ? away / distance : CVector2(-along.GetY(), along.GetX());
    hold(CVector3(inward.GetX(), inward.GetY(), 0.0), radius + (isBehind ? distance : -distance));
  }
  return isHeld;
}

}  // namespace argos
