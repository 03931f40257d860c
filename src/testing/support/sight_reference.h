#ifndef ARGOS3_TESTING_SUPPORT_SIGHT_REFERENCE_H
#define ARGOS3_TESTING_SUPPORT_SIGHT_REFERENCE_H

#include <argos3/core/utility/math/vector3.h>

#include <string>
#include <vector>

namespace argos {

class CLEDEntity;
class CSpace;

/**
 * @return true if no body except that of the root entity @p viewer occludes @p point from @p eye
 * (m, world frame), by brute force and from the definitions of the solids. Points on the surface of
 * a body are visible from that side.
 */
bool ReferenceInSight(CSpace& space, const CVector3& eye, const CVector3& point,
                      const std::string& viewer);

/** All LEDs and lights that are enabled and not black, in order of creation. */
std::vector<CLEDEntity*> ReferenceLitLEDs(CSpace& space);

}  // namespace argos

#endif
