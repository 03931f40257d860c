#ifndef ARGOS3_TESTING_SUPPORT_SIGHT_REFERENCE_H
#define ARGOS3_TESTING_SUPPORT_SIGHT_REFERENCE_H

#include <argos3/core/utility/math/vector3.h>

#include <string>
#include <vector>

namespace argos {

class CLEDEntity;
class CSpace;

/**
 * True if no body but that of the root entity @p viewer hides @p point from @p eye (m, world
 * frame): one body after the other, straight from the definitions of their solids. What lies on the
 * surface of a body is not hidden from that side.
 */
bool ReferenceInSight(CSpace& space, const CVector3& eye, const CVector3& point,
                      const std::string& viewer);

/** All LEDs and lights that are enabled and not black, in order of creation. */
std::vector<CLEDEntity*> ReferenceLitLEDs(CSpace& space);

}  // namespace argos

#endif
