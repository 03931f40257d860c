// Grippers and turrets of a planar world.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// rad; a loaded turret that is farther from where it should be has stalled
constexpr Real kServoSlack = 0.01;
// the most bodies that may hold one, and be held by it, together
constexpr UInt8 kMaxGrips = 255;

// kg/s; so that two masses on a spring come to rest as fast as they can without swinging
Real ComputeCriticalDamping(Real stiffness, Real a, Real b) {
  return 2.0 * std::sqrt(stiffness * a * b / (a + b));
}

}  // namespace

SManipulator* CPlanarWorld::FindManipulator(const SPlanarHandle& handle) {
  if (!m_driven[handle.Slot].HasManipulator) {
    return nullptr;
  }
  const auto found =
      std::find_if(m_manipulators.begin(), m_manipulators.end(),
                   [&handle](const SManipulator& each) { return each.Owner.Handle == &handle; });
  return found != m_manipulators.end() ? &*found : nullptr;
}

void CPlanarWorld::SetManipulator(const SPlanarOwner& owner, const SBodyDescription& description,
                                  CGripperEquippedEntity* gripper, CTurretEntity* turret) {
  if (owner.Handle->Kind != EPlanarKind::Driven) {
    return;
  }
  SManipulator* manipulator = FindManipulator(*owner.Handle);
  if (gripper == nullptr && turret == nullptr) {
    if (manipulator != nullptr) {
      RemoveManipulator(*owner.Handle);
    }
    return;
  }
  if (manipulator == nullptr) {
    manipulator = &m_manipulators.emplace_back();
    manipulator->Owner = owner;
    m_driven[owner.Handle->Slot].HasManipulator = true;
  }
  if (manipulator->IsHolding() && manipulator->Gripper != gripper) {
    Release(*manipulator);
  }
  manipulator->Gripper = description.Gripper ? gripper : nullptr;
  manipulator->Limits = description.Gripper.value_or(SGripperDescription());
  manipulator->Turret = description.Turret ? turret : nullptr;
  manipulator->TurretLimits = description.Turret;
  if (manipulator->Turret != nullptr) {
    manipulator->Rotation = turret->GetRotation().GetValue();
  }
}

void CPlanarWorld::RemoveManipulator(const SPlanarHandle& handle) {
  SManipulator* const manipulator = FindManipulator(handle);
  if (manipulator->IsHolding()) {
    Release(*manipulator);
  }
  // in order: grips are solved in it
  m_manipulators.erase(m_manipulators.begin() + (manipulator - m_manipulators.data()));
  m_driven[handle.Slot].HasManipulator = false;
}

UInt8& CPlanarWorld::NumGrips(const SPlanarHandle& handle) {
  return handle.Kind == EPlanarKind::Driven ? m_driven[handle.Slot].NumGrips
                                            : m_passive[handle.Slot].NumGrips;
}

bool CPlanarWorld::IsInGrip(const SPlanarHandle& handle) const {
  return handle.Kind != EPlanarKind::Immovable &&
         const_cast<CPlanarWorld&>(*this).NumGrips(handle) > 0;
}

// Makes what every gripper needs to hold something; it goes with the bodies in @p extras.
void CPlanarWorld::ReserveGrips(std::vector<b2Body*>& extras) {
  b2BodyDef body;
  body.type = b2_dynamicBody;
  for (size_t i = 0; i < m_manipulators.size(); ++i) {
    b2RevoluteJointDef pivot;
    b2WheelJointDef hold;
    pivot.bodyA = hold.bodyA = m_ground;
    pivot.bodyB = hold.bodyB = m_world.CreateBody(&body);
    hold.localAxisA.Set(1.0F, 0.0F);
    m_world.CreateJoint(&pivot);
    m_world.CreateJoint(&hold);
    extras.push_back(pivot.bodyB);
  }
}

