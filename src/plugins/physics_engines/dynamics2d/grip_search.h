#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_GRIP_SEARCH_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_GRIP_SEARCH_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solids.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>
#include <argos3/plugins/simulator/physics_engines/planar/disc_pairs.h>

#include <optional>

namespace argos {

/** A place on a body that a gripper can reach. */
struct SGripPlace {
  SPlanarOwner Owner;
  SPlanarVector Point = {};  // m; next to the gripper, if sides of the arena are joined
};

/**
 * Finds the place that a gripper reaches: of all grippable bodies in the disc, the one with the
 * point nearest to the centre; of equally near ones, that of the entity with the lowest index. The
 * point is the nearest one of the described solids, or the centre if it is inside one.
 * @param solids  of this tick.
 * @param centre  of the disc, m. @param radius m.
 * @param own     the gripper's own body.
 */
std::optional<SGripPlace> FindGripPlace(const CPlanarStore& store, const CDiscPairs& discPairs,
                                        CCrowdSolids& solids, const SPlanarVector& centre,
                                        Real radius, const SPlanarHandle& own);

}  // namespace argos

#endif
