#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_POVRAY_FRAME_SERIES_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_POVRAY_FRAME_SERIES_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/visualizations/povray/povray_renderer.h>
#include <argos3/plugins/simulator/visualizations/povray/scene_file.h>
#include <argos3/plugins/simulator/visualizations/scene/camera_plan.h>
#include <argos3/plugins/simulator/visualizations/scene/frame_choice.h>
#include <argos3/plugins/simulator/visualizations/scene/frame_files.h>
#include <argos3/plugins/simulator/visualizations/scene/scene_builder.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace argos {

class CLockFile;
class CSimulator;
class CViewDrawing;

/** What the attributes of `<povray>` say. */
struct SPovrayFrameSettings : SFrameChoice, SFrameContents {
  enum class ERender : std::uint8_t { No, Yes, IfInstalled };

  SPovraySettings Scene;
  std::string Directory = "out";
  std::string BaseName = "scene_";
  ERender Render = ERender::IfInstalled;
  std::uint32_t Threads = 0; /**< threads of POV-Ray; 0: one per core */
  bool UseModels = true; /**< if false, all entities appear as the parts of their appearances */
};

/** The models of types of entities, looked up when a type first appears; see CPovrayModel. */
class CPovrayModels {
 public:
  /** @return valid as long as this object. */
  const CSceneBuilder::TModels& Find(const std::string& type);

  /** Texts by number. */
  const std::vector<std::string>& GetObjects() const { return m_objects; }

 private:
  std::map<std::string, CSceneBuilder::TModels>
      m_models;  // keys are types; empty if a type has none
  std::vector<std::string> m_objects;
};

/**
 * Writes scene files of a run, and starts POV-Ray for them. Files are written in Observe();
 * pictures follow on another thread.
 */
class CPovrayFrameSeries : private CNonCopyable {
 public:
  /**
   * @param drawing  what users' code draws; must outlive the series.
   * @throws CARGoSException as CFrameFiles; if pictures are required and POV-Ray is not installed.
   */
  CPovrayFrameSeries(const SPovrayFrameSettings& settings, const SCameraSettings& camera,
                     CViewDrawing& drawing);
  ~CPovrayFrameSeries();

  /**
   * Called with the first state and after each tick.
   * @throws CARGoSException if a scene cannot be written, or an earlier one not be rendered.
   */
  void Observe(CSimulator& simulator);
  /** Writes the final state if it has no file yet; waits for all pictures. @throws as Observe(). */
  void Finish(CSimulator& simulator);
  /** The next state begins another run, whose files replace those of the same names. */
  void Reset();

 private:
  SPovrayJob MakeJob() const;
  void Begin();
  void WriteScene(CSimulator& simulator);
  // returns its name; empty: no image
  std::string WriteFloor();
  void WarnSkipped(std::size_t number, std::uint32_t tick);

  SPovrayFrameSettings m_settings;
  CCameraPlan m_camera;
  CViewDrawing& m_drawing;
  CFrameFiles m_files;
  std::unique_ptr<CLockFile> m_lock;  // held from the first file to the last
  CPovrayModels m_models;
  CSceneBuilder m_builder;
  SScene m_scene;
  std::optional<std::uint32_t> m_lastTick;  // last tick of this run that has a file
  std::uint64_t m_floorVersion = 0;  // SFloorImage::Version of the file
  std::string m_floorFile;
  bool m_hasWarned = false;
  std::unique_ptr<CPovrayRenderer> m_renderer;  // null: scene files only
};

}  // namespace argos

#endif
