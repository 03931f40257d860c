#include <argos3/plugins/simulator/physics_engines/dynamics2d/active_set.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// share of its greatest impulse below which a drive could do more
constexpr float kHolds = 0.999F;
// of what the solver has left of its way, the share that a drive makes up for in a substep: all of
// it would make chains of robots oscillate
constexpr float kMakesUp = 0.25F;

bool IsTouching(b2Body& body) {
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (edge->contact->IsTouching()) {
      return true;
    }
  }
  return false;
}

}  // namespace

void CActiveSet::Activate(UInt32 slot) {
  SDrivenBody& body = m_store.GetDriven(slot);
  ARGOS_ASSERT(!body.IsActive(), "the robot in slot " << slot << " is active already");
  const Real unitsPerMetre = m_store.GetSettings().UnitsPerMetre;
  b2Body& box2dBody =
      m_store.CreateBody(body.Pose, EPlanarKind::Driven, body.Owner, body.IsGrippable);
  if (body.IsDisc) {
    AddDisc(box2dBody, body.BoundingRadius, unitsPerMetre, kMovableFriction);
    b2MassData mass;
    mass.mass = static_cast<float>(body.Kind->Mass);
    mass.center.SetZero();
    mass.I = m_store.ToUnits(body.Kind->Inertia * unitsPerMetre);
    box2dBody.SetMassData(&mass);
  } else {
    const SBodyDescription& description = *body.Owner.Body->GetBodyDescription();
    AddFixtures(box2dBody, description, unitsPerMetre, kMovableFriction);
    SetMass(box2dBody, description, unitsPerMetre);
  }
  box2dBody.SetLinearVelocity(
      b2Vec2(m_store.ToUnits(body.Velocity.X), m_store.ToUnits(body.Velocity.Y)));
  box2dBody.SetAngularVelocity(static_cast<float>(body.Velocity.W));

  b2MotorJointDef definition;
  definition.bodyA = &m_store.GetGround();
  definition.bodyB = &box2dBody;
  definition.collideConnected = true;
  definition.correctionFactor = 1.0F;  // the target of a substep is reached in it
  body.ActiveNumber = static_cast<UInt32>(m_bodies.size());
  SActiveBody& active = m_bodies.emplace_back();
  active.Slot = slot;
  active.Body = &box2dBody;
  active.Motor = static_cast<b2MotorJoint*>(m_store.GetWorld().CreateJoint(&definition));
}

void CActiveSet::Activate(SPassiveBody& body) {
  if (body.Body->IsEnabled()) {
    return;
  }
  b2Body& box2dBody = *body.Body;
  box2dBody.SetTransform(b2Vec2(m_store.ToUnits(body.Pose.X), m_store.ToUnits(body.Pose.Y)),
                         static_cast<float>(body.Pose.ComputeYaw()));
  box2dBody.SetEnabled(true);
  SetVelocity(*body.Owner.Handle, body.Velocity);
  body.X = box2dBody.GetPosition().x;
  body.Y = box2dBody.GetPosition().y;
  body.Angle = box2dBody.GetAngle();
}

void CActiveSet::Deactivate(UInt32 slot) {
  std::vector<SDrivenBody>& driven = m_store.GetDriven();
  const UInt32 number = m_store.GetDriven(slot).ActiveNumber;
  ARGOS_ASSERT(At(number).Slot == slot, "the robot in slot " << slot << " is not the active one");
  m_store.DestroyBody(*At(number).Body);  // and its motor
  driven[slot].ActiveNumber = SDrivenBody::kInactive;
  if (number + 1 != m_bodies.size()) {
    m_bodies[number] = m_bodies.back();
    driven[m_bodies[number].Slot].ActiveNumber = number;
  }
  m_bodies.pop_back();
}

