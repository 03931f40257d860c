#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_LOOP_FUNCTIONS_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_LOOP_FUNCTIONS_H

// the path that users' code includes
#include <argos3/core/simulator/tick/loop_functions.h>

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/simulator.h>
#endif

#endif
