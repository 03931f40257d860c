#ifndef ARGOS3_CORE_SIMULATOR_QUERY_PLUGINS_H
#define ARGOS3_CORE_SIMULATOR_QUERY_PLUGINS_H

// the path that users' code includes
#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/program/query_plugins.h>
#endif

#endif
