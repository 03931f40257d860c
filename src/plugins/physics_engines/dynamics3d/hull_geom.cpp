#include <argos3/plugins/simulator/physics_engines/dynamics3d/hull_geom.h>

#include <argos3/core/simulator/geometry/convex_solid.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/prism_geom.h>

#include <cmath>

namespace argos {

namespace {

constexpr unsigned int kSides = 24;  // its corners are 0.9 % of the radius outside of the cylinder

void AddPlane(SHullArrays& arrays, dReal x, dReal y, dReal z, dReal distance) {
  arrays.Planes.insert(arrays.Planes.end(), {x, y, z, distance});
}

// a regular polygon around a circle
std::vector<CVector2> Enclose(dReal radius) {
  std::vector<CVector2> corners;
  const dReal outer = radius / std::cos(ARGOS_PI / kSides);
  for (unsigned int i = 0; i < kSides; ++i) {
    const dReal angle = 2.0 * ARGOS_PI * i / kSides;
    corners.emplace_back(outer * std::cos(angle), outer * std::sin(angle));
  }
  return corners;
}

// along z, with the origin half-way up
SHullArrays MakePrism(const std::vector<CVector2>& base, dReal length) {
  SHullArrays arrays;
  const auto sides = static_cast<unsigned int>(base.size());
  for (unsigned int i = 0; i < sides; ++i) {
    const unsigned int next = (i + 1) % sides;
    for (const dReal z : {-0.5 * length, 0.5 * length}) {
      arrays.Points.insert(arrays.Points.end(), {base[i].GetX(), base[i].GetY(), z});
    }
    CVector2 normal(base[next].GetY() - base[i].GetY(), base[i].GetX() - base[next].GetX());
    normal.Normalize();
    AddPlane(arrays, normal.GetX(), normal.GetY(), 0.0, normal.DotProduct(base[i]));
    arrays.Polygons.insert(arrays.Polygons.end(), {4, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
  }
  for (const bool isTop : {true, false}) {
    AddPlane(arrays, 0.0, 0.0, isTop ? 1.0 : -1.0, 0.5 * length);
    arrays.Polygons.push_back(sides);
    for (unsigned int i = 0; i < sides; ++i) {
      arrays.Polygons.push_back(isTop ? 2 * i + 1 : 2 * (sides - 1 - i));
    }
  }
  return arrays;
}

// of a prism or a cylinder
SHullArrays MakeHullOf(dGeomID upright) {
  if (IsPrism(upright)) {
    return MakePrism(GetPrismBase(upright), GetPrismHeight(upright));
  }
  dReal radius = 0.0;
  dReal length = 0.0;
  dGeomCylinderGetParams(upright, &radius, &length);
  return MakePrism(Enclose(radius), length);
}

dGeomID MakeConvex(SHullArrays& arrays) {
  return dCreateConvex(nullptr, arrays.Planes.data(),
                       static_cast<unsigned int>(arrays.Planes.size() / 4), arrays.Points.data(),
                       static_cast<unsigned int>(arrays.Points.size() / 3), arrays.Polygons.data());
}

}  // namespace

dGeomID MakeHullGeom(const CConvexSolid& solid, SHullArrays& arrays) {
  for (const CVector3& corner : solid.GetCorners()) {
    const CVector3 point = corner - solid.GetCentroid();
    arrays.Points.insert(arrays.Points.end(), {point.GetX(), point.GetY(), point.GetZ()});
  }
  for (const CConvexHull::SFace& face : solid.GetFaces()) {
    const CVector3& normal = face.Normal;
    AddPlane(arrays, normal.GetX(), normal.GetY(), normal.GetZ(),
             face.Direction - normal.DotProduct(solid.GetCentroid()));
    arrays.Polygons.insert(arrays.Polygons.end(), {3, face.VertexIndices[0], face.VertexIndices[1],
                                                   face.VertexIndices[2]});
  }
  return MakeConvex(arrays);
}

int FindHullContacts(dGeomID hull, dGeomID upright, int most, dContactGeom* contacts, int skip) {
  SHullArrays arrays = MakeHullOf(upright);
  const dGeomID prism = MakeConvex(arrays);
  const dReal* const place = dGeomGetPosition(upright);
  dGeomSetPosition(prism, place[0], place[1], place[2]);
  dGeomSetRotation(prism, dGeomGetRotation(upright));
  const int count = dCollide(hull, prism, most, contacts, skip);
  for (int i = 0; i < count; ++i) {
    auto& contact = *reinterpret_cast<dContactGeom*>(reinterpret_cast<char*>(contacts) +
                                                     static_cast<size_t>(i) * skip);
    (contact.g1 == prism ? contact.g1 : contact.g2) = upright;
  }
  dGeomDestroy(prism);
  return count;
}

}  // namespace argos
