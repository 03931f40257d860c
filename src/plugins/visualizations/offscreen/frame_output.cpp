#include <argos3/plugins/simulator/visualizations/offscreen/frame_output.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/visualizations/scene/camera_xml.h>
#include <argos3/plugins/simulator/visualizations/offscreen/frame_series.h>
#include <argos3/plugins/simulator/visualizations/offscreen/offscreen_xml.h>

#include <cmath>
#include <utility>

namespace argos {

namespace {

SArenaBox GetArenaBox(const CSpace& space) {
  return {ToEigen(space.GetArenaCenter()), ToEigen(space.GetArenaSize())};
}

}  // namespace

CFrameOutput::CFrameOutput() = default;
CFrameOutput::~CFrameOutput() = default;

void CFrameOutput::InitAsOffscreen(TConfigurationNode& tree) {
  SFrameSeriesSettings settings = ReadOffscreenSettings(tree);
  CompleteFilmSettings(settings,
                       static_cast<UInt32>(std::lround(1.0 / CurrentSimulator().GetTickLength())));
  SCameraSettings camera(CCameraTimeline(MakeDefaultPlacements(GetArenaBox(CurrentSpace()))));
  ReadCameraSettings(tree, CurrentSpace(), camera);
  InitFrames(tree, settings, camera);
}

void CFrameOutput::InitAsQtOpenGl(TConfigurationNode& tree) {
  const SQtOpenGlRequest request = ReadQtOpenGlRequest(tree);
  SCameraSettings camera(CCameraTimeline(MakeDefaultPlacements(GetArenaBox(CurrentSpace()))));
  ReadCamera(tree, camera.Timeline);
  if (request.WantsFrames) {
    InitFrames(tree, request.Frames, camera);
    return;
  }
  LOG << "[INFO] <qt-opengl> has no window here and requests no frames: running headless"
      << (request.HasUserFunctions ? ", without its user functions" : "") << std::endl;
}

void CFrameOutput::InitFrames(TConfigurationNode& tree, const SFrameSeriesSettings& settings,
                              const SCameraSettings& camera) {
  try {
    m_series = std::make_unique<CFrameSeries>(settings, camera, m_drawing);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(tree) << " cannot draw frames", ex);
  }
  m_drawing.Init(tree);
}

void CFrameOutput::Destroy() {
  const std::unique_ptr<CFrameSeries> series = std::move(m_series);
  try {
    if (series != nullptr) {
      series->Close();
    }
  } catch (...) {
    m_drawing.Destroy();
    throw;
  }
  m_drawing.Destroy();
}

void CFrameOutput::Reset() {
  if (m_series != nullptr) {
    m_series->Reset();
  }
}

void CFrameOutput::Observe(CSimulator& simulator) {
  if (m_series != nullptr) {
    m_series->Observe(simulator);
  }
}

void CFrameOutput::Finish(CSimulator& simulator) {
  if (m_series != nullptr) {
    m_series->Finish(simulator);
  }
}

}  // namespace argos
