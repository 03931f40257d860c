#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_VISUALIZATION_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_VISUALIZATION_H

#include <argos3/core/simulator/default_visualization.h>
#include <argos3/core/simulator/view_drawing.h>

#include <memory>

namespace argos {

class CCameraTimeline;
class CFrameRecorder;
struct SRecordingSettings;

/**
 * Base of the visualizations that draw frames into image files; headless if none are requested.
 *
 * What `<user_functions>` in its element and the loop functions draw is part of the frames.
 */
class CFrameVisualization : public CDefaultVisualization {
 public:
  CFrameVisualization();
  ~CFrameVisualization() override;

  void Destroy() override;
  /** @throws CARGoSException also if a frame cannot be drawn or written. */
  void Execute() override;

 protected:
  /** Prepares frames as the attributes of `<offscreen>` say. @throws CARGoSException with file and
   * line. */
  void InitAsOffscreen(TConfigurationNode& tree);
  /** The same for `<qt-opengl>`, which may request none. */
  void InitAsQtOpenGl(TConfigurationNode& tree);

 private:
  void InitFrames(TConfigurationNode& tree, const SRecordingSettings& settings,
                  const CCameraTimeline& timeline);

  CViewDrawing m_drawing;
  std::unique_ptr<CFrameRecorder> m_recorder;  // null: headless
};

}  // namespace argos

#endif
