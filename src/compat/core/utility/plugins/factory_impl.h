#ifndef ARGOS3_COMPAT_CORE_UTILITY_PLUGINS_FACTORY_IMPL_H
#define ARGOS3_COMPAT_CORE_UTILITY_PLUGINS_FACTORY_IMPL_H

// kept for compatibility of include paths; factory.h contains everything
#include <argos3/core/utility/plugins/factory.h>

#endif
