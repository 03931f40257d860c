#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_spread.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/hull_geom.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/prism_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/prism_geom.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace argos {

namespace {

struct SUpright {
  CVector3 Centre;  // m, world frame
  CVector3 Axis;  // of length 1
  Real Radius = 0.0;
  Real HalfLength = 0.0;
};

SUpright Describe(dGeomID geom) {
  SUpright cylinder;
  dReal radius = 0.0;
  dReal length = 0.0;
  dGeomCylinderGetParams(geom, &radius, &length);
  const dReal* const rotation = dGeomGetRotation(geom);
  cylinder.Centre = FromODE(dGeomGetPosition(geom));
  cylinder.Axis.Set(rotation[2], rotation[6], rotation[10]);
  cylinder.Radius = radius;
  cylinder.HalfLength = 0.5 * length;
  return cylinder;
}

// sine of the least angle from upright at which the lowest point of a rim is computed; below it,
// four points that are fixed to the cylinder, so that it does not rattle from one to the next
constexpr Real kFlat = 0.01;

// Contacts at four points of each rim, of which one is the lowest where the cylinder leans. The
// normal points to the cylinder.
int FindContactsWithFace(dGeomID geom, dGeomID other, const CVector3& normal, Real height, int most,
                         dContactGeom* contacts, int skip) {
  const SUpright cylinder = Describe(geom);
  const dReal* const rotation = dGeomGetRotation(geom);
  CVector3 across(rotation[0], rotation[4], rotation[8]);
  const CVector3 downhill = cylinder.Axis * normal.DotProduct(cylinder.Axis) - normal;
  if (const Real slope = downhill.Length(); slope > kFlat) {
    across = downhill / slope;
  }
  const CVector3 aside = Cross(cylinder.Axis, across);
  std::array<dContactGeom, 8> all{};
  int count = 0;
  for (const Real end : {-1.0, 1.0}) {
    const CVector3 middle = cylinder.Centre + cylinder.Axis * (end * cylinder.HalfLength);
    for (const CVector3& direction : {across, -across, aside, -aside}) {
      const CVector3 point = middle + direction * cylinder.Radius;
      const Real depth = height - normal.DotProduct(point);
      if (depth < 0.0) {
        continue;
      }
      SetContact(all[count++], point, normal, depth, geom, other);
    }
  }
  return KeepSpread(all.data(), count, most, contacts, skip);
}

// the part of the first cylinder's axis that is beside the second, m from the first one's centre
struct SBeside {
  Real Low;
  Real High;
};

SBeside FindBeside(const SUpright& first, const SUpright& second) {
  const Real along = (second.Centre - first.Centre).DotProduct(first.Axis);
  return {std::max(-first.HalfLength, along - second.HalfLength),
          std::min(first.HalfLength, along + second.HalfLength)};
}

// cosine of the greatest angle between the axes of cylinders that lean and stand side by side: 15
// degrees; within it, the distance at the ends is nearly that of the surfaces
constexpr Real kBeside = 0.966;

// Heights on the first axis at which cylinders side by side may touch: both ends and, of axes that
// are not parallel, the place between at which these are nearest.
struct SHeights {
  std::array<Real, 3> Values{};
  int Count = 0;
};

SHeights ChooseHeights(const SUpright& first, const SUpright& second, const SBeside& beside) {
  SHeights heights{{beside.Low, beside.High, 0.0}, 2};
  const Real cosine = first.Axis.DotProduct(second.Axis);
  if (std::abs(cosine) > kParallel) {
    return heights;
  }
  const CVector3 apart = first.Centre - second.Centre;
  const Real nearest = (cosine * apart.DotProduct(second.Axis) - apart.DotProduct(first.Axis)) /
                       (1.0 - cosine * cosine);
  if (nearest > beside.Low && nearest < beside.High) {
    heights.Values[heights.Count++] = nearest;
  }
  return heights;
}

// the depth of the overlap at that height, m, below 0 if they are apart; the direction from the
// second to the first
Real MeasureDepth(const SUpright& first, const SUpright& second, Real height, CVector3& direction) {
  const CVector3 on = first.Centre + first.Axis * height;
  const Real along = (on - second.Centre).DotProduct(second.Axis);
  direction = on - (second.Centre + second.Axis * along);
  const Real distance = direction.Length();
  if (distance > 1e-9) {
    direction /= distance;
  } else {
    // coincident axes determine no direction: it is chosen across the most upright axis of the
    // world
    direction = std::abs(second.Axis.GetX()) < 0.8 ? CVector3::X : CVector3::Y;
    direction -= second.Axis * direction.DotProduct(second.Axis);
    direction.Normalize();
  }
  return first.Radius + second.Radius - distance;
}

// Exchanges the two solids.
void Exchange(dContactGeom* contacts, int count, int skip) {
  for (int i = 0; i < count; ++i) {
    dContactGeom& contact = ContactAt(contacts, i, skip);
    std::swap(contact.g1, contact.g2);
    for (UInt32 axis = 0; axis < 3; ++axis) {
      contact.normal[axis] = -contact.normal[axis];
    }
  }
}

int FindContactsWithPlane(dGeomID cylinder, dGeomID plane, int most, dContactGeom* contacts,
                          int skip) {
  dVector4 parameters;
  dGeomPlaneGetParams(plane, parameters);
  return FindContactsWithFace(cylinder, plane, FromODE(parameters), parameters[3], most, contacts,
                              skip);
}

// The face of a box on which a cylinder stands with a whole end.
struct SStand {
  CVector3 Normal;  // outwards, world frame
  Real Height;  // m: points on it have this product with the normal
};

std::optional<SStand> FindFaceBelow(const SUpright& cylinder, dGeomID box) {
  dVector3 size;
  dGeomBoxGetLengths(box, size);
  const dReal* const rotation = dGeomGetRotation(box);
  const CVector3 centre = FromODE(dGeomGetPosition(box));
  std::optional<SStand> face;
  for (UInt32 axis = 0; axis < 3; ++axis) {
    const CVector3 along(rotation[axis], rotation[4 + axis], rotation[8 + axis]);
    const Real place = along.DotProduct(cylinder.Centre - centre);
    const Real half = 0.5 * size[axis];
    if (std::abs(along.DotProduct(cylinder.Axis)) > kParallel && std::abs(place) > half) {
      const CVector3 normal = place > 0.0 ? along : -along;
      face = SStand{normal, half + normal.DotProduct(centre)};
    } else if (std::abs(place) + cylinder.Radius > half) {
      return std::nullopt;
    }
  }
  return face;
}

// For a cylinder on a box, ODE returns points all around its rim, as many as the array can store.
constexpr int kMaxBoxContacts = 16;

// @return true if a cylinder stands beside a box: a part of its side that is longer than the reach
// is at the same height.
bool IsBesideBox(const SUpright& cylinder, dGeomID box, Real reach) {
  dVector3 size;
  dGeomBoxGetLengths(box, size);
  const dReal* const rotation = dGeomGetRotation(box);
  const CVector3 up(rotation[2], rotation[6], rotation[10]);
  const Real above = up.DotProduct(cylinder.Centre - FromODE(dGeomGetPosition(box)));
  return std::abs(up.DotProduct(cylinder.Axis)) > kParallel &&
         cylinder.HalfLength + 0.5 * size[2] - std::abs(above) > reach;
}

int FindContactsWithBox(dGeomID first, dGeomID second, int most, dContactGeom* contacts, int skip,
                        Real reach) {
  const bool isFirst = dGeomGetClass(first) == dCylinderClass;
  const dGeomID cylinder = isFirst ? first : second;
  const dGeomID box = isFirst ? second : first;
  if (const auto face = FindFaceBelow(Describe(cylinder), box)) {
    const int count =
        FindContactsWithFace(cylinder, box, face->Normal, face->Height, most, contacts, skip);
    if (!isFirst) {
      Exchange(contacts, count, skip);
    }
    return count;
  }
  if (reach > kSkin && IsBesideBox(Describe(cylinder), box, reach)) {
    return FindPrismContacts(first, second, most, contacts, skip, reach);
  }
  std::array<dContactGeom, kMaxBoxContacts> all;
  const int count = dCollide(first, second, kMaxBoxContacts, all.data(), sizeof(dContactGeom));
  return KeepSpread(all.data(), count, most, contacts, skip);
}

int FindContactsOfCylinders(dGeomID first, dGeomID second, int most, dContactGeom* contacts,
                            int skip, Real reach) {
  const SUpright a = Describe(first);
  const SUpright b = Describe(second);
  const SBeside beside = FindBeside(a, b);
  CVector3 direction;
  const Real depth = MeasureDepth(a, b, 0.5 * (beside.Low + beside.High), direction);
  const bool isParallel = std::abs(a.Axis.DotProduct(b.Axis)) > kBeside;
  if (!isParallel || (depth > 0.0 && beside.High - beside.Low < depth)) {
    // skew, or one on top of the other
    return dCollide(first, second, most, contacts, skip);
  }
  if (beside.High < beside.Low) {
    return 0;
  }
  int count = 0;
  const SHeights heights = ChooseHeights(a, b, beside);
  for (int i = 0; i < heights.Count; ++i) {
    const Real height = heights.Values[i];
    const Real inside = MeasureDepth(a, b, height, direction);
    if (inside < -reach || count == most) {
      continue;
    }
    const CVector3 point = a.Centre + a.Axis * height - direction * (a.Radius - 0.5 * inside);
    SetContact(ContactAt(contacts, count, skip), point, direction, inside, first, second);
    ++count;
  }
  return count;
}

}  // namespace

