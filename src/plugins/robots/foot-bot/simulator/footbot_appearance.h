#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_APPEARANCE_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_APPEARANCE_H

#include <argos3/core/simulator/visualization/appearance.h>

namespace argos {

/** @return the appearance of foot-bots. */
SAppearance MakeFootBotAppearance();

}  // namespace argos

#endif
