#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_OFFSCREEN_OUTPUT_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_OFFSCREEN_OUTPUT_H

#include <argos3/plugins/simulator/visualizations/offscreen/frame_output.h>

namespace argos {

/** Draws the arena into image files, with OpenGL and without a display: `<offscreen>`. */
class COffscreenOutput : public CFrameOutput {
 public:
  /** Reads the attributes that the plug-in's description lists. @throws CARGoSException with file
   * and line. */
  void Init(TConfigurationNode& tree) override { InitAsOffscreen(tree); }
};

}  // namespace argos

#endif
