#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_RAY_HIT_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_RAY_HIT_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <vector>

namespace argos {

class CEmbodiedEntity;

/** One body crossed by a ray. */
struct SEmbodiedEntityIntersectionItem {
  CEmbodiedEntity* IntersectedEntity; /**< is not owned; null if nothing was hit */
  Real TOnRay; /**< fraction of the ray's length, [0,1]; 0 = start inside */

  SEmbodiedEntityIntersectionItem() : IntersectedEntity(nullptr), TOnRay(1.0) {}
  SEmbodiedEntityIntersectionItem(CEmbodiedEntity* entity, Real tOnRay)
      : IntersectedEntity(entity), TOnRay(tOnRay) {}
  bool operator<(const SEmbodiedEntityIntersectionItem& other) const {
    return TOnRay < other.TOnRay;
  }
};

typedef std::vector<SEmbodiedEntityIntersectionItem> TEmbodiedEntityIntersectionData;

}  // namespace argos

#endif
