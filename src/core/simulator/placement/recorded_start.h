#ifndef ARGOS3_CORE_SIMULATOR_PLACEMENT_RECORDED_START_H
#define ARGOS3_CORE_SIMULATOR_PLACEMENT_RECORDED_START_H

#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

class CSpace;

/**
 * Puts entities where those of the same ids were in a recorded run, if `<arena>` has the attribute
 * `start_from`, a recording; `start_at` is a tick of it, such as "100", or a time, such as "12.5s",
 * by default that of its last state. These poses become the initial ones, which Reset() restores.
 *
 * Entities that the recording does not have, and bodies that cannot move, stay where they are.
 * Velocities, readings and the states of controllers are those of a new run.
 * @throws CARGoSException if there is no such state, if no entity of the arena is in it, if one of
 *   them overlaps a body there that the recording does not have, or if `<arena>` has
 *   redistribute="true".
 */
void PlaceAsRecorded(CSpace& space, TConfigurationNode& arena);

}  // namespace argos

#endif
