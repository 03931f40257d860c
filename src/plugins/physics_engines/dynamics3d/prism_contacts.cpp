#include <argos3/plugins/simulator/physics_engines/dynamics3d/prism_contacts.h>

#include <argos3/core/simulator/geometry/convex_polygon.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_spread.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/prism_geom.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace argos {

namespace {

// m; of gaps that differ by less, the first one counts
constexpr Real kSameGap = 1e-9;
// an edge across another one counts if its gap is greater than that of the best face by these:
// faces have more contacts, so bodies rest more quietly on them
constexpr Real kEdgeGain = 1e-5;  // m
constexpr Real kEdgeShare = 0.05;  // of the gap
constexpr size_t kCylinderSides = 24;

using TPolygon = std::vector<CVector2>;
using TPoints = std::vector<CVector3>;

/** Vectors that keep their memory from one pair of geoms to the next. */
struct SScratch {
  std::array<TPolygon, 2> Bases;
  TPoints Face, Clipped;
  std::vector<dContactGeom> Contacts;
};

/** A geom's place in the world. */
struct SFrame {
  CVector3 Centre;  // m
  std::array<CVector3, 3> Axes;  // of unit length

  explicit SFrame(dGeomID geom) : Centre(FromODE(dGeomGetPosition(geom))) {
    const dReal* const rotation = dGeomGetRotation(geom);
    for (size_t i = 0; i < 3; ++i) {
      Axes[i].Set(rotation[i], rotation[4 + i], rotation[8 + i]);
    }
  }
  CVector3 ToWorld(const CVector2& planar, Real up) const {
    return Centre + Rotated(planar) + Axes[2] * up;
  }
  CVector3 Rotated(const CVector2& planar) const {
    return Axes[0] * planar.GetX() + Axes[1] * planar.GetY();
  }
  CVector2 AlongBase(const CVector3& vector) const {
    return CVector2(vector.DotProduct(Axes[0]), vector.DotProduct(Axes[1]));
  }
};

/** A convex prism in the world. Faces: the sides by their first corners, the bottom, the top. */
struct SPlacedPrism : SFrame {
  const TPolygon& Base;  // m
  Real Half;  // m, of the height

  SPlacedPrism(dGeomID geom, const TPolygon& base, Real height)
      : SFrame(geom), Base(base), Half(0.5 * height) {}

