#ifndef ARGOS3_CORE_SIMULATOR_TICK_TICK_TIMES_H
#define ARGOS3_CORE_SIMULATOR_TICK_TICK_TIMES_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/**
 * Wall time spent in each phase of the ticks measured so far, s. Sense and Control are summed over
 * threads: on one thread they are wall time.
 */
struct STickTimes {
  Real Act = 0.0;
  Real Physics = 0.0;
  Real Index = 0.0;
  Real Media = 0.0;
  Real PreStep = 0.0;
  Real SenseAndControl = 0.0; /**< the phase */
  Real Sense = 0.0; /**< within it */
  Real Control = 0.0; /**< within it */
  Real PostStep = 0.0;
  UInt64 Ticks = 0;
};

}  // namespace argos

#endif
