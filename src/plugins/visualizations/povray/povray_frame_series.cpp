#include <argos3/plugins/simulator/visualizations/povray/povray_frame_series.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/povray_model.h>
#include <argos3/core/simulator/visualization/view_drawing.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/lock_file.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/plugins/simulator/visualizations/scene/drawing_to_scene.h>
#include <argos3/support/child_process.h>
#include <argos3/support/shell_quoting.h>

#include <fmt/format.h>

#include <filesystem>

namespace argos {

namespace {

std::string NameOf(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

void WriteFile(const std::string& path, const std::string& content) {
  std::string problem;
  if (!ReplaceFile(path, content, problem)) {
    THROW_ARGOSEXCEPTION("The scene file \"" << path << "\" cannot be written: " << problem);
  }
}

}  // namespace

const CSceneBuilder::TModels& CPovrayModels::Find(const std::string& type) {
  const auto [found, isNew] = m_models.try_emplace(type);
  if (isNew && CFactory<CPovrayModel>::Exists(type)) {
    const std::unique_ptr<CPovrayModel> model(CFactory<CPovrayModel>::New(type));
    for (const CPovrayModel::SPart& part : model->MakeParts()) {
      found->second.emplace_back(part.Anchor, m_objects.size());
      m_objects.push_back(part.Object);
    }
  }
  return found->second;
}

CPovrayFrameSeries::CPovrayFrameSeries(const SPovrayFrameSettings& settings,
                                       const SCameraSettings& camera, CViewDrawing& drawing)
    : m_settings(settings),
      m_camera(camera, static_cast<double>(settings.Scene.Width) / settings.Scene.Height),
      m_drawing(drawing),
      m_files(settings.Directory, settings.BaseName, true),
      m_builder(settings.ShowRays) {
  if (settings.UseModels) {
    m_builder.SetModels([this](const std::string& type) -> const CSceneBuilder::TModels& {
      return m_models.Find(type);
    });
  }
  const bool isInstalled = !FindProgram(GetPovrayProgram()).empty();
  if (settings.Render != SPovrayFrameSettings::ERender::No && isInstalled) {
    CheckPovrayName(settings.BaseName);
  }
  if (settings.Render == SPovrayFrameSettings::ERender::Yes && !isInstalled) {
    THROW_ARGOSEXCEPTION("The program \""
                         << GetPovrayProgram()
                         << "\" is not installed, which render=\"true\" needs; install POV-Ray, "
                         << "name it by the environment variable ARGOS_POVRAY, or write "
                         << "render=\"auto\"");
  }
}

CPovrayFrameSeries::~CPovrayFrameSeries() = default;

SPovrayJob CPovrayFrameSeries::MakeJob() const {
  const SPovraySettings& scene = m_settings.Scene;
  return {scene.Width, scene.Height, scene.Quality, m_settings.Threads, m_files.GetDirectory()};
}

void CPovrayFrameSeries::Begin() {
  m_lock = m_files.Lock();
  m_floorVersion = 0;
  const bool renders = m_settings.Render != SPovrayFrameSettings::ERender::No &&
                       !FindProgram(GetPovrayProgram()).empty();
  const std::string scene = m_files.MakeFileName(0, "pov");
  CLogControl::Notify("<povray> writes scene files, " + scene + " and following" +
                      (renders ? ", and renders them with " + GetPovrayProgram() : ""));
  if (renders) {
    m_renderer = std::make_unique<CPovrayRenderer>(MakeJob());
  } else if (m_settings.Render == SPovrayFrameSettings::ERender::IfInstalled) {
    std::string command =
        "cd " + QuoteForShell(m_files.GetDirectory()) + " && " + QuoteForShell(GetPovrayProgram());
    const std::string name = NameOf(scene);
    for (const std::string& argument : MakePovrayArguments(
             MakeJob(), name, std::filesystem::path(name).stem().string() + ".png")) {
      command += ' ' + QuoteForShell(argument);
    }
    CLogControl::Notify("<povray> renders nothing, because \"" + GetPovrayProgram() +
                        "\" is not installed. Where it is: " + command);
  }
}

void CPovrayFrameSeries::Observe(CSimulator& simulator) {
  if (m_lock == nullptr) {
    Begin();
  }
  m_drawing.Observe(simulator);
  if (m_settings.IsWanted(simulator.GetSpace().GetSimulationClock(), !m_lastTick.has_value())) {
    WriteScene(simulator);
  }
}

void CPovrayFrameSeries::Finish(CSimulator& simulator) {
  if (m_settings.IsLastWanted() && m_lastTick != simulator.GetSpace().GetSimulationClock()) {
    WriteScene(simulator);
  }
  if (m_renderer != nullptr) {
    m_renderer->Finish();
    m_renderer.reset();
  }
  m_lock.reset();
}

void CPovrayFrameSeries::Reset() {
  m_lastTick.reset();
  m_camera.Reset();
}

std::string CPovrayFrameSeries::WriteFloor() {
  const SFloorImage& floor = m_scene.Floor;
  if (floor.Width == 0 || floor.Height == 0 || floor.Pixels == nullptr) {
    return "";
  }
  if (floor.Version != m_floorVersion) {
    // scene files that wait for POV-Ray still need the one before
    const std::string path = fmt::format("{}/{}floor_{:04}.ppm", m_files.GetDirectory(),
                                         m_files.GetBaseName(), floor.Version);
    WriteFile(path, MakeFloorFile(floor));
    m_floorVersion = floor.Version;
    m_floorFile = NameOf(path);
  }
  return m_floorFile;
}

void CPovrayFrameSeries::WarnSkipped(std::size_t number, std::uint32_t tick) {
  if (number > 0 && !m_hasWarned) {
    m_hasWarned = true;
    LOGERR << "[WARNING] <povray> leaves out " << number << " shapes in tick " << tick
           << ", whose position or size is infinite or not a number" << std::endl;
  }
}

void CPovrayFrameSeries::WriteScene(CSimulator& simulator) {
  CSpace& space = simulator.GetSpace();
  const UInt32 tick = space.GetSimulationClock();
  const SPovraySettings& settings = m_settings.Scene;
  m_scene.ShowGrid = m_settings.ShowGrid;
  m_scene.ShowBoundary = m_settings.ShowBoundary;
  m_builder.Build(space, m_scene);
  if (m_scene.Floor.Pixels == nullptr) {
    m_scene.Floor = m_settings.Ground;
  }
  AddDrawing(m_drawing.Draw(simulator, static_cast<UInt32>(settings.Width),
                            static_cast<UInt32>(settings.Height)),
             m_scene);
  SSceneExtras extras;
  extras.Models = m_models.GetObjects();
  extras.FloorFile = WriteFloor();
  const std::string path = m_files.MakeFileName(tick, "pov");
  std::size_t numSkipped = 0;
  WriteFile(path,
            MakeSceneFile(m_scene, m_camera.ComputeAt(space, tick), settings, extras, numSkipped));
  WarnSkipped(numSkipped, tick);
  if (m_renderer != nullptr) {
    m_renderer->Submit(NameOf(path));
  }
  m_lastTick = tick;
}

}  // namespace argos
