#ifndef ARGOS3_CORE_SIMULATOR_IMAGES_IMAGE_FILE_H
#define ARGOS3_CORE_SIMULATOR_IMAGES_IMAGE_FILE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace argos {

// Files of images. The library of images is opened at the first call (image_library.h).

/** The pixels of an image file. */
struct SImage {
  size_t Width = 0; /**< pixels */
  size_t Height = 0; /**< pixels */
  std::vector<UInt8> Pixels; /**< red, green, blue, sRGB (Height, Width, 3); lowest row first */
};

/** Limit of an image that is read; so many take 0.8 GB in a floor. */
constexpr size_t kMaxImagePixels = size_t(1) << 28;

/** The path in quotes, with what it resolves to if that differs; for messages. */
std::string DescribePath(const std::string& path);

/**
 * Reads an image file of any format that FreeImage knows.
 * @param what  for errors, such as "floor image".
 * @throws CARGoSException if the file cannot be opened, is no image, or has more than
 *   kMaxImagePixels, which is found before they are read.
 */
SImage ReadImage(const std::string& path, const std::string& what);

/** A format that 24-bit pictures can be written in. */
struct SImageFormat {
  int Number = 0; /**< identifier in the library */
  int Flags = 0; /**< flags of the library; 0: the format's own */
};

/** @return the format of the file's extension; nothing if none can be written. */
std::optional<SImageFormat> FindImageFormat(const std::string& fileName);
/** The extensions of all formats, separated by ", ". */
std::string ListImageFormats();
/**
 * Sets how the format trades size against time or loss.
 * @param quality  0 (smallest file) to kMaxImageQuality (best, or least packed); -1: fast.
 */
void SetQuality(SImageFormat& format, int quality);
constexpr int kMaxImageQuality = 100;

/** A picture in memory of the caller: each pixel begins with red, green and blue, sRGB. */
struct SPixelView {
  size_t Width; /**< pixels */
  size_t Height; /**< pixels */
  const UInt8* LowestRow;
  std::ptrdiff_t RowStep; /**< bytes from a row to the one above */
  std::ptrdiff_t PixelStep; /**< bytes from a pixel to the next one */
};

/**
 * Encodes a picture as the content of a file, for ReplaceFile().
 * @throws CARGoSException with the library's reason.
 */
std::string EncodeImage(const SPixelView& picture, const SImageFormat& format);

}  // namespace argos

#endif
