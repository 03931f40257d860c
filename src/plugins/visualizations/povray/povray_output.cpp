#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/view_drawing.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/visualizations/povray/povray_frame_series.h>
#include <argos3/plugins/simulator/visualizations/povray/povray_xml.h>
#include <argos3/plugins/simulator/visualizations/scene/camera_xml.h>

#include <memory>

namespace argos {

/** Writes scene files for POV-Ray, and renders them where it is installed: `<povray>`. */
class CPovrayOutput : public CRunOutput {
 public:
  /** @throws CARGoSException with file and line. */
  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  /** @throws CARGoSException if a scene cannot be written or rendered. */
  void Observe(CSimulator& simulator) override;
  void Finish(CSimulator& simulator) override;

 private:
  CViewDrawing m_drawing;
  std::unique_ptr<CPovrayFrameSeries> m_series;  // null before Init() and after Destroy()
};

void CPovrayOutput::Init(TConfigurationNode& tree) {
  const SPovrayFrameSettings settings = ReadPovraySettings(tree);
  CSpace& space = CurrentSpace();
  SCameraSettings camera(CCameraTimeline(
      MakeDefaultPlacements({ToEigen(space.GetArenaCenter()), ToEigen(space.GetArenaSize())})));
  ReadCameraSettings(tree, space, camera);
  try {
    m_series = std::make_unique<CPovrayFrameSeries>(settings, camera, m_drawing);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(tree) << " cannot write scenes", ex);
  }
  m_drawing.Init(tree);
}

void CPovrayOutput::Reset() {
  if (m_series != nullptr) {
    m_series->Reset();
  }
}

void CPovrayOutput::Destroy() {
  m_series.reset();
  m_drawing.Destroy();
}

void CPovrayOutput::Observe(CSimulator& simulator) {
  m_series->Observe(simulator);
}

void CPovrayOutput::Finish(CSimulator& simulator) {
  m_series->Finish(simulator);
}

REGISTER_RUN_OUTPUT(
    CPovrayOutput, "povray", "the authors of this project", "1.0",
    "Writes scene files for the ray tracer POV-Ray, and renders them.",
    R"(Writes a scene file of the state before the first tick, after every n-th tick, and of the final
state: <directory>/<base_name><tick, 10 digits>.pov. Where POV-Ray 3.7 is installed, it renders
each of them to a picture with the ending .png, with soft shadows, reflections, glass and the light
of lamps and LEDs; it takes seconds per picture. POV-Ray runs one scene at a time, beside the
simulation; when two scenes wait, the simulation waits. Files appear under their names only when
they are complete. The view does not change the experiment.

The environment variable ARGOS_POVRAY names the program, if it is not "povray".

REQUIRED XML CONFIGURATION

  <visualization>
    <povray />
  </visualization>

OPTIONAL XML CONFIGURATION

  <visualization>
    <povray directory="out" base_name="scene_" size="1280x960" every="1" ticks="0-50,100"
            quality="good" look="light" render="auto" threads="0" max_lights="8"
            show_grid="true" show_boundary="true" show_rays="true" models="true">
      <camera view="oblique" fit="arena">
        <placements>
          <placement index="1" position="2,2,1" look_at="0,0,0" up="0,0,1"
                     lens_focal_length="30" />
        </placements>
        <timeline loop="200">
          <keyframe placement="0" step="0" />
          <interpolate />
          <keyframe placement="1" step="100" />
        </timeline>
      </camera>
      <overlays>
        <clock />
      </overlays>
      <user_functions label="my_drawing" library="path/to/library" />
    </povray>
  </visualization>

Attributes of <povray>:
  directory      path; folder of the files, created if missing. Default: out
  base_name      string without a slash; prefix of their names. POV-Ray opens names of ASCII characters only. Default: scene_
  size           WxH, pixels, each from 16 to 16384. Default: 1280x960
  width, height  the same as two attributes, pixels
  every          integer, at least 1, ticks; every n-th tick has a scene. Default: 1
  ticks          ticks and ranges of ticks, increasing, separated by commas: only they
                 have scenes, of these every n-th tick. Default: the whole run
  quality        draft: hard shadows, no light from surfaces; good: soft shadows and
                 light that surfaces reflect; best: the same with less noise, many times
                 as slow. Default: good
  look           light (for print) or dark (for slides; LEDs shine on the floor).
                 Default: light
  render         true: POV-Ray must be installed; auto: renders if it is, otherwise says
                 how to; false: scene files only. Default: auto
  threads        integer, at most 512; of POV-Ray; 0: one per core. Default: 0
  max_lights     integer, at most 1000; light sources for LEDs, and as many for lamps.
                 Others glow without lighting anything; the light of LEDs is shared out.
                 Default: 8
  ground_texture, ground_texture_size
                 path, m; as in <offscreen>. Default: none
  show_grid      bool; lines on the ground every 0.1, 1 and 10 m. Default: true
  show_boundary  bool; the outline of the arena. Default: true
  show_rays      bool; the rays of sensors that have show_rays="true". Default: true
  models         bool; finer models of types that have some, such as the foot-bot and the
                 eye-bot. Default: true

<camera>, <overlays> and <user_functions> are those of <offscreen>: see argos3 -q offscreen. Texts
have POV-Ray's own fonts. If the floor has an image, it is a file <base_name>floor_<number>.ppm
beside the scenes.
)",
    "Usable")

}  // namespace argos
