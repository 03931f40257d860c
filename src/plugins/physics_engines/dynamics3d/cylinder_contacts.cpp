#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_spread.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/hull_geom.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/prism_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/prism_geom.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <algorithm>
#include <array>
#include <cmath>

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

// For a cylinder on a box, ODE returns points all around its rim, as many as the array can store.
constexpr int kMostOfBox = 16;

int FindContactsWithBox(dGeomID first, dGeomID second, int most, dContactGeom* contacts, int skip) {
  std::array<dContactGeom, kMostOfBox> all;
  const int count = dCollide(first, second, kMostOfBox, all.data(), sizeof(dContactGeom));
  return KeepSpread(all.data(), count, most, contacts, skip);
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
  if (IsPrism(first) || IsPrism(second)) {
    return FindPrismContacts(first, second, most, contacts, skip, reach);
  }
  if (areA(dCylinderClass, dBoxClass) || areA(dBoxClass, dCylinderClass)) {
    return FindContactsWithBox(first, second, most, contacts, skip);
  }
  if (dGeomGetClass(first) != dCylinderClass || dGeomGetClass(second) != dCylinderClass) {
    return dCollide(first, second, most, contacts, skip);
  }
  const SUpright a = Describe(first);
  const SUpright b = Describe(second);
  const SBeside beside = FindBeside(a, b);
  CVector3 direction;
  const Real depth = MeasureDepth(a, b, 0.5 * (beside.Low + beside.High), direction);
  const bool isParallel = std::abs(a.Axis.DotProduct(b.Axis)) > kParallel;
  if (!isParallel || (depth > 0.0 && beside.High - beside.Low < depth)) {
    // skew, or one on top of the other
    return dCollide(first, second, most, contacts, skip);
  }
  if (beside.High < beside.Low) {
    return 0;
  }
  int count = 0;
  for (const Real height : {beside.Low, beside.High}) {
    const Real inside = MeasureDepth(a, b, height, direction);
    if (inside < -reach || count == most) {
      continue;
    }
    dContactGeom& contact = ContactAt(contacts, count, skip);
    const CVector3 point = a.Centre + a.Axis * height - direction * (a.Radius - 0.5 * inside);
    for (UInt32 i = 0; i < 3; ++i) {
      contact.pos[i] = point[i];
      contact.normal[i] = direction[i];
    }
    contact.depth = inside;
    contact.g1 = first;
    contact.g2 = second;
    contact.side1 = contact.side2 = -1;
    ++count;
  }
  return count;
}

}  // namespace argos