void CActiveSet::Select(const CDiscPairs& discPairs, CCrowd& crowd) {
  SelectPassive(crowd);
  if (!crowd.HasExcluded() && m_bodies.empty()) {
    return;
  }
  const std::vector<SDrivenBody>& driven = m_store.GetDriven();
  m_isWanted.assign(driven.size(), 0);
  const std::vector<CDiscPairs::SDisc>& discs = discPairs.GetDiscs();
  for (UInt32 place = 0; place < discs.size(); ++place) {
    m_isWanted[discs[place].Number] = crowd.IsExcluded(place) ? 1 : 0;
  }
  const std::vector<CCrowdSolids::SSolid>& solids = crowd.GetSolids().GetSolids();
  for (UInt32 i = 0; i < solids.size(); ++i) {
    if (solids[i].Kind == EPlanarKind::Driven) {
      m_isWanted[solids[i].Slot] = crowd.IsExcluded(crowd.GetSolids().GetNumDiscs() + i) ? 1 : 0;
    }
  }
  // backwards, because the last one takes the place of a deactivated one
  for (size_t i = m_bodies.size(); i-- > 0;) {
    const UInt32 slot = m_bodies[i].Slot;
    if (m_isWanted[slot] == 0) {
      Deactivate(slot);
    }
  }
  for (UInt32 slot = 0; slot < driven.size(); ++slot) {
    if (m_isWanted[slot] != 0 && !driven[slot].IsActive()) {
      Activate(slot);
    }
  }
}

// A body that Box2D has moved is where it has left it.
void CActiveSet::SelectPassive(CCrowd& crowd) {
  const CCrowdSolids& solids = crowd.GetSolids();
  for (UInt32 i = 0; i < solids.GetSolids().size(); ++i) {
    const CCrowdSolids::SSolid& solid = solids.GetSolids()[i];
    if (solid.Kind != EPlanarKind::Passive) {
      continue;
    }
    SPassiveBody& body = m_store.GetPassive()[solid.Slot];
    if (crowd.IsExcluded(solids.GetNumDiscs() + i)) {
      Activate(body);
    } else if (body.Body->IsEnabled()) {
      body.Body->SetEnabled(false);
    }
  }
}

void CActiveSet::UpdateSlot(UInt32 slot) {
  const std::vector<SDrivenBody>& driven = m_store.GetDriven();
  if (slot < driven.size() && driven[slot].IsActive()) {
    m_bodies[driven[slot].ActiveNumber].Slot = slot;
  }
}

b2Body& CActiveSet::GetBox2DBody(const SPlanarHandle& handle) const {
  return handle.Kind == EPlanarKind::Driven ? *At(m_store.GetDriven(handle).ActiveNumber).Body
                                            : *m_store.GetPassive(handle).Body;
}

void CActiveSet::SetVelocity(const SPlanarHandle& handle, const SPlanarVelocity& velocity) {
  b2Body* box2dBody = nullptr;
  if (handle.Kind == EPlanarKind::Passive) {
    SPassiveBody& body = m_store.GetPassive(handle);
    body.Velocity = velocity;
    box2dBody = body.Body->IsEnabled() ? body.Body : nullptr;
  } else if (handle.Kind == EPlanarKind::Driven) {
    SDrivenBody& body = m_store.GetDriven(handle);
    body.Velocity = velocity;
    box2dBody = body.IsActive() ? &GetBox2DBody(handle) : nullptr;
  }
  if (box2dBody != nullptr) {
    box2dBody->SetLinearVelocity(b2Vec2(m_store.ToUnits(velocity.X), m_store.ToUnits(velocity.Y)));
    box2dBody->SetAngularVelocity(static_cast<float>(velocity.W));
  }
}

void CActiveSet::StartTick() {
  for (SActiveBody& active : m_bodies) {
    StartTick(active);
  }
}

