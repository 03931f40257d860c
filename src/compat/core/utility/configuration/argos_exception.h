#ifndef ARGOS3_COMPAT_CORE_UTILITY_CONFIGURATION_ARGOS_EXCEPTION_H
#define ARGOS3_COMPAT_CORE_UTILITY_CONFIGURATION_ARGOS_EXCEPTION_H

// the path that users' code includes
#include <argos3/core/utility/errors/argos_exception.h>

#endif
