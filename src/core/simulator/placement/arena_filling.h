#ifndef ARGOS3_CORE_SIMULATOR_PLACEMENT_ARENA_FILLING_H
#define ARGOS3_CORE_SIMULATOR_PLACEMENT_ARENA_FILLING_H

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

class CSpace;

/**
 * Puts what `<arena>` declares into the space: the entities in document order, then the
 * `<distribute>` elements. An entity that fails is noted in @p errors, and the next one follows.
 */
void FillArena(CSpace& space, TConfigurationNode& arena, CLoadErrors& errors);

}  // namespace argos

#endif
