#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_finder.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// of two geoms: the corners of a face; ODE chooses those far apart of the eight that two boxes may
// have, and fewer are solved better
constexpr int kMaxContacts = 4;
// m/s: what slides more slowly has no direction worth following
constexpr Real kSlidingSpeed = 1e-4;
// rows of the two hinges with motors of a robot
constexpr UInt32 kAxleRows = 12;

SRigidBody& BodyOf(dGeomID geom) {
  return *static_cast<SRigidBody*>(dGeomGetData(geom));
}

// can this do something on its own?
bool IsActive(const SRigidBody& body) {
  return body.IsMovable() && !body.Asleep;
}

bool DoBoundsOverlap(dGeomID first, dGeomID second) {
  dReal a[6];  // m: least and greatest x, y and z
  dReal b[6];
  dGeomGetAABB(first, a);
  dGeomGetAABB(second, b);
  return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3] && a[4] <= b[5] &&
         b[4] <= a[5];
}

CVector3 VelocityAt(dGeomID geom, const CVector3& point) {
  const dBodyID part = dGeomGetBody(geom);
  if (part == nullptr) {
    return CVector3();
  }
  return FromODE(dBodyGetLinearVel(part)) +
         Cross(FromODE(dBodyGetAngularVel(part)), point - FromODE(dBodyGetPosition(part)));
}

void SetDirection(dContact& contact, const CVector3& direction) {
  contact.surface.mode |= dContactFDir1;
  contact.fdir1[0] = direction.GetX();
  contact.fdir1[1] = direction.GetY();
  contact.fdir1[2] = direction.GetZ();
}

CVector3 AlongSurface(const CVector3& vector, const CVector3& normal) {
  return vector - normal * vector.DotProduct(normal);
}

}  // namespace

CContactFinder::CContactFinder(const SRigidSettings& settings, dWorldID world)
    : m_settings(settings), m_world(world), m_contacts(dJointGroupCreate(0)) {}

CContactFinder::~CContactFinder() {
  dJointGroupDestroy(m_contacts);
}

void CContactFinder::Clear() {
  dJointGroupEmpty(m_contacts);
}

void CContactFinder::Find(const std::vector<SRigidBody*>& movables,
                          const std::vector<SRigidBody*>& fixed,
                          const std::vector<SRigidBody*>& planes, const CVector3& gravity) {
  m_gravity = gravity;
  m_numContacts = 0;
  m_parents.resize(movables.size());
  for (UInt32 i = 0; i < m_parents.size(); ++i) {
    m_parents[i] = i;
  }
  m_islands.assign(movables.size(), {});
  const std::vector<SRigidPair>& pairs = m_broadPhase.FindPairs(movables, fixed);
  WakeNeighbours(pairs);
  for (SRigidBody* body : movables) {
    for (size_t i = 0; !body->Asleep && i < planes.size(); ++i) {
      if (body->Low.GetZ() <= planes[i]->High.GetZ()) {
        Touch(*body, *planes[i]);
      }
    }
  }
  for (const SRigidPair& pair : pairs) {
    if (IsActive(*pair.First) || IsActive(*pair.Second)) {
      Touch(*pair.First, *pair.Second);
    }
  }
  CountRows(movables);
}

// What is awake wakes what it comes near to, and that the next.
void CContactFinder::WakeNeighbours(const std::vector<SRigidPair>& pairs) {
  bool changed = true;
  while (changed) {
    changed = false;
    for (const SRigidPair& pair : pairs) {
      SRigidBody& first = *pair.First;
      SRigidBody& second = *pair.Second;
      if (first.IsMovable() && second.IsMovable() && first.Asleep != second.Asleep) {
        WakeRigidBody(first.Asleep ? first : second);
        changed = true;
      }
    }
  }
}

void CContactFinder::Touch(SRigidBody& first, SRigidBody& second) {
  const UInt32 before = m_numContacts;
  for (const dGeomID a : first.Geoms) {
    for (const dGeomID b : second.Geoms) {
      if ((dGeomGetCategoryBits(a) & dGeomGetCollideBits(b)) != 0 && DoBoundsOverlap(a, b)) {
        Touch(a, b);
      }
    }
  }
  if (m_numContacts == before) {
    return;
  }
  if (first.IsMovable() && second.IsMovable()) {
    const UInt32 a = FindRoot(first.Number);
    const UInt32 b = FindRoot(second.Number);
    // the lower number leads
    m_parents[std::max(a, b)] = std::min(a, b);
  } else {
    m_islands[first.IsMovable() ? first.Number : second.Number].Supported = true;
  }
}

void CContactFinder::Touch(dGeomID first, dGeomID second) {
  dContact contacts[kMaxContacts];
  const int count = FindContacts(first, second, kMaxContacts, &contacts[0].geom, sizeof(dContact));
  const unsigned long kinds = dGeomGetCategoryBits(first) | dGeomGetCategoryBits(second);
  for (int i = 0; i < count; ++i) {
    AddContact(contacts[i], BodyOf(first), BodyOf(second), kinds);
  }
}