// The step of the tick leads from Box2D's pose of the body to the end of its arc.
void CActiveSet::StartTick(SActiveBody& active) {
  const SPlanarSettings& settings = m_store.GetSettings();
  const SDrivenBody& body = GetRobot(active);
  b2Body& box2dBody = *active.Body;
  const Real lag = settings.VelocityLag;
  SPlanarPose start = body.Pose;
  if (active.BehindAngle != 0.0F) {
    const Real behind = 0.5 * static_cast<Real>(active.BehindAngle);
    Turn(start, std::cos(behind), std::sin(behind));
  }
  const SArc arc = FollowArcs(start, body.Command, body.NextCommand, settings.Tick, lag);
  const Real turn =
      (lag * body.Command.YawRate + (1.0 - lag) * body.NextCommand.YawRate) * settings.Tick;

  if (std::abs(box2dBody.GetAngle()) > kMaxAngle) {
    box2dBody.SetTransform(box2dBody.GetPosition(), static_cast<float>(body.Pose.ComputeYaw()));
  }
  const b2Vec2 position = box2dBody.GetPosition();
  active.StartAngle = box2dBody.GetAngle();
  const Real startAngle = active.StartAngle;
  active.StartYaw =
      startAngle + std::remainder(body.Pose.ComputeYaw() - startAngle, 2.0 * ARGOS_PI);
  active.StepX = static_cast<float>(arc.End.X * settings.UnitsPerMetre - position.x);
  active.StepY = static_cast<float>(arc.End.Y * settings.UnitsPerMetre - position.y);
  active.StepAngle = static_cast<float>(active.StartYaw + turn - startAngle);
  active.SpentImpulse = 0.0F;
  active.SpentAngularImpulse = 0.0F;
}

float CActiveSet::ComputeNeededSubsteps() const {
  const float tick = static_cast<float>(m_store.GetSettings().Tick);
  const float stepShare = static_cast<float>(kMaxStepShare);
  const float stepTurn = static_cast<float>(kMaxStepTurn);
  float needed = 0.0F;
  for (const SActiveBody& active : m_bodies) {
    const SDrivenBody& body = GetRobot(active);
    const float planned = b2Vec2(active.StepX, active.StepY).Length();
    const float coasting = active.Body->GetLinearVelocity().Length() * tick;
    const float longest = std::max(planned, coasting);
    const float half = m_store.ToUnits(body.Kind->NarrowestHalf);
    needed =
        std::max({needed, longest / (stepShare * half), std::abs(active.StepAngle) / stepTurn});
  }
  return needed;
}

Real CActiveSet::ComputeWeakestDrive() const {
  const Real perTick = 1.0 / m_store.GetSettings().Tick;
  Real weakest = HUGE_VAL;
  for (const SActiveBody& active : m_bodies) {
    const SDrivenBody& body = GetRobot(active);
    const Real force = body.Kind->Mass * body.Kind->MaxSpeedChange * perTick;
    weakest = std::min(weakest, force * body.Kind->NarrowestHalf * body.Kind->Mass);
  }
  return weakest;
}

void CActiveSet::SetMotors(UInt32 substep, UInt32 substeps) {
  for (SActiveBody& active : m_bodies) {
    active.Pull = substep == 0 ? b2Vec2_zero : active.Pull;
    SetMotor(active, substep, substeps);
  }
}

// The drive bounds the impulse in the tick. A motor exerts an equal share in each substep. But a
// robot that touches nothing may use as much of the bound as it takes to reach its speed at the
// start of the tick: this makes its path an exact arc.
void CActiveSet::SetMotor(SActiveBody& active, UInt32 substep, UInt32 substeps) {
  const float share = 1.0F / static_cast<float>(substeps);
  const float elapsed = static_cast<float>(substep + 1) * share;
  const float perTick = static_cast<float>(1.0 / m_store.GetSettings().Tick);
  const float perSubstep = perTick * static_cast<float>(substeps);
  const SDrivenBody& body = GetRobot(active);
  b2Body& box2dBody = *active.Body;
  const float mass = static_cast<float>(body.Kind->Mass);  // including that of its turret
  const float inertia = box2dBody.GetInertia();
  const float inTick = mass * m_store.ToUnits(body.Kind->MaxSpeedChange);
  const float angularInTick = inertia * static_cast<float>(body.Kind->MaxYawRateChange);
  // what was not used is not saved for later
  float impulse = std::min(share * inTick, elapsed * inTick - active.SpentImpulse);
  float angularImpulse =
      std::min(share * angularInTick, elapsed * angularInTick - active.SpentAngularImpulse);
  if (body.NumGrips == 0 && !IsTouching(box2dBody)) {
    // slightly more than the change of velocity takes, for the solver's rounding errors
    constexpr float kAmple = 1.01F;
    const b2Vec2 step(active.StepX, active.StepY);
    const float change = (perTick * step - box2dBody.GetLinearVelocity()).Length();
    const float turn = std::abs(perTick * active.StepAngle - box2dBody.GetAngularVelocity());
    impulse = std::clamp(kAmple * mass * change, impulse,
                         std::max(impulse, inTick - active.SpentImpulse));
    angularImpulse =
        std::clamp(kAmple * inertia * turn, angularImpulse,
                   std::max(angularImpulse, angularInTick - active.SpentAngularImpulse));
  }
  active.MostImpulse = std::max(0.0F, impulse);
  active.MostAngularImpulse = std::max(0.0F, angularImpulse);
  active.Motor->SetMaxForce(active.MostImpulse * perSubstep);
  active.Motor->SetMaxTorque(active.MostAngularImpulse * perSubstep);
  active.Motor->SetLinearOffset(box2dBody.GetPosition() + kMakesUp * active.Behind +
                                share * b2Vec2(active.StepX, active.StepY));
  active.Motor->SetAngularOffset(box2dBody.GetAngle() + kMakesUp * active.BehindAngle +
                                 share * active.StepAngle);
  active.Behind *= 1.0F - kMakesUp;
  active.BehindAngle *= 1.0F - kMakesUp;
}

