#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DRIVE_MOTION_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DRIVE_MOTION_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_bodies.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>

namespace argos {

/** Reads the command of a robot's drive. @param tick s. @throws SBadDriveCommand */
inline SDriveCommand ReadCommand(const SDrivenBody& body, Real tick) {
  SDriveCommand command = body.Drive.Read();
  if (!command.IsFinite()) {
    throw SBadDriveCommand{body.Owner.Body, body.Drive};
  }
  const Real maxYawRate = kMaxSubsteps * kMaxStepTurn / tick;
  command.YawRate = std::clamp(command.YawRate, -maxYawRate, maxYawRate);
  return command.Limited(body.Kind->MaxSpeed);
}

}  // namespace argos

#endif
