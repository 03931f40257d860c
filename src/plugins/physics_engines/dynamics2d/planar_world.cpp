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
  m_encounters.SetMargin(kAround * m_metresPerUnit);
  const b2BodyDef definition;
  m_ground = m_world.CreateBody(&definition);
}

CPlanarWorld::~CPlanarWorld() = default;

void CPlanarWorld::Reserve(size_t immovable, size_t passive, size_t driven) {
  m_immovable.reserve(immovable);
  m_passive.reserve(passive);
  m_driven.reserve(driven);
}

b2Body& CPlanarWorld::CreateBody(const SPlanarPose& pose, EPlanarKind kind,
                                 const SPlanarOwner& owner, bool grippable) {
  UInt32 number = m_numNumbers;
  if (m_freeNumbers.empty()) {
    ++m_numNumbers;
  } else {
    number = m_freeNumbers.back();
    m_freeNumbers.pop_back();
  }
  if (number >= m_grippable.size()) {
    m_grippable.resize(number + 1);
  }
  m_grippable[number] = grippable ? owner : SPlanarOwner();
  m_ghostFilter.SetDriven(number, kind == EPlanarKind::Driven);
  b2BodyDef definition;
  definition.type = kind == EPlanarKind::Immovable ? b2_staticBody : b2_dynamicBody;
  definition.position.Set(ToUnits(pose.X), ToUnits(pose.Y));
  definition.angle = static_cast<float>(pose.ComputeYaw());
  definition.userData.pointer = number;
  // a robot with its motor off, or standing still, is not at rest: it may start at any tick
  definition.allowSleep = kind != EPlanarKind::Driven;
  return *m_world.CreateBody(&definition);
}

void CPlanarWorld::DestroyBody(b2Body& body) {
  m_freeNumbers.push_back(GetBodyNumber(body));
  m_world.DestroyBody(&body);
}

void CPlanarWorld::AddImmovable(const SPlanarOwner& owner, const SBodyDescription& description,
                                const SPlanarPose& pose) {
  *owner.Handle = {EPlanarKind::Immovable, static_cast<UInt32>(m_immovable.size())};
  SImmovableBody& body = m_immovable.emplace_back();
  body.Owner = owner;
  body.Body = &CreateBody(pose, EPlanarKind::Immovable, owner, false);
  AddFixtures(*body.Body, description, m_settings.UnitsPerMetre, kImmovableFriction);
  body.Obstacles = DescribeFootprints(description, pose);
  m_obstaclesChanged = true;
}

void CPlanarWorld::AddPassive(const SPlanarOwner& owner, const SBodyDescription& description,
                              const SPlanarPose& pose) {
  *owner.Handle = {EPlanarKind::Passive, static_cast<UInt32>(m_passive.size())};
  SPassiveBody& body = m_passive.emplace_back();
  body.Owner = owner;
  body.Pose = pose;
  body.Body = &CreateBody(pose, EPlanarKind::Passive, owner, description.Grippable);
  AddFixtures(*body.Body, description, m_settings.UnitsPerMetre, kMovableFriction);
  SetMass(*body.Body, description, m_settings.UnitsPerMetre);
  body.X = body.Body->GetPosition().x;
  body.Y = body.Body->GetPosition().y;
  body.Angle = body.Body->GetAngle();
  body.Extent = ToUnits(ComputeNarrowestHalf(description));
  body.BoundingRadius = description.ComputeBoundingRadius();
  m_widestMovable = std::max(m_widestMovable, body.BoundingRadius);
  AddGroundFriction(*body.Body, description);
}

void CPlanarWorld::AddGroundFriction(b2Body& body, const SBodyDescription& description) {
  using EClass = SGroundFrictionDescription::EClass;
  SGroundFriction friction = {0.0, 0.0};
  if (description.GroundFriction) {
    friction = description.GroundFriction->Class == EClass::Box ? m_settings.BoxFriction
                                                                : m_settings.CylinderFriction;
  }
  // a body that nothing brakes must not be frozen when it creeps
  body.SetSleepingAllowed(friction.Force > 0.0 && friction.Torque > 0.0);
  if (friction.Force > 0.0 || friction.Torque > 0.0) {
    b2FrictionJointDef definition;
    definition.Initialize(m_ground, &body, body.GetWorldCenter());
    definition.maxForce = ToUnits(friction.Force);
    definition.maxTorque = ToUnits(friction.Torque * m_settings.UnitsPerMetre);
    definition.collideConnected = true;
    m_world.CreateJoint(&definition);
  }
}

