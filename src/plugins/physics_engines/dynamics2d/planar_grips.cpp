#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_grips.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/grip_search.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/overlap_solver.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// rad; a loaded turret that is farther from its target has stalled
constexpr Real kServoSlack = 0.01;
// most grips in which one body takes part
constexpr UInt8 kMaxGrips = 255;

// kg/s, the critical damping of two masses (kg) on a spring (N/m)
Real ComputeCriticalDamping(Real stiffness, Real a, Real b) {
  return 2.0 * std::sqrt(stiffness * a * b / (a + b));
}

// keeps the centre of mass and the moment of inertia
void ChangeMass(b2Body& body, float change) {
  b2MassData mass;
  body.GetMassData(&mass);
  mass.mass += change;
  body.SetMassData(&mass);
}

}  // namespace

SManipulator* CPlanarGrips::Find(const SPlanarHandle& handle) {
  if (!m_store.GetDriven(handle).HasManipulator) {
    return nullptr;
  }
  const auto found =
      std::find_if(m_manipulators.begin(), m_manipulators.end(),
                   [&handle](const SManipulator& each) { return *each.Owner.Handle == handle; });
  return found != m_manipulators.end() ? &*found : nullptr;
}

void CPlanarGrips::SetManipulator(const SPlanarOwner& owner, const SBodyDescription& description,
                                  CGripperEquippedEntity* gripper, CTurretEntity* turret) {
  if (owner.Handle->Kind != EPlanarKind::Driven) {
    return;
  }
  SManipulator* manipulator = Find(*owner.Handle);
  if (gripper == nullptr && turret == nullptr) {
    if (manipulator != nullptr) {
      RemoveManipulator(*manipulator);
    }
    return;
  }
  if (manipulator == nullptr) {
    if (m_manipulators.empty()) {
      m_manipulators.reserve(m_store.GetDriven().capacity());
    }
    manipulator = &m_manipulators.emplace_back();
    manipulator->Owner = owner;
    m_store.GetDriven(*owner.Handle).HasManipulator = true;
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

void CPlanarGrips::RemoveManipulator(SManipulator& manipulator) {
  if (manipulator.IsHolding()) {
    Release(manipulator);
  }
  m_store.GetDriven(*manipulator.Owner.Handle).HasManipulator = false;
  // keeps the order, in which grips are solved
  m_manipulators.erase(m_manipulators.begin() + (&manipulator - m_manipulators.data()));
}

void CPlanarGrips::Remove(const SPlanarHandle& handle) {
  if (IsInGrip(handle)) {
    for (SManipulator& each : m_manipulators) {
      if (each.IsHolding() && (*each.Owner.Handle == handle || *each.Held.Handle == handle)) {
        Release(each);
      }
    }
  }
  SManipulator* const manipulator = handle.Kind == EPlanarKind::Driven ? Find(handle) : nullptr;
  if (manipulator != nullptr) {
    RemoveManipulator(*manipulator);
  }
}

bool CPlanarGrips::IsInGrip(const SPlanarHandle& handle) const {
  return handle.Kind != EPlanarKind::Immovable && m_store.GetNumGrips(handle) > 0;
}

void CPlanarGrips::CreateSpares(std::vector<b2Body*>& spares) {
  b2BodyDef body;
  body.type = b2_dynamicBody;
  for (size_t i = 0; i < m_manipulators.size(); ++i) {
    b2RevoluteJointDef pivot;
    b2WheelJointDef hold;
    pivot.bodyA = hold.bodyA = &m_store.GetGround();
    pivot.bodyB = hold.bodyB = m_store.GetWorld().CreateBody(&body);
    hold.localAxisA.Set(1.0F, 0.0F);
    m_store.GetWorld().CreateJoint(&pivot);
    m_store.GetWorld().CreateJoint(&hold);
    spares.push_back(pivot.bodyB);
  }
}

void CPlanarGrips::StartTick() {
  const Real maxRate = kMaxSubsteps * kMaxStepTurn / m_store.GetSettings().Tick;
  for (SManipulator& each : m_manipulators) {
    if (each.Turret != nullptr) {
      each.Rotation = each.Turret->GetRotation().GetValue();
      each.IsMotorOn = each.Turret->IsDriven();
      each.Rate =
          std::clamp(each.Turret->AdvanceControl(m_store.GetSettings().Tick), -maxRate, maxRate);
    }
    if (each.IsHolding()) {
      // other code may have changed what the gripper holds
      const bool stillHolds = each.Gripper->IsLocked() && each.Gripper->IsGripping() &&
                              &each.Gripper->GetGrippedEntity() == each.Held.Body;
      if (!stillHolds) {
        Release(each);
      }
    }
    // errors of the solver are corrected, but a stalled turret does not accumulate them
    const bool isBehind =
        std::abs(std::remainder(each.Target - each.Rotation, 2.0 * ARGOS_PI)) > kServoSlack;
    each.Target = (isBehind || !each.IsMotorOn ? each.Rotation : each.Target) +
                  each.Rate * m_store.GetSettings().Tick;
  }
}

bool CPlanarGrips::IsHoldingAny() const {
  return std::any_of(m_manipulators.begin(), m_manipulators.end(),
                     [](const SManipulator& each) { return each.IsHolding(); });
}

bool CPlanarGrips::IsSeeking(const SManipulator& manipulator) const {
  return manipulator.Gripper != nullptr && !manipulator.IsHolding() &&
         manipulator.Gripper->IsLocked() && m_store.GetSettings().GrippingRigidity > 0.0;
}

// how far the sensing disc reaches out of the circle around the robot, m
Real CPlanarGrips::ComputeSeekReach(const SManipulator& manipulator) const {
  const CVector3& offset = manipulator.Gripper->GetOffset();
  return std::max(0.0, std::hypot(offset.GetX(), offset.GetY()) + manipulator.Limits.SensorRadius -
                           m_store.GetDriven(*manipulator.Owner.Handle).BoundingRadius);
}

void CPlanarGrips::MakeGrips() {
  for (SManipulator& each : m_manipulators) {
    const SDrivenBody& body = m_store.GetDriven(*each.Owner.Handle);
    if (IsSeeking(each) && body.IsActive() && body.NumGrips < kMaxGrips) {
      MakeGrip(each);
    }
  }
}

void CPlanarGrips::MakeGrip(SManipulator& manipulator) {
  b2Body& base = m_active.GetBox2DBody(*manipulator.Owner.Handle);
  const b2Rot turn(base.GetAngle() + static_cast<float>(manipulator.Rotation));
  const CVector3& offset = manipulator.Gripper->GetOffset();
  const b2Vec2 arm(m_store.ToUnits(offset.GetX()), m_store.ToUnits(offset.GetY()));
  const SGripPlace place =
      FindGripPlace(m_store.GetWorld(), base.GetPosition() + b2Mul(turn, arm),
                    m_store.ToUnits(manipulator.Limits.SensorRadius), m_store.GetGrippable(), base);
  if (place.Body == nullptr) {
    return;
  }
  // a copy, because the list may change
  const SPlanarOwner held = m_store.GetGrippable()[GetBodyNumber(*place.Body)];
  if (m_store.GetNumGrips(*held.Handle) == kMaxGrips) {
    return;
  }
  const b2Vec2 onTurret = b2MulT(turn, place.Point - base.GetPosition());
  const b2Vec2 onHeld = place.Body->GetLocalPoint(place.Point);
  Attach(manipulator, held,
         {m_store.ToMetres(onTurret.x), m_store.ToMetres(onTurret.y), m_store.ToMetres(onHeld.x),
          m_store.ToMetres(onHeld.y)});
}

void CPlanarGrips::Attach(SManipulator& manipulator, const SPlanarOwner& held,
                          const SGripPoints& points) {
  manipulator.Base = &m_active.GetBox2DBody(*manipulator.Owner.Handle);
  manipulator.Held = held;
  manipulator.Points = points;
  if (manipulator.TurretLimits) {
    CreateTurretBody(manipulator);
  }
  b2WheelJointDef definition;
  definition.bodyA = &manipulator.GetCarrier();
  definition.bodyB = &m_active.GetBox2DBody(*held.Handle);
  definition.collideConnected = true;
  definition.localAnchorA.Set(m_store.ToUnits(points.ArmX), m_store.ToUnits(points.ArmY));
  definition.localAnchorB.Set(m_store.ToUnits(points.HeldX), m_store.ToUnits(points.HeldY));
  definition.localAxisA = definition.localAnchorA;
  if (definition.localAxisA.Normalize() < b2_epsilon) {
    definition.localAxisA.Set(1.0F, 0.0F);
  }
  definition.stiffness = static_cast<float>(m_store.GetSettings().GrippingRigidity);
  definition.damping = static_cast<float>(ComputeCriticalDamping(
      m_store.GetSettings().GrippingRigidity,
      m_store.GetDriven(*manipulator.Owner.Handle).Kind->Mass, definition.bodyB->GetMass()));
  manipulator.Hold = static_cast<b2WheelJoint*>(m_store.GetWorld().CreateJoint(&definition));
  definition.bodyB->SetAwake(true);
  ++m_store.GetNumGrips(*manipulator.Owner.Handle);
  ++m_store.GetNumGrips(*held.Handle);
  manipulator.Gripper->SetGrippedEntity(*held.Body);
}

void CPlanarGrips::CreateTurretBody(SManipulator& manipulator) {
  b2Body& base = *manipulator.Base;
  b2BodyDef body;
  body.type = b2_dynamicBody;
  body.position = base.GetPosition();
  body.angle = base.GetAngle() + static_cast<float>(manipulator.Rotation);
  body.linearVelocity = base.GetLinearVelocityFromLocalPoint(b2Vec2_zero);
  body.angularVelocity = base.GetAngularVelocity() + static_cast<float>(manipulator.Rate);
  body.allowSleep = false;
  manipulator.TurretBody = m_store.GetWorld().CreateBody(&body);

  const STurretDescription& limits = *manipulator.TurretLimits;
  const bool isDisc = m_store.GetDriven(*manipulator.Owner.Handle).IsDisc;
  b2MassData mass;
  mass.mass = isDisc ? 0.5F * base.GetMass() : static_cast<float>(limits.Mass);
  mass.center.SetZero();
  mass.I = m_store.ToUnits(limits.PlanarInertia * m_store.GetSettings().UnitsPerMetre);
  manipulator.TurretBody->SetMassData(&mass);
  ChangeMass(base, -mass.mass);

  b2RevoluteJointDef pivot;
  pivot.bodyA = &base;
  pivot.bodyB = manipulator.TurretBody;
  pivot.enableMotor = true;
  manipulator.Pivot = static_cast<b2RevoluteJoint*>(m_store.GetWorld().CreateJoint(&pivot));
}

void CPlanarGrips::Release(SManipulator& manipulator) {
  ARGOS_ASSERT(manipulator.IsHolding(), "a grip is released twice");
  m_store.GetWorld().DestroyJoint(manipulator.Hold);  // wakes both bodies
  manipulator.Hold = nullptr;
  if (manipulator.TurretBody != nullptr) {
    const float mass = manipulator.TurretBody->GetMass();
    m_store.GetWorld().DestroyBody(manipulator.TurretBody);  // and its pivot
    ChangeMass(*manipulator.Base, mass);
    manipulator.TurretBody = nullptr;
    manipulator.Pivot = nullptr;
  }
  --m_store.GetNumGrips(*manipulator.Owner.Handle);
  const SPlanarHandle& held = *manipulator.Held.Handle;
  --m_store.GetNumGrips(held);
  if (held.Kind == EPlanarKind::Passive) {
    m_store.GetPassive(held).WasReleased = true;
  }
  manipulator.Held = SPlanarOwner();
  manipulator.Base = nullptr;
  manipulator.Gripper->ClearGrippedEntity();
}

// The longest path of the held body in the tick due to the turret's motor, m.
Real CPlanarGrips::ComputeSwing(const SManipulator& manipulator) const {
  if (!manipulator.IsHolding() || !manipulator.IsMotorOn) {
    return 0.0;
  }
  const Real radius = m_store.GetBoundingRadius(*manipulator.Held.Handle);
  const Real reach = std::hypot(manipulator.Points.ArmX, manipulator.Points.ArmY) + 2.0 * radius;
  return std::abs(manipulator.Rate) * m_store.GetSettings().Tick * reach;
}

Real CPlanarGrips::ComputeLongestSwing() const {
  Real longest = 0.0;
  for (const SManipulator& each : m_manipulators) {
    longest = std::max(longest, ComputeSwing(each));
  }
  return longest;
}

float CPlanarGrips::ComputeNeededSubsteps() const {
  Real needed = 0.0;
  for (const SManipulator& each : m_manipulators) {
    const Real swing = ComputeSwing(each);
    if (swing > 0.0) {
      const Real half = m_store.GetNarrowestHalf(*each.Held.Handle);
      needed = std::max({needed, swing / (kMaxStepShare * half),
                         std::abs(each.Rate) * m_store.GetSettings().Tick / kMaxStepTurn});
    }
  }
  return static_cast<float>(needed);
}

// The target of a substep is absolute, so that an error of the solver is corrected in the next one.
void CPlanarGrips::SetTurretMotors(UInt32 substep, UInt32 substeps) {
  const Real duration = m_store.GetSettings().Tick / substeps;
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
    each.Pivot->SetMaxMotorTorque(m_store.ToUnits(torque * m_store.GetSettings().UnitsPerMetre));
  }
}

// The overlap solver moves robots without their turrets.
void CPlanarGrips::AlignTurrets() {
  for (SManipulator& each : m_manipulators) {
    if (each.TurretBody != nullptr) {
      each.TurretBody->SetTransform(each.Base->GetPosition(), each.TurretBody->GetAngle());
    }
  }
}

float CPlanarGrips::ComputeGreatestImpulse() const {
  float greatest = 0.0F;
  for (const SManipulator& each : m_manipulators) {
    if (each.IsHolding()) {
      greatest = std::max(greatest, each.Hold->GetReactionForce(1.0F).Length());
    }
  }
  return greatest;
}

void CPlanarGrips::FinishTick(float substepDuration) {
  for (SManipulator& each : m_manipulators) {
    if (each.TurretBody == nullptr) {
      each.Rotation += each.Rate * m_store.GetSettings().Tick;
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
                                m_store.ToUnits(each.Limits.MaxForce)) {
      Release(each);
    }
  }
}

void CPlanarGrips::FindCluster(const CEmbodiedEntity& body,
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

void CPlanarGrips::CopyGrips(const std::vector<CEmbodiedEntity*>& cluster,
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

void CPlanarGrips::RestoreGrip(const SGripTransfer& grip, const SPlanarHandle& holder,
                               const SPlanarHandle& held) {
  for (const SPlanarHandle* end : {&holder, &held}) {
    if (end->Kind == EPlanarKind::Passive) {
      m_active.Activate(m_store.GetPassive(*end));
    } else if (!m_store.GetDriven(*end).IsActive()) {
      m_active.Activate(end->Slot);
    }
  }
  SManipulator* const found = Find(holder);
  ARGOS_ASSERT(found != nullptr && !found->IsHolding(),
               "a grip is restored of a robot without a free gripper, in slot " << holder.Slot);
  SManipulator& manipulator = *found;
  manipulator.Rotation = grip.TurretRotation;
  Attach(manipulator, m_store.GetOwner(held),
         {grip.Arm.GetX(), grip.Arm.GetY(), grip.PointOnHeld.GetX(), grip.PointOnHeld.GetY()});
}

}  // namespace argos
