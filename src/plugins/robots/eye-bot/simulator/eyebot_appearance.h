#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_APPEARANCE_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_APPEARANCE_H

#include <argos3/core/simulator/visualization/appearance.h>

namespace argos {

/** What every eye-bot looks like, in the frame of its origin. */
SAppearance MakeEyeBotAppearance();

}  // namespace argos

#endif
