#ifndef ARGOS3_CORE_SIMULATOR_PLACEMENT_ARENA_FILLING_H
#define ARGOS3_CORE_SIMULATOR_PLACEMENT_ARENA_FILLING_H

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

class CSpace;

/**
 * Creates the entities that `<arena>` declares, in document order, then those of its `<distribute>`
 * elements. A failure is recorded in @p errors, and loading continues with the next entity.
 */
void FillArena(CSpace& space, TConfigurationNode& arena, CLoadErrors& errors);

}  // namespace argos

#endif
