#include <argos3/core/simulator/physics_engine/drive_source.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <sstream>

namespace argos {

std::string CDriveSource::Describe() const {
  CTextOutput text;
  if (HasWheels()) {
    text << "left = " << GetWheels()[0] << " m/s, right = " << GetWheels()[1] << " m/s";
  } else {
    const SDriveCommand command = Read();
    text << "ahead = " << command.Ahead << " m/s, left = " << command.Left
         << " m/s, yaw rate = " << command.YawRate << " rad/s";
  }
  return text.str();
}

void ThrowBadCommand(const SBadDriveCommand& bad) {
  THROW_ARGOSEXCEPTION("robot \"" << bad.Robot->GetRootEntity().GetId() << "\": "
                                  << (bad.Drive.HasWheels() ? "wheel speeds" : "drive commands")
                                  << " must be finite numbers, found " << bad.Drive.Describe());
}

}  // namespace argos
