#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_finder.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_ghosts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_grips.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// contacts of two geoms: the corners of a face. Of the eight contacts that two boxes may have, ODE
// selects distant ones; the solver converges better with fewer.
constexpr int kMaxContacts = 4;
// m/s; below this speed, the direction of sliding is ignored
constexpr Real kSlidingSpeed = 1e-4;
// a contact is anticipated if it will occur within that many substeps at the present speed
constexpr Real kForesight = 1.5;
// rows of the two hinges with motors of a robot
constexpr UInt32 kAxleRows = 12;
// rows of the motors of a planar drive
constexpr UInt32 kPlanarDriveRows = 3;
// rows of a hinge or a slider with its motor, and more than those of a ball joint
constexpr UInt32 kJointRows = 6;
// rows of a turret's pivot with its motor, and of the ball joint on its arm
constexpr UInt32 kGripRows = 9;

// @return true if the body is movable and awake.
bool IsActive(const SRigidBody& body) {
  return body.IsMovable() && !body.Asleep;
}

bool DoBoundsOverlap(dGeomID first, dGeomID second, Real reach) {
  dReal a[6];  // m: least and greatest x, y and z
  dReal b[6];
  dGeomGetAABB(first, a);
  dGeomGetAABB(second, b);
  return a[0] <= b[1] + reach && b[0] <= a[1] + reach && a[2] <= b[3] + reach &&
         b[2] <= a[3] + reach && a[4] <= b[5] + reach && b[4] <= a[5] + reach;
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
    : m_settings(settings),
      m_world(world),
      m_contacts(dJointGroupCreate(0)),
      m_probe(dCreateSphere(nullptr, 1.0)) {}

CContactFinder::~CContactFinder() {
  dGeomDestroy(m_probe);
  dJointGroupDestroy(m_contacts);
}

void CContactFinder::Reserve(size_t movables, size_t fixed) {
  m_parents.reserve(movables);
  m_islands.reserve(movables);
  m_broadPhase.Reserve(movables + fixed);
}

void CContactFinder::Clear() {
  dJointGroupEmpty(m_contacts);
}

void CContactFinder::Find(const std::vector<SRigidBody*>& movables,
                          const std::vector<SRigidBody*>& fixed,
                          const std::vector<SRigidBody*>& planes, const CRigidGrips& grips,
                          const CRigidGhosts& ghosts, const CVector3& gravity, Real substep) {
  m_gravity = gravity;
  m_substep = substep;
  m_numContacts = 0;
  m_parents.resize(movables.size());
  for (UInt32 i = 0; i < m_parents.size(); ++i) {
    m_parents[i] = i;
  }
  m_islands.assign(movables.size(), {});
  const std::vector<SRigidPair>& pairs = m_broadPhase.FindPairs(movables, fixed);
  WakeNeighbours(pairs, grips);
  for (SRigidBody* body : movables) {
    body->HasGroundContact = false;
    if (!body->Asleep) {
      TouchItself(*body);
    }
    for (size_t i = 0; !body->Asleep && i < planes.size(); ++i) {
      if (body->Low.GetZ() <= planes[i]->High.GetZ() &&
          body->High.GetZ() >= planes[i]->Low.GetZ()) {
        Touch(*body, *planes[i]);
      }
    }
  }
  for (const SRigidPair& pair : pairs) {
    if (IsActive(*pair.First) || IsActive(*pair.Second)) {
      Touch(*pair.First, *pair.Second);
    }
  }
  // ghosts support no body, and keep none awake
  ghosts.ForEachMeeting([this](const SRigidBody& body, const SRigidBody& ghost) {
    if (IsActive(body)) {
      TouchSolids(body, ghost);
    }
  });
  grips.ForEachGrip([this](const SRigidBody& holder, const SRigidBody& held) {
    Unite(holder, held);
    IslandOf(holder.ActiveNumber).Rows += kGripRows;
  });
  CountRows(movables);
}

// Awake bodies wake their neighbours, which wake theirs.
void CContactFinder::WakeNeighbours(const std::vector<SRigidPair>& pairs,
                                    const CRigidGrips& grips) {
  bool changed = true;
  const auto wake = [&changed](SRigidBody& first, SRigidBody& second) {
    if (first.IsMovable() && second.IsMovable() && first.Asleep != second.Asleep) {
      WakeRigidBody(first.Asleep ? first : second);
      changed = true;
    }
  };
  while (changed) {
    changed = false;
    for (const SRigidPair& pair : pairs) {
      wake(*pair.First, *pair.Second);
    }
    grips.ForEachGrip(wake);
  }
}

void CContactFinder::Unite(const SRigidBody& first, const SRigidBody& second) {
  const UInt32 a = FindRoot(first.ActiveNumber);
  const UInt32 b = FindRoot(second.ActiveNumber);
  // the lower number leads
  m_parents[std::max(a, b)] = std::min(a, b);
}

void CContactFinder::Touch(SRigidBody& first, SRigidBody& second) {
  const UInt32 before = m_numContacts;
  TouchSolids(first, second);
  if (first.HasDrive()) {
    Roll(first, second);
  }
  if (second.HasDrive()) {
    Roll(second, first);
  }
  if (m_numContacts == before) {
    return;
  }
  if (first.IsMovable() && second.IsMovable()) {
    Unite(first, second);
  } else {
    IslandOf(first.IsMovable() ? first.ActiveNumber : second.ActiveNumber).Supported = true;
  }
}

// the distance below which two robots may touch in the substep, m
Real CContactFinder::ComputeReach(const SRigidBody& first, const SRigidBody& second) const {
  if (!first.HasDrive() || !second.HasDrive()) {
    return 0.0;
  }
  const CVector3 speed =
      FromODE(dBodyGetLinearVel(first.Body)) - FromODE(dBodyGetLinearVel(second.Body));
  return kForesight * speed.Length() * m_substep;
}

void CContactFinder::TouchSolids(const SRigidBody& first, const SRigidBody& second) {
  const Real reach = ComputeReach(first, second);
  for (const dGeomID a : first.Solids) {
    for (const dGeomID b : second.Solids) {
      TouchPair(first, a, second, b, reach);
    }
  }
}

void CContactFinder::TouchPair(const SRigidBody& first, dGeomID a, const SRigidBody& second,
                               dGeomID b, Real reach) {
  // the base of an articulated body may be fixed
  const bool isFixed = dGeomGetBody(a) == nullptr && dGeomGetBody(b) == nullptr;
  if (isFixed || !DoBoundsOverlap(a, b, reach)) {
    return;
  }
  dContact contacts[kMaxContacts];
  const int count = FindContacts(a, b, kMaxContacts, &contacts[0].geom, sizeof(dContact), reach);
  for (int i = 0; i < count; ++i) {
    AddSolidContact(contacts[i], first, second);
  }
}

// the links of an articulated body
void CContactFinder::TouchItself(const SRigidBody& body) {
  for (const auto& [first, second] : body.SelfPairs) {
    TouchPair(body, body.Solids[first], body, body.Solids[second], 0.0);
  }
}

void CContactFinder::Roll(SRigidBody& robot, const SRigidBody& ground) {
  const dReal* const rotation = dBodyGetRotation(robot.Body);
  const CVector3 up(rotation[2], rotation[6], rotation[10]);
  for (size_t i = robot.GetFirstRoller(); i < robot.Rollers.size(); ++i) {
    // wheels without load have no grip
    if (i < robot.Wheels.size() && robot.WheelCfm == 0.0) {
      continue;
    }
    const CVector3 centre = LocateRoller(robot, i);
    for (const dGeomID solid : ground.Solids) {
      dContact contact;
      if (FindRollerContact(robot.Rollers[i], centre, ground, solid, contact.geom) &&
          up.DotProduct(FromODE(contact.geom.normal)) >= kRollerSupport) {
        AddRollerContact(contact, robot, i, ground);
        robot.HasGroundContact = true;
      }
    }
  }
}

// The normal points into the roller.
bool CContactFinder::FindRollerContact(const SRoller& roller, const CVector3& centre,
                                       const SRigidBody& ground, dGeomID solid,
                                       dContactGeom& contact) const {
  if (ground.IsCeiling()) {
    return false;
  }
  if (ground.IsPlane()) {
    contact.normal[0] = contact.normal[1] = 0.0;
    contact.normal[2] = 1.0;
    contact.depth = ground.High.GetZ() - (centre.GetZ() - roller.Radius);
    contact.pos[0] = centre.GetX();
    contact.pos[1] = centre.GetY();
    contact.pos[2] = centre.GetZ() - roller.Radius;
    return contact.depth >= 0.0;
  }
  dReal bounds[6];  // m: least and greatest x, y and z
  dGeomGetAABB(solid, bounds);
  for (UInt32 axis = 0; axis < 3; ++axis) {
    if (centre[axis] + roller.Radius < bounds[2 * axis] ||
        centre[axis] - roller.Radius > bounds[2 * axis + 1]) {
      return false;
    }
  }
  dGeomSphereSetRadius(m_probe, roller.Radius);
  dGeomSetPosition(m_probe, centre.GetX(), centre.GetY(), centre.GetZ());
  return FindContacts(m_probe, solid, 1, &contact, sizeof(dContact)) > 0;
}

// Casters slide without friction. A wheel has friction along its axle, and rolls across it. Its
// spring is compressed by its travel, which puts its contact where that of a rigid rim would be.
void CContactFinder::AddRollerContact(dContact& contact, const SRigidBody& robot, size_t roller,
                                      const SRigidBody& ground) {
  contact.surface = {};
  contact.surface.mode = dContactApprox1;
  if (roller >= robot.Wheels.size()) {
    Join(contact, robot.Body, ground.Body, 1, robot);
    return;
  }
  contact.surface.mode |= dContactSoftERP | dContactSoftCFM;
  contact.surface.mu = robot.Friction * ground.Friction;
  contact.surface.soft_erp = robot.WheelErp;
  contact.surface.soft_cfm = robot.WheelCfm;
  const CVector3 normal = FromODE(contact.geom.normal);
  const CVector3 rim = LocateRoller(robot, roller) - normal * robot.WheelRadius;
  for (UInt32 i = 0; i < 3; ++i) {
    contact.geom.pos[i] = rim[i];
  }
  const dReal* const rotation = dBodyGetRotation(robot.Body);
  const CVector3 axle(rotation[1], rotation[5], rotation[9]);
  const CVector3 ahead = Cross(axle, normal);
  const Real length = ahead.Length();
  if (length > 0.1) {
    SetDirection(contact, ahead / length);
  }
  Join(contact, robot.Wheels[roller], ground.Body, contact.surface.mu > 0.0 ? 3 : 1, robot);
}

// Bodies that will touch within the substep get a contact that stops them at its surface: without
// it, they would overlap by their path in a substep before ODE finds a contact.
void CContactFinder::AddSolidContact(dContact& contact, const SRigidBody& first,
                                     const SRigidBody& second) {
  dSurfaceParameters& surface = contact.surface;
  surface = {};
  contact.geom.depth -= first.Margin + second.Margin;
  if (contact.geom.depth < 0.0) {
    const Real gap = -contact.geom.depth;
    const CVector3 point = FromODE(contact.geom.pos);
    const CVector3 velocity =
        VelocityAt(contact.geom.g1, point) - VelocityAt(contact.geom.g2, point);
    const Real approach = -velocity.DotProduct(FromODE(contact.geom.normal));
    if (gap > kForesight * approach * m_substep || m_settings.Restitution > 0.0) {
      return;
    }
    contact.geom.depth = 0.0;
    surface.mode |= dContactMotionN;
    surface.motionN = -gap / m_substep;
  }
  surface.mode |= dContactApprox1;
  surface.mu = first.Friction * second.Friction;
  if (m_settings.Restitution > 0.0) {
    surface.mode |= dContactBounce;
    surface.bounce = m_settings.Restitution;
    surface.bounce_vel = m_settings.BounceSpeed;
  }
  SetSlidingDirection(contact);
  Join(contact, dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2),
       surface.mu > 0.0 ? 3 : 1, first.IsMovable() ? first : second);
}

