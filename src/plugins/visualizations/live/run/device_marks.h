#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_DEVICE_MARKS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_DEVICE_MARKS_H

#include <argos3/plugins/simulator/visualizations/live/link/live_messages.h>

namespace argos {

class CEntity;

/**
 * What the sensors of a robot have perceived, where it is in the robot's frame: a list of objects
 * with "kind" ("blob" or "message"), "sensor" (its label), "range" (m), "bearing" and "elevation"
 * (rad) and, of blobs, "color" ([r,g,b]). At most 200; empty if the entity is no robot.
 */
TJson ReadDeviceMarks(CEntity& root);

/** The readings of a foot-bot's ring of light sensors, by column; null if it has none. */
TJson ReadLight(CEntity& root);

}  // namespace argos

#endif
