#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_QTOPENGL_VISUALIZATION_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_QTOPENGL_VISUALIZATION_H

#include <argos3/core/simulator/default_visualization.h>

#include <memory>

namespace argos {

class CFrameRecorder;

/**
 * Runs experiments whose file requests the window `<qt-opengl>`, which this simulator does not
 * have: headless, or with frames drawn off-screen if the file requests frame grabbing.
 */
class CQtOpenGlVisualization : public CDefaultVisualization {
 public:
  CQtOpenGlVisualization();
  ~CQtOpenGlVisualization() override;

  /** Reads the attributes that the plug-in's description lists. @throws CARGoSException with file
   * and line. */
  void Init(TConfigurationNode& tree) override;
  void Destroy() override;

  /** @throws CARGoSException also if a frame cannot be drawn or written. */
  void Execute() override;

 private:
  std::unique_ptr<CFrameRecorder> m_recorder;  // null: headless
};

}  // namespace argos

#endif
