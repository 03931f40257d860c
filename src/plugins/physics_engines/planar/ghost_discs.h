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
 * Lists those of an engine's ghosts that drive on a plane at that height, m; to be called while
 * nobody moves, or in Update().
 *
 * Things without a drive are left out: a ghost cannot be pushed, and they are to be.
 */
void ListGhostDiscs(const CPhysicsEngine& engine, Real elevation, std::vector<SGhostDisc>& discs);

}  // namespace argos

#endif
