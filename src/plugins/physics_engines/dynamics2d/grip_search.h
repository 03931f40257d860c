#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_GRIP_SEARCH_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_GRIP_SEARCH_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_bodies.h>

#include <box2d/box2d.h>

#include <vector>

namespace argos {

/** A place on a body that a gripper can reach. */
struct SGripPlace {
  b2Body* Body = nullptr;  // null: there is none
  b2Vec2 Point = b2Vec2_zero;  // world frame, Box2D units
};

/**
 * Finds the place that a gripper reaches: of all bodies in the disc, the one with the point nearest
 * to the centre; of equally near ones, that of the entity with the lowest index. The point is the
 * nearest one of the described solids, or the centre if it is inside one.
 * @param radius     Box2D units.
 * @param grippable  owners by number of body; empty for bodies that cannot be gripped.
 * @param own        the gripper's own body.
 */
SGripPlace FindGripPlace(const b2World& world, const b2Vec2& centre, float radius,
                         const std::vector<SPlanarOwner>& grippable, const b2Body& own);

}  // namespace argos

#endif
