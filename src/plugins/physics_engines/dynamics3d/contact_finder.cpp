#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_finder.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/cylinder_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/face_contacts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/key_table.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_ghosts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_grips.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// contacts of two geoms: the corners of a face. Of the eight contacts that two boxes may have, ODE
// selects distant ones; the solver converges better with fewer.
constexpr int kMaxContacts = CContactCache::kMaxContacts;
// m/s; below this speed, the direction of sliding is ignored
constexpr Real kSlidingSpeed = 1e-4;
// cosine of the greatest angle between two grounds under a wheel of which only one bears it
constexpr Real kSameGround = 0.9;
// rows of the two hinges with motors of a robot
constexpr UInt32 kAxleRows = 12;
// rows of the motors of a planar drive
constexpr UInt32 kPlanarDriveRows = 3;
// rows of a hinge or a slider with its motor, and more than those of a ball joint
constexpr UInt32 kJointRows = 6;
// rows of a turret's pivot with its motor, and of the ball joint on its arm
constexpr UInt32 kGripRows = 9;

// numbers of pairs of solids, and of rollers with solids
constexpr UInt64 kMaxSolids = 1U << 12;
constexpr UInt64 kRollerKeys = kMaxSolids * kMaxSolids;

CVector3 InFrameOf(dBodyID part, const CVector3& point) {
  const dReal* const r = dBodyGetRotation(part);
  const CVector3 arm = point - FromODE(dBodyGetPosition(part));
  return CVector3(r[0] * arm.GetX() + r[4] * arm.GetY() + r[8] * arm.GetZ(),
                  r[1] * arm.GetX() + r[5] * arm.GetY() + r[9] * arm.GetZ(),
                  r[2] * arm.GetX() + r[6] * arm.GetY() + r[10] * arm.GetZ());
}

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

CVector3 VelocityAt(dBodyID part, const CVector3& point) {
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
  m_list.StartSubstep();
  m_cache.StartSubstep();
  ResetForest(m_parents, movables.size());
  m_islands.assign(movables.size(), {});
  const std::vector<SRigidPair>& pairs = m_broadPhase.FindPairs(
      movables, fixed, substep,
      m_settings.Stepper != SRigidSettings::EStepper::Direct && m_settings.Restitution == 0.0);
  WakeNeighbours(pairs, grips);
  for (SRigidBody* body : movables) {
    body->HasGroundContact = false;
    body->Supports = {};
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
    // what still dozes is not touched
    const bool isAsleep = (pair.First->IsMovable() && pair.First->Asleep) ||
                          (pair.Second->IsMovable() && pair.Second->Asleep);
    if (!isAsleep && (IsActive(*pair.First) || IsActive(*pair.Second))) {
      Touch(*pair.First, *pair.Second);
    }
  }
  // ghosts support no body, and keep none awake
  ghosts.ForEachMeeting([this](const SRigidBody& body, const SRigidBody& ghost) {
    if (IsActive(body) && !body.IsUpright) {
      TouchSolids(body, ghost);
    }
  });
  grips.ForEachGrip([this](const SRigidBody& holder, const SRigidBody& held) {
    Unite(holder, held);
    IslandOf(holder.ActiveNumber).Rows += kGripRows;
  });
  CountRows(movables);
  m_list.InheritForces();
}