void CPlanarWorld::ReleaseAllOf(const SPlanarHandle& handle) {
  for (SManipulator& each : m_manipulators) {
    if (each.IsHolding() && (each.Owner.Handle == &handle || each.Held.Handle == &handle)) {
      Release(each);
    }
  }
}

b2Body& CPlanarWorld::GetBox2DBody(const SPlanarHandle& handle) {
  return handle.Kind == EPlanarKind::Driven ? *m_inPlay[m_driven[handle.Slot].InPlay].Body
                                            : *m_passive[handle.Slot].Body;
}

// Reads what grippers and turrets are to do in this tick, and lets go.
void CPlanarWorld::StartTickOfManipulators() {
  const Real maxRate = kMaxSubsteps * kMaxStepTurn / m_settings.Tick;
  m_seekReach = 0.0;
  for (SManipulator& each : m_manipulators) {
    if (each.Turret != nullptr) {
      each.Rotation = each.Turret->GetRotation().GetValue();
      each.IsMotorOn = each.Turret->IsDriven();
      each.Rate = std::clamp(each.Turret->AdvanceControl(m_settings.Tick), -maxRate, maxRate);
    }
    if (each.IsHolding()) {
      // what the gripper says to hold is another thing, or nothing, if somebody else has changed it
      const bool holdsOn = each.Gripper->IsLocked() && each.Gripper->IsGripping() &&
                           &each.Gripper->GetGrippedEntity() == each.Held.Body;
      if (!holdsOn) {
        Release(each);
      }
    }
    // what the solver missed is made up for, but what stalls does not wind up
    const bool isBehind =
        std::abs(std::remainder(each.Target - each.Rotation, 2.0 * ARGOS_PI)) > kServoSlack;
    each.Target =
        (isBehind || !each.IsMotorOn ? each.Rotation : each.Target) + each.Rate * m_settings.Tick;
    if (IsSeeking(each)) {
      m_seekReach = std::max(m_seekReach, ComputeSeekReach(each));
    }
  }
}

bool CPlanarWorld::IsAnythingHeld() const {
  return std::any_of(m_manipulators.begin(), m_manipulators.end(),
                     [](const SManipulator& each) { return each.IsHolding(); });
}

bool CPlanarWorld::IsSeeking(const SManipulator& manipulator) const {
  return manipulator.Gripper != nullptr && !manipulator.IsHolding() &&
         manipulator.Gripper->IsLocked() && m_settings.GrippingRigidity > 0.0;
}

// how far the sensing disc reaches out of the circle around the body, m
Real CPlanarWorld::ComputeSeekReach(const SManipulator& manipulator) const {
  const CVector3& offset = manipulator.Gripper->GetOffset();
  return std::max(0.0, std::hypot(offset.GetX(), offset.GetY()) + manipulator.Limits.SensorRadius -
                           m_driven[manipulator.Owner.Handle->Slot].BoundingRadius);
}

// Robots whose grippers seek something meet what is in reach of those.
void CPlanarWorld::ExtendSeekers() {
  for (const SManipulator& each : m_manipulators) {
    const UInt32 slot = each.Owner.Handle->Slot;
    if (IsSeeking(each) && m_driven[slot].IsDisc) {
      m_encounters.Extend(slot, ComputeSeekReach(each));
    }
  }
}

