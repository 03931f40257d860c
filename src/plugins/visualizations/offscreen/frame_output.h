#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_OUTPUT_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_OUTPUT_H

#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/visualization/view_drawing.h>

#include <memory>

namespace argos {

class CFrameSeries;
struct SCameraSettings;
struct SFrameSeriesSettings;

/**
 * Base of the views that draw frames into image files or films; draws nothing if none are
 * requested.
 *
 * What `<user_functions>` in its element and the loop functions draw is part of the frames.
 */
class CFrameOutput : public CRunOutput {
 public:
  CFrameOutput();
  ~CFrameOutput() override;

  void Reset() override;
  /** @throws CARGoSException if what an unfinished run has left cannot be completed. */
  void Destroy() override;
  /** @throws CARGoSException if a frame or a film cannot be drawn or written. */
  void Observe(CSimulator& simulator) override;
  void Finish(CSimulator& simulator) override;

 protected:
  /** Prepares frames as the attributes of `<offscreen>` say. @throws CARGoSException with file and
   * line. */
  void InitAsOffscreen(TConfigurationNode& tree);
  /** The same for `<qt-opengl>`, which may request none. */
  void InitAsQtOpenGl(TConfigurationNode& tree);

 private:
  void InitFrames(TConfigurationNode& tree, const SFrameSeriesSettings& settings,
                  const SCameraSettings& camera);

  CViewDrawing m_drawing;
  std::unique_ptr<CFrameSeries> m_series;  // null: headless
};

}  // namespace argos

#endif
