#include <argos3/plugins/simulator/entities/planar_drive_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>

namespace argos {

CPlanarDriveEntity::CPlanarDriveEntity(CComposableEntity* parent)
    : CPlanarDriveEntity(parent, std::string()) {}

CPlanarDriveEntity::CPlanarDriveEntity(CComposableEntity* parent, const std::string& id)
    : CEntity(parent, id) {}

void CPlanarDriveEntity::Reset() {
  m_command = SDriveCommand();
}

void CPlanarDriveEntity::SetCommand(const SDriveCommand& command) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetCommand()");
  }
  if (!command.IsFinite()) {
    THROW_ARGOSEXCEPTION("planar drive \"" << GetContext() << GetId()
                                           << "\": a command must be finite, got ahead = "
                                           << command.Ahead << " m/s, left = " << command.Left
                                           << " m/s, yaw rate = " << command.YawRate << " rad/s");
  }
  m_command = command;
}

void CPlanarDriveEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  digest.Add(m_command.Ahead);
  digest.Add(m_command.Left);
  digest.Add(m_command.YawRate);
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CPlanarDriveEntity)

}  // namespace argos
