#include <argos3/plugins/simulator/visualizations/offscreen/frame_visualization.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_hooks.h>
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

CFrameVisualization::CFrameVisualization() = default;
CFrameVisualization::~CFrameVisualization() = default;

void CFrameVisualization::InitAsOffscreen(TConfigurationNode& tree) {
  const SRecordingSettings settings = ReadOffscreenSettings(tree);
  const SArenaBox arena = GetArenaBox(m_cSpace);
  CCameraTimeline timeline(MakeDefaultPlacements(arena));
  const double aspectRatio = static_cast<double>(settings.Render.Width) / settings.Render.Height;
  timeline.SetPlacement(0, MakeFramingPlacement(arena, aspectRatio, ComputeTop(m_cSpace)));
  ReadCamera(tree, timeline);
  InitFrames(tree, settings, timeline);
}

void CFrameVisualization::InitAsQtOpenGl(TConfigurationNode& tree) {
  const SQtOpenGlRequest request = ReadQtOpenGlRequest(tree);
  CCameraTimeline timeline(MakeDefaultPlacements(GetArenaBox(m_cSpace)));
  ReadCamera(tree, timeline);
  if (request.WantsFrames) {
    InitFrames(tree, request.Recording, timeline);
    return;
  }
  LOG << "[INFO] <qt-opengl> has no window here and requests no frames: running headless"
      << (request.HasUserFunctions ? ", without its user functions" : "") << std::endl;
}

void CFrameVisualization::InitFrames(TConfigurationNode& tree, const SRecordingSettings& settings,
                                     const CCameraTimeline& timeline) {
  try {
    m_recorder = std::make_unique<CFrameRecorder>(settings, timeline, m_drawing);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(
        tree.GetLocation() << ": <" << tree.Value() << "> cannot draw frames", ex);
  }
  m_drawing.Init(tree);
}

void CFrameVisualization::Destroy() {
  m_recorder.reset();
  m_drawing.Destroy();
}

void CFrameVisualization::Execute() {
  if (m_recorder == nullptr) {
    CDefaultVisualization::Execute();
    return;
  }
  m_recorder->Run(m_cSimulator);
  CLoopFunctions& loopFunctions = m_cSimulator.GetLoopFunctions();
  CallHook(m_cSimulator.GetSpace().GetContext(), "PostExperiment()",
           [&loopFunctions] { loopFunctions.PostExperiment(); });
}

}  // namespace argos
