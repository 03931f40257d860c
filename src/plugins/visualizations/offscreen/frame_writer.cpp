#include <argos3/plugins/simulator/visualizations/offscreen/frame_writer.h>

#include <argos3/core/simulator/images/image_encoding.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/lock_file.h>

#include <argos3/core/utility/text/classic_locale.h>

#include <FreeImage.h>

#include <memory>
#include <sstream>

namespace argos {

namespace {

constexpr int kBitsPerPixel = 24;
constexpr int kBestQuality = 100;
// of zlib's 1 to 9: takes a quarter to a half less time than 6, libpng's own, for files up to a
// fifth larger
constexpr int kPngLevel = 3;

bool CanWrite(FREE_IMAGE_FORMAT format) {
  return FreeImage_FIFSupportsWriting(format) != 0 &&
         FreeImage_FIFSupportsExportBPP(format, kBitsPerPixel) != 0;
}

std::string ListFormats() {
  std::string names;
  for (int i = 0; i < FreeImage_GetFIFCount(); ++i) {
    const auto format = static_cast<FREE_IMAGE_FORMAT>(i);
    if (CanWrite(format)) {
      names += (names.empty() ? "" : ", ") + std::string(FreeImage_GetFIFExtensionList(format));
    }
  }
  return names;
}

// for PNG a higher quality means less compression; for lossy formats it means less loss
int ComputeFlags(FREE_IMAGE_FORMAT format, int quality) {
  if (quality < 0) {
    return format == FIF_PNG ? kPngLevel : 0;
  }
  switch (format) {
    case FIF_PNG: {
      const int level = 9 - quality * 9 / kBestQuality;
      return level == 0 ? PNG_Z_NO_COMPRESSION : level;
    }
    case FIF_JPEG:
    case FIF_WEBP:
      return quality > 0 ? quality : 1;
    case FIF_TIFF:
      return quality == kBestQuality ? TIFF_NONE : TIFF_DEFLATE;
    default:
      return 0;
  }
}

struct SBitmapDeleter {
  void operator()(FIBITMAP* bitmap) const { FreeImage_Unload(bitmap); }
};

std::unique_ptr<FIBITMAP, SBitmapDeleter> MakeBitmap(const SPicture& picture) {
  std::unique_ptr<FIBITMAP, SBitmapDeleter> bitmap(
      FreeImage_Allocate(picture.Width, picture.Height, kBitsPerPixel));
  if (bitmap == nullptr) {
    THROW_ARGOSEXCEPTION("There is no memory for a picture of " << picture.Width << "x"
                                                                << picture.Height << " pixels");
  }
  for (int row = 0; row < picture.Height; ++row) {
    BYTE* to = FreeImage_GetScanLine(bitmap.get(), picture.Height - 1 - row);
    const std::uint8_t* from = picture.At(0, row);
    for (int column = 0; column < picture.Width; ++column, to += 3, from += 4) {
      to[FI_RGBA_RED] = from[0];
      to[FI_RGBA_GREEN] = from[1];
      to[FI_RGBA_BLUE] = from[2];
    }
  }
  return bitmap;
}

}  // namespace

CFrameWriter::CFrameWriter(const SFrameFileSettings& settings) : m_settings(settings) {
  CheckFormat();
  CheckQuality();
  m_files.emplace(settings.Directory, settings.BaseName, settings.CreateDirectory);
}

CFrameWriter::~CFrameWriter() = default;

void CFrameWriter::CheckFormat() {
  const FREE_IMAGE_FORMAT format =
      FreeImage_GetFIFFromFilename(("frame." + m_settings.Format).c_str());
  // FreeImage reads the part behind the last dot only
  const bool isExtension = m_settings.Format.find_first_of("./") == std::string::npos;
  if (!isExtension || format == FIF_UNKNOWN || !CanWrite(format)) {
    THROW_ARGOSEXCEPTION("Frames cannot be written in the format \""
                         << m_settings.Format << "\"; choose one of " << ListFormats());
  }
  m_format = format;
}

void CFrameWriter::CheckQuality() {
  if (m_settings.Quality < -1 || m_settings.Quality > kBestQuality) {
    THROW_ARGOSEXCEPTION("The quality of frames is " << m_settings.Quality
                                                     << "; it must be from 0 to " << kBestQuality
                                                     << ", or -1 for the format's own");
  }
  m_flags = ComputeFlags(static_cast<FREE_IMAGE_FORMAT>(m_format), m_settings.Quality);
}

std::string CFrameWriter::MakeFileName(std::uint32_t tick) const {
  return m_files->MakeFileName(tick, m_settings.Format);
}

void CFrameWriter::Begin() {
  m_lock.reset();  // of a run that failed
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
  text << ", to " << MakeFileName(0) << " and following";
  return text.str();
}

void CFrameWriter::Write(const SPicture& picture, std::uint32_t tick) {
  const std::string fileName = MakeFileName(tick);
  const std::string content = EncodeImage(*MakeBitmap(picture), m_format, m_flags);
  std::string problem;
  if (!ReplaceFile(fileName, content, problem)) {
    THROW_ARGOSEXCEPTION("The frame \"" << fileName << "\" cannot be written: " << problem);
  }
}

std::unique_ptr<CLockFile> CFrameWriter::LockFrames() const {
  return m_files->Lock();
}

}  // namespace argos