void CPlanarWorld::AddDriven(const SPlanarOwner& owner, const SBodyDescription& description,
                             const SPlanarPose& pose, const Real* wheels) {
  const SDifferentialDriveDescription& drive = *description.Drive;
  const UInt32 slot = static_cast<UInt32>(m_driven.size());
  *owner.Handle = {EPlanarKind::Driven, slot};
  SDrivenBody& body = m_driven.emplace_back();
  body.Owner = owner;
  body.Pose = body.NextPose = pose;
  body.Wheels = wheels;
  body.Mass = description.Mass;
  body.Inertia =
      description.PlanarInertia ? *description.PlanarInertia : description.ComputePlanarInertia();
  body.InverseInterwheel = 1.0 / drive.InterwheelDistance;
  body.MaxSpeedChange = drive.MaxForce * m_settings.Tick / body.Mass;
  body.MaxYawRateChange = drive.MaxTorque * m_settings.Tick / body.Inertia;
  body.BoundingRadius = description.ComputeBoundingRadius();
  m_widestMovable = std::max(m_widestMovable, body.BoundingRadius);
  body.NarrowestHalf = ComputeNarrowestHalf(description);
  body.MaxSpeed = kMaxSubsteps * kMaxStepShare * body.NarrowestHalf / m_settings.Tick;
  body.IsDisc = IsCentredDisc(description);
  body.IsGrippable = description.Grippable;
  if (!body.IsDisc) {
    EnterPlay(slot, &description);
  }
}

// Gives a robot a body in Box2D. The description is needed only of one that is not a disc.
void CPlanarWorld::EnterPlay(UInt32 slot, const SBodyDescription* description) {
  SDrivenBody& body = m_driven[slot];
  b2Body& box2dBody = CreateBody(body.Pose, EPlanarKind::Driven, body.Owner, body.IsGrippable);
  if (body.IsDisc) {
    AddDisc(box2dBody, body.BoundingRadius, m_settings.UnitsPerMetre, kMovableFriction);
    b2MassData mass;
    mass.mass = static_cast<float>(body.Mass);
    mass.center.SetZero();
    mass.I = ToUnits(body.Inertia * m_settings.UnitsPerMetre);
    box2dBody.SetMassData(&mass);
  } else {
    AddFixtures(box2dBody, *description, m_settings.UnitsPerMetre, kMovableFriction);
    SetMass(box2dBody, *description, m_settings.UnitsPerMetre);
  }
  box2dBody.SetLinearVelocity(b2Vec2(ToUnits(body.Velocity.X), ToUnits(body.Velocity.Y)));
  box2dBody.SetAngularVelocity(static_cast<float>(body.Velocity.W));

  b2MotorJointDef definition;
  definition.bodyA = m_ground;
  definition.bodyB = &box2dBody;
  definition.collideConnected = true;
  definition.correctionFactor = 1.0F;  // the target of a substep is reached in it
  body.InPlay = static_cast<UInt32>(m_inPlay.size());
  SInPlay& play = m_inPlay.emplace_back();
  play.Slot = slot;
  play.Body = &box2dBody;
  play.Motor = static_cast<b2MotorJoint*>(m_world.CreateJoint(&definition));
}

void CPlanarWorld::LeavePlay(UInt32 slot) {
  const UInt32 number = m_driven[slot].InPlay;
  DestroyBody(*m_inPlay[number].Body);  // and its motor
  m_driven[slot].InPlay = SDrivenBody::kNotInPlay;
  if (number + 1 != m_inPlay.size()) {
    m_inPlay[number] = m_inPlay.back();
    m_driven[m_inPlay[number].Slot].InPlay = number;
  }
  m_inPlay.pop_back();
}

// Moves the last body of an array into the slot of one that is gone.
template <typename BODY>
void CPlanarWorld::FillSlot(std::vector<BODY>& bodies, UInt32 slot) {
  *bodies[slot].Owner.Handle = SPlanarHandle();
  if (slot + 1 != bodies.size()) {
    bodies[slot] = std::move(bodies.back());
    bodies[slot].Owner.Handle->Slot = slot;
  }
  bodies.pop_back();
}

void CPlanarWorld::Remove(const SPlanarHandle& handle) {
  const UInt32 slot = handle.Slot;
  if (IsInGrip(handle)) {
    ReleaseAllOf(handle);
  }
  switch (handle.Kind) {
    case EPlanarKind::Immovable:
      DestroyBody(*m_immovable[slot].Body);
      FillSlot(m_immovable, slot);
      m_obstaclesChanged = true;
      break;
    case EPlanarKind::Passive:
      DestroyBody(*m_passive[slot].Body);
      FillSlot(m_passive, slot);
      break;
    case EPlanarKind::Driven:
      if (m_driven[slot].HasManipulator) {
        RemoveManipulator(handle);
      }
      if (m_driven[slot].InPlay != SDrivenBody::kNotInPlay) {
        LeavePlay(slot);
      }
      FillSlot(m_driven, slot);
      if (slot < m_driven.size() && m_driven[slot].InPlay != SDrivenBody::kNotInPlay) {
        m_inPlay[m_driven[slot].InPlay].Slot = slot;
      }
      break;
  }
}

