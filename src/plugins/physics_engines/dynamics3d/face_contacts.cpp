#include <argos3/plugins/simulator/physics_engines/dynamics3d/face_contacts.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_cache.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// cosine of the greatest angle between normals that are taken for one
constexpr Real kSameNormal = 1.0 - 1e-9;
// the skins of both sides that an edge is covered by, with the rounding of places
constexpr Real kBothSides = 2.1;

// Moves contacts with one normal along it, into a plane. The bodies can then rock on each other
// without sliding at any of them, which friction would have to prevent with great forces between
// the contacts. The lever of the normal force is the same.
void Level(dContact* contacts, int count) {
  if (count == 0) {
    return;
  }
  const CVector3 normal = FromODE(contacts[0].geom.normal);
  Real sum = 0.0;
  for (int i = 0; i < count; ++i) {
    if (normal.DotProduct(FromODE(contacts[i].geom.normal)) < kSameNormal) {
      return;
    }
    sum += normal.DotProduct(FromODE(contacts[i].geom.pos));
  }
  for (int i = 0; i < count; ++i) {
    const Real up = sum / count - normal.DotProduct(FromODE(contacts[i].geom.pos));
    for (UInt32 axis = 0; axis < 3; ++axis) {
      contacts[i].geom.pos[axis] += up * normal[axis];
    }
  }
}

// which axis of a box a normal is parallel to; 3: none
UInt32 FindParallelAxis(dGeomID box, const CVector3& normal) {
  constexpr Real kParallelFace = 1.0 - 1e-6;  // cosine
  const dReal* const r = dGeomGetRotation(box);
  for (UInt32 axis = 0; axis < 3; ++axis) {
    if (std::abs(CVector3(r[axis], r[4 + axis], r[8 + axis]).DotProduct(normal)) > kParallelFace) {
      return axis;
    }
  }
  return 3;
}

// Boxes with parallel faces that cover each other by no more than the skins of both touch with an
// edge only, where neither stops the other: boxes in a stack do so with those at their corners.
bool IsSliver(dGeomID first, dGeomID second, const dContact* contacts, int count, Real skins) {
  if (count == 0 || dGeomGetClass(first) != dBoxClass || dGeomGetClass(second) != dBoxClass) {
    return false;
  }
  const CVector3 normal = FromODE(contacts[0].geom.normal);
  const UInt32 across = FindParallelAxis(first, normal);
  if (across == 3 || FindParallelAxis(second, normal) == 3) {
    return false;
  }
  const dReal* const r = dGeomGetRotation(first);
  for (UInt32 axis = 0; axis < 3; ++axis) {
    Real low = HUGE_VAL;
    Real high = -HUGE_VAL;
    for (int i = 0; i < count; ++i) {
      const Real place =
          CVector3(r[axis], r[4 + axis], r[8 + axis]).DotProduct(FromODE(contacts[i].geom.pos));
      low = std::min(low, place);
      high = std::max(high, place);
    }
    if (axis != across && high - low < skins) {
      return true;
    }
  }
  return false;
}

// The surface of a ball reaches farther by as much as its contacts are anticipated.
int FindBallContacts(dGeomID first, dGeomID second, dGeomID ball, Real reach, dContact* contacts) {
  const Real radius = dGeomSphereGetRadius(ball);
  dGeomSphereSetRadius(ball, radius + reach);
  const int count =
      FindContacts(first, second, CContactCache::kMaxContacts, &contacts[0].geom, sizeof(dContact));
  dGeomSphereSetRadius(ball, radius);
  const Real back = ball == first ? 0.5 * reach : -0.5 * reach;
  for (int i = 0; i < count; ++i) {
    dContactGeom& contact = contacts[i].geom;
    contact.depth -= reach;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      contact.pos[axis] += back * contact.normal[axis];
    }
  }
  return count;
}

}  // namespace

int FindFaceContacts(dGeomID first, dGeomID second, Real reach, Real skins, dContact* contacts) {
  for (const dGeomID solid : {first, second}) {
    if (dGeomGetClass(solid) == dSphereClass) {
      return FindBallContacts(first, second, solid, reach, contacts);
    }
  }
  const int count = FindContacts(first, second, CContactCache::kMaxContacts, &contacts[0].geom,
                                 sizeof(dContact), reach);
  if (IsSliver(first, second, contacts, count, kBothSides * skins)) {
    return 0;
  }
  Level(contacts, count);
  return count;
}

}  // namespace argos
