#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>

#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// Coefficients of contact friction; two bodies in contact have the product of theirs. Source: the
// values of ARGoS 3's dynamics2d.
constexpr Real kMovableFriction = 0.7;
constexpr Real kImmovableFriction = 0.1;

// finds the number of a fixture's box in the broad phase, which Box2D does not tell
struct SProxyFinder {
  const b2BroadPhase& BroadPhase;
  const b2Fixture* Fixture;
  int32 Proxy = b2BroadPhase::e_nullProxy;

  bool QueryCallback(int32 proxy) {
    if (static_cast<b2FixtureProxy*>(BroadPhase.GetUserData(proxy))->fixture == Fixture) {
      Proxy = proxy;
      return false;
    }
    return true;
  }
};

int32 FindProxy(const b2BroadPhase& broadPhase, const b2Fixture& fixture) {
  SProxyFinder finder = {broadPhase, &fixture};
  broadPhase.Query(&finder, fixture.GetAABB(0));
  return finder.Proxy;
}

// Box2D fills a table of contact types on the first contact of the process. Several worlds are
// stepped at the same time, so this must have happened before.
bool MakeFirstContact() {
  b2World world(b2Vec2(0.0F, 0.0F));
  b2CircleShape disc;
  disc.m_radius = 1.0F;
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  for (int i = 0; i < 2; ++i) {
    world.CreateBody(&definition)->CreateFixture(&disc, 1.0F);
  }
  world.Step(0.0F, 1, 1);
  return true;
}

}  // namespace

CPlanarWorld::CPlanarWorld(const SPlanarSettings& settings)
    : m_settings(settings),
      m_metresPerUnit(1.0 / settings.UnitsPerMetre),
      m_world(b2Vec2(0.0F, 0.0F)) {
  static const bool kHadFirstContact = MakeFirstContact();
  static_cast<void>(kHadFirstContact);
  m_world.SetContinuousPhysics(false);
  m_world.SetAutoClearForces(false);  // there are none
  m_world.SetContactListener(nullptr);
  m_world.SetContactFilter(nullptr);
  const b2BodyDef definition;
  m_ground = m_world.CreateBody(&definition);
}

CPlanarWorld::~CPlanarWorld() = default;

// What is const of it is not the object, but only what Box2D hands out: "for testing". The search for
// new contacts and the boxes of the broad phase are reached only through it.
b2ContactManager& CPlanarWorld::GetContactManager() {
  return const_cast<b2ContactManager&>(m_world.GetContactManager());
}

b2Body& CPlanarWorld::CreateBody(const SBodyDescription& description, const SPlanarPose& pose,
                                 EPlanarKind kind, UInt32 slot) {
  UInt32 number = static_cast<UInt32>(m_references.size());
  if (m_freeNumbers.empty()) {
    m_references.emplace_back();
  } else {
    number = m_freeNumbers.back();
    m_freeNumbers.pop_back();
  }
  m_references[number] = {kind, slot};

  b2BodyDef definition;
  definition.type = kind == EPlanarKind::Immovable ? b2_staticBody : b2_dynamicBody;
  definition.position.Set(ToUnits(pose.X), ToUnits(pose.Y));
  definition.angle = static_cast<float>(pose.ComputeYaw());
  definition.userData.pointer = number;
  // robots are put to sleep and woken by this class
  definition.allowSleep = kind != EPlanarKind::Driven;
  b2Body& body = *m_world.CreateBody(&definition);
  const Real friction = kind == EPlanarKind::Immovable ? kImmovableFriction : kMovableFriction;
  AddFixtures(body, description, m_settings.UnitsPerMetre, friction);
  if (kind != EPlanarKind::Immovable) {
    SetMass(body, description, m_settings.UnitsPerMetre);
  }
  m_mayHaveNewContacts = true;
  return body;
}

void CPlanarWorld::DestroyBody(b2Body& body) {
  m_freeNumbers.push_back(GetBodyNumber(body));
  m_world.DestroyBody(&body);
}

void CPlanarWorld::AddImmovable(const SPlanarOwner& owner, const SBodyDescription& description,
                                const SPlanarPose& pose) {
  const UInt32 slot = static_cast<UInt32>(m_immovable.size());
  m_immovable.push_back({owner, &CreateBody(description, pose, EPlanarKind::Immovable, slot)});
  *owner.Handle = {EPlanarKind::Immovable, slot};
}

