#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_SPACE_MULTI_THREAD_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_SPACE_MULTI_THREAD_H

#include <argos3/core/simulator/space/space.h>

namespace argos {

/** The space of a run with several threads; the pool's schedule distributes the work. */
using CSpaceMultiThread = CSpace;

}  // namespace argos

#endif
