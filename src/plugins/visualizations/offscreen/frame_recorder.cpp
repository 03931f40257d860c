#include <argos3/plugins/simulator/visualizations/offscreen/frame_recorder.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/view_drawing.h>
#include <argos3/core/utility/files/lock_file.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/simulator/visualizations/scene/drawing_to_scene.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <memory>
#include <sstream>

namespace argos {

CFrameRecorder::CFrameRecorder(const SRecordingSettings& settings, const SCameraSettings& camera,
                               CViewDrawing& drawing)
    : m_settings(settings),
      m_camera(camera, static_cast<double>(settings.Render.Width) / settings.Render.Height),
      m_drawing(drawing),
      m_writer(settings.File),
      m_builder(settings.ShowRays) {}

CFrameRecorder::~CFrameRecorder() = default;

void CFrameRecorder::Announce() const {
  CTextOutput text;
  text << m_settings.Announcement << "drawing frames of " << m_settings.Render.Width << "x"
       << m_settings.Render.Height << " pixels, one every ";
  if (m_settings.Every == 1) {
    text << "tick";
  } else {
    text << m_settings.Every << " ticks";
  }
  text << ", to " << m_writer.MakeFileName(0) << " and following (" << m_pipeline->DescribeDriver()
       << ")";
  LOG << "[INFO] " << text.str() << std::endl;
  LOG.Flush();
}

void CFrameRecorder::Begin() {
  m_lock = m_writer.LockFrames();
  if (!m_pipeline.has_value()) {
    m_pipeline.emplace(m_settings.Render, [this](const SPicture& picture, std::uint32_t tick) {
      m_writer.Write(picture, tick);
    });
  }
  Announce();
}

void CFrameRecorder::Observe(CSimulator& simulator) {
  if (m_lock == nullptr) {
    Begin();
  }
  m_drawing.Observe(simulator);
  if (m_settings.IsWanted(simulator.GetSpace().GetSimulationClock(), !m_lastTick.has_value())) {
    WriteFrame(simulator);
  }
}

void CFrameRecorder::Finish(CSimulator& simulator) {
  if (m_settings.IsLastWanted() && m_lastTick != simulator.GetSpace().GetSimulationClock()) {
    WriteFrame(simulator);
  }
  if (m_pipeline.has_value()) {
    m_pipeline->Finish();
  }
  m_lock.reset();
}

void CFrameRecorder::Reset() {
  m_lastTick.reset();
  m_camera.Reset();
}

void CFrameRecorder::WriteFrame(CSimulator& simulator) {
  CSpace& space = simulator.GetSpace();
  const UInt32 tick = space.GetSimulationClock();
  CFramePipeline::SFrame& frame = m_pipeline->Acquire();
  frame.Tick = tick;
  frame.Scene.ShowGrid = m_settings.ShowGrid;
  frame.Scene.ShowBoundary = m_settings.ShowBoundary;
  m_builder.Build(space, frame.Scene);
  if (frame.Scene.Floor.Pixels == nullptr) {
    frame.Scene.Floor = m_settings.Ground;
  }
  const SRenderSettings& render = m_settings.Render;
  AddDrawing(m_drawing.Draw(simulator, static_cast<UInt32>(render.Width),
                            static_cast<UInt32>(render.Height)),
             frame.Scene);
  frame.Placement = m_camera.ComputeAt(space, tick);
  m_pipeline->Submit();
  m_lastTick = tick;
}

}  // namespace argos
