#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_SETTINGS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_SETTINGS_H

#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>

namespace argos {

/** The parameters of a planar world. */
struct SPlanarSettings {
  Real Tick = 0.1;  // s
  Real VelocityLag = 0.0;  // of drives, as a share of a tick
  UInt32 Substeps = 1;  // least number in a tick; more if a body is very fast
  bool RefineInCrowds = true;  // more substeps also while overlaps remain
  Real SmallestRadius = 0.1;  // of a movable body, or half of a narrowest side, m
  SGroundFriction BoxFriction;
  SGroundFriction CylinderFriction;
  SPeriodicity Period;  // of the arena, in the frame of the engine
  Real GrippingRigidity = 10000.0;  // N/m; 0: grippers hold nothing
};

}  // namespace argos

#endif
