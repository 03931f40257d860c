// One tick of a planar world, in the order of Advance().

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>

#include <argos3/core/utility/math/angles.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

/** What the wheels of a robot ask for. */
struct SWheelMotion {
  Real Speed;  // m/s, ahead
  Real YawRate;  // rad/s
};

SWheelMotion ReadWheels(const SDrivenBody& body, Real tick) {
  const Real left = body.Wheels[0];
  const Real right = body.Wheels[1];
  const Real speed = 0.5 * (left + right);
  const Real yawRate = (right - left) * body.InverseInterwheel;
  if (!std::isfinite(speed) || !std::isfinite(yawRate)) {
    throw SBadWheelSpeed{body.Owner.Model, left, right};
  }
  const Real maxYawRate = kMaxSubsteps * kMaxStepTurn / tick;
  return {std::clamp(speed, -body.MaxSpeed, body.MaxSpeed),
          std::clamp(yawRate, -maxYawRate, maxYawRate)};
}

bool IsTouching(b2Body& body) {
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (edge->contact->IsTouching()) {
      return true;
    }
  }
  return false;
}

}  // namespace

void CPlanarWorld::Advance() {
  StartTickOfManipulators();
  PlanDriven();
  FindEncounters();
  MeetGhosts();
  ChooseWhoPlays();
  Grip();
  PlaceGhosts();
  if (IsAnythingAwake()) {
    for (SInPlay& play : m_inPlay) {
      StartTickInPlay(play);
    }
    const UInt32 substeps = ChooseSubsteps();
    StepBox2D(substeps);
    for (SInPlay& play : m_inPlay) {
      FinishInPlay(play, substeps);
    }
    FinishManipulators(static_cast<float>(m_settings.Tick / substeps));
  } else {
    FinishManipulators(static_cast<float>(m_settings.Tick));
  }
  RemoveGhosts();
  FinishPassive();
}

// Decides where each robot would be at the end of the tick if nothing were in its way.
void CPlanarWorld::PlanDriven() {
  m_longestPath = 0.0;
  m_encounters.Clear(m_driven.size());
  for (UInt32 slot = 0; slot < m_driven.size(); ++slot) {
    Plan(m_driven[slot], slot);
  }
}

void CPlanarWorld::Plan(SDrivenBody& body, UInt32 slot) {
  const Real tick = m_settings.Tick;
  const SWheelMotion wanted = ReadWheels(body, tick);

  // the torque bounds how much the yaw rate changes, the force how much the velocity does
  const Real yawRate = body.Velocity.W + std::clamp(wanted.YawRate - body.Velocity.W,
                                                    -body.MaxYawRateChange, body.MaxYawRateChange);
  const SArc arc = FollowArc(body.Pose, wanted.Speed, yawRate, tick);
  Real velocityX = arc.DX / tick;
  Real velocityY = arc.DY / tick;
  Real path = std::abs(wanted.Speed) * tick;
  body.NextPose = arc.End;
  const Real changeX = velocityX - body.Velocity.X;
  const Real changeY = velocityY - body.Velocity.Y;
  const Real squaredChange = changeX * changeX + changeY * changeY;
  if (squaredChange > body.MaxSpeedChange * body.MaxSpeedChange) {
    const Real share = body.MaxSpeedChange / std::sqrt(squaredChange);
    velocityX = body.Velocity.X + share * changeX;
    velocityY = body.Velocity.Y + share * changeY;
    path = std::sqrt(velocityX * velocityX + velocityY * velocityY) * tick;
    body.NextPose.X = body.Pose.X + velocityX * tick;
    body.NextPose.Y = body.Pose.Y + velocityY * tick;
  }
  body.NextVelocity = {velocityX, velocityY, yawRate};

  m_longestPath = std::max(m_longestPath, path);
  if (body.IsDisc) {
    m_encounters.Place(slot, body.Pose.X, body.Pose.Y,
                       body.BoundingRadius + path + kEncounterSlack * m_metresPerUnit);
  }
}