// Lets locked grippers that hold nothing take hold of what they reach.
void CPlanarWorld::Grip() {
  for (SManipulator& each : m_manipulators) {
    SDrivenBody& body = m_driven[each.Owner.Handle->Slot];
    if (!IsSeeking(each) || body.InPlay == SDrivenBody::kNotInPlay || body.NumGrips == kMaxGrips) {
      continue;
    }
    b2Body& base = GetBox2DBody(*each.Owner.Handle);
    const b2Rot turn(base.GetAngle() + static_cast<float>(each.Rotation));
    const CVector3& offset = each.Gripper->GetOffset();
    const b2Vec2 arm(ToUnits(offset.GetX()), ToUnits(offset.GetY()));
    const SGripPlace place = FindGripPlace(m_world, base.GetPosition() + b2Mul(turn, arm),
                                           ToUnits(each.Limits.SensorRadius), m_grippable, base);
    if (place.Body == nullptr) {
      continue;
    }
    const SPlanarOwner& held = m_grippable[GetBodyNumber(*place.Body)];
    if (NumGrips(*held.Handle) == kMaxGrips) {
      continue;
    }
    const b2Vec2 onTurret = b2MulT(turn, place.Point - base.GetPosition());
    const b2Vec2 onHeld = place.Body->GetLocalPoint(place.Point);
    Attach(each, held,
           {ToMetres(onTurret.x), ToMetres(onTurret.y), ToMetres(onHeld.x), ToMetres(onHeld.y)});
  }
}

void CPlanarWorld::Attach(SManipulator& manipulator, const SPlanarOwner& held,
                          const SGripPoints& points) {
  manipulator.Base = &GetBox2DBody(*manipulator.Owner.Handle);
  manipulator.Held = held;
  manipulator.Points = points;
  if (manipulator.TurretLimits) {
    MakeTurretBody(manipulator);
  }
  b2WheelJointDef definition;
  definition.bodyA = &manipulator.GetCarrier();
  definition.bodyB = &GetBox2DBody(*held.Handle);
  definition.collideConnected = true;
  definition.localAnchorA.Set(ToUnits(points.ArmX), ToUnits(points.ArmY));
  definition.localAnchorB.Set(ToUnits(points.HeldX), ToUnits(points.HeldY));
  definition.localAxisA = definition.localAnchorA;
  if (definition.localAxisA.Normalize() < b2_epsilon) {
    definition.localAxisA.Set(1.0F, 0.0F);
  }
  definition.stiffness = static_cast<float>(m_settings.GrippingRigidity);
  definition.damping = static_cast<float>(ComputeCriticalDamping(
      m_settings.GrippingRigidity, m_driven[manipulator.Owner.Handle->Slot].Mass,
      definition.bodyB->GetMass()));
  manipulator.Hold = static_cast<b2WheelJoint*>(m_world.CreateJoint(&definition));
  definition.bodyB->SetAwake(true);
  ++NumGrips(*manipulator.Owner.Handle);
  ++NumGrips(*held.Handle);
  manipulator.Gripper->SetGrippedEntity(*held.Body);
}

void CPlanarWorld::MakeTurretBody(SManipulator& manipulator) {
  b2Body& base = *manipulator.Base;
  b2BodyDef body;
  body.type = b2_dynamicBody;
  body.position = base.GetPosition();
  body.angle = base.GetAngle() + static_cast<float>(manipulator.Rotation);
  body.linearVelocity = base.GetLinearVelocityFromLocalPoint(b2Vec2_zero);
  body.angularVelocity = base.GetAngularVelocity() + static_cast<float>(manipulator.Rate);
  body.allowSleep = false;
  manipulator.TurretBody = m_world.CreateBody(&body);

  const STurretDescription& limits = *manipulator.TurretLimits;
  const bool isDisc = m_driven[manipulator.Owner.Handle->Slot].IsDisc;
  b2MassData mass;
  mass.mass = isDisc ? 0.5F * base.GetMass() : static_cast<float>(limits.Mass);
  mass.center.SetZero();
  mass.I = ToUnits(limits.PlanarInertia * m_settings.UnitsPerMetre);
  manipulator.TurretBody->SetMassData(&mass);
  ChangeMass(base, -mass.mass);

  b2RevoluteJointDef pivot;
  pivot.bodyA = &base;
  pivot.bodyB = manipulator.TurretBody;
  pivot.enableMotor = true;
  manipulator.Pivot = static_cast<b2RevoluteJoint*>(m_world.CreateJoint(&pivot));
}

