#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_UNITS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_UNITS_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** Several sensors measure in centimeters, as in ARGoS 3. */
inline constexpr Real kCentimetersPerMeter = 100.0;

}  // namespace argos

#endif
