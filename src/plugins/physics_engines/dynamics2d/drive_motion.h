#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DRIVE_MOTION_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DRIVE_MOTION_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_bodies.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_settings.h>

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

/** What the drive of a robot aims at in a tick, after it was planned. */
inline SPlanarVelocity ComputeTarget(const SDrivenBody& body, const SPlanarSettings& settings) {
  if (!body.IsLimited) {
    return body.NextVelocity;
  }
  const Real lag = settings.VelocityLag;
  const SArc arc = FollowArcs(body.Pose, body.Command, body.NextCommand, settings.Tick, lag);
  return {arc.DX / settings.Tick, arc.DY / settings.Tick,
          lag * body.Command.YawRate + (1.0 - lag) * body.NextCommand.YawRate};
}

}  // namespace argos

#endif
