#ifndef ARGOS3_PLUGINS_ENTITIES_PLANAR_DRIVE_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_PLANAR_DRIVE_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>

namespace argos {

/**
 * The command of a drive that can move a robot to all sides: a velocity in the plane, in the frame
 * of the body. SPlanarDriveDescription of the body defines the limits of the drive.
 */
class CPlanarDriveEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  explicit CPlanarDriveEntity(CComposableEntity* parent);
  CPlanarDriveEntity(CComposableEntity* parent, const std::string& id);

  /** Sets the command to 0. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "planar_drive"; }

  /** The reference stays valid as long as the entity; engines read it in every tick. */
  const SDriveCommand& GetCommand() const { return m_command; }
  /**
   * Sets the command for the next physics phase.
   * @throws CARGoSException if a number is not finite; the command is then unchanged.
   */
  void SetCommand(const SDriveCommand& command);

  void UpdateDigest(CDigest& digest) const override;

 private:
  SDriveCommand m_command;
};

}  // namespace argos

#endif
