#include <argos3/core/simulator/images/image_library.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/core/utility/text/lists.h>

#include <FreeImage.h>

#include <cstdio>
#include <memory>

namespace argos {

namespace {

constexpr int kBitsPerPixel = 24;
// zlib has 1 to 9. This takes a quarter to a half less time than 6, libpng's own, for files up to a
// fifth larger
constexpr int kFastPngLevel = 3;

struct SBitmapDeleter {
  void operator()(FIBITMAP* bitmap) const { FreeImage_Unload(bitmap); }
};
using TBitmap = std::unique_ptr<FIBITMAP, SBitmapDeleter>;

// the library prints what is wrong with an image through a callback without context
thread_local std::string t_imageProblem;

void NoteImageProblem(FREE_IMAGE_FORMAT, const char* message) {
  t_imageProblem = message;
}

std::string ImageProblem() {
  return t_imageProblem.empty() ? "" : ": " + t_imageProblem;
}

struct SMemoryDeleter {
  void operator()(FIMEMORY* memory) const { FreeImage_CloseMemory(memory); }
};

// a compressed file of some kilobytes may need more memory than there is
void CheckSize(FREE_IMAGE_FORMAT format, FIMEMORY& memory, const std::string& fileName,
               const std::string& what) {
  if (FreeImage_FIFSupportsNoPixels(format) == 0) {
    return;
  }
  const TBitmap header(FreeImage_LoadFromMemory(format, &memory, FIF_LOAD_NOPIXELS));
  FreeImage_SeekMemory(&memory, 0, SEEK_SET);
  if (header) {
    const size_t width = FreeImage_GetWidth(header.get());
    const size_t height = FreeImage_GetHeight(header.get());
    if (width * height > kMaxImagePixels) {
      THROW_ARGOSEXCEPTION("the " << what << " " << DescribePath(fileName) << " has " << width
                                  << " x " << height << " pixels; at most " << kMaxImagePixels
                                  << " are possible, such as 16384 x 16384");
    }
  }
}

TBitmap ReadBitmap(const std::string& fileName, const std::string& what) {
  std::string content;
  std::string problem;
  if (!ReadInputFile(fileName, content, problem)) {
    THROW_ARGOSEXCEPTION("cannot open the " << what << " " << DescribePath(fileName) << ": "
                                            << problem
                                            << "; relative paths start at the working directory");
  }
  t_imageProblem.clear();
  FreeImage_SetOutputMessage(&NoteImageProblem);
  // the library does not change the content, although the type allows it
  const std::unique_ptr<FIMEMORY, SMemoryDeleter> memory(FreeImage_OpenMemory(
      reinterpret_cast<BYTE*>(content.data()), static_cast<DWORD>(content.size())));
  FREE_IMAGE_FORMAT format = FreeImage_GetFileTypeFromMemory(memory.get(), 0);
  if (format == FIF_UNKNOWN) {
    format = FreeImage_GetFIFFromFilename(fileName.c_str());
  }
  if (format == FIF_UNKNOWN || !FreeImage_FIFSupportsReading(format)) {
    THROW_ARGOSEXCEPTION("the " << what << " " << DescribePath(fileName)
                                << " is in no image format that can be read, such as "
                                   "PNG, JPEG, BMP or TIFF");
  }
  CheckSize(format, *memory, fileName, what);
  const TBitmap asStored(FreeImage_LoadFromMemory(format, memory.get(), 0));
  if (!asStored) {
    THROW_ARGOSEXCEPTION("cannot read the " << what << " " << DescribePath(fileName) << " as "
                                            << FreeImage_GetFormatFromFIF(format)
                                            << ImageProblem());
  }
  TBitmap bitmap(FreeImage_ConvertTo24Bits(asStored.get()));
  if (!bitmap) {
    // single-channel images of other depths
    const TBitmap standard(FreeImage_ConvertToStandardType(asStored.get(), 1));
    bitmap.reset(standard ? FreeImage_ConvertTo24Bits(standard.get()) : nullptr);
  }
  if (!bitmap || FreeImage_GetWidth(bitmap.get()) == 0 || FreeImage_GetHeight(bitmap.get()) == 0) {
    THROW_ARGOSEXCEPTION("the " << what << " " << DescribePath(fileName)
                                << " has no pixels that can be turned into colours");
  }
  return bitmap;
}

bool CanWrite(FREE_IMAGE_FORMAT format) {
  return FreeImage_FIFSupportsWriting(format) != 0 &&
         FreeImage_FIFSupportsExportBPP(format, kBitsPerPixel) != 0;
}

// for PNG a higher quality means less compression; for lossy formats it means less loss
int ComputeFlags(FREE_IMAGE_FORMAT format, int quality) {
  if (quality < 0) {
    return format == FIF_PNG ? kFastPngLevel : 0;
  }
  switch (format) {
    case FIF_PNG: {
      const int level = 9 - quality * 9 / kMaxImageQuality;
      return level == 0 ? PNG_Z_NO_COMPRESSION : level;
    }
    case FIF_JPEG:
    case FIF_WEBP:
      return quality > 0 ? quality : 1;
    case FIF_TIFF:
      return quality == kMaxImageQuality ? TIFF_NONE : TIFF_DEFLATE;
    default:
      return 0;
  }
}

TBitmap MakeBitmap(const SPixelView& picture) {
  TBitmap bitmap(FreeImage_Allocate(static_cast<int>(picture.Width),
                                    static_cast<int>(picture.Height), kBitsPerPixel));
  if (!bitmap) {
    THROW_ARGOSEXCEPTION("there is no memory for a picture of " << picture.Width << "x"
                                                                << picture.Height << " pixels");
  }
  ARGOS_ASSERT(picture.LowestRow != nullptr && picture.PixelStep >= 3,
               "pixels of " << picture.PixelStep << " bytes");
  for (size_t row = 0; row < picture.Height; ++row) {
    BYTE* to = FreeImage_GetScanLine(bitmap.get(), static_cast<int>(row));
    const UInt8* from = picture.LowestRow + static_cast<std::ptrdiff_t>(row) * picture.RowStep;
    for (size_t column = 0; column < picture.Width; ++column, to += 3, from += picture.PixelStep) {
      to[FI_RGBA_RED] = from[0];
      to[FI_RGBA_GREEN] = from[1];
      to[FI_RGBA_BLUE] = from[2];
    }
  }
  return bitmap;
}

class CFreeImageLibrary : public CImageLibrary {
 public:
  SImage Read(const std::string& path, const std::string& what) const override;
  std::optional<SImageFormat> FindFormat(const std::string& fileName) const override;
  std::string ListFormats() const override;
  void SetQuality(SImageFormat& format, int quality) const override;
  std::string Encode(const SPixelView& picture, const SImageFormat& format) const override;
};

SImage CFreeImageLibrary::Read(const std::string& path, const std::string& what) const {
  const TBitmap bitmap = ReadBitmap(path, what);
  SImage image;
  image.Width = FreeImage_GetWidth(bitmap.get());
  image.Height = FreeImage_GetHeight(bitmap.get());
  image.Pixels.reserve(3 * image.Width * image.Height);
  // the library, too, counts rows from the bottom
  for (size_t row = 0; row < image.Height; ++row) {
    const BYTE* pixel = FreeImage_GetScanLine(bitmap.get(), static_cast<int>(row));
    for (size_t column = 0; column < image.Width; ++column, pixel += 3) {
      image.Pixels.insert(image.Pixels.end(),
                          {pixel[FI_RGBA_RED], pixel[FI_RGBA_GREEN], pixel[FI_RGBA_BLUE]});
    }
  }
  return image;
}

std::optional<SImageFormat> CFreeImageLibrary::FindFormat(const std::string& fileName) const {
  const FREE_IMAGE_FORMAT format = FreeImage_GetFIFFromFilename(fileName.c_str());
  if (format == FIF_UNKNOWN || !CanWrite(format)) {
    return std::nullopt;
  }
  return SImageFormat{format, 0};
}

std::string CFreeImageLibrary::ListFormats() const {
  std::string names;
  for (int i = 0; i < FreeImage_GetFIFCount(); ++i) {
    const auto format = static_cast<FREE_IMAGE_FORMAT>(i);
    if (CanWrite(format)) {
      AppendItem(names, std::string(FreeImage_GetFIFExtensionList(format)));
    }
  }
  return names;
}

void CFreeImageLibrary::SetQuality(SImageFormat& format, int quality) const {
  format.Flags = ComputeFlags(static_cast<FREE_IMAGE_FORMAT>(format.Number), quality);
}

// FreeImage's functions for files ignore failed writes, and overflow a buffer with the message on a
// long path
std::string CFreeImageLibrary::Encode(const SPixelView& picture, const SImageFormat& format) const {
  const auto type = static_cast<FREE_IMAGE_FORMAT>(format.Number);
  const TBitmap bitmap = MakeBitmap(picture);
  t_imageProblem.clear();
  FreeImage_SetOutputMessage(&NoteImageProblem);
  const std::unique_ptr<FIMEMORY, SMemoryDeleter> memory(FreeImage_OpenMemory());
  BYTE* content = nullptr;
  DWORD size = 0;
  if (memory == nullptr ||
      !FreeImage_SaveToMemory(type, bitmap.get(), memory.get(), format.Flags) ||
      !FreeImage_AcquireMemory(memory.get(), &content, &size) || size == 0) {
    THROW_ARGOSEXCEPTION("a picture of " << picture.Width << "x" << picture.Height
                                         << " pixels cannot be stored as "
                                         << FreeImage_GetFormatFromFIF(type) << ImageProblem());
  }
  return std::string(reinterpret_cast<const char*>(content), size);
}

}  // namespace

REGISTER_SYMBOL(CImageLibrary, CFreeImageLibrary, "freeimage", "the authors of this project", "1.0",
                "Reads and writes image files with FreeImage.", "See image_file.h.", "Usable")

}  // namespace argos
