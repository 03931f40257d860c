#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_GHOST_DISCS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_GHOST_DISCS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <vector>

namespace argos {

class CPhysicsEngine;

/** A robot of another engine at the start of the tick: the circle around it, m, world frame. */
struct SGhostDisc {
  Real X, Y;
  Real Radius;
};

/**
 * Lists the ghosts of an engine that drive on a plane at that height, m; to be called while no body
 * moves, or in Update().
 *
 * Objects without a drive are left out: they must give way when pushed, and a ghost cannot.
 */
void ListGhostDiscs(const CPhysicsEngine& engine, Real elevation, std::vector<SGhostDisc>& discs);

}  // namespace argos

#endif