// Finds out which robots may meet something. Those in play may be pushed: they reach as far as the
// fastest body goes.
void CPlanarWorld::FindEncounters() {
  if (m_obstaclesChanged) {
    UpdateObstacles();
  }
  const Real slack = kEncounterSlack * m_metresPerUnit;
  for (const SInPlay& play : m_inPlay) {
    const SDrivenBody& body = m_driven[play.Slot];
    const Real speed = std::hypot(body.Velocity.X, body.Velocity.Y) +
                       (body.IsDisc ? 0.0 : std::abs(body.Velocity.W) * body.BoundingRadius);
    m_longestPath = std::max(m_longestPath, speed * m_settings.Tick);
  }
  for (const SPassiveBody& body : m_passive) {
    if (body.Body->IsAwake()) {
      const Real speed = ToMetres(body.Body->GetLinearVelocity().Length()) +
                         std::abs(body.Body->GetAngularVelocity()) * body.BoundingRadius;
      m_longestPath = std::max(m_longestPath, speed * m_settings.Tick);
    }
  }
  for (const SManipulator& each : m_manipulators) {
    m_longestPath = std::max(m_longestPath, ComputeSwing(each));
  }
  for (const SInPlay& play : m_inPlay) {
    const SDrivenBody& body = m_driven[play.Slot];
    if (body.IsDisc) {
      m_encounters.SetReach(play.Slot, body.BoundingRadius + m_longestPath + slack);
    }
  }
  ExtendSeekers();
  m_encounters.MarkAll();
  for (const SInPlay& play : m_inPlay) {
    const SDrivenBody& body = m_driven[play.Slot];
    if (!body.IsDisc) {
      const Real seek = body.HasManipulator ? m_seekReach : 0.0;
      m_encounters.MarkNear(body.Pose.X, body.Pose.Y,
                            body.BoundingRadius + m_longestPath + slack + seek);
    }
  }
  for (const SPassiveBody& body : m_passive) {
    m_encounters.MarkNear(body.Pose.X, body.Pose.Y, body.BoundingRadius + m_longestPath + slack);
  }
}

void CPlanarWorld::UpdateObstacles() {
  std::vector<SFootprint> obstacles;
  for (const SImmovableBody& body : m_immovable) {
    obstacles.insert(obstacles.end(), body.Obstacles.begin(), body.Obstacles.end());
  }
  m_encounters.SetObstacles(obstacles);
  m_obstaclesChanged = false;
}

void CPlanarWorld::ChooseWhoPlays() {
  // backwards, because the last one takes the place of one that leaves
  for (size_t i = m_inPlay.size(); i-- > 0;) {
    const UInt32 slot = m_inPlay[i].Slot;
    const SDrivenBody& body = m_driven[slot];
    if (body.IsDisc && body.NumGrips == 0 && m_encounters.GetMark(slot) == CProximityFilter::Free) {
      LeavePlay(slot);
    }
  }
  for (UInt32 slot = 0; slot < m_driven.size(); ++slot) {
    if (m_encounters.GetMark(slot) == CProximityFilter::Active &&
        m_driven[slot].InPlay == SDrivenBody::kNotInPlay) {
      EnterPlay(slot, nullptr);
    }
  }
}

// What the motor is to do in this tick: take the body from where Box2D has it to the end of its
// arc.
void CPlanarWorld::StartTickInPlay(SInPlay& play) {
  const SDrivenBody& body = m_driven[play.Slot];
  b2Body& box2dBody = *play.Body;
  const SWheelMotion wanted = ReadWheels(body, m_settings.Tick);
  const SArc arc = FollowArc(body.Pose, wanted.Speed, wanted.YawRate, m_settings.Tick);

  if (std::abs(box2dBody.GetAngle()) > kMaxAngle) {
    box2dBody.SetTransform(box2dBody.GetPosition(), static_cast<float>(body.Pose.ComputeYaw()));
  }
  const b2Vec2 position = box2dBody.GetPosition();
  play.StartAngle = box2dBody.GetAngle();
  const Real startAngle = play.StartAngle;
  play.StartYaw = startAngle + std::remainder(body.Pose.ComputeYaw() - startAngle, 2.0 * ARGOS_PI);
  play.StepX = static_cast<float>(arc.End.X * m_settings.UnitsPerMetre - position.x);
  play.StepY = static_cast<float>(arc.End.Y * m_settings.UnitsPerMetre - position.y);
  play.StepAngle =
      static_cast<float>(play.StartYaw + wanted.YawRate * m_settings.Tick - startAngle);
  play.SpentImpulse = 0.0F;
  play.SpentAngularImpulse = 0.0F;
}

bool CPlanarWorld::IsAnythingAwake() const {
  return !m_inPlay.empty() ||
         std::any_of(m_passive.begin(), m_passive.end(),
                     [](const SPassiveBody& body) { return body.Body->IsAwake(); });
}