void CPlanarWorld::AddPassive(const SPlanarOwner& owner, const SBodyDescription& description,
                              const SPlanarPose& pose) {
  const UInt32 slot = static_cast<UInt32>(m_passive.size());
  SPassiveBody body;
  body.Pose = pose;
  body.Owner = owner;
  body.Body = &CreateBody(description, pose, EPlanarKind::Passive, slot);
  SetUpPassive(body, description);
  m_passive.push_back(body);
  *owner.Handle = {EPlanarKind::Passive, slot};
}

void CPlanarWorld::SetUpPassive(SPassiveBody& body, const SBodyDescription& description) {
  using EClass = SGroundFrictionDescription::EClass;
  body.X = body.Body->GetPosition().x;
  body.Y = body.Body->GetPosition().y;
  body.Angle = body.Body->GetAngle();
  body.Extent = ToUnits(ComputeNarrowestHalf(description));
  body.GroundFriction = nullptr;

  SGroundFriction friction = {0.0, 0.0};
  if (description.GroundFriction) {
    friction = description.GroundFriction->Class == EClass::Box ? m_settings.BoxFriction
                                                                : m_settings.CylinderFriction;
  }
  // a body that nothing brakes must not be frozen when it creeps
  body.Body->SetSleepingAllowed(friction.Force > 0.0 && friction.Torque > 0.0);
  if (friction.Force > 0.0 || friction.Torque > 0.0) {
    b2FrictionJointDef definition;
    definition.Initialize(m_ground, body.Body, body.Body->GetWorldCenter());
    definition.maxForce = ToUnits(friction.Force);
    definition.maxTorque = static_cast<float>(friction.Torque * m_settings.UnitsPerMetre *
                                              m_settings.UnitsPerMetre);
    definition.collideConnected = true;
    body.GroundFriction = static_cast<b2FrictionJoint*>(m_world.CreateJoint(&definition));
  }
}

void CPlanarWorld::AddDriven(const SPlanarOwner& owner, const SBodyDescription& description,
                             const SPlanarPose& pose, const Real* wheels) {
  const UInt32 slot = static_cast<UInt32>(m_driven.size());
  SDrivenBody& body = m_driven.emplace_back();
  body.Pose = body.NextPose = pose;
  body.Owner = owner;
  body.Wheels = wheels;
  body.Body = &CreateBody(description, pose, EPlanarKind::Driven, slot);
  SetUpDriven(body, slot, description);
  *owner.Handle = {EPlanarKind::Driven, slot};
}

void CPlanarWorld::SetUpDriven(SDrivenBody& body, UInt32 slot,
                               const SBodyDescription& description) {
  const SDifferentialDriveDescription& drive = *description.Drive;
  const Real narrowest = ComputeNarrowestHalf(description);
  body.InverseInterwheel = 1.0 / drive.InterwheelDistance;
  body.MaxSpeedChange = drive.MaxForce * m_settings.Tick / description.Mass;
  const Real inertia = static_cast<Real>(body.Body->GetInertia()) * m_metresPerUnit * m_metresPerUnit;
  body.MaxYawRateChange = drive.MaxTorque * m_settings.Tick / inertia;
  body.MaxSpeed = kMaxSubsteps * kMaxStepShare * narrowest / m_settings.Tick;
  body.Extent = ToUnits(narrowest);
  body.IsDisc = IsCentredDisc(description);
  body.Radius = body.Extent + kShapeMargin;
  body.InPlay = SDrivenBody::kNotInPlay;
  body.Body->SetAwake(false);
  if (body.IsDisc) {
    body.Proxy = FindProxy(GetContactManager().m_broadPhase, *body.Body->GetFixtureList());
    ReadSafeRegion(body);
  } else {
    BringIntoPlay(slot, 0.0);
  }
}

