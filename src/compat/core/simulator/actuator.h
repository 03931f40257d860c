#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_ACTUATOR_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_ACTUATOR_H

// the path that users' code includes
#include <argos3/core/simulator/entity/actuator.h>

#endif
