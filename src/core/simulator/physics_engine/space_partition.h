#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_SPACE_PARTITION_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_SPACE_PARTITION_H

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/math/range.h>

namespace argos {

class CLoadErrors;

/**
 * Checks how the regions of engines fit together; every problem is noted in @p errors, with its
 * geometry.
 *
 * Engines of different types may share space: the first one in document order that houses a body
 * takes it. So may engines without <boundaries>, which take what is outside all regions. Gates lead
 * to an engine that exists and whose region is behind them.
 */
void CheckPartition(const CPhysicsEngine::TVector& engines, CLoadErrors& errors);

/** Tells each engine where its borders to others are. @param arena m; of what is inside it. */
void FindBorders(const CPhysicsEngine::TVector& engines, const CRange<CVector3>& arena);

/**
 * Replaces every <auto_partition> in <physics_engines> by the engines that it stands for: a grid of
 * count regions over the arena, as square as can be. The outer ones reach beyond the arena, by its
 * longer side.
 * @param arena  the <arena> element: size and center; what is wrong with it is not noted here.
 * @return whether all is right; problems are noted in @p errors.
 */
bool ExpandAutoPartitions(TConfigurationNode& section, TConfigurationNode& arena,
                          CLoadErrors& errors);

/** Documentation of <auto_partition>, for argos3 -q. */
extern const char* const kAutoPartitionDocumentation;

}  // namespace argos

#endif