template <typename BODY>
void CPlanarWorld::RemoveFrom(std::vector<BODY>& bodies, UInt32 slot) {
  DestroyBody(*bodies[slot].Body);
  *bodies[slot].Owner.Handle = SPlanarHandle();
  if (slot + 1 != bodies.size()) {
    bodies[slot] = bodies.back();
    bodies[slot].Owner.Handle->Slot = slot;
    m_references[GetBodyNumber(*bodies[slot].Body)].Slot = slot;
  }
  bodies.pop_back();
}

void CPlanarWorld::Remove(const SPlanarHandle& handle) {
  const UInt32 slot = handle.Slot;
  if (handle.Kind == EPlanarKind::Immovable) {
    RemoveFrom(m_immovable, slot);
  } else if (handle.Kind == EPlanarKind::Passive) {
    RemoveFrom(m_passive, slot);
  } else {
    if (m_driven[slot].InPlay != SDrivenBody::kNotInPlay) {
      TakeOutOfPlay(slot);
    }
    RemoveFrom(m_driven, slot);
    if (slot < m_driven.size() && m_driven[slot].InPlay != SDrivenBody::kNotInPlay) {
      m_inPlay[m_driven[slot].InPlay].Slot = slot;
    }
  }
}

void CPlanarWorld::MoveTo(const SPlanarHandle& handle, const SBodyDescription& description,
                          const SPlanarPose& pose) {
  const UInt32 slot = handle.Slot;
  // a new Box2D body has no impulses left over from contacts at the old place
  if (handle.Kind == EPlanarKind::Immovable) {
    SImmovableBody& body = m_immovable[slot];
    DestroyBody(*body.Body);
    body.Body = &CreateBody(description, pose, handle.Kind, slot);
  } else if (handle.Kind == EPlanarKind::Passive) {
    SPassiveBody& body = m_passive[slot];
    DestroyBody(*body.Body);
    body.Body = &CreateBody(description, pose, handle.Kind, slot);
    body.Pose = pose;
    SetUpPassive(body, description);
  } else {
    SDrivenBody& body = m_driven[slot];
    if (body.InPlay != SDrivenBody::kNotInPlay) {
      TakeOutOfPlay(slot);
    }
    DestroyBody(*body.Body);
    body.Body = &CreateBody(description, pose, handle.Kind, slot);
    body.Pose = body.NextPose = pose;
    body.Velocity = body.NextVelocity = SPlanarVelocity();
    SetUpDriven(body, slot, description);
  }
}

// Box2D takes memory for contacts and joints in blocks that it keeps. Making as many as a swarm of
// this size is likely to need, and taking them away again, leaves the blocks to be used in ticks.
void CPlanarWorld::Reserve() {
  constexpr size_t kClusterSize = 32;  // discs, of which each touches each
  constexpr size_t kContactsInCluster = kClusterSize * (kClusterSize - 1) / 2;
  const size_t bodies = m_driven.size() + m_passive.size();
  const size_t clusters = bodies / kContactsInCluster + 1;
  const size_t motors = m_driven.size() / 4 + 64;

  b2AABB everything;
  everything.lowerBound.SetZero();
  everything.upperBound.SetZero();
  for (b2Body* body = m_world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr;
         fixture = fixture->GetNext()) {
      everything.Combine(fixture->GetAABB(0));
    }
  }
  b2CircleShape disc;
  disc.m_radius = 1.0F;
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  std::vector<b2Body*> extras;
  for (size_t i = 0; i < clusters * kClusterSize; ++i) {
    // outside everything, and each cluster apart from the others
    const float cluster = static_cast<float>(i / kClusterSize);
    definition.position.Set(everything.upperBound.x + 10.0F, everything.lowerBound.y + 10.0F * cluster);
    extras.push_back(m_world.CreateBody(&definition));
    extras.back()->CreateFixture(&disc, 1.0F);
  }
  for (size_t i = 0; i < motors; ++i) {
    b2MotorJointDef motor;
    motor.bodyA = m_ground;
    motor.bodyB = extras.front();
    m_world.CreateJoint(&motor);
  }
  FindNewContacts();
  for (b2Body* extra : extras) {
    m_world.DestroyBody(extra);
  }
  m_mayHaveNewContacts = true;

  m_overlaps.Reserve(2 * bodies + 64);
  m_inPlay.reserve(m_driven.size());
  m_leaving.reserve(m_driven.size());
}

}  // namespace argos