// As many as asked for, and more if a body would move too far in one.
UInt32 CPlanarWorld::ChooseSubsteps() const {
  const float tick = static_cast<float>(m_settings.Tick);
  const float stepShare = static_cast<float>(kMaxStepShare);
  const float stepTurn = static_cast<float>(kMaxStepTurn);
  float needed = 0.0F;
  for (const SInPlay& play : m_inPlay) {
    const SDrivenBody& body = m_driven[play.Slot];
    const float planned = b2Vec2(play.StepX, play.StepY).Length();
    const float coasting = play.Body->GetLinearVelocity().Length() * tick;
    needed =
        std::max({needed, std::max(planned, coasting) / (stepShare * ToUnits(body.NarrowestHalf)),
                  std::abs(play.StepAngle) / stepTurn});
  }
  for (const SPassiveBody& body : m_passive) {
    if (body.Body->IsAwake()) {
      const float distance = body.Body->GetLinearVelocity().Length() * tick;
      const float turn = std::abs(body.Body->GetAngularVelocity()) * tick;
      needed = std::max({needed, distance / (stepShare * body.Extent), turn / stepTurn});
    }
  }
  needed = std::max(needed, ComputeSubstepsForSwings());
  const UInt32 cap = std::max(kMaxSubsteps, m_settings.Substeps);
  if (!(needed < static_cast<float>(cap))) {
    return cap;
  }
  UInt32 substeps =
      std::max(m_settings.Substeps + m_extraSubsteps, static_cast<UInt32>(std::ceil(needed)));
  if (m_settings.RefineInCrowds) {
    substeps = std::max(substeps, ComputeSubstepsForCrowds());
    if (IsAnythingHeld()) {
      substeps = std::max(substeps,
                          static_cast<UInt32>(std::ceil(m_settings.Tick / kMaxGripSubstep - 1e-6)));
    }
  }
  return substeps;
}

// See kSubstepsPerDrive. Of all robots, the one that needs most decides.
UInt32 CPlanarWorld::ComputeSubstepsForCrowds() const {
  if (m_greatestForce == 0.0F) {
    return 0;
  }
  const Real perTick = 1.0 / m_settings.Tick;
  Real weakest = HUGE_VAL;  // of force * radius * mass, (N s)^2
  for (const SInPlay& play : m_inPlay) {
    const SDrivenBody& body = m_driven[play.Slot];
    const Real force = body.Mass * body.MaxSpeedChange * perTick;
    weakest = std::min(weakest, force * body.NarrowestHalf * body.Mass);
  }
  const float impulse = static_cast<float>(m_settings.Tick) * m_greatestForce;
  const float substeps = kSubstepsPerDrive * impulse / ToUnits(std::sqrt(weakest));
  return static_cast<UInt32>(std::min(substeps, static_cast<float>(kMaxSubsteps)));
}

// Of Box2D's velocity solver, in a substep.
int CPlanarWorld::ChooseIterations(UInt32 substeps) const {
  if (IsAnythingHeld()) {
    const float duration = static_cast<float>(m_settings.Tick / substeps);
    return std::clamp(static_cast<int>(std::ceil(duration * kGripIterationsPerSecond)),
                      kVelocityIterations, kMaxGripIterations);
  }
  const bool isCrowd = m_settings.RefineInCrowds && substeps > kFewSubsteps;
  return isCrowd ? kCrowdVelocityIterations : kVelocityIterations;
}

void CPlanarWorld::StepBox2D(UInt32 substeps) {
  const float duration = static_cast<float>(m_settings.Tick / substeps);
  const int iterations = ChooseIterations(substeps);
  float deepestOverlap = 0.0F;
  float greatestImpulse = 0.0F;
  for (UInt32 substep = 0; substep < substeps; ++substep) {
    SetMotors(substep, substeps);
    SetTurretMotors(substep, substeps);
    m_world.Step(duration, iterations, kPositionIterations);
    AccountMotors();
    deepestOverlap = std::max(deepestOverlap, m_overlaps.Resolve(m_world));
    PutTurretsOnRobots();
    greatestImpulse =
        std::max({greatestImpulse, m_overlaps.GetGreatestImpulse(), ComputeGreatestGripImpulse()});
  }
  m_greatestForce = greatestImpulse / duration;
  if (m_settings.RefineInCrowds) {
    Refine(deepestOverlap);
  }
}

// Cuts the next ticks finer or coarser.
void CPlanarWorld::Refine(float deepestOverlap) {
  if (deepestOverlap > kTooDeep) {
    m_extraSubsteps = std::min(m_extraSubsteps + 1, kMaxExtraSubsteps);
    m_calmTicks = 0;
  } else if (deepestOverlap > kShallow) {
    m_calmTicks = 0;
  } else if (m_extraSubsteps > 0 && ++m_calmTicks >= kCalmTicks) {
    --m_extraSubsteps;
    m_calmTicks = 0;
  }
}

