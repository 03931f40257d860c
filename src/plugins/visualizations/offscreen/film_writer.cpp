#include <argos3/plugins/simulator/visualizations/offscreen/film_writer.h>

#include <argos3/core/simulator/loading/loading_check.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/writing.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/support/child_process.h>
#include <argos3/support/numbered_file.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace argos {

namespace fs = std::filesystem;

/* The file that ffmpeg writes, locked so that others neither write nor remove it. */
class CPartFile : private CNonCopyable {
 public:
  explicit CPartFile(const std::string& file)
      : m_target(FollowLinks(file)), m_path(m_target + kPartSuffix) {
    std::string problem;
    m_lock = OpenPart(m_path, problem);
    if (m_lock < 0) {
      THROW_ARGOSEXCEPTION("The film \"" << file << "\" cannot be written: \"" << m_path
                                         << "\": " << problem);
    }
  }
  ~CPartFile() {
    if (!m_isRenamed) {
      unlink(m_path.c_str());
    }
    close(m_lock);
  }

  const std::string& GetPath() const { return m_path; }

  bool Rename() {
    m_isRenamed = std::rename(m_path.c_str(), m_target.c_str()) == 0;
    return m_isRenamed;
  }

 private:
  std::string m_target;
  std::string m_path;
  int m_lock = -1;
  bool m_isRenamed = false;
};

namespace {

constexpr double kBytesPerMegabyte = 1e6;

std::string FolderOf(const std::string& file) {
  const std::string folder = fs::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

bool IsDiskFull(const std::string& file) {
  struct statvfs disk {};
  if (statvfs(file.c_str(), &disk) != 0 || disk.f_blocks == 0) {
    return false;
  }
  return (geteuid() == 0 ? disk.f_bfree : disk.f_bavail) == 0;
}

std::string Indent(std::string text) {
  Replace(text, "\n", "\n  ");
  return "\n  " + text;
}

}  // namespace

std::string FindFfmpeg() {
  const char* const chosen = std::getenv("ARGOS_FFMPEG");
  return FindProgram(chosen != nullptr ? chosen : "ffmpeg");
}

void PrepareFilmFile(const std::string& file) {
  std::error_code error;
  if (fs::exists(file, error) && !fs::is_regular_file(file, error)) {
    THROW_ARGOSEXCEPTION("The film \"" << file
                                       << "\" cannot be written: there is something of this name "
                                          "that is no file");
  }
  const std::string problem =
      FindFolderProblem(FolderOf(file), CLoadingCheck::IsActive() ? EMissingFolder::WillBeCreated
                                                                  : EMissingFolder::IsCreated);
  if (!problem.empty()) {
    THROW_ARGOSEXCEPTION("The film \"" << file << "\" cannot be written: " << problem);
  }
}

CFilmWriter::CFilmWriter(const SFilmSettings& settings, const std::string& ffmpeg)
    : m_settings(settings), m_ffmpeg(ffmpeg) {
  PrepareFilmFile(settings.File);
}

CFilmWriter::~CFilmWriter() = default;

void CFilmWriter::Begin() {
  m_file = NumberFile(m_settings.File, ++m_run);
  RemoveStaleParts(FolderOf(FollowLinks(m_file)));
  m_part = std::make_unique<CPartFile>(m_file);
}

void CFilmWriter::Write(const SPicture& picture, std::uint32_t tick) {
  if (m_part == nullptr) {
    return;
  }
  ++m_numPictures;
  if (!m_firstTick) {
    m_first = picture;
    m_firstTick = tick;
    return;
  }
  if (m_encoder == nullptr) {
    StartEncoder(m_settings.IsInParts ? m_settings.Every : tick - *m_firstTick);
  }
  Encode(picture);
}

void CFilmWriter::StartEncoder(std::uint32_t ticks) {
  m_rate = ComputeFrameRate(m_settings.TicksPerSecond, m_settings.Speed, ticks);
  std::vector<std::string> arguments = {m_ffmpeg};
  for (std::string& argument :
       MakeFilmArguments(m_settings, m_rate, m_first.Width, m_first.Height, m_part->GetPath())) {
    arguments.push_back(std::move(argument));
  }
  try {
    m_encoder = std::make_unique<CChildProcess>(arguments);
  } catch (CARGoSException& error) {
    DropFilm();
    THROW_ARGOSEXCEPTION_NESTED("The film \"" << m_file << "\" cannot be written", error);
  }
  Encode(m_first);
  m_first = SPicture();
}

void CFilmWriter::Encode(const SPicture& picture) {
  if (IsDiskFull(m_part->GetPath())) {
    // ffmpeg notices it only when its buffers are full
    m_encoder->Kill();
    DropFilm();
    THROW_ARGOSEXCEPTION("The film \"" << m_file
                                       << "\" cannot be written: no space is left on its disk");
  }
  if (!m_encoder->Write(picture.Pixels.data(), picture.Pixels.size())) {
    ThrowFailure();
  }
}

// ffmpeg reads no more
void CFilmWriter::ThrowFailure() {
  const SProcessEnd end = m_encoder->Finish();
  const std::string messages = m_encoder->GetErrorText();
  DropFilm();
  THROW_ARGOSEXCEPTION("The film \""
                       << m_file << "\" cannot be written: \"" << m_ffmpeg << "\" ended with "
                       << end.Description << " before the film was complete"
                       << (messages.empty() ? std::string(", without a message")
                                            : "; its last messages:" + Indent(messages)));
}

void CFilmWriter::DropFilm() {
  m_encoder.reset();
  m_part.reset();
  m_first = SPicture();
  m_firstTick.reset();
  m_numPictures = 0;
}

void CFilmWriter::Finish() {
  if (m_part == nullptr) {
    return;
  }
  if (!m_firstTick) {
    DropFilm();
    LOGERR << "[WARNING] The film " << m_file << " is not written: it has no pictures" << std::endl;
    return;
  }
  if (m_encoder == nullptr) {
    StartEncoder(m_settings.Every);
  }
  if (!m_encoder->Finish().IsSuccess) {
    ThrowFailure();
  }
  if (!m_part->Rename()) {
    const int error = errno;
    DropFilm();
    THROW_ARGOSEXCEPTION("The film \"" << m_file
                                       << "\" cannot be renamed: " << std::strerror(error));
  }
  std::error_code ignored;
  CLogControl::Notify(fmt::format(
      "The film {} is complete: {} picture{}, {:.4g} s, {}, {:.3g} MB", m_file, m_numPictures,
      m_numPictures == 1 ? "" : "s", static_cast<double>(m_numPictures) / m_rate.Get(),
      DescribeSpeed(m_settings.Speed),
      static_cast<double>(fs::file_size(m_file, ignored)) / kBytesPerMegabyte));
  DropFilm();
}

std::string CFilmWriter::Describe(int width, int height, std::uint32_t every) const {
  const SFrameRate rate = ComputeFrameRate(m_settings.TicksPerSecond, m_settings.Speed, every);
  return fmt::format("writing a film to {}, {}x{} pixels, {:.4g} frames a second, {}", m_file,
                     width, height, ChooseFileRate(m_settings, rate).Get(),
                     DescribeSpeed(m_settings.Speed));
}

}  // namespace argos