void CContactFinder::AddContact(dContact& contact, const SRigidBody& first,
                                const SRigidBody& second, unsigned long kinds) {
  const CVector3 normal = FromODE(contact.geom.normal);
  const bool rolls = (kinds & (geom_kind::kWheel | geom_kind::kCaster)) != 0;
  const bool isFirstRoller = (dGeomGetCategoryBits(contact.geom.g1) &
                              (geom_kind::kWheel | geom_kind::kCaster)) != 0;
  const SRigidBody& robot = isFirstRoller ? first : second;
  if (rolls) {
    // the normal points into the first geom
    const dReal* const rotation = dBodyGetRotation(robot.Body);
    const CVector3 up(rotation[2], rotation[6], rotation[10]);
    const bool bears = (isFirstRoller ? 1.0 : -1.0) * up.DotProduct(normal) >= kRollerSupport;
    if (!bears || ((kinds & geom_kind::kWheel) != 0 && robot.WheelCfm == 0.0)) {
      return;
    }
  }
  dSurfaceParameters& surface = contact.surface;
  surface = {};
  surface.mode = dContactApprox1;
  surface.mu = first.Friction * second.Friction;
  if ((kinds & geom_kind::kCaster) != 0) {
    surface.mu = 0.0;
  } else if ((kinds & geom_kind::kWheel) != 0) {
    SetRolling(contact, robot);
  } else {
    if (m_settings.Restitution > 0.0) {
      surface.mode |= dContactBounce;
      surface.bounce = m_settings.Restitution;
      surface.bounce_vel = m_settings.BounceSpeed;
    }
    SetSlidingDirection(contact);
  }
  const UInt32 rows = surface.mu > 0.0 ? 3 : 1;
  m_islands[first.IsMovable() ? first.Number : second.Number].Rows += rows;
  const dJointID joint = dJointCreateContact(m_world, m_contacts, &contact);
  dJointAttach(joint, dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2));
  ++m_numContacts;
}

// A wheel is held along its axle, and rolls across it. It is pressed in by its travel: it gives way,
// and touches the floor where its rim would without.
void CContactFinder::SetRolling(dContact& contact, const SRigidBody& robot) {
  const dReal* const rotation = dBodyGetRotation(robot.Body);
  const CVector3 axle(rotation[1], rotation[5], rotation[9]);
  const CVector3 normal = FromODE(contact.geom.normal);
  const CVector3 ahead = Cross(axle, normal);
  const Real length = ahead.Length();
  if (length > 0.1) {
    SetDirection(contact, ahead / length);
  }
  contact.surface.mode |= dContactSoftERP | dContactSoftCFM;
  contact.surface.soft_erp = robot.WheelErp;
  contact.surface.soft_cfm = robot.WheelCfm;
  const bool isFirst = dGeomGetCategoryBits(contact.geom.g1) == geom_kind::kWheel;
  const CVector3 centre = FromODE(dGeomGetPosition(isFirst ? contact.geom.g1 : contact.geom.g2));
  const CVector3 rim = centre - normal * ((isFirst ? 1.0 : -1.0) * robot.WheelRadius);
  for (UInt32 i = 0; i < 3; ++i) {
    contact.geom.pos[i] = rim[i];
  }
}

// ODE limits friction along two directions apart, so by a square. With one of them along the
// motion, or along the weight where nothing moves, that is Coulomb's circle.
void CContactFinder::SetSlidingDirection(dContact& contact) const {
  const CVector3 normal = FromODE(contact.geom.normal);
  const CVector3 point = FromODE(contact.geom.pos);
  const CVector3 sliding =
      AlongSurface(VelocityAt(contact.geom.g1, point) - VelocityAt(contact.geom.g2, point), normal);
  const Real speed = sliding.Length();
  if (speed > kSlidingSpeed) {
    SetDirection(contact, sliding / speed);
    return;
  }
  const CVector3 pull = AlongSurface(m_gravity, normal);
  const Real length = pull.Length();
  if (length > 1e-3 * m_gravity.Length()) {
    SetDirection(contact, pull / length);
  }
}

UInt32 CContactFinder::FindRoot(UInt32 body) {
  while (m_parents[body] != body) {
    m_parents[body] = m_parents[m_parents[body]];
    body = m_parents[body];
  }
  return body;
}

void CContactFinder::CountRows(const std::vector<SRigidBody*>& movables) {
  m_mostRows = 0;
  for (UInt32 i = 0; i < movables.size(); ++i) {
    SIsland& own = m_islands[i];
    own.Rows += movables[i]->HasWheels() ? kAxleRows : 0;
    const UInt32 root = FindRoot(i);
    if (root != i) {
      m_islands[root].Rows += own.Rows;
      m_islands[root].Supported = m_islands[root].Supported || own.Supported;
    }
  }
  // every root has all of its rows now
  for (UInt32 i = 0; i < movables.size(); ++i) {
    m_mostRows = std::max(m_mostRows, m_islands[i].Rows);
  }
}

}  // namespace argos