void CContactFinder::Join(const dContact& contact, dBodyID first, dBodyID second, UInt32 rows,
                          const SRigidBody& counted) {
  dJointAttach(dJointCreateContact(m_world, m_contacts, &contact), first, second);
  IslandOf(counted.ActiveNumber).Rows += rows;
  ++m_numContacts;
}

// ODE limits friction separately along two directions, so by a square. If one direction is that of
// the motion, or of gravity without motion, the limit is the same as that of Coulomb's circle.
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
  ARGOS_ASSERT(body < m_parents.size(), "there is no movable body with the number " << body);
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
    own.Rows += movables[i]->HasPlanarDrive() ? kPlanarDriveRows : 0;
    own.Rows += static_cast<UInt32>(kJointRows * movables[i]->Links.size());
    own.Supported = own.Supported || dBodyIsKinematic(movables[i]->Body) != 0;
    const UInt32 root = FindRoot(i);
    if (root != i) {
      m_islands[root].Rows += own.Rows;
      m_islands[root].Supported = m_islands[root].Supported || own.Supported;
    }
  }
  // the rows of all roots are complete now
  for (UInt32 i = 0; i < movables.size(); ++i) {
    m_mostRows = std::max(m_mostRows, m_islands[i].Rows);
  }
}

}  // namespace argos
