#include <argos3/plugins/simulator/visualizations/offscreen/film_frames.h>

#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/simulator/visualizations/offscreen/film_writer.h>
#include <argos3/plugins/simulator/visualizations/offscreen/frame_writer.h>
#include <argos3/support/numbered_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

namespace argos {

namespace {

namespace fs = std::filesystem;

// a name that CFrameWriter gives
bool IsFrame(std::string_view name) {
  constexpr std::string_view kStart = "frame_";
  constexpr std::string_view kEnd = ".png";
  if (name.size() <= kStart.size() + kEnd.size() || name.substr(0, kStart.size()) != kStart ||
      name.substr(name.size() - kEnd.size()) != kEnd) {
    return false;
  }
  const std::string_view number =
      name.substr(kStart.size(), name.size() - kStart.size() - kEnd.size());
  return std::all_of(number.begin(), number.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

void RemoveFrames(const std::string& folder) {
  std::vector<fs::path> frames;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    if (IsFrame(entry->path().filename().string())) {
      frames.push_back(entry->path());
    }
  }
  for (const fs::path& frame : frames) {
    fs::remove(frame, error);
  }
}

}  // namespace

CFilmFrames::CFilmFrames(const SFilmSettings& settings) : m_settings(settings) {
  PrepareFilmFile(settings.File);
}

CFilmFrames::~CFilmFrames() = default;

std::string CFilmFrames::MakeFolder() const {
  return m_file + ".frames";
}

void CFilmFrames::Begin() {
  m_file = NumberFile(m_settings.File, ++m_run);
  SFrameFileSettings file;
  file.Directory = MakeFolder();
  m_writer = std::make_unique<CFrameWriter>(file);
  m_writer->Begin();
  RemoveFrames(file.Directory);
  m_firstTick.reset();
  m_ticks.reset();
  LOGERR << "[WARNING] There is no ffmpeg in PATH, nor as ARGOS_FFMPEG: instead of the film "
         << m_file << ", its frames are written to the folder " << file.Directory
         << "; the command that makes the film is printed at the end of the run" << std::endl;
}

void CFilmFrames::Write(const SPicture& picture, std::uint32_t tick) {
  if (m_firstTick && !m_ticks) {
    m_ticks = tick - *m_firstTick;
  }
  if (!m_firstTick) {
    m_firstTick = tick;
  }
  m_writer->Write(picture, tick);
}

void CFilmFrames::Finish() {
  if (m_writer == nullptr) {
    return;
  }
  m_writer->Finish();
  m_writer.reset();
  const std::uint32_t ticks =
      m_settings.IsInParts ? m_settings.Every : m_ticks.value_or(m_settings.Every);
  const SFrameRate rate = ComputeFrameRate(m_settings.TicksPerSecond, m_settings.Speed, ticks);
  LOGERR << "[WARNING] The film " << m_file
         << " is not written, because there is no ffmpeg. To make it of the frames, install ffmpeg "
            "and type\n  "
         << MakeFilmCommand(m_settings, rate, MakeFolder(), m_file) << std::endl;
}

std::string CFilmFrames::Describe(int width, int height, std::uint32_t every) const {
  return fmt::format(
      "drawing the frames of a film, {}x{} pixels, {}, to {}", width, height,
      every == 1 ? std::string("one every tick") : fmt::format("one every {} ticks", every),
      MakeFolder());
}

}  // namespace argos