// Sets the target of each motor for a substep, and the most it may push.
//
// What is bounded is the impulse in the tick. A motor pushes evenly, its share in each substep. But
// a robot that touches nothing may use more of it at once, as much as it takes to reach its speed
// at the start of the tick: that is what makes its tick an exact arc.
void CPlanarWorld::SetMotors(UInt32 substep, UInt32 substeps) {
  const float share = 1.0F / static_cast<float>(substeps);
  const float elapsed = static_cast<float>(substep + 1) * share;
  const float perTick = static_cast<float>(1.0 / m_settings.Tick);
  const float perSubstep = perTick * static_cast<float>(substeps);
  for (SInPlay& play : m_inPlay) {
    const SDrivenBody& body = m_driven[play.Slot];
    b2Body& box2dBody = *play.Body;
    const float mass = static_cast<float>(body.Mass);  // also of what its turret has taken over
    const float inertia = box2dBody.GetInertia();
    const float inTick = mass * ToUnits(body.MaxSpeedChange);
    const float angularInTick = inertia * static_cast<float>(body.MaxYawRateChange);
    float impulse = elapsed * inTick - play.SpentImpulse;
    float angularImpulse = elapsed * angularInTick - play.SpentAngularImpulse;
    if (body.NumGrips == 0 && !IsTouching(box2dBody)) {
      // a little more than the change of velocity takes, for the solver's roundings
      constexpr float kAmple = 1.01F;
      const b2Vec2 step(play.StepX, play.StepY);
      const float change = (perTick * step - box2dBody.GetLinearVelocity()).Length();
      const float turn = std::abs(perTick * play.StepAngle - box2dBody.GetAngularVelocity());
      impulse = std::clamp(kAmple * mass * change, impulse,
                           std::max(impulse, inTick - play.SpentImpulse));
      angularImpulse =
          std::clamp(kAmple * inertia * turn, angularImpulse,
                     std::max(angularImpulse, angularInTick - play.SpentAngularImpulse));
    }
    play.Motor->SetMaxForce(std::max(0.0F, impulse) * perSubstep);
    play.Motor->SetMaxTorque(std::max(0.0F, angularImpulse) * perSubstep);
    play.Motor->SetLinearOffset(box2dBody.GetPosition() + share * b2Vec2(play.StepX, play.StepY));
    play.Motor->SetAngularOffset(box2dBody.GetAngle() + share * play.StepAngle);
  }
}

void CPlanarWorld::AccountMotors() {
  for (SInPlay& play : m_inPlay) {
    play.SpentImpulse += play.Motor->GetReactionForce(1.0F).Length();
    play.SpentAngularImpulse += std::abs(play.Motor->GetReactionTorque(1.0F));
  }
}

// Decides whether Box2D let the robot go where it wanted.
void CPlanarWorld::FinishInPlay(SInPlay& play, UInt32 substeps) {
  SDrivenBody& body = m_driven[play.Slot];
  const b2Vec2 position = play.Body->GetPosition();
  const float angle = play.Body->GetAngle();
  const b2Vec2 target(ToUnits(body.NextPose.X), ToUnits(body.NextPose.Y));
  const Real targetYaw = play.StartYaw + body.NextVelocity.W * m_settings.Tick;

  // each substep rounds once, and so do the target, the step and the difference
  const float roundings = static_cast<float>(substeps + 3) * b2_epsilon;
  const float tolerance = roundings * std::max({1.0F, std::abs(position.x), std::abs(position.y)});
  if (std::abs(position.x - target.x) <= tolerance &&
      std::abs(position.y - target.y) <= tolerance &&
      std::abs(angle - static_cast<float>(targetYaw)) <=
          roundings * std::max(1.0F, std::abs(angle))) {
    return;
  }
  body.NextPose.X = ToMetres(position.x);
  body.NextPose.Y = ToMetres(position.y);
  body.NextPose.SetYaw(play.StartYaw + (static_cast<Real>(angle) - play.StartAngle));
  const b2Vec2 velocity = play.Body->GetLinearVelocityFromLocalPoint(b2Vec2_zero);
  body.NextVelocity = {ToMetres(velocity.x), ToMetres(velocity.y),
                       static_cast<Real>(play.Body->GetAngularVelocity())};
}

void CPlanarWorld::FinishPassive() {
  for (SPassiveBody& body : m_passive) {
    const b2Vec2 position = body.Body->GetPosition();
    const float angle = body.Body->GetAngle();
    const bool moved = position.x != body.X || position.y != body.Y || angle != body.Angle;
    // what was let go may be in another engine's region
    body.Moved = moved || body.WasLetGo;
    body.WasLetGo = false;
    if (moved) {
      body.X = position.x;
      body.Y = position.y;
      body.Angle = angle;
      body.Pose.X = ToMetres(position.x);
      body.Pose.Y = ToMetres(position.y);
      body.Pose.SetYaw(angle);
      const b2Vec2 velocity = body.Body->GetLinearVelocityFromLocalPoint(b2Vec2_zero);
      body.Velocity = {ToMetres(velocity.x), ToMetres(velocity.y),
                       static_cast<Real>(body.Body->GetAngularVelocity())};
    }
  }
}

}  // namespace argos
