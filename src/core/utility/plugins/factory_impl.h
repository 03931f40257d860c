#ifndef ARGOS3_CORE_UTILITY_PLUGINS_FACTORY_IMPL_H
#define ARGOS3_CORE_UTILITY_PLUGINS_FACTORY_IMPL_H

// a path that existing code includes; everything is in factory.h
#include <argos3/core/utility/plugins/factory.h>

#endif
