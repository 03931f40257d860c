#include <argos3/plugins/simulator/physics_engines/pointmass3d/drivers.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/memory/room.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_body.h>

namespace argos {

namespace {

// removes an element; the last one gets its place
template <typename T>
void FillPlace(std::vector<T>& values, UInt32 number) {
  values[number] = values.back();
  values.pop_back();
}

}  // namespace

SPointMassHandle CDrivers::Add(CPointMass3DBody& owner, const CDriveSource& drive,
                               const SPlanarPose& pose, Real height) {
  ReserveOneMore(m_poses);
  ReserveOneMore(m_heights);
  ReserveOneMore(m_drives);
  ReserveOneMore(m_owners);
  const SPointMassHandle handle = {static_cast<UInt32>(m_poses.size()), m_generations.Add()};
  m_poses.push_back(pose);
  m_heights.push_back(height);
  m_drives.push_back(drive);
  m_owners.push_back(&owner);
  return handle;
}

CPointMass3DBody* CDrivers::Remove(const SPointMassHandle& handle) {
  const UInt32 number = GetNumber(handle);
  m_generations.Remove(number);
  FillPlace(m_poses, number);
  FillPlace(m_heights, number);
  FillPlace(m_drives, number);
  FillPlace(m_owners, number);
  return number < m_owners.size() ? m_owners[number] : nullptr;
}

void CDrivers::Clear() {
  m_poses.clear();
  m_heights.clear();
  m_drives.clear();
  m_owners.clear();
  m_generations.Clear();
}

void CDrivers::Place(UInt32 number, const SPlanarPose& pose, Real height) {
  m_poses[Checked(number)] = pose;
  m_heights[number] = height;
}

void CDrivers::Advance(Real tick) {
  for (size_t i = 0; i < m_poses.size(); ++i) {
    const SArc arc = FollowArc(m_poses[i], m_drives[i].Read(), tick);
    // written so that NaN fails too
    if (!(std::abs(arc.End.X) + std::abs(arc.End.Y) + std::abs(arc.End.HalfCos) <= kMaxDistance)) {
      THROW_ARGOSEXCEPTION(
          "robot \"" << m_owners[i]->GetEmbodiedEntity().GetRootEntity().GetId() << "\": "
                     << (m_drives[i].HasWheels() ? "wheel speeds" : "drive commands") << " of "
                     << m_drives[i].Describe() << " lead beyond " << kMaxDistance << " m");
    }
    m_poses[i] = arc.End;
  }
}

}  // namespace argos
