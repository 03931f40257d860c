#ifndef ARGOS3_TESTING_SUPPORT_ARENA_TEXT_H
#define ARGOS3_TESTING_SUPPORT_ARENA_TEXT_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector3.h>

#include <string>

/* XML of objects in an arena, with all digits of their numbers. Lengths in m. */

namespace argos {

/** All digits. */
std::string ToText(Real value);
/** "x,y,z" with all digits. */
std::string ToText(const CVector3& vector);
/** Attributes of a `<body>`. */
std::string PoseText(const CVector3& position, Real yawDegrees = 0.0);
/** A fixed cylinder standing on the ground. */
std::string PillarText(const std::string& id, Real x, Real y, Real radius, Real height);
/** A fixed box. @param position  of the centre of its base. */
std::string BoxText(const std::string& id, const CVector3& size, const CVector3& position,
                    Real yawDegrees = 0.0);
/** A light of intensity 1 in the medium "leds". */
std::string LightText(const std::string& id, const CVector3& position,
                      const std::string& color = "red");

}  // namespace argos

#endif
