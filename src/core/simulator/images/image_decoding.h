#ifndef ARGOS3_CORE_SIMULATOR_IMAGES_IMAGE_DECODING_H
#define ARGOS3_CORE_SIMULATOR_IMAGES_IMAGE_DECODING_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <vector>

namespace argos {

/** The pixels of an image file. */
struct SImage {
  size_t Width = 0; /**< pixels */
  size_t Height = 0; /**< pixels */
  std::vector<UInt8> Pixels; /**< red, green, blue, sRGB (Height, Width, 3); lowest row first */
};

/** Of an image that is read; they take 0.8 GB in a floor. */
constexpr size_t kMostImagePixels = size_t(1) << 28;

/** The path in quotes, with what it resolves to if that differs; for messages. */
std::string DescribePath(const std::string& path);

/**
 * Reads an image file of any format that FreeImage knows.
 * @param what  for errors, such as "floor image".
 * @throws CARGoSException if the file cannot be opened, is no image, or has more than
 *   kMostImagePixels, which is found before they are read.
 */
SImage ReadImage(const std::string& path, const std::string& what);

}  // namespace argos

#endif