int FindContacts(dGeomID first, dGeomID second, int most, dContactGeom* contacts, int skip,
                 dReal reach) {
  const auto areA = [first, second](int a, int b) {
    return dGeomGetClass(first) == a && dGeomGetClass(second) == b;
  };
  const auto isUpright = [](dGeomID geom) {
    return IsPrism(geom) || dGeomGetClass(geom) == dCylinderClass;
  };
  if (dGeomGetClass(first) == dConvexClass && isUpright(second)) {
    return FindHullContacts(first, second, most, contacts, skip);
  }
  if (isUpright(first) && dGeomGetClass(second) == dConvexClass) {
    return FindHullContacts(second, first, most, contacts, skip);
  }
  // ODE finds no contacts of boxes that are apart
  if (IsPrism(first) || IsPrism(second) || (areA(dBoxClass, dBoxClass) && reach > kSkin)) {
    return FindPrismContacts(first, second, most, contacts, skip, reach);
  }
  if (areA(dCylinderClass, dBoxClass) || areA(dBoxClass, dCylinderClass)) {
    return FindContactsWithBox(first, second, most, contacts, skip, reach);
  }
  if (areA(dCylinderClass, dPlaneClass)) {
    return FindContactsWithPlane(first, second, most, contacts, skip);
  }
  if (areA(dPlaneClass, dCylinderClass)) {
    const int count = FindContactsWithPlane(second, first, most, contacts, skip);
    Exchange(contacts, count, skip);
    return count;
  }
  if (dGeomGetClass(first) != dCylinderClass || dGeomGetClass(second) != dCylinderClass) {
    return dCollide(first, second, most, contacts, skip);
  }
  return FindContactsOfCylinders(first, second, most, contacts, skip, reach);
}

}  // namespace argos
