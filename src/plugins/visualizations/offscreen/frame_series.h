#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_SERIES_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_SERIES_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/visualizations/scene/camera_plan.h>
#include <argos3/plugins/simulator/visualizations/offscreen/film_encoding.h>
#include <argos3/plugins/simulator/visualizations/offscreen/frame_pipeline.h>
#include <argos3/plugins/simulator/visualizations/offscreen/frame_writer.h>
#include <argos3/plugins/simulator/visualizations/offscreen/renderer.h>
#include <argos3/plugins/simulator/visualizations/scene/frame_choice.h>
#include <argos3/plugins/simulator/visualizations/scene/scene_builder.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace argos {

class CPictureSink;
class CSimulator;
class CViewDrawing;

/** Selects the frames, their appearance and their files, or their film. */
struct SFrameSeriesSettings : SFrameChoice, SFrameContents {
  SRenderSettings Render;
  SFrameFileSettings File;
  std::optional<SFilmSettings> Film; /**< a film is written in place of files if it is set */
  bool ChoosesEvery = false; /**< a film whose Every is set by ChooseEvery() */
  std::string Announcement = "The off-screen visualization is "; /**< begins the line in the log */
};

/**
 * Writes pictures of a run: of the state before the first tick, after every n-th one, and perhaps
 * of the final state. Pictures of a film have the same distance in ticks.
 *
 * The constructor checks the settings. The first call of Observe() starts the threads that draw
 * and write, see CFramePipeline; scenes are built, and users' code draws, in Observe().
 */
class CFrameSeries : private CNonCopyable {
 public:
  /**
   * @param drawing  what users' code draws; must outlive the series.
   * @throws CARGoSException as CFrameWriter and CFilmWriter.
   */
  CFrameSeries(const SFrameSeriesSettings& settings, const SCameraSettings& camera,
               CViewDrawing& drawing);
  ~CFrameSeries();

  /**
   * Called with the first state and after each tick.
   * @throws CARGoSException if an earlier frame cannot be drawn or written; if another run writes
   * the same files, as CPictureSink::Begin().
   */
  void Observe(CSimulator& simulator);
  /** Writes the final state if it has no frame yet, and waits for all frames. @throws
   * CARGoSException as Observe(). */
  void Finish(CSimulator& simulator);
  /** The next state begins another run, whose frames replace those of the same names. */
  void Reset();
  /** Completes the output of a run that has not ended in order. @throws CARGoSException as
   * Finish(). */
  void Close();

 private:
  void Begin();
  void Announce() const;
  bool IsWanted(std::uint32_t tick) const;
  void WriteFrame(CSimulator& simulator);

  SFrameSeriesSettings m_settings;
  CCameraPlan m_camera;
  CViewDrawing& m_drawing;
  std::unique_ptr<CPictureSink> m_sink;
  bool m_hasBegun = false;  // a run, whose output is not complete
  std::optional<std::uint32_t> m_lastTick;  // last tick of this run that has a frame
  std::optional<std::uint32_t> m_distance;  // ticks between the first two frames of this run
  CSceneBuilder m_builder;
  std::optional<CFramePipeline> m_pipeline;  // the last member: its threads use the others
};

}  // namespace argos

#endif
