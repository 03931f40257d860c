#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_CAMERA_XML_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_CAMERA_XML_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/simulator/visualizations/offscreen/camera_timeline.h>

namespace argos {

/**
 * Reads the `<camera>` child of a visualization, if there is one.
 *
 * Accepts `<placements>` with `<placement index="" position="" look_at="" up=""
 * lens_focal_length="">`, `<timeline loop="">` with `<keyframe placement="" step="">` and
 * `<interpolate>`, and the older `<placement idx="">` right inside `<camera>`.
 *
 * @param visualization  the parent of `<camera>`.
 * @param timeline       holds the default placements, receives the others and the keyframes.
 * @throws CARGoSException with file and line, if something is missing, malformed or out of range.
 */
void ReadCamera(TConfigurationNode& visualization, CCameraTimeline& timeline);

}  // namespace argos

#endif
