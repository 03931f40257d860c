#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_APPEARANCE_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_APPEARANCE_H

#include <argos3/core/simulator/visualization/appearance.h>

namespace argos {

/** @return the appearance of eye-bots, in the frame of the origin. */
SAppearance MakeEyeBotAppearance();

}  // namespace argos

#endif
