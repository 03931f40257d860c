#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_APPEARANCE_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_SIMULATOR_PIPUCK_APPEARANCE_H

#include <argos3/core/simulator/visualization/appearance.h>

namespace argos {

/** @return the appearance of Pi-Pucks. */
SAppearance MakePiPuckAppearance();

}  // namespace argos

#endif
