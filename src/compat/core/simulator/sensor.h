#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SENSOR_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SENSOR_H

// the path that users' code includes
#include <argos3/core/simulator/entity/sensor.h>

#endif
