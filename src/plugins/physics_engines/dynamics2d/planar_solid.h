#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_SOLID_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_SOLID_H

#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>

#include <vector>

namespace argos {

/** The shape and mass of a movable body that is not a disc with a drive. */
struct SPlanarSolid {
  std::vector<SFootprint> Parts;  // in the frame of the body
  Real CentreX = 0.0, CentreY = 0.0;  // of mass, in the frame of the body, m
  Real Mass = 0.0;  // kg
  Real Inertia = 0.0;  // about the centre of mass, kg m^2
  Real Radius = 0.0;  // of the circle around the centre of mass that contains all parts, m
  Real NarrowestHalf = 0.0;  // half of its narrowest side, m
  SGroundFriction Friction = {0.0, 0.0};  // bounds; none for a robot
};

SPlanarSolid DescribeSolid(const SBodyDescription& description, const SGroundFriction& friction);

}  // namespace argos

#endif
