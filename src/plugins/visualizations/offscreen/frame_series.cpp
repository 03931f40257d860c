#include <argos3/plugins/simulator/visualizations/offscreen/frame_series.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/view_drawing.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/plugins/simulator/visualizations/offscreen/film_frames.h>
#include <argos3/plugins/simulator/visualizations/offscreen/film_writer.h>
#include <argos3/plugins/simulator/visualizations/offscreen/frame_writer.h>
#include <argos3/plugins/simulator/visualizations/scene/drawing_to_scene.h>

#include <memory>

namespace argos {

namespace {

std::unique_ptr<CPictureSink> MakeSink(const SFrameSeriesSettings& settings) {
  if (!settings.Film) {
    return std::make_unique<CFrameWriter>(settings.File);
  }
  const std::string ffmpeg = FindFfmpeg();
  if (ffmpeg.empty()) {
    return std::make_unique<CFilmFrames>(*settings.Film);
  }
  return std::make_unique<CFilmWriter>(*settings.Film, ffmpeg);
}

}  // namespace

CFrameSeries::CFrameSeries(const SFrameSeriesSettings& settings, const SCameraSettings& camera,
                           CViewDrawing& drawing)
    : m_settings(settings),
      m_camera(camera, static_cast<double>(settings.Render.Width) / settings.Render.Height),
      m_drawing(drawing),
      m_sink(MakeSink(settings)),
      m_builder(settings.ShowRays) {}

CFrameSeries::~CFrameSeries() = default;

void CFrameSeries::Announce() const {
  const SRenderSettings& render = m_settings.Render;
  std::string text =
      m_settings.Announcement + m_sink->Describe(render.Width, render.Height, m_settings.Every);
  if (CLogControl::GetLevel() == ELogLevel::Debug) {
    text += " (" + m_pipeline->DescribeDriver() + ")";
  }
  CLogControl::Notify(text);
}

void CFrameSeries::Begin() {
  m_sink->Begin();
  m_hasBegun = true;
  if (!m_pipeline.has_value()) {
    m_pipeline.emplace(m_settings.Render, [this](const SPicture& picture, std::uint32_t tick) {
      m_sink->Write(picture, tick);
    });
  }
  Announce();
}

void CFrameSeries::Observe(CSimulator& simulator) {
  if (!m_hasBegun) {
    Begin();
  }
  m_drawing.Observe(simulator);
  if (IsWanted(simulator.GetSpace().GetSimulationClock())) {
    WriteFrame(simulator);
  }
}

bool CFrameSeries::IsWanted(std::uint32_t tick) const {
  if (m_settings.Film && m_settings.Ticks.empty() && m_lastTick.has_value()) {
    // a replay may begin at any tick, show every n-th one, and then the last one
    return tick - *m_lastTick >= m_distance.value_or(m_settings.Every);
  }
  return m_settings.IsWanted(tick, !m_lastTick.has_value());
}

void CFrameSeries::Finish(CSimulator& simulator) {
  if (m_settings.IsLastWanted() && m_lastTick != simulator.GetSpace().GetSimulationClock()) {
    WriteFrame(simulator);
  }
  Close();
}

void CFrameSeries::Close() {
  if (!m_hasBegun) {
    return;
  }
  m_hasBegun = false;
  try {
    if (m_pipeline.has_value()) {
      m_pipeline->Finish();
    }
  } catch (...) {
    m_sink->Finish();
    throw;
  }
  m_sink->Finish();
}

void CFrameSeries::Reset() {
  Close();
  m_lastTick.reset();
  m_distance.reset();
  m_camera.Reset();
}

void CFrameSeries::WriteFrame(CSimulator& simulator) {
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
  if (m_lastTick.has_value() && !m_distance.has_value()) {
    m_distance = tick - *m_lastTick;
  }
  m_lastTick = tick;
}

}  // namespace argos
