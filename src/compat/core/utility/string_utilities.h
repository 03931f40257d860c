#ifndef ARGOS3_COMPAT_CORE_UTILITY_STRING_UTILITIES_H
#define ARGOS3_COMPAT_CORE_UTILITY_STRING_UTILITIES_H

// the path that users' code includes
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/text/string_utilities.h>

#endif
