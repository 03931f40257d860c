#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_grips.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/grip_search.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// rad; a loaded turret that is farther from its target has stalled
constexpr Real kServoSlack = 0.01;
// most grips in which one body takes part
constexpr UInt8 kMaxGrips = 255;

// kg, the mass of two that a spring between them moves
Real ComputeReducedMass(Real a, Real b) {
  return a * b / (a + b);
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

bool CPlanarGrips::IsSeeking(const SManipulator& manipulator) const {
  return manipulator.Gripper != nullptr && !manipulator.IsHolding() &&
         manipulator.Gripper->IsLocked() && m_store.GetSettings().GrippingRigidity > 0.0;
}

void CPlanarGrips::MakeGrips(const CDiscPairs& discPairs, CCrowdSolids& solids) {
  for (SManipulator& each : m_manipulators) {
    if (IsSeeking(each) && m_store.GetDriven(*each.Owner.Handle).NumGrips < kMaxGrips) {
      MakeGrip(each, discPairs, solids);
    }
  }
}

void CPlanarGrips::MakeGrip(SManipulator& manipulator, const CDiscPairs& discPairs,
                            CCrowdSolids& solids) {
  const SPlanarPose& pose = m_store.GetDriven(*manipulator.Owner.Handle).Pose;
  const CVector3& offset = manipulator.Gripper->GetOffset();
  const Real angle = pose.ComputeYaw() + manipulator.Rotation;
  const SPlanarVector arm = Rotate({offset.GetX(), offset.GetY()}, angle);
  const std::optional<SGripPlace> place =
      FindGripPlace(m_store, discPairs, solids, {pose.X + arm.X, pose.Y + arm.Y},
                    manipulator.Limits.SensorRadius, *manipulator.Owner.Handle);
  if (!place || m_store.GetNumGrips(*place->Owner.Handle) == kMaxGrips) {
    return;
  }
  const SPlanarHandle& held = *place->Owner.Handle;
  const SPlanarPose& heldPose = held.Kind == EPlanarKind::Driven ? m_store.GetDriven(held).Pose
                                                                 : m_store.GetPassive(held).Pose;
  const SPeriodicity& period = m_store.GetSettings().Period;
  const SPlanarVector onTurret = Rotate({place->Point.X - pose.X, place->Point.Y - pose.Y}, -angle);
  const SPlanarVector onHeld = Rotate({period.X.Shorten(place->Point.X - heldPose.X),
                                       period.Y.Shorten(place->Point.Y - heldPose.Y)},
                                      -heldPose.ComputeYaw());
  Attach(manipulator, place->Owner, {onTurret.X, onTurret.Y, onHeld.X, onHeld.Y});
}

void CPlanarGrips::Attach(SManipulator& manipulator, const SPlanarOwner& held,
                          const SGripPoints& points) {
  SDrivenBody& holder = m_store.GetDriven(*manipulator.Owner.Handle);
  manipulator.Held = held;
  manipulator.Points = points;
  manipulator.ArmRate = static_cast<float>(holder.Velocity.W + manipulator.Rate);
  manipulator.Along = manipulator.Across = manipulator.Torque = 0.0F;
  for (const SPlanarHandle* end : {manipulator.Owner.Handle, held.Handle}) {
    ++m_store.GetNumGrips(*end);
    if (end->Kind == EPlanarKind::Driven) {
      m_store.GetDriven(*end).PullX = m_store.GetDriven(*end).PullY = 0.0F;
    }
  }
  ++m_numHolds;
  manipulator.Gripper->SetGrippedEntity(*held.Body);
}

// A disc's place, or a solid's number.
UInt32 CPlanarGrips::FindItem(const CDiscPairs& discPairs, const CCrowdSolids& solids,
                              const SPlanarHandle& handle) const {
  return handle.Kind == EPlanarKind::Driven && m_store.GetDriven(handle).IsDisc
             ? discPairs.GetPlace(handle.Slot)
             : solids.GetItem(handle.Kind, handle.Slot);
}

void CPlanarGrips::AddTo(CDiscPairs& discPairs, CCrowd& crowd) const {
  ForEachHold([&](const SManipulator& each) {
    SCrowdGrip grip = Describe(each);
    grip.Holder = FindItem(discPairs, crowd.GetSolids(), *each.Owner.Handle);
    grip.Held = FindItem(discPairs, crowd.GetSolids(), *each.Held.Handle);
    crowd.AddGrip(discPairs, grip);
  });
}

SCrowdGrip CPlanarGrips::Describe(const SManipulator& manipulator) const {
  const SPlanarSettings& settings = m_store.GetSettings();
  const SGripPoints& points = manipulator.Points;
  const SDrivenBody& holder = m_store.GetDriven(*manipulator.Owner.Handle);
  const SPlanarHandle& heldHandle = *manipulator.Held.Handle;
  const bool isDriven = heldHandle.Kind == EPlanarKind::Driven;
  const SPlanarPose& heldPose =
      isDriven ? m_store.GetDriven(heldHandle).Pose : m_store.GetPassive(heldHandle).Pose;
  const SPlanarSolid* const heldSolid =
      isDriven ? m_store.GetDriven(heldHandle).Solid.get() : &m_store.GetPassive(heldHandle).Solid;
  const Real heldMass =
      heldSolid != nullptr ? heldSolid->Mass : m_store.GetDriven(heldHandle).Kind->Mass;
  const Real yaw = holder.Pose.ComputeYaw();
  SCrowdGrip grip;
  if (holder.Solid != nullptr) {
    grip.Pivot = Rotate({-holder.Solid->CentreX, -holder.Solid->CentreY}, yaw);
  }
  const Real length = std::hypot(points.ArmX, points.ArmY);
  const Real armYaw = yaw + manipulator.Rotation;
  grip.Arm = Rotate({points.ArmX, points.ArmY}, armYaw);
  grip.Axis = length > 0.0 ? SPlanarVector{grip.Arm.X / length, grip.Arm.Y / length}
                           : Rotate({1.0, 0.0}, armYaw);
  grip.Point = {points.HeldX, points.HeldY};
  if (heldSolid != nullptr) {
    grip.Point = {points.HeldX - heldSolid->CentreX, points.HeldY - heldSolid->CentreY};
  }
  grip.Point = Rotate(grip.Point, heldPose.ComputeYaw());
  grip.Stiffness = settings.GrippingRigidity;
  const Real mass = ComputeReducedMass(holder.Kind->Mass, heldMass);
  grip.Damping = 2.0 * std::sqrt(settings.GrippingRigidity * mass);  // critical
  const Real rate = std::sqrt(settings.GrippingRigidity / mass);
  grip.NeededSubsteps = static_cast<float>(ComputeNeededSubsteps(manipulator, rate));
  if (manipulator.TurretLimits) {
    const STurretDescription& limits = *manipulator.TurretLimits;
    grip.InverseArmInertia = static_cast<float>(1.0 / limits.PlanarInertia);
    grip.ArmRate = manipulator.ArmRate;
    grip.MotorTarget = manipulator.Target - manipulator.Rotation;
    grip.MotorRate = manipulator.Rate;
    grip.IsMotorOn = manipulator.IsMotorOn;
    grip.MotorTorque =
        static_cast<float>(manipulator.IsMotorOn ? limits.MaxTorque : limits.FreeTorque);
  }
  grip.Along = manipulator.Along;
  grip.Across = manipulator.Across;
  grip.Motor = manipulator.Torque;
  return grip;
}

void CPlanarGrips::Release(SManipulator& manipulator) {
  ARGOS_ASSERT(manipulator.IsHolding(), "a grip is released twice");
  --m_store.GetNumGrips(*manipulator.Owner.Handle);
  const SPlanarHandle& held = *manipulator.Held.Handle;
  --m_store.GetNumGrips(held);
  if (held.Kind == EPlanarKind::Passive) {
    m_store.GetPassive(held).WasReleased = true;
  }
  manipulator.Held = SPlanarOwner();
  --m_numHolds;
  manipulator.Gripper->ClearGrippedEntity();
}

// How far from the robot's centre the held body reaches, m.
Real CPlanarGrips::ComputeReach(const SManipulator& manipulator) const {
  return std::hypot(manipulator.Points.ArmX, manipulator.Points.ArmY) +
         2.0 * m_store.GetBoundingRadius(*manipulator.Held.Handle);
}

Real CPlanarGrips::ComputeLongestPath() const {
  Real fastest = 0.0;
  ForEachHold([&](const SManipulator& each) {
    const SDrivenBody& holder = m_store.GetDriven(*each.Owner.Handle);
    const SDriveCommand& command = holder.NextCommand;
    const Real turn = std::max(std::abs(command.YawRate), std::abs(holder.Velocity.W)) +
                      (each.IsMotorOn ? std::abs(each.Rate) : 0.0);
    const SPlanarVelocity held = m_store.GetVelocity(*each.Held.Handle);
    const Real heldSpeed = std::hypot(held.X, held.Y) +
                           std::abs(held.W) * m_store.GetBoundingRadius(*each.Held.Handle);
    const Real speed = std::hypot(holder.Velocity.X, holder.Velocity.Y);
    fastest =
        std::max({fastest, std::max(command.ComputeSpeed(), speed) + turn * ComputeReach(each),
                  kMaxGripGrowth * std::max(speed, heldSpeed)});
  });
  return fastest * m_store.GetSettings().Tick;
}

// Substeps of a tick in which the held body does not move too far in one, nor the turret turns too
// far, and that resolve the swing of a soft spring. @param rate  of the spring, rad/s.
Real CPlanarGrips::ComputeNeededSubsteps(const SManipulator& manipulator, Real rate) const {
  const SPlanarSettings& settings = m_store.GetSettings();
  // the tolerance keeps a rounding error from adding a substep
  const bool isSoft = rate * settings.Tick < kSoftGrip * settings.Substeps;
  Real needed =
      settings.RefineInCrowds && isSoft ? std::ceil(settings.Tick / kMaxGripSubstep - 1e-6) : 1.0;
  if (manipulator.IsMotorOn) {
    const Real turn = std::abs(manipulator.Rate) * settings.Tick;
    const Real half = m_store.GetNarrowestHalf(*manipulator.Held.Handle);
    needed = std::max(
        {needed, turn * ComputeReach(manipulator) / (kMaxStepShare * half), turn / kMaxStepTurn});
  }
  return needed;
}

void CPlanarGrips::FinishTick(const std::vector<SCrowdGrip>& grips) {
  auto next = grips.begin();
  for (SManipulator& each : m_manipulators) {
    if (each.IsHolding()) {
      const SCrowdGrip& grip = *next++;
      each.Along = grip.Along;
      each.Across = grip.Across;
      each.Torque = grip.Motor;
      each.ArmRate = grip.ArmRate;
      if (each.TurretLimits) {
        each.Rotation = std::remainder(each.Rotation + grip.Rotation, 2.0 * ARGOS_PI);
      }
    }
    if (!each.IsHolding() || !each.TurretLimits) {
      each.Rotation += each.Rate * m_store.GetSettings().Tick;
    }
    if (each.Turret != nullptr) {
      each.Turret->SetRotation(CRadians(each.Rotation));
    }
    if (each.IsHolding() && std::hypot(static_cast<Real>(each.Along),
                                       static_cast<Real>(each.Across)) > each.Limits.MaxForce) {
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
  SManipulator* const found = Find(holder);
  ARGOS_ASSERT(found != nullptr && !found->IsHolding(),
               "a grip is restored of a robot without a free gripper, in slot " << holder.Slot);
  SManipulator& manipulator = *found;
  manipulator.Rotation = grip.TurretRotation;
  Attach(manipulator, m_store.GetOwner(held),
         {grip.Arm.GetX(), grip.Arm.GetY(), grip.PointOnHeld.GetX(), grip.PointOnHeld.GetY()});
}

}  // namespace argos
