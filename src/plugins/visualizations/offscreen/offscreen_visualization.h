#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_OFFSCREEN_VISUALIZATION_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_OFFSCREEN_VISUALIZATION_H

#include <argos3/core/simulator/visualization/visualization.h>

#include <memory>

namespace argos {

class CFrameRecorder;

/** Draws the arena into image files, with OpenGL and without a display: `<offscreen>`. */
class COffscreenVisualization : public CVisualization {
 public:
  COffscreenVisualization();
  ~COffscreenVisualization() override;

  /** Reads the attributes that the plug-in's description lists. @throws CARGoSException with file
   * and line. */
  void Init(TConfigurationNode& tree) override;
  void Destroy() override;

  /** @throws CARGoSException also if a frame cannot be drawn or written. */
  void Execute() override;

 private:
  std::unique_ptr<CFrameRecorder> m_recorder;
};

}  // namespace argos

#endif
