#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_RAY_LINES_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_RAY_LINES_H

#include <argos3/plugins/simulator/visualizations/scene/scene_parts.h>

namespace argos {

class CControllableEntity;

/**
 * Adds the rays that a robot's sensors recorded, and the points that they hit. An obstructed ray
 * ends at its hit; it has its full length if no hit was recorded on it.
 */
void AddRayLines(CControllableEntity& robot, SScene& scene);

}  // namespace argos

#endif
