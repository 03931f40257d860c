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

CContactFinder::CContactFinder(const SRigidSettings& settings, dWorldID world, dSpaceID space)
    : m_settings(settings), m_world(world), m_space(space), m_contacts(dJointGroupCreate(0)) {}

CContactFinder::~CContactFinder() {
  dJointGroupDestroy(m_contacts);
}

void CContactFinder::Clear() {
  dJointGroupEmpty(m_contacts);
}

void CContactFinder::Find(const std::vector<SRigidBody*>& movables, const CVector3& gravity) {
  m_gravity = gravity;
  m_numContacts = 0;
  m_pairs.clear();
  m_meetings.clear();
  m_parents.resize(movables.size());
  for (UInt32 i = 0; i < m_parents.size(); ++i) {
    m_parents[i] = i;
  }
  m_islands.assign(movables.size(), {});
  dSpaceCollide(m_space, this, &CContactFinder::Meet);
  WakeNeighbours();
  for (const SPair& pair : m_pairs) {
    if (IsActive(BodyOf(pair.First)) || IsActive(BodyOf(pair.Second))) {
      Touch(pair);
    }
  }
  CountRows(movables);
}

void CContactFinder::Meet(void* finder, dGeomID first, dGeomID second) {
  if (dGeomIsSpace(first) || dGeomIsSpace(second)) {
    dSpaceCollide2(first, second, finder, &CContactFinder::Meet);
    return;
  }
  auto& self = *static_cast<CContactFinder*>(finder);
  self.m_pairs.push_back({first, second});
  if (BodyOf(first).IsMovable() && BodyOf(second).IsMovable()) {
    self.m_meetings.push_back({first, second});
  }
}

// What is awake wakes what it comes near to, and that the next.
void CContactFinder::WakeNeighbours() {
  bool changed = true;
  while (changed) {
    changed = false;
    for (const SPair& pair : m_meetings) {
      SRigidBody& first = BodyOf(pair.First);
      SRigidBody& second = BodyOf(pair.Second);
      if (first.Asleep != second.Asleep) {
        WakeRigidBody(first.Asleep ? first : second);
        changed = true;
      }
    }
  }
}

void CContactFinder::Touch(const SPair& pair) {
  dContact contacts[kMaxContacts];
  const int count =
      FindContacts(pair.First, pair.Second, kMaxContacts, &contacts[0].geom, sizeof(dContact));
  SRigidBody& first = BodyOf(pair.First);
  SRigidBody& second = BodyOf(pair.Second);
  const unsigned long kinds = dGeomGetCategoryBits(pair.First) | dGeomGetCategoryBits(pair.Second);
  const UInt32 before = m_numContacts;
  for (int i = 0; i < count; ++i) {
    AddContact(contacts[i], first, second, kinds);
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

void CContactFinder::AddContact(dContact& contact, const SRigidBody& first,
                                const SRigidBody& second, unsigned long kinds) {
  const CVector3 normal = FromODE(contact.geom.normal);
  const bool rolls = (kinds & (geom_kind::kWheel | geom_kind::kCaster)) != 0;
  const bool isFirstRoller =
      (dGeomGetCategoryBits(contact.geom.g1) & (geom_kind::kWheel | geom_kind::kCaster)) != 0;
  if (rolls) {
    // the normal points into the first geom
    const SRigidBody& robot = isFirstRoller ? first : second;
    const dReal* const rotation = dBodyGetRotation(robot.Body);
    const CVector3 up(rotation[2], rotation[6], rotation[10]);
    if ((isFirstRoller ? 1.0 : -1.0) * up.DotProduct(normal) < kRollerSupport) {
      return;
    }
  }
  dSurfaceParameters& surface = contact.surface;
  surface = {};
  surface.mode = dContactApprox1;
  surface.mu = first.Friction * second.Friction;
  if ((kinds & geom_kind::kCaster) != 0) {
    const SRigidBody& robot = isFirstRoller ? first : second;
    surface.mode = dContactSoftERP | dContactSoftCFM;
    surface.mu = 0.0;
    surface.soft_erp = robot.CasterErp;
    surface.soft_cfm = robot.CasterCfm;
  } else if ((kinds & geom_kind::kWheel) != 0) {
    SetRollingDirection(contact, isFirstRoller ? first : second);
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

// A wheel is held along its axle, and rolls across it.
void CContactFinder::SetRollingDirection(dContact& contact, const SRigidBody& robot) {
  const dReal* const rotation = dBodyGetRotation(robot.Body);
  const CVector3 axle(rotation[1], rotation[5], rotation[9]);
  const CVector3 ahead = Cross(axle, FromODE(contact.geom.normal));
  const Real length = ahead.Length();
  if (length > 0.1) {
    SetDirection(contact, ahead / length);
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
