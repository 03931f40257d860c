#include <argos3/plugins/simulator/visualizations/offscreen/frame_recorder.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/view_drawing.h>
#include <argos3/core/utility/files/lock_file.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/simulator/visualizations/offscreen/drawing_to_scene.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <memory>
#include <sstream>

namespace argos {

CFrameRecorder::CFrameRecorder(const SRecordingSettings& settings, const CCameraTimeline& timeline,
                               CViewDrawing& drawing)
    : m_settings(settings),
      m_timeline(timeline),
      m_drawing(drawing),
      m_writer(settings.File),
      m_builder(settings.ShowRays) {
  m_scene.ShowGrid = settings.ShowGrid;
  m_scene.ShowBoundary = settings.ShowBoundary;
}

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
  text << ", to " << m_writer.MakeFileName(0) << " and following (" << m_renderer->DescribeDriver()
       << ")";
  LOG << "[INFO] " << text.str() << std::endl;
  LOG.Flush();
}

void CFrameRecorder::Begin() {
  m_lock = m_writer.LockFrames();
  if (!m_renderer.has_value()) {
    m_renderer.emplace(m_settings.Render);
  }
  Announce();
}

void CFrameRecorder::Observe(CSimulator& simulator) {
  if (m_lock == nullptr) {
    Begin();
  }
  m_drawing.Observe(simulator);
  if (!m_lastTick.has_value() ||
      simulator.GetSpace().GetSimulationClock() % m_settings.Every == 0) {
    WriteFrame(simulator);
  }
}

void CFrameRecorder::Finish(CSimulator& simulator) {
  if (m_settings.KeepLastFrame && m_lastTick != simulator.GetSpace().GetSimulationClock()) {
    WriteFrame(simulator);
  }
  m_lock.reset();
}

void CFrameRecorder::Reset() {
  m_lastTick.reset();
}

void CFrameRecorder::WriteFrame(CSimulator& simulator) {
  CSpace& space = simulator.GetSpace();
  const UInt32 tick = space.GetSimulationClock();
  m_builder.Build(space, m_scene);
  const SRenderSettings& render = m_settings.Render;
  AddDrawing(m_drawing.Draw(simulator, static_cast<UInt32>(render.Width),
                            static_cast<UInt32>(render.Height)),
             m_scene);
  m_renderer->Render(m_scene, m_timeline.ComputeAt(tick), m_picture);
  m_writer.Write(m_picture, tick);
  m_lastTick = tick;
}

}  // namespace argos