// its centre and its moment of inertia stay
void CPlanarWorld::ChangeMass(b2Body& body, float change) {
  b2MassData mass;
  body.GetMassData(&mass);
  mass.mass += change;
  body.SetMassData(&mass);
}

void CPlanarWorld::Release(SManipulator& manipulator) {
  m_world.DestroyJoint(manipulator.Hold);  // wakes both bodies
  manipulator.Hold = nullptr;
  if (manipulator.TurretBody != nullptr) {
    const float mass = manipulator.TurretBody->GetMass();
    m_world.DestroyBody(manipulator.TurretBody);  // and its pivot
    ChangeMass(*manipulator.Base, mass);
    manipulator.TurretBody = nullptr;
    manipulator.Pivot = nullptr;
  }
  --NumGrips(*manipulator.Owner.Handle);
  const SPlanarHandle& held = *manipulator.Held.Handle;
  --NumGrips(held);
  if (held.Kind == EPlanarKind::Passive) {
    m_passive[held.Slot].WasLetGo = true;
  }
  manipulator.Held = SPlanarOwner();
  manipulator.Base = nullptr;
  manipulator.Gripper->ClearGrippedEntity();
}

// How far a turret's motor moves what is held, at most, in the tick, m.
Real CPlanarWorld::ComputeSwing(const SManipulator& manipulator) const {
  if (!manipulator.IsHolding() || !manipulator.IsMotorOn) {
    return 0.0;
  }
  const SPlanarHandle& held = *manipulator.Held.Handle;
  const Real radius = held.Kind == EPlanarKind::Driven ? m_driven[held.Slot].BoundingRadius
                                                       : m_passive[held.Slot].BoundingRadius;
  const Real reach = std::hypot(manipulator.Points.ArmX, manipulator.Points.ArmY) + 2.0 * radius;
  return std::abs(manipulator.Rate) * m_settings.Tick * reach;
}

// Of a tick, so that nothing that is held moves, and no turret turns, too far in one.
float CPlanarWorld::ComputeSubstepsForSwings() const {
  Real needed = 0.0;
  for (const SManipulator& each : m_manipulators) {
    const Real swing = ComputeSwing(each);
    if (swing > 0.0) {
      const SPlanarHandle& held = *each.Held.Handle;
      const Real half = held.Kind == EPlanarKind::Driven ? m_driven[held.Slot].NarrowestHalf
                                                         : ToMetres(m_passive[held.Slot].Extent);
      needed = std::max({needed, swing / (kMaxStepShare * half),
                         std::abs(each.Rate) * m_settings.Tick / kMaxStepTurn});
    }
  }
  return static_cast<float>(needed);
}

// Sets where each turret is to be at the end of a substep: what the solver has missed in one is
// made up for in the next.
void CPlanarWorld::SetTurretMotors(UInt32 substep, UInt32 substeps) {
  const Real duration = m_settings.Tick / substeps;
  for (SManipulator& each : m_manipulators) {
    if (each.Pivot == nullptr) {
      continue;
    }
    const STurretDescription& limits = *each.TurretLimits;
    Real speed = 0.0;  // rad/s
    if (each.IsMotorOn) {
      const Real target = each.Target - each.Rate * duration * (substeps - 1 - substep);
      speed = std::remainder(target - each.Pivot->GetJointAngle(), 2.0 * ARGOS_PI) / duration;
    }
    each.Pivot->SetMotorSpeed(static_cast<float>(speed));
    const Real torque = each.IsMotorOn ? limits.MaxTorque : limits.FreeTorque;
    each.Pivot->SetMaxMotorTorque(ToUnits(torque * m_settings.UnitsPerMetre));
  }
}

// The overlap solver does not know turrets: they are where their robots are.
void CPlanarWorld::PutTurretsOnRobots() {
  for (SManipulator& each : m_manipulators) {
    if (each.TurretBody != nullptr) {
      each.TurretBody->SetTransform(each.Base->GetPosition(), each.TurretBody->GetAngle());
    }
  }
}

