#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_SPACE_NO_THREADS_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_SPACE_NO_THREADS_H

#include <argos3/core/simulator/space/space.h>

namespace argos {

/** The space of a run with `threads="0"`: the pool has no workers. */
using CSpaceNoThreads = CSpace;

}  // namespace argos

#endif
