#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_VISUALIZATION_DEFAULT_VISUALIZATION_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_VISUALIZATION_DEFAULT_VISUALIZATION_H

// the path that users' code includes
#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/default_visualization.h>
#endif

#endif