  size_t GetNumFaces() const { return Base.size() + 2; }
  bool IsSide(size_t face) const { return face < Base.size(); }
  CVector3 ComputeNormal(size_t face) const {
    if (IsSide(face)) {
      return Rotated(ComputeSideNormal(Base, face));
    }
    return face == Base.size() ? -Axes[2] : Axes[2];
  }
  // a point of the face
  CVector3 GetPoint(size_t face) const {
    return IsSide(face) ? ToWorld(Base[face], -Half)
                        : ToWorld(Base[0], face == Base.size() ? -Half : Half);
  }
  CVector3 FindFarthest(const CVector3& direction) const {
    const size_t corner = FindFarthestCorner(Base, AlongBase(direction));
    return ToWorld(Base[corner], direction.DotProduct(Axes[2]) < 0.0 ? -Half : Half);
  }
  // the direction of the edges beside a face: sides, then vertical edges; not of unit length
  CVector3 ComputeEdge(size_t number) const {
    return IsSide(number) ? Rotated(NextCorner(Base, number) - Base[number]) : Axes[2];
  }
  void ListCorners(size_t face, TPoints& corners) const {
    corners.clear();
    if (IsSide(face)) {
      const CVector2& next = NextCorner(Base, face);
      corners = {ToWorld(Base[face], -Half), ToWorld(next, -Half), ToWorld(next, Half),
                 ToWorld(Base[face], Half)};
      return;
    }
    for (const CVector2& corner : Base) {
      corners.push_back(ToWorld(corner, face == Base.size() ? -Half : Half));
    }
  }
};

/** The direction along which two prisms are farthest apart. */
struct SBestAxis {
  CVector3 Direction;  // of unit length, from the first to the second
  Real Gap = -HUGE_VAL;  // m; negative if they overlap
  const SPlacedPrism* Reference = nullptr;  // whose face it is; null: of two edges
  size_t Face = 0;
  CVector3 FirstEdge, SecondEdge;
};

// Tests the faces of a prism. @return false if the other one is farther than the reach.
bool TestFaces(const SPlacedPrism& prism, const SPlacedPrism& other, bool isFirst, Real reach,
               SBestAxis& best) {
  for (size_t face = 0; face < prism.GetNumFaces(); ++face) {
    const CVector3 normal = prism.ComputeNormal(face);
    const Real gap = normal.DotProduct(other.FindFarthest(-normal) - prism.GetPoint(face));
    if (gap > reach) {
      return false;
    }
    if (gap > best.Gap + kSameGap) {
      best = {isFirst ? normal : -normal, gap, &prism, face, {}, {}};
    }
  }
  return true;
}

// the same for the normals of pairs of edges; between parallel axes, they are normals of faces
bool TestEdges(const SPlacedPrism& first, const SPlacedPrism& second, Real reach, SBestAxis& best) {
  constexpr Real kParallelEdges = 1e-6;  // sine of the angle between them
  if (Cross(first.Axes[2], second.Axes[2]).Length() < kParallelEdges) {
    return true;
  }
  const Real needed = best.Gap + kEdgeShare * std::abs(best.Gap) + kEdgeGain;
  SBestAxis bestEdges;
  for (size_t i = 0; i <= first.Base.size(); ++i) {
    const CVector3 a = first.ComputeEdge(i);
    for (size_t j = 0; j <= second.Base.size(); ++j) {
      const CVector3 b = second.ComputeEdge(j);
      CVector3 normal = Cross(a, b);
      const Real length = normal.Length();
      if (length < kParallelEdges * a.Length() * b.Length()) {
        continue;
      }
      normal /= length;
      for (const CVector3& direction : {normal, -normal}) {
        const Real gap =
            direction.DotProduct(second.FindFarthest(-direction) - first.FindFarthest(direction));
        if (gap > reach) {
          return false;
        }
        if (gap > bestEdges.Gap + kSameGap) {
          bestEdges = {direction, gap, nullptr, 0, a, b};
        }
      }
    }
  }
  if (bestEdges.Gap > needed) {
    best = bestEdges;
  }
  return true;
}

void AddContact(const CVector3& point, const CVector3& normal, Real depth,
                std::vector<dContactGeom>& contacts) {
  SetContact(contacts.emplace_back(), point, normal, depth, nullptr, nullptr);
}

// Keeps the part of a polygon behind a plane. Source: I. Sutherland and G. Hodgman, Reentrant
// polygon clipping, Communications of the ACM 17 (1974).
void ClipFace(SScratch& scratch, const CVector3& point, const CVector3& normal) {
  TPoints& face = scratch.Face;
  scratch.Clipped.clear();
  for (size_t i = 0; i < face.size(); ++i) {
    const CVector3& start = face[i];
    const CVector3& end = face[i + 1 < face.size() ? i + 1 : 0];
    const Real before = normal.DotProduct(start - point);
    const Real after = normal.DotProduct(end - point);
    if (before <= 0.0) {
      scratch.Clipped.push_back(start);
    }
    if ((before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0)) {
      scratch.Clipped.push_back(start + (end - start) * (before / (before - after)));
    }
  }
  face.swap(scratch.Clipped);
}

void ClipToFace(SScratch& scratch, const SPlacedPrism& prism, size_t face) {
  if (!prism.IsSide(face)) {
    for (size_t side = 0; side < prism.Base.size(); ++side) {
      ClipFace(scratch, prism.GetPoint(side), prism.ComputeNormal(side));
    }
    return;
  }
  const CVector3 along = prism.ComputeEdge(face);
  const CVector3 start = prism.GetPoint(face);
  ClipFace(scratch, start, -along);
  ClipFace(scratch, start + along, along);
  ClipFace(scratch, start, -prism.Axes[2]);
  ClipFace(scratch, prism.GetPoint(prism.Base.size() + 1), prism.Axes[2]);
}

// the contacts on a face: the other prism's most opposite face, clipped to what is above it
void AddFaceContacts(const SBestAxis& best, const SPlacedPrism& first, const SPlacedPrism& second,
                     Real reach, SScratch& scratch) {
  const SPlacedPrism& prism = *best.Reference;
  const SPlacedPrism& other = &prism == &first ? second : first;
  const CVector3 normal = prism.ComputeNormal(best.Face);
  size_t incident = 0;
  Real least = HUGE_VAL;
  for (size_t face = 0; face < other.GetNumFaces(); ++face) {
    const Real along = normal.DotProduct(other.ComputeNormal(face));
    if (along < least) {
      least = along;
      incident = face;
    }
  }
  other.ListCorners(incident, scratch.Face);
  ClipToFace(scratch, prism, best.Face);
  const CVector3 plane = prism.GetPoint(best.Face);
  for (const CVector3& point : scratch.Face) {
    const Real depth = -normal.DotProduct(point - plane);
    if (depth >= -reach) {
      // between both surfaces
      AddContact(point + normal * (0.5 * depth), -best.Direction, depth, scratch.Contacts);
    }
  }
  if (scratch.Contacts.empty() && best.Gap <= 0.0) {
    // corner to corner; while they are apart, they may pass each other
    const CVector3 corner = other.FindFarthest(-normal);
    AddContact(corner - normal * (0.5 * best.Gap), -best.Direction, -best.Gap, scratch.Contacts);
  }
}

// the contact of two edges: between their nearest points
void AddEdgeContact(const SBestAxis& best, const SPlacedPrism& first, const SPlacedPrism& second,
                    SScratch& scratch) {
  const CVector3 onFirst = first.FindFarthest(best.Direction);
  const CVector3 onSecond = second.FindFarthest(-best.Direction);
  const CVector3& a = best.FirstEdge;
  // the plane through the second edge and along the direction
  const CVector3 across = Cross(best.SecondEdge, best.Direction);
  const Real share = across.DotProduct(onSecond - onFirst) / across.DotProduct(a);
  AddContact(onFirst + a * share + best.Direction * (0.5 * best.Gap), -best.Direction, -best.Gap,
             scratch.Contacts);
}

// Adds the contacts, with normals into the first. @return the direction from the first to the
// second, if there are any; else the zero vector.
CVector3 CollidePrisms(const SPlacedPrism& first, const SPlacedPrism& second, Real reach,
                       SScratch& scratch) {
  SBestAxis best;
  if (!TestFaces(first, second, true, reach, best) ||
      !TestFaces(second, first, false, reach, best) || !TestEdges(first, second, reach, best)) {
    return CVector3();
  }
  if (best.Reference != nullptr) {
    AddFaceContacts(best, first, second, reach, scratch);
  } else {
    AddEdgeContact(best, first, second, scratch);
  }
  return best.Direction;
}

// A prism, or a box as one. @param base  receives the base of a box.
SPlacedPrism PlacePrism(dGeomID solid, TPolygon& base) {
  if (IsPrism(solid)) {
    return SPlacedPrism(solid, GetPrismBase(solid), GetPrismHeight(solid));
  }
  dVector3 size;
  dGeomBoxGetLengths(solid, size);
  const Real x = 0.5 * size[0];
  const Real y = 0.5 * size[1];
  base = {CVector2(-x, -y), CVector2(x, -y), CVector2(x, y), CVector2(-x, y)};
  return SPlacedPrism(solid, base, size[2]);
}

void CollideWithPlane(const SPlacedPrism& prism, dGeomID plane, Real reach, SScratch& scratch) {
  dVector4 parameters;
  dGeomPlaneGetParams(plane, parameters);
  const CVector3 normal = FromODE(parameters);
  for (const CVector2& corner : prism.Base) {
    for (const Real up : {-prism.Half, prism.Half}) {
      const CVector3 point = prism.ToWorld(corner, up);
      const Real depth = parameters[3] - normal.DotProduct(point);
      if (depth >= -reach) {
        AddContact(point, normal, depth, scratch.Contacts);
      }
    }
  }
}

void CollideWithSphere(const SPlacedPrism& prism, dGeomID sphere, Real reach, SScratch& scratch) {
  const Real radius = dGeomSphereGetRadius(sphere);
  const CVector3 centre = FromODE(dGeomGetPosition(sphere));
  const CVector3 offset = centre - prism.Centre;
  const Real up = offset.DotProduct(prism.Axes[2]);
  const Real above = std::abs(up) - prism.Half;
  const SPolygonNearest beside = FindNearest(prism.Base, prism.AlongBase(offset));
  // from the prism to the centre of the sphere
  const CVector3 away = prism.Rotated(beside.Normal);
  const CVector3 cap = up < 0.0 ? -prism.Axes[2] : prism.Axes[2];
  CVector3 normal;
  Real distance = 0.0;
  if (beside.Distance > 0.0 && above > 0.0) {
    distance = std::hypot(beside.Distance, above);
    normal = away * (beside.Distance / distance) + cap * (above / distance);
  } else {
    distance = std::max(beside.Distance, above);
    normal = beside.Distance > above ? away : cap;
  }
  const Real depth = radius - distance;
  if (depth >= -reach) {
    AddContact(centre - normal * (distance + 0.5 * depth), -normal, depth, scratch.Contacts);
  }
}

// A cylinder as a prism. @param towards  where one of its edges is, in its plane.
void ListRim(TPolygon& rim, Real radius, const CVector2& towards) {
  rim.clear();
  const Real start = std::atan2(towards.GetY(), towards.GetX());
  for (size_t i = 0; i < kCylinderSides; ++i) {
    const Real angle = start + 2.0 * ARGOS_PI * static_cast<Real>(i) / kCylinderSides;
    rim.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
}

// @return false if the prism and the cylinder do not stand side by side.
bool CollideBesideCylinder(const SPlacedPrism& prism, const SFrame& cylinder, Real radius,
                           Real length, Real reach, SScratch& scratch) {
  const Real cosine = prism.Axes[2].DotProduct(cylinder.Axes[2]);
  if (std::abs(cosine) <= kParallel) {
    return false;
  }
  // heights above the prism's centre, along the cylinder's axis
  const CVector3 axis = cosine < 0.0 ? -cylinder.Axes[2] : cylinder.Axes[2];
  const CVector3 offset = cylinder.Centre - prism.Centre;
  const Real along = offset.DotProduct(prism.Axes[2]);
  const Real low = std::max(-prism.Half, along - 0.5 * length);
  const Real high = std::min(prism.Half, along + 0.5 * length);
  const auto measure = [&](Real height) {
    return FindNearest(prism.Base, prism.AlongBase(offset + axis * (height - along)));
  };
  const Real depth = radius - measure(0.5 * (low + high)).Distance;
  if (depth > 0.0 && high - low < depth) {
    return false;
  }
  if (high < low) {
    return true;
  }
  for (const Real height : {low, high}) {
    const SPolygonNearest nearest = measure(height);
    const Real inside = radius - nearest.Distance;
    if (inside >= -reach) {
      const CVector2 between = nearest.Point - nearest.Normal * (0.5 * inside);
      AddContact(prism.ToWorld(between, height), -prism.Rotated(nearest.Normal), inside,
                 scratch.Contacts);
    }
  }
  return true;
}

void CollideWithCylinder(const SPlacedPrism& prism, dGeomID cylinder, Real reach,
                         SScratch& scratch) {
  dReal radius = 0.0;
  dReal length = 0.0;
  dGeomCylinderGetParams(cylinder, &radius, &length);
  const SFrame frame(cylinder);
  if (CollideBesideCylinder(prism, frame, radius, length, reach, scratch)) {
    return;
  }
  TPolygon& rim = scratch.Bases[0];
  const SPlacedPrism rough(cylinder, rim, length);
  // around the cylinder, so that no contact is missed; then inside, with an edge at the contact
  ListRim(rim, radius / std::cos(ARGOS_PI / kCylinderSides), CVector2::X);
  const CVector3 direction = CollidePrisms(prism, rough, reach, scratch);
  scratch.Contacts.clear();
  if (direction != CVector3()) {
    const CVector2 towards = -frame.AlongBase(direction);
    ListRim(rim, radius, towards.SquareLength() > 1e-12 ? towards : CVector2::X);
    CollidePrisms(prism, rough, reach, scratch);
  }
}

// the contacts of a prism, with normals into it
void Collide(const SPlacedPrism& prism, dGeomID other, Real reach, SScratch& scratch) {
  switch (dGeomGetClass(other)) {
    case dPlaneClass:
      CollideWithPlane(prism, other, reach, scratch);
      break;
    case dCylinderClass:
      CollideWithCylinder(prism, other, reach, scratch);
      break;
    case dSphereClass:
      CollideWithSphere(prism, other, reach, scratch);
      break;
    default:
      CollidePrisms(prism, PlacePrism(other, scratch.Bases[0]), reach, scratch);
      break;
  }
}

}  // namespace

int FindPrismContacts(dGeomID first, dGeomID second, int most, dContactGeom* contacts, int skip,
                      dReal reach) {
  thread_local SScratch scratch;
  scratch.Contacts.clear();
  const bool isFirst = IsPrism(first) || (dGeomGetClass(first) == dBoxClass && !IsPrism(second));
  Collide(PlacePrism(isFirst ? first : second, scratch.Bases[1]), isFirst ? second : first, reach,
          scratch);
  for (dContactGeom& contact : scratch.Contacts) {
    contact.g1 = first;
    contact.g2 = second;
    for (UInt32 i = 0; i < 3 && !isFirst; ++i) {
      contact.normal[i] = -contact.normal[i];
    }
  }
  return KeepSpread(scratch.Contacts.data(), static_cast<int>(scratch.Contacts.size()), most,
                    contacts, skip);
}

}  // namespace argos
