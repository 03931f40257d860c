#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_RAY_QUERIES_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_RAY_QUERIES_H

#include <argos3/core/simulator/geometry/ray_hit.h>
#include <argos3/core/utility/math/ray3.h>

namespace argos {

/**
 * Finds all bodies of the calling thread's current simulator that @p ray crosses.
 * @param data cleared first; unsorted afterwards, each body once.
 * @return true if any body was hit.
 */
bool GetEmbodiedEntitiesIntersectedByRay(TEmbodiedEntityIntersectionData& data, const CRay3& ray);

/** Finds the first body that @p ray meets. @return false, with no entity in @p item, if none. */
bool GetClosestEmbodiedEntityIntersectedByRay(SEmbodiedEntityIntersectionItem& item,
                                              const CRay3& ray);

/** The same without the body @p ignored. */
bool GetClosestEmbodiedEntityIntersectedByRay(SEmbodiedEntityIntersectionItem& item,
                                              const CRay3& ray, CEmbodiedEntity& ignored);

}  // namespace argos

#endif