// Awake bodies wake their neighbours, which wake theirs.
void CContactFinder::WakeNeighbours(const std::vector<SRigidPair>& pairs,
                                    const CRigidGrips& grips) const {
  bool changed = true;
  const auto wake = [&](SRigidBody& first, SRigidBody& second) {
    if (first.IsMovable() && second.IsMovable() && first.Asleep != second.Asleep &&
        IsWoken(first, second)) {
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

// What only dozes is woken by what touches it: it may be asleep for a tick at most.
bool CContactFinder::IsWoken(const SRigidBody& first, const SRigidBody& second) const {
  if (!(first.Asleep ? first : second).Dozes || first.HasDrive() || second.HasDrive()) {
    return true;
  }
  const Real reach = ComputeReach(first, second);
  const Real skins = std::min(first.Margin, kSkin) + std::min(second.Margin, kSkin);
  dContact contacts[kMaxContacts];
  for (const dGeomID one : first.Solids) {
    for (const dGeomID other : second.Solids) {
      if (DoBoundsOverlap(one, other, reach) &&
          FindFaceContacts(one, other, reach, skins, contacts) > 0) {
        return true;
      }
    }
  }
  return false;
}

void CContactFinder::Unite(const SRigidBody& first, const SRigidBody& second) {
  Connect(m_parents, first.ActiveNumber, second.ActiveNumber);
}

void CContactFinder::Touch(SRigidBody& first, SRigidBody& second) {
  const UInt32 before = GetNumContacts();
  TouchSolids(first, second);
  if (first.HasDrive()) {
    Roll(first, second);
  }
  if (second.HasDrive()) {
    Roll(second, first);
  }
  if (GetNumContacts() == before) {
    return;
  }
  if (first.IsMovable() && second.IsMovable()) {
    Unite(first, second);
  } else {
    IslandOf(first.IsMovable() ? first.ActiveNumber : second.ActiveNumber).Supported = true;
  }
}

// the distance below which two bodies may touch in the substep, m; at rest that of the skin, also
// of solids that have none
Real CContactFinder::ComputeReach(const SRigidBody& first, const SRigidBody& second) const {
  const Real rest = m_settings.Stepper == SRigidSettings::EStepper::Direct ? 0.0 : kSkin;
  const bool isOfRobots = first.HasDrive() && second.HasDrive();
  if (!isOfRobots &&
      (rest == 0.0 || (m_settings.Restitution > 0.0 && !IsBall(first) && !IsBall(second)))) {
    return rest;
  }
  const auto velocityOf = [](const SRigidBody& body) {
    return body.Body != nullptr ? FromODE(dBodyGetLinearVel(body.Body)) : CVector3();
  };
  Real speed = (velocityOf(first) - velocityOf(second)).Length();
  if (!isOfRobots && m_settings.Restitution == 0.0) {
    speed += ComputeRimSpeed(first) + ComputeRimSpeed(second);
  }
  return std::max(rest, kForesight * speed * m_substep);
}

void CContactFinder::TouchSolids(const SRigidBody& first, const SRigidBody& second) {
  const Real reach = ComputeReach(first, second);
  for (size_t a = 0; a < first.Solids.size(); ++a) {
    for (size_t b = 0; b < second.Solids.size(); ++b) {
      TouchPair(first, a, second, b, reach);
    }
  }
}

void CContactFinder::TouchPair(const SRigidBody& first, size_t a, const SRigidBody& second,
                               size_t b, Real reach) {
  const dGeomID one = first.Solids[a];
  const dGeomID other = second.Solids[b];
  // the base of an articulated body may be fixed
  const bool isFixed = dGeomGetBody(one) == nullptr && dGeomGetBody(other) == nullptr;
  if (isFixed || !DoBoundsOverlap(one, other, reach)) {
    return;
  }
  dContact contacts[kMaxContacts];
  const int count = FindLeveled(first, a, second, b, reach, contacts);
  const size_t before = GetNumContacts();
  for (int i = 0; i < count; ++i) {
    AddSolidContact(contacts[i], first, a, second, b);
  }
  if (count == 1 && GetNumContacts() > before && !first.HasDrive() && !second.HasDrive()) {
    const Real narrowest = std::min(first.IsMovable() ? first.Narrowest : HUGE_VAL,
                                    second.IsMovable() ? second.Narrowest : HUGE_VAL);
    m_list.Get().back().Patch = kPatchShare * narrowest;
  }
}

// Contacts of two solids, of those that do not move against each other the same as before.
int CContactFinder::FindLeveled(const SRigidBody& first, size_t a, const SRigidBody& second,
                                size_t b, Real reach, dContact* contacts) {
  const dGeomID one = first.Solids[a];
  const dGeomID other = second.Solids[b];
  if (m_settings.Stepper == SRigidSettings::EStepper::Direct) {
    return FindContacts(one, other, kMaxContacts, &contacts[0].geom, sizeof(dContact), reach);
  }
  // robots are anticipated by their speed; ghosts have no number of their own
  const bool isKept =
      !first.HasDrive() && !second.HasDrive() && first.Serial != 0 && second.Serial != 0;
  int count = -1;
  if (isKept) {
    const UInt64 key = ComputePairKey(first.Serial, second.Serial, a * kMaxSolids + b);
    count = m_cache.Find(key, first.IsMovable() ? first : second, one, other, contacts);
  }
  if (count < 0) {
    const Real skins = std::min(first.Margin, kSkin) + std::min(second.Margin, kSkin);
    count = FindFaceContacts(one, other, reach, skins, contacts);
    if (isKept) {
      m_cache.Store(contacts, count);
    }
  }
  return count;
}

// the links of an articulated body
void CContactFinder::TouchItself(const SRigidBody& body) {
  for (const auto& [first, second] : body.SelfPairs) {
    TouchPair(body, first, body, second, 0.0);
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
    for (size_t j = 0; j < ground.Solids.size(); ++j) {
      dContact contact;
      if (FindRollerContact(robot.Rollers[i], centre, ground, ground.Solids[j], contact.geom) &&
          (i >= robot.Wheels.size() || contact.geom.depth >= 0.0) &&
          up.DotProduct(FromODE(contact.geom.normal)) >= kRollerSupport) {
        AddRollerContact(contact, robot, i, ground, j);
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
    return contact.depth >= -kSkin;
  }
  const Real reach = roller.Radius + kSkin;
  dReal bounds[6];  // m: least and greatest x, y and z
  dGeomGetAABB(solid, bounds);
  for (UInt32 axis = 0; axis < 3; ++axis) {
    if (centre[axis] + reach < bounds[2 * axis] || centre[axis] - reach > bounds[2 * axis + 1]) {
      return false;
    }
  }
  dGeomSphereSetRadius(m_probe, reach);
  dGeomSetPosition(m_probe, centre.GetX(), centre.GetY(), centre.GetZ());
  if (FindContacts(m_probe, solid, 1, &contact, sizeof(dContact)) == 0) {
    return false;
  }
  contact.depth -= ground.Margin + kSkin;
  return contact.depth >= -kSkin;
}

// Casters slide without friction. A wheel's spring is compressed by its travel, which puts its
// contact where that of a rigid rim would be.
void CContactFinder::AddRollerContact(dContact& contact, SRigidBody& robot, size_t roller,
                                      const SRigidBody& ground, size_t solid) {
  contact.surface = {};
  contact.surface.mode = dContactApprox1;
  const UInt64 solids = kRollerKeys + roller * kMaxSolids + solid;
  if (contact.geom.depth < 0.0) {
    // it may come down in the substep, but not farther
    contact.surface.mode |= dContactMotionN;
    contact.surface.motionN = contact.geom.depth / m_substep;
    contact.geom.depth = 0.0;
  }
  if (roller >= robot.Wheels.size()) {
    Join(contact, robot, ground, 1, solids);
    return;
  }
  contact.surface.mode |= dContactSoftERP | dContactSoftCFM;
  contact.surface.mu = robot.Friction * ground.Friction;
  contact.surface.soft_erp = robot.WheelErp;
  contact.surface.soft_cfm = robot.WheelCfm;
  const CVector3 rim =
      LocateRoller(robot, roller) - FromODE(contact.geom.normal) * robot.WheelRadius;
  for (UInt32 i = 0; i < 3; ++i) {
    contact.geom.pos[i] = rim[i];
  }
  SRigidContact& added = Join(contact, robot, ground, contact.surface.mu > 0.0 ? 3 : 1, solids);
  added.Wheel = static_cast<UInt32>(roller);
  added.FirstPart = robot.Wheels[roller];
  BearOnce(robot, roller);
}

// The last contact is one of a wheel. Of two grounds on each other, such as a floor and a plate,
// only the upper one bears it: two would compress its spring twice.
void CContactFinder::BearOnce(SRigidBody& robot, size_t wheel) {
  std::vector<SRigidContact>& contacts = m_list.Get();
  SRigidContact& added = contacts.back();
  UInt32& support = robot.Supports[wheel];
  if (support == 0) {
    support = static_cast<UInt32>(contacts.size());
    return;
  }
  SRigidContact& other = contacts[support - 1];
  const Real cosine =
      FromODE(added.Contact.geom.normal).DotProduct(FromODE(other.Contact.geom.normal));
  if (cosine < kSameGround) {
    return;
  }
  if (added.Contact.geom.depth <= other.Contact.geom.depth) {
    added.IsVoid = true;
  } else {
    other.IsVoid = true;
    support = static_cast<UInt32>(contacts.size());
  }
}

// Bodies that will touch within the substep get a contact that stops them at its surface: without
// it, they would overlap by their path in a substep before ODE finds a contact.
void CContactFinder::AddSolidContact(dContact& contact, const SRigidBody& first, size_t a,
                                     const SRigidBody& second, size_t b) {
  dSurfaceParameters& surface = contact.surface;
  surface = {};
  contact.geom.depth -= first.Margin + second.Margin;
  if (contact.geom.depth < 0.0) {
    const Real gap = -contact.geom.depth;
    const CVector3 point = FromODE(contact.geom.pos);
    const CVector3 velocity = VelocityAt(dGeomGetBody(contact.geom.g1), point) -
                              VelocityAt(dGeomGetBody(contact.geom.g2), point);
    const Real approach = -velocity.DotProduct(FromODE(contact.geom.normal));
    if (gap > std::max(kForesight * approach * m_substep, 2.0 * kSkin) ||
        m_settings.Restitution > 0.0) {
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
  SRigidContact& added = Join(contact, first, second, surface.mu > 0.0 ? 3 : 1, a * kMaxSolids + b);
  added.FirstPart = dGeomGetBody(contact.geom.g1);
  added.SecondPart = dGeomGetBody(contact.geom.g2);
}

// @param solids  number of the two solids among those of both bodies.
SRigidContact& CContactFinder::Join(const dContact& contact, const SRigidBody& first,
                                    const SRigidBody& second, UInt32 rows, UInt64 solids) {
  const SRigidBody& counted = first.IsMovable() ? first : second;
  IslandOf(counted.ActiveNumber).Rows += rows;
  SRigidContact& added = m_list.Add();
  added.Contact = contact;
  added.First = &first;
  added.Second = &second;
  added.FirstPart = first.Body;
  added.SecondPart = second.Body;
  added.Counted = counted.ActiveNumber;
  added.Key = ComputePairKey(first.Serial, second.Serial, solids);
  added.Place = InFrameOf(counted.Body, FromODE(contact.geom.pos));
  return added;
}

void CContactFinder::CreateInODE(bool ofAll) {
  for (SRigidContact& contact : m_list.Get()) {
    if (!contact.IsVoid && (ofAll || IslandOf(FindRoot(contact.Counted)).HasJoints)) {
      SetDirectionInODE(contact);
      SoftenInODE(contact);
      dJointAttach(dJointCreateContact(m_world, m_contacts, &contact.Contact), contact.FirstPart,
                   contact.SecondPart);
    }
  }
}

// The world's softness of constraints, in m/s per N, is that of its joints: contacts of heavy
// bodies are harder, others as soft as the settings say.
void CContactFinder::SoftenInODE(SRigidContact& added) const {
  Real mass = HUGE_VAL;
  for (const dBodyID part : {added.FirstPart, added.SecondPart}) {
    if (part != nullptr && dBodyIsKinematic(part) == 0) {
      dMass own;
      dBodyGetMass(part, &own);
      mass = std::min<Real>(mass, own.mass);
    }
  }
  dSurfaceParameters& surface = added.Contact.surface;
  const Real softness =
      m_settings.ConstraintForceMixing / (mass < HUGE_VAL ? std::max<Real>(1.0, mass) : 1.0);
  surface.mode |= dContactSlip1 | dContactSlip2;
  surface.slip1 = surface.slip2 = softness;
  if (added.Wheel == SRigidContact::kNoWheel) {
    surface.mode |= dContactSoftCFM;
    surface.soft_cfm = softness;
  }
}

// ODE limits friction separately along two directions, so by a square. If one direction is that of
// the motion, or of gravity without motion, the limit is the same as that of Coulomb's circle. A
// wheel has friction along its axle, and rolls across it.
void CContactFinder::SetDirectionInODE(SRigidContact& added) const {
  dContact& contact = added.Contact;
  const CVector3 normal = FromODE(contact.geom.normal);
  if (added.Wheel != SRigidContact::kNoWheel) {
    const dReal* const rotation = dBodyGetRotation(added.First->Body);
    const CVector3 ahead = Cross(CVector3(rotation[1], rotation[5], rotation[9]), normal);
    const Real length = ahead.Length();
    if (length > 0.1) {
      SetDirection(contact, ahead / length);
    }
    return;
  }
  const CVector3 point = FromODE(contact.geom.pos);
  const CVector3 sliding = AlongSurface(
      VelocityAt(added.FirstPart, point) - VelocityAt(added.SecondPart, point), normal);
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
  return FindRootOf(m_parents, body);
}

void CContactFinder::CountRows(const std::vector<SRigidBody*>& movables) {
  for (UInt32 i = 0; i < movables.size(); ++i) {
    SIsland& own = m_islands[i];
    own.Rows += movables[i]->HasWheels() ? kAxleRows : 0;
    own.Rows += movables[i]->HasPlanarDrive() ? kPlanarDriveRows : 0;
    own.Rows += static_cast<UInt32>(kJointRows * movables[i]->Links.size());
    own.HasJoints = movables[i]->IsArticulated();
    own.Supported = own.Supported || dBodyIsKinematic(movables[i]->Body) != 0;
    const UInt32 root = FindRoot(i);
    if (root != i) {
      m_islands[root].Rows += own.Rows;
      m_islands[root].Supported = m_islands[root].Supported || own.Supported;
      m_islands[root].HasJoints = m_islands[root].HasJoints || own.HasJoints;
    }
  }
}

}  // namespace argos