void CActiveSet::AccountMotors() {
  for (SActiveBody& active : m_bodies) {
    AccountMotor(active);
  }
}

// A grip is solved by few iterations: without making up for what they leave, a robot that turns a
// load would drift off its arc.
void CActiveSet::AccountMotor(SActiveBody& active) const {
  const b2MotorJoint& motor = *active.Motor;
  const b2Vec2 pull = motor.GetReactionForce(1.0F);
  const float impulse = pull.Length();
  const float angularImpulse = std::abs(motor.GetReactionTorque(1.0F));
  active.Pull += pull;
  active.SpentImpulse += impulse;
  active.SpentAngularImpulse += angularImpulse;
  const bool isInGrip = GetRobot(active).NumGrips > 0;
  const bool keepsPlace = isInGrip && impulse < kHolds * active.MostImpulse;
  const bool keepsYaw = isInGrip && angularImpulse < kHolds * active.MostAngularImpulse;
  active.Behind += motor.GetLinearOffset() - active.Body->GetPosition();
  active.BehindAngle += motor.GetAngularOffset() - active.Body->GetAngle();
  if (!keepsPlace) {
    active.Behind = b2Vec2_zero;
  }
  if (!keepsYaw) {
    active.BehindAngle = 0.0F;
  }
}

void CActiveSet::FinishTick(UInt32 substeps) {
  for (const SActiveBody& active : m_bodies) {
    FinishTick(active, substeps);
  }
}

void CActiveSet::FinishTick(const SActiveBody& active, UInt32 substeps) {
  SDrivenBody& body = GetRobot(active);
  const b2Vec2 position = active.Body->GetPosition();
  const float angle = active.Body->GetAngle();
  const b2Vec2 target(m_store.ToUnits(body.NextPose.X), m_store.ToUnits(body.NextPose.Y));
  const Real targetYaw = active.StartYaw + body.NextVelocity.W * m_store.GetSettings().Tick;

  // each substep rounds once, as do the target, the step and the difference
  const float roundings = static_cast<float>(substeps + 3) * b2_epsilon;
  const float tolerance = roundings * std::max({1.0F, std::abs(position.x), std::abs(position.y)});
  if (std::abs(position.x - target.x) <= tolerance &&
      std::abs(position.y - target.y) <= tolerance &&
      std::abs(angle - static_cast<float>(targetYaw)) <=
          roundings * std::max(1.0F, std::abs(angle))) {
    return;
  }
  body.NextPose.X = m_store.ToMetres(position.x);
  body.NextPose.Y = m_store.ToMetres(position.y);
  body.NextPose.SetYaw(active.StartYaw + (static_cast<Real>(angle) - active.StartAngle));
  const b2Vec2 velocity = active.Body->GetLinearVelocityFromLocalPoint(b2Vec2_zero);
  body.NextVelocity = {m_store.ToMetres(velocity.x), m_store.ToMetres(velocity.y),
                       static_cast<Real>(active.Body->GetAngularVelocity())};
}

}  // namespace argos
