#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_DRIVERS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_DRIVERS_H

#include <argos3/core/simulator/physics_engine/drive_source.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/point_mass_handle.h>

#include <vector>

namespace argos {

class CPointMass3DBody;

/** m; no body may be farther from the world's origin: positions are accurate to 1e-7 m there. */
constexpr Real kMaxDistance = 1e9;

/**
 * The bodies of an engine that have a drive, and their motion: the exact arc of its command, at the
 * height where they were placed, without contacts.
 *
 * Numbers of bodies are dense; removing one moves the last one into its place. A handle holds the
 * number of a body until then.
 */
class CDrivers : public CPointMassHandles {
 public:
  size_t GetCount() const { return m_poses.size(); }
  /**
   * Adds a body.
   * @param drive  read in every tick.
   * @return its handle, with the number GetCount() before the call.
   */
  SPointMassHandle Add(CPointMass3DBody& owner, const CDriveSource& drive, const SPlanarPose& pose,
                       Real height);
  /** Removes a body. @return the body that now has its number, if any. */
  CPointMass3DBody* Remove(const SPointMassHandle& handle);
  void Clear();

  void Place(UInt32 number, const SPlanarPose& pose, Real height);
  const SPlanarPose& GetPose(UInt32 number) const { return m_poses[Checked(number)]; }
  /** m. */
  Real GetHeight(UInt32 number) const { return m_heights[Checked(number)]; }
  CPointMass3DBody& GetOwner(UInt32 number) const { return *m_owners[Checked(number)]; }
  SDriveCommand GetCommand(UInt32 number) const { return m_drives[Checked(number)].Read(); }

  /**
   * Moves all bodies by a tick.
   * @param tick  s.
   * @throws CARGoSException that names the robot if its command leads beyond kMaxDistance.
   */
  void Advance(Real tick);

 private:
  UInt32 Checked(UInt32 number) const {
    ARGOS_ASSERT(number < GetCount(), "there is no driving body with the number " << number);
    return number;
  }

  // all (bodies)
  std::vector<SPlanarPose> m_poses;  // frame of the engine; written by Advance()
  std::vector<Real> m_heights;  // m
  std::vector<CDriveSource> m_drives;
  std::vector<CPointMass3DBody*> m_owners;
};

}  // namespace argos

#endif
