#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_SPACE_MULTI_THREAD_BALANCE_LENGTH_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_SPACE_MULTI_THREAD_BALANCE_LENGTH_H

#include <argos3/core/simulator/space/space.h>

namespace argos {

/** The space of a run with `method="balance_length"`: the pool's schedule makes the difference. */
using CSpaceMultiThreadBalanceLength = CSpace;

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/space/space_multi_thread.h>
#endif

#endif