SPlanarVelocity CPlanarWorld::GetVelocity(const SPlanarHandle& handle) const {
  switch (handle.Kind) {
    case EPlanarKind::Passive:
      return m_passive[handle.Slot].Velocity;
    case EPlanarKind::Driven:
      return m_driven[handle.Slot].Velocity;
    default:
      return SPlanarVelocity();
  }
}

bool CPlanarWorld::IsAt(const SPlanarHandle& handle, const SPlanarPose& pose) const {
  if (handle.Kind == EPlanarKind::Immovable) {
    return false;
  }
  constexpr Real kRounding = 1e-12;  // of sines and cosines
  const SPlanarPose& mine =
      handle.Kind == EPlanarKind::Driven ? m_driven[handle.Slot].Pose : m_passive[handle.Slot].Pose;
  // half angles that differ by pi are one heading
  const Real cosine = mine.HalfCos * pose.HalfCos + mine.HalfSin * pose.HalfSin;
  const Real sine = mine.HalfSin * pose.HalfCos - mine.HalfCos * pose.HalfSin;
  return mine.X == pose.X && mine.Y == pose.Y && std::abs(sine) < kRounding &&
         std::abs(cosine) > 0.5;
}

void CPlanarWorld::SetVelocity(const SPlanarHandle& handle, const SPlanarVelocity& velocity) {
  b2Body* box2dBody = nullptr;
  if (handle.Kind == EPlanarKind::Passive) {
    m_passive[handle.Slot].Velocity = velocity;
    box2dBody = m_passive[handle.Slot].Body;
  } else if (handle.Kind == EPlanarKind::Driven) {
    SDrivenBody& body = m_driven[handle.Slot];
    body.Velocity = velocity;
    if (body.InPlay != SDrivenBody::kNotInPlay) {
      box2dBody = m_inPlay[body.InPlay].Body;
    }
  }
  if (box2dBody != nullptr) {
    box2dBody->SetLinearVelocity(b2Vec2(ToUnits(velocity.X), ToUnits(velocity.Y)));
    box2dBody->SetAngularVelocity(static_cast<float>(velocity.W));
  }
}

// Box2D takes memory for bodies, contacts and joints in blocks that it keeps. Making as many as a
// swarm of this size is likely to need, and taking them away again, leaves the blocks to be used in
// ticks; so do the vectors here.
void CPlanarWorld::ReserveForTick() {
  constexpr size_t kClusterSize = 4;  // discs, of which each touches each
  // an eighth in play is what a swarm at the benchmark's density comes to; a denser one takes more
  // memory while it condenses
  const size_t inPlay = m_driven.size() / 8 + 64;
  const size_t numExtras = inPlay / kClusterSize * kClusterSize;

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
  for (size_t i = 0; i < numExtras; ++i) {
    // outside everything, and each cluster apart from the others
    const size_t numClustersBefore = i / kClusterSize;
    const auto cluster = static_cast<float>(numClustersBefore);
    definition.position.Set(everything.upperBound.x + 10.0F,
                            everything.lowerBound.y + 10.0F * cluster);
    b2Body* extra = m_world.CreateBody(&definition);
    extra->CreateFixture(&disc, 1.0F);
    b2MotorJointDef motor;
    motor.bodyA = m_ground;
    motor.bodyB = extra;
    m_world.CreateJoint(&motor);
    extras.push_back(extra);
  }
  ReserveGrips(extras);
  m_world.Step(0.0F, 0, 0);  // finds contacts, moves nothing
  for (b2Body* extra : extras) {
    m_world.DestroyBody(extra);
  }
  if (!m_manipulators.empty()) {
    m_manipulators.reserve(m_driven.capacity());
  }
  m_overlaps.Reserve(2 * (inPlay + m_passive.capacity()) + m_immovable.size());
  m_inPlay.reserve(inPlay);
  m_freeNumbers.reserve(inPlay);
  m_grippable.reserve(m_numNumbers + inPlay);
  m_ghostFilter.Reserve(m_numNumbers + inPlay);
  m_encounters.Reserve(m_driven.capacity());
}

}  // namespace argos
