#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_QUERY_PLUGINS_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_QUERY_PLUGINS_H

// the path that users' code includes
#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/program/query_plugins.h>
#endif

#endif
