#ifndef ARGOS3_PLUGINS_ROBOTS_E_PUCK_SIMULATOR_EPUCK_APPEARANCE_H
#define ARGOS3_PLUGINS_ROBOTS_E_PUCK_SIMULATOR_EPUCK_APPEARANCE_H

#include <argos3/core/simulator/visualization/appearance.h>

namespace argos {

/** @return the appearance of e-pucks. */
SAppearance MakeEPuckAppearance();

}  // namespace argos

#endif
