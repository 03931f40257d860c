#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_CAMERA_XML_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_CAMERA_XML_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/simulator/visualizations/scene/camera_plan.h>
#include <argos3/plugins/simulator/visualizations/scene/camera_timeline.h>

namespace argos {

/**
 * Reads the `<camera>` child of a visualization, if there is one.
 *
 * Accepts `<placements>` with `<placement index="" position="" look_at="" up=""
 * lens_focal_length="" orthographic_height="">`, `<timeline loop="">` with `<keyframe placement=""
 * step="">` and
 * `<interpolate>`, and the older `<placement idx="">` right inside `<camera>`.
 *
 * @param visualization  the parent of `<camera>`.
 * @param timeline       holds the default placements, receives the others and the keyframes.
 * @throws CARGoSException with file and line, if something is missing, malformed or out of range.
 */
void ReadCamera(TConfigurationNode& visualization, CCameraTimeline& timeline);

/**
 * The same, with the attributes of `<camera>`: view, fit, projection, margin, lens_focal_length,
 * follow and reach. Placement 0 is the view, unless it is given as a `<placement>`.
 *
 * @param space     must contain the entity that `follow` names.
 * @param settings  its timeline holds the default placements.
 * @throws CARGoSException as ReadCamera(); if there is no such entity; if placement 0 is given in
 *         both ways.
 */
void ReadCameraSettings(TConfigurationNode& visualization, CSpace& space,
                        SCameraSettings& settings);

}  // namespace argos

#endif
