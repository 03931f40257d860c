#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_OFFSCREEN_VISUALIZATION_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_OFFSCREEN_VISUALIZATION_H

#include <argos3/plugins/simulator/visualizations/offscreen/frame_visualization.h>

namespace argos {

/** Draws the arena into image files, with OpenGL and without a display: `<offscreen>`. */
class COffscreenVisualization : public CFrameVisualization {
 public:
  /** Reads the attributes that the plug-in's description lists. @throws CARGoSException with file
   * and line. */
  void Init(TConfigurationNode& tree) override { InitAsOffscreen(tree); }
};

}  // namespace argos

#endif
