#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_OFFSCREEN_XML_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_OFFSCREEN_XML_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/simulator/visualizations/offscreen/frame_series.h>

namespace argos {

/**
 * Reads the attributes of `<offscreen>`, see the visualization's description.
 * @throws CARGoSException with file and line, if one does not parse or is out of range.
 */
SFrameSeriesSettings ReadOffscreenSettings(TConfigurationNode& node);

/** Sets what depends on the experiment: of a film, the time of a tick, and a default of "every". */
void CompleteFilmSettings(SFrameSeriesSettings& settings, UInt32 ticksPerSecond);

/** The settings in the elements and attributes of `<qt-opengl>`. */
struct SQtOpenGlRequest {
  bool WantsFrames = false;
  bool HasUserFunctions = false;
  SFrameSeriesSettings Frames;
};

/**
 * Reads `<qt-opengl>` except its camera. Settings that only a window needs are checked and ignored.
 * @throws CARGoSException with file and line, if something does not parse or is out of range.
 */
SQtOpenGlRequest ReadQtOpenGlRequest(TConfigurationNode& node);

}  // namespace argos

#endif
