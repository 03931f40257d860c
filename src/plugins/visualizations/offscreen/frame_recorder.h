#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_RECORDER_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_RECORDER_H

#include <argos3/plugins/simulator/visualizations/offscreen/camera_timeline.h>
#include <argos3/plugins/simulator/visualizations/offscreen/frame_writer.h>
#include <argos3/plugins/simulator/visualizations/offscreen/renderer.h>
#include <argos3/plugins/simulator/visualizations/offscreen/scene.h>
#include <argos3/plugins/simulator/visualizations/offscreen/scene_builder.h>

#include <cstdint>
#include <optional>
#include <string>

namespace argos {

class CSimulator;
class CViewDrawing;

/** Selects the frames, their appearance and their files. */
struct SRecordingSettings {
  SRenderSettings Render;
  SFrameFileSettings File;
  std::uint32_t Every = 1; /**< ticks from frame to frame, > 0 */
  bool KeepLastFrame =
      true; /**< draw the final state even if its tick is not a multiple of Every */
  bool ShowGrid = true;
  bool ShowBoundary = true;
  bool ShowRays = true;
  std::string Announcement = "The off-screen visualization is "; /**< begins the line in the log */
};

/**
 * Runs an experiment and writes pictures of it.
 *
 * The constructor checks the settings. The thread that runs the experiment creates the OpenGL
 * context, which belongs to one thread.
 */
class CFrameRecorder {
 public:
  /**
   * @param drawing  what users' code draws; must outlive the recorder.
   * @throws CARGoSException as CFrameWriter.
   */
  CFrameRecorder(const SRecordingSettings& settings, const CCameraTimeline& timeline,
                 CViewDrawing& drawing);

  /**
   * Steps the simulator until the experiment is finished, and writes a frame of the state before
   * the first tick, after every n-th one, and perhaps of the final state.
   * @throws CARGoSException if a frame cannot be drawn or written; if another run writes frames of
   *   the same names, as CFrameWriter::LockFrames().
   */
  void Run(CSimulator& simulator);

 private:
  void Announce() const;
  void WriteFrame(CSimulator& simulator);

  SRecordingSettings m_settings;
  CCameraTimeline m_timeline;
  CViewDrawing& m_drawing;
  CFrameWriter m_writer;
  CSceneBuilder m_builder;
  std::optional<CRenderer> m_renderer;
  SScene m_scene;
  SPicture m_picture;
};

}  // namespace argos

#endif
