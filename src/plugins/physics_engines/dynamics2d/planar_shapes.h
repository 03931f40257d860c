#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_SHAPES_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_SHAPES_H

#include <argos3/core/simulator/geometry/body_description.h>

class b2Body;

namespace argos {

/**
 * Shapes in Box2D exceed the described ones by this on each side, Box2D units.
 *
 * Box2D tolerates overlaps of shapes at rest up to its slop. Two shapes that are enlarged by half a
 * slop each reach this overlap when the described ones touch.
 */
extern const float kShapeMargin;

/** Adds a fixture for each solid of the description, seen from above, to @p body. */
void AddFixtures(b2Body& body, const SBodyDescription& description, Real unitsPerMetre,
                 Real friction);

/** Gives @p body the mass, centre of mass and moment of inertia of the description. */
void SetMass(b2Body& body, const SBodyDescription& description, Real unitsPerMetre);

/** Adds a fixture that is a disc around the origin. @param radius m. */
void AddDisc(b2Body& body, Real radius, Real unitsPerMetre, Real friction);

}  // namespace argos

#endif
