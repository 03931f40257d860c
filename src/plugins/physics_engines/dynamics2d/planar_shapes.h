#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_SHAPES_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_SHAPES_H

#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/encounters.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>

#include <vector>

class b2Body;

namespace argos {

/**
 * Shapes are larger than described by this on each side, Box2D units.
 *
 * Box2D lets shapes at rest overlap by its slop. Two shapes grown by half a slop each do so when
 * the described ones touch.
 */
extern const float kShapeMargin;

/** Adds a fixture for each solid of the description, seen from above, to @p body. */
void AddFixtures(b2Body& body, const SBodyDescription& description, Real unitsPerMetre,
                 Real friction);

/** Gives @p body the mass, centre of mass and moment of inertia of the description. */
void SetMass(b2Body& body, const SBodyDescription& description, Real unitsPerMetre);

/** Adds a fixture that is a disc around the origin. @param radius m. */
void AddDisc(b2Body& body, Real radius, Real unitsPerMetre, Real friction);

/** The solids of a body at that pose, seen from above; tilted ones are bounded by discs. */
std::vector<SObstacle> DescribeObstacles(const SBodyDescription& description,
                                         const SPlanarPose& pose);

/** Is it one disc around the origin? */
bool IsCentredDisc(const SBodyDescription& description);

/** Half of the narrowest side of any solid seen from above, m. */
Real ComputeNarrowestHalf(const SBodyDescription& description);

}  // namespace argos

#endif
