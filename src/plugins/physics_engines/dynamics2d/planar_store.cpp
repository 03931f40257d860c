#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/overlap_solver.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace argos {

namespace {

// Box2D fills a static table of contact types on the first contact of the process. As several
// worlds are stepped in parallel, this must have happened before.
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

CPlanarStore::CPlanarStore(const SPlanarSettings& settings)
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

void CPlanarStore::Reserve(size_t immovable, size_t passive, size_t driven) {
  m_immovable.reserve(immovable);
  m_passive.reserve(passive);
  m_driven.reserve(driven);
  const std::array<size_t, 3> counts = {immovable, passive, driven};
  for (size_t kind = 0; kind < counts.size(); ++kind) {
    m_generations[kind].Reserve(counts[kind]);
  }
}

void CPlanarStore::ReserveNumbers(size_t additional) {
  m_freeNumbers.reserve(additional);
  m_grippable.reserve(m_numNumbers + additional);
  m_users.reserve(m_numNumbers + additional);
}

b2Body& CPlanarStore::CreateBody(const SPlanarPose& pose, EPlanarKind kind,
                                 const SPlanarOwner& owner, bool grippable) {
  UInt32 number = m_numNumbers;
  if (m_freeNumbers.empty()) {
    ++m_numNumbers;
    m_grippable.emplace_back();
    m_users.emplace_back();
  } else {
    number = m_freeNumbers.back();
    m_freeNumbers.pop_back();
  }
  m_grippable[number] = grippable ? owner : SPlanarOwner();
  m_users[number] = kind == EPlanarKind::Driven ? EUser::Robot : EUser::Other;
  b2BodyDef definition;
  definition.type = kind == EPlanarKind::Immovable ? b2_staticBody : b2_dynamicBody;
  definition.position.Set(ToUnits(pose.X), ToUnits(pose.Y));
  definition.angle = static_cast<float>(pose.ComputeYaw());
  definition.userData.pointer = number;
  // a robot may start at any tick, so it never sleeps
  definition.allowSleep = kind != EPlanarKind::Driven;
  return *m_world.CreateBody(&definition);
}

void CPlanarStore::DestroyBody(b2Body& body) {
  const UInt32 number = GetBodyNumber(body);
  CheckNumber(number);
  m_users[number] = EUser::None;
  m_freeNumbers.push_back(number);
  m_world.DestroyBody(&body);
}

// of a body that is about to get the last slot
SPlanarHandle CPlanarStore::MakeHandle(EPlanarKind kind, size_t slot) {
  return {kind, static_cast<UInt32>(slot), m_generations[static_cast<size_t>(kind)].Add()};
}

void CPlanarStore::AddImmovable(const SPlanarOwner& owner, const SBodyDescription& description,
                                const SPlanarPose& pose) {
  *owner.Handle = MakeHandle(EPlanarKind::Immovable, m_immovable.size());
  SImmovableBody& body = m_immovable.emplace_back();
  body.Owner = owner;
  body.Body = &CreateBody(pose, EPlanarKind::Immovable, owner, false);
  AddFixtures(*body.Body, description, m_settings.UnitsPerMetre, kImmovableFriction);
  body.Obstacles = DescribeFootprints(description, pose);
  m_obstaclesChanged = true;
}

std::vector<SFootprint> CPlanarStore::ListObstacles() {
  std::vector<SFootprint> obstacles;
  for (const SImmovableBody& body : m_immovable) {
    obstacles.insert(obstacles.end(), body.Obstacles.begin(), body.Obstacles.end());
  }
  m_obstaclesChanged = false;
  return obstacles;
}

void CPlanarStore::AddPassive(const SPlanarOwner& owner, const SBodyDescription& description,
                              const SPlanarPose& pose) {
  *owner.Handle = MakeHandle(EPlanarKind::Passive, m_passive.size());
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
  body.Solid = DescribeSolid(description, ChooseGroundFriction(description, m_settings.BoxFriction,
                                                               m_settings.CylinderFriction));
  m_widestMovable = std::max(m_widestMovable, body.BoundingRadius);
  AddGroundFriction(*body.Body, body.Solid.Friction);
  body.Body->SetEnabled(false);
}

void CPlanarStore::AddGroundFriction(b2Body& body, const SGroundFriction& friction) {
  // Box2D would freeze a slow body even if no friction stops it
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

const SDrivenKind& CPlanarStore::GetOrAddKind(const SDrivenKind& kind) {
  // the kind added last is most often the next one, too
  const auto found = std::find(m_drivenKinds.rbegin(), m_drivenKinds.rend(), kind);
  return found != m_drivenKinds.rend() ? *found : m_drivenKinds.emplace_back(kind);
}

void CPlanarStore::AddDriven(const SPlanarOwner& owner, const SBodyDescription& description,
                             const SPlanarPose& pose, const CDriveSource& drive) {
  const SPlanarDriveDescription limits = description.GetDriveLimits();
  *owner.Handle = MakeHandle(EPlanarKind::Driven, m_driven.size());
  SDrivenBody& body = m_driven.emplace_back();
  body.Owner = owner;
  body.Pose = body.NextPose = pose;
  body.Drive = drive;
  SDrivenKind kind;
  kind.Mass = description.Mass;
  kind.Inertia =
      description.PlanarInertia ? *description.PlanarInertia : description.ComputePlanarInertia();
  kind.MaxSpeedChange = limits.MaxForce * m_settings.Tick / kind.Mass;
  kind.MaxYawRateChange = limits.MaxTorque * m_settings.Tick / kind.Inertia;
  kind.NarrowestHalf = ComputeNarrowestHalf(description);
  kind.MaxSpeed = kMaxSubsteps * kMaxStepShare * kind.NarrowestHalf / m_settings.Tick;
  body.Kind = &GetOrAddKind(kind);
  body.BoundingRadius = description.ComputeBoundingRadius();
  m_widestMovable = std::max(m_widestMovable, body.BoundingRadius);
  body.IsDisc = IsCentredDisc(description);
  if (!body.IsDisc) {
    body.Solid = std::make_unique<SPlanarSolid>(DescribeSolid(description, {0.0, 0.0}));
    m_drivenSolids.push_back(owner.Handle->Slot);
  }
  body.IsGrippable = description.Grippable;
}

// Before a robot is removed from a slot, and the last one gets it.
void CPlanarStore::ForgetDrivenSolid(UInt32 slot) {
  std::erase(m_drivenSolids, slot);
  if (!m_drivenSolids.empty() && m_drivenSolids.back() + 1 == m_driven.size()) {
    m_drivenSolids.back() = slot;
    std::sort(m_drivenSolids.begin(), m_drivenSolids.end());
  }
}

// Moves the last body of an array into the slot of the removed one.
template <typename BODY>
void CPlanarStore::FillSlot(std::vector<BODY>& bodies, EPlanarKind kind, UInt32 slot) {
  *bodies[slot].Owner.Handle = SPlanarHandle();
  const UInt32 generation = m_generations[static_cast<size_t>(kind)].Remove(slot);
  if (slot + 1 != bodies.size()) {
    bodies[slot] = std::move(bodies.back());
    bodies[slot].Owner.Handle->Slot = slot;
    bodies[slot].Owner.Handle->Generation = generation;
  }
  bodies.pop_back();
}

void CPlanarStore::Remove(const SPlanarHandle& handle) {
  GenerationsOf(handle.Kind).Check(handle);
  const UInt32 slot = handle.Slot;
  switch (handle.Kind) {
    case EPlanarKind::Immovable:
      DestroyBody(*m_immovable[slot].Body);
      FillSlot(m_immovable, EPlanarKind::Immovable, slot);
      m_obstaclesChanged = true;
      break;
    case EPlanarKind::Passive:
      DestroyBody(*m_passive[slot].Body);
      FillSlot(m_passive, EPlanarKind::Passive, slot);
      break;
    case EPlanarKind::Driven:
      ARGOS_ASSERT(!m_driven[slot].IsActive(), "an active robot is removed from slot " << slot);
      ForgetDrivenSolid(slot);
      FillSlot(m_driven, EPlanarKind::Driven, slot);
      break;
  }
}

UInt8& CPlanarStore::GetNumGrips(const SPlanarHandle& handle) {
  return handle.Kind == EPlanarKind::Driven ? GetDriven(handle).NumGrips
                                            : GetPassive(handle).NumGrips;
}

Real CPlanarStore::GetBoundingRadius(const SPlanarHandle& handle) const {
  return handle.Kind == EPlanarKind::Driven ? GetDriven(handle).BoundingRadius
                                            : GetPassive(handle).BoundingRadius;
}

Real CPlanarStore::GetNarrowestHalf(const SPlanarHandle& handle) const {
  return handle.Kind == EPlanarKind::Driven ? GetDriven(handle).Kind->NarrowestHalf
                                            : ToMetres(GetPassive(handle).Extent);
}

const SPlanarOwner& CPlanarStore::GetOwner(const SPlanarHandle& handle) const {
  switch (handle.Kind) {
    case EPlanarKind::Immovable:
      return m_immovable[SlotOf(handle, EPlanarKind::Immovable)].Owner;
    case EPlanarKind::Passive:
      return GetPassive(handle).Owner;
    default:
      return GetDriven(handle).Owner;
  }
}

SPlanarVelocity CPlanarStore::GetVelocity(const SPlanarHandle& handle) const {
  switch (handle.Kind) {
    case EPlanarKind::Passive:
      return GetPassive(handle).Velocity;
    case EPlanarKind::Driven:
      return GetDriven(handle).Velocity;
    default:
      GenerationsOf(handle.Kind).Check(handle);
      return SPlanarVelocity();
  }
}

bool CPlanarStore::IsAt(const SPlanarHandle& handle, const SPlanarPose& pose,
                        const CVector3& origin) const {
  if (handle.Kind == EPlanarKind::Immovable) {
    return false;
  }
  constexpr Real kRounding = 1e-12;  // of sines and cosines
  const SPlanarPose& mine =
      handle.Kind == EPlanarKind::Driven ? GetDriven(handle).Pose : GetPassive(handle).Pose;
  // half angles that differ by pi are the same heading
  const Real cosine = mine.HalfCos * pose.HalfCos + mine.HalfSin * pose.HalfSin;
  const Real sine = mine.HalfSin * pose.HalfCos - mine.HalfCos * pose.HalfSin;
  return mine.X + origin.GetX() == pose.X && mine.Y + origin.GetY() == pose.Y &&
         std::abs(sine) < kRounding && std::abs(cosine) > 0.5;
}

}  // namespace argos
