#include <argos3/plugins/simulator/visualizations/offscreen/frame_output.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/plugins/simulator/visualizations/offscreen/camera_xml.h>
#include <argos3/plugins/simulator/visualizations/offscreen/frame_recorder.h>
#include <argos3/plugins/simulator/visualizations/offscreen/recording_xml.h>

#include <algorithm>

namespace argos {

namespace {

// height above the ground that the picture must show, m: the whole arena if something flies
double ComputeTop(CSpace& space) {
  for (CEntity* root : space.GetRootEntityVector()) {
    const CEmbodiedEntity* const body = FindDescribedBody(*root);
    if (body != nullptr && body->GetBodyDescription()->Propellers) {
      return std::max(0.0, space.GetArenaLimits().GetMax().GetZ());
    }
  }
  return 0.0;
}

SArenaBox GetArenaBox(const CSpace& space) {
  return {ToEigen(space.GetArenaCenter()), ToEigen(space.GetArenaSize())};
}

}  // namespace

CFrameOutput::CFrameOutput() = default;
CFrameOutput::~CFrameOutput() = default;

void CFrameOutput::InitAsOffscreen(TConfigurationNode& tree) {
  const SRecordingSettings settings = ReadOffscreenSettings(tree);
  const SArenaBox arena = GetArenaBox(CurrentSpace());
  CCameraTimeline timeline(MakeDefaultPlacements(arena));
  const double aspectRatio = static_cast<double>(settings.Render.Width) / settings.Render.Height;
  timeline.SetPlacement(0, MakeFramingPlacement(arena, aspectRatio, ComputeTop(CurrentSpace())));
  ReadCamera(tree, timeline);
  InitFrames(tree, settings, timeline);
}

void CFrameOutput::InitAsQtOpenGl(TConfigurationNode& tree) {
  const SQtOpenGlRequest request = ReadQtOpenGlRequest(tree);
  CCameraTimeline timeline(MakeDefaultPlacements(GetArenaBox(CurrentSpace())));
  ReadCamera(tree, timeline);
  if (request.WantsFrames) {
    InitFrames(tree, request.Recording, timeline);
    return;
  }
  LOG << "[INFO] <qt-opengl> has no window here and requests no frames: running headless"
      << (request.HasUserFunctions ? ", without its user functions" : "") << std::endl;
}

void CFrameOutput::InitFrames(TConfigurationNode& tree, const SRecordingSettings& settings,
                              const CCameraTimeline& timeline) {
  try {
    m_recorder = std::make_unique<CFrameRecorder>(settings, timeline, m_drawing);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(
        tree.GetLocation() << ": <" << tree.Value() << "> cannot draw frames", ex);
  }
  m_drawing.Init(tree);
}

void CFrameOutput::Destroy() {
  m_recorder.reset();
  m_drawing.Destroy();
}

void CFrameOutput::Reset() {
  if (m_recorder != nullptr) {
    m_recorder->Reset();
  }
}

void CFrameOutput::Observe(CSimulator& simulator) {
  if (m_recorder != nullptr) {
    m_recorder->Observe(simulator);
  }
}

void CFrameOutput::Finish(CSimulator& simulator) {
  if (m_recorder != nullptr) {
    m_recorder->Finish(simulator);
  }
}

}  // namespace argos
