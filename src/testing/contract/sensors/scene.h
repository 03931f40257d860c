#ifndef ARGOS3_TESTING_CONTRACT_SENSORS_SCENE_H
#define ARGOS3_TESTING_CONTRACT_SENSORS_SCENE_H

#include <argos3/core/utility/math/vector3.h>

#include <string>

namespace argos {

/*
 * The XML of what stands around robots in tests of sensors. Lengths in m, angles in degrees.
 */

/** Attributes of a `<body>`. @param position of the base, world frame. */
std::string Pose(const CVector3& position, Real yaw = 0.0);
/** An upright cylinder that does not move. */
std::string Cylinder(const std::string& id, const CVector3& position, Real radius,
                     Real height = 0.5);
/** A box that does not move. @param position of the centre of its base. */
std::string Box(const std::string& id, const CVector3& size, const CVector3& position,
                Real yaw = 0.0);
std::string Light(const std::string& id, const CVector3& position, Real intensity);

}  // namespace argos

#endif