float CPlanarWorld::ComputeGreatestGripImpulse() const {
  float greatest = 0.0F;
  for (const SManipulator& each : m_manipulators) {
    if (each.IsHolding()) {
      greatest = std::max(greatest, each.Hold->GetReactionForce(1.0F).Length());
    }
  }
  return greatest;
}

// Says where turrets point, and lets slip what was pulled with too much force in the last substep.
void CPlanarWorld::FinishManipulators(float substepDuration) {
  for (SManipulator& each : m_manipulators) {
    if (each.TurretBody == nullptr) {
      each.Rotation += each.Rate * m_settings.Tick;
    } else {
      const Real turretAngle = each.TurretBody->GetAngle();
      each.Rotation = std::remainder(each.Pivot->GetJointAngle(), 2.0 * ARGOS_PI);
      if (std::abs(turretAngle) > kMaxAngle) {
        each.TurretBody->SetTransform(
            each.TurretBody->GetPosition(),
            static_cast<float>(std::remainder(turretAngle, 2.0 * ARGOS_PI)));
      }
    }
    if (each.Turret != nullptr) {
      each.Turret->SetRotation(CRadians(each.Rotation));
    }
    if (each.IsHolding() && each.Hold->GetReactionForce(1.0F / substepDuration).Length() >
                                ToUnits(each.Limits.MaxForce)) {
      Release(each);
    }
  }
}

void CPlanarWorld::FindCluster(const CEmbodiedEntity& body,
                               std::vector<CEmbodiedEntity*>& cluster) const {
  cluster.clear();
  const auto contains = [&cluster](const CEmbodiedEntity* each) {
    return std::find(cluster.begin(), cluster.end(), each) != cluster.end();
  };
  // grows until no grip leads out of it
  for (size_t before = SIZE_MAX; cluster.size() != before;) {
    before = cluster.size();
    for (const SManipulator& each : m_manipulators) {
      if (!each.IsHolding()) {
        continue;
      }
      const bool isConnected = contains(each.Owner.Body) || contains(each.Held.Body) ||
                               each.Owner.Body == &body || each.Held.Body == &body;
      for (CEmbodiedEntity* const end : {each.Owner.Body, each.Held.Body}) {
        if (isConnected && !contains(end)) {
          cluster.push_back(end);
        }
      }
    }
  }
}

void CPlanarWorld::CopyGrips(const std::vector<CEmbodiedEntity*>& cluster,
                             std::vector<SGripTransfer>& grips) const {
  grips.clear();
  for (const SManipulator& each : m_manipulators) {
    if (each.IsHolding() &&
        std::find(cluster.begin(), cluster.end(), each.Owner.Body) != cluster.end()) {
      grips.push_back({each.Owner.Body, each.Held.Body,
                       CVector3(each.Points.ArmX, each.Points.ArmY, 0.0),
                       CVector3(each.Points.HeldX, each.Points.HeldY, 0.0), each.Rotation});
    }
  }
}

void CPlanarWorld::RestoreGrip(const SGripTransfer& grip, const SPlanarHandle& holder,
                               const SPlanarHandle& held) {
  for (const SPlanarHandle* end : {&holder, &held}) {
    if (end->Kind == EPlanarKind::Driven && m_driven[end->Slot].InPlay == SDrivenBody::kNotInPlay) {
      EnterPlay(end->Slot, nullptr);
    }
  }
  SManipulator& manipulator = *FindManipulator(holder);
  manipulator.Rotation = grip.TurretRotation;
  const SPlanarOwner& heldOwner =
      held.Kind == EPlanarKind::Driven ? m_driven[held.Slot].Owner : m_passive[held.Slot].Owner;
  Attach(manipulator, heldOwner,
         {grip.Arm.GetX(), grip.Arm.GetY(), grip.PointOnHeld.GetX(), grip.PointOnHeld.GetY()});
}

}  // namespace argos
