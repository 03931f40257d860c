#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace argos {

CPlanarStore::CPlanarStore(const SPlanarSettings& settings) : m_settings(settings) {}

void CPlanarStore::Reserve(size_t immovable, size_t passive, size_t driven) {
  m_immovable.reserve(immovable);
  m_passive.reserve(passive);
  m_driven.reserve(driven);
  const std::array<size_t, 3> counts = {immovable, passive, driven};
  for (size_t kind = 0; kind < counts.size(); ++kind) {
    m_generations[kind].Reserve(counts[kind]);
  }
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
  body.IsGrippable = description.Grippable;
  body.BoundingRadius = description.ComputeBoundingRadius();
  body.Solid = DescribeSolid(description, ChooseGroundFriction(description, m_settings.BoxFriction,
                                                               m_settings.CylinderFriction));
  m_widestMovable = std::max(m_widestMovable, body.BoundingRadius);
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
      FillSlot(m_immovable, EPlanarKind::Immovable, slot);
      m_obstaclesChanged = true;
      break;
    case EPlanarKind::Passive:
      FillSlot(m_passive, EPlanarKind::Passive, slot);
      break;
    case EPlanarKind::Driven:
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
                                            : GetPassive(handle).Solid.NarrowestHalf;
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

void CPlanarStore::SetVelocity(const SPlanarHandle& handle, const SPlanarVelocity& velocity) {
  if (handle.Kind == EPlanarKind::Passive) {
    GetPassive(handle).Velocity = velocity;
  } else if (handle.Kind == EPlanarKind::Driven) {
    GetDriven(handle).Velocity = velocity;
  }
}

bool CPlanarStore::IsGrippable(const SPlanarHandle& handle) const {
  return handle.Kind == EPlanarKind::Driven ? GetDriven(handle).IsGrippable
                                            : GetPassive(handle).IsGrippable;
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
