#include <argos3/plugins/simulator/visualizations/offscreen/frame_writer.h>

#include <argos3/core/simulator/images/image_file.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/lock_file.h>

#include <argos3/core/utility/text/classic_locale.h>

#include <memory>
#include <sstream>

namespace argos {

CFrameWriter::CFrameWriter(const SFrameFileSettings& settings) : m_settings(settings) {
  CheckFormat();
  CheckQuality();
  m_files.emplace(settings.Directory, settings.BaseName, settings.CreateDirectory);
}

CFrameWriter::~CFrameWriter() = default;

void CFrameWriter::CheckFormat() {
  const std::optional<SImageFormat> format = FindImageFormat("frame." + m_settings.Format);
  // FreeImage looks only at the part behind the last dot
  const bool isExtension = m_settings.Format.find_first_of("./") == std::string::npos;
  if (!isExtension || !format) {
    THROW_ARGOSEXCEPTION("Frames cannot be written in the format \""
                         << m_settings.Format << "\"; choose one of " << ListImageFormats());
  }
  m_format = *format;
}

void CFrameWriter::CheckQuality() {
  if (m_settings.Quality < -1 || m_settings.Quality > kMaxImageQuality) {
    THROW_ARGOSEXCEPTION("The quality of frames is "
                         << m_settings.Quality << "; it must be from 0 to " << kMaxImageQuality
                         << ", or -1 for the format's own");
  }
  SetQuality(m_format, m_settings.Quality);
}

std::string CFrameWriter::MakeFileName(std::uint32_t tick) const {
  return m_files->MakeFileName(tick, m_settings.Format);
}

void CFrameWriter::Begin() {
  m_lock.reset();  // a run that failed has left it
  m_lock = LockFrames();
}

void CFrameWriter::Finish() {
  m_lock.reset();
}

std::string CFrameWriter::Describe(int width, int height, std::uint32_t every) const {
  CTextOutput text;
  text << "drawing frames of " << width << "x" << height << " pixels, one every ";
  if (every == 1) {
    text << "tick";
  } else {
    text << every << " ticks";
  }
  text << ", to " << MakeFileName(0) << ", ...";
  return text.str();
}

void CFrameWriter::Write(const SPicture& picture, std::uint32_t tick) {
  const std::string fileName = MakeFileName(tick);
  ARGOS_ASSERT(picture.Width > 0 && picture.Height > 0,
               "a picture of " << picture.Width << "x" << picture.Height << " pixels");
  // rows are stored from top to bottom
  const std::ptrdiff_t rowBytes = 4 * static_cast<std::ptrdiff_t>(picture.Width);
  const SPixelView pixels{static_cast<size_t>(picture.Width), static_cast<size_t>(picture.Height),
                          picture.At(0, picture.Height - 1), -rowBytes, 4};
  const std::string content = EncodeImage(pixels, m_format);
  std::string problem;
  if (!ReplaceFile(fileName, content, problem)) {
    THROW_ARGOSEXCEPTION("The frame \"" << fileName << "\" cannot be written: " << problem);
  }
}

std::unique_ptr<CLockFile> CFrameWriter::LockFrames() const {
  return m_files->Lock();
}

}  // namespace argos
