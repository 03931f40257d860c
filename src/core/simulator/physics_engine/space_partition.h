#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_SPACE_PARTITION_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_SPACE_PARTITION_H

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/math/range.h>

namespace argos {

class CLoadErrors;

/**
 * Checks that the regions of engines fit together; adds every problem, with its geometry, to
 * @p errors.
 *
 * Engines of different types may share space: the first one in document order that accepts a body
 * owns it. So may engines without <boundaries>, which accept bodies outside all regions. Gates must
 * lead to an engine that exists and whose region is behind them.
 */
void CheckPartition(const CPhysicsEngine::TVector& engines, CLoadErrors& errors);

/** Sets the borders of each engine to others. @param arena m; borders outside are left out. */
void FindBorders(const CPhysicsEngine::TVector& engines, const CRange<CVector3>& arena);

/**
 * Replaces every <auto_partition> in <physics_engines> by its engines: a grid of count regions over
 * the arena, which are as nearly square as possible. The outer ones reach beyond the arena by its
 * longer side.
 * @param arena  the <arena> element: size and center; its own errors are reported elsewhere.
 * @return true if there is no problem; adds problems to @p errors.
 */
bool ExpandAutoPartitions(TConfigurationNode& section, TConfigurationNode& arena,
                          CLoadErrors& errors);

/** Documentation of <auto_partition>, for argos3 -q. */
extern const char* const kAutoPartitionDocumentation;

}  // namespace argos

#endif
