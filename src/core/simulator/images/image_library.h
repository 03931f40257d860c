#ifndef ARGOS3_CORE_SIMULATOR_IMAGES_IMAGE_LIBRARY_H
#define ARGOS3_CORE_SIMULATOR_IMAGES_IMAGE_LIBRARY_H

#include <argos3/core/simulator/images/image_file.h>

#include <optional>
#include <string>

namespace argos {

/**
 * What image_file.h offers, of a library of images. Its implementation is in a library of its own,
 * which is opened at the first use: FreeImage brings 25 others along, half of the time of a start.
 * Several threads may call the functions at once.
 */
class CImageLibrary {
 public:
  virtual ~CImageLibrary() = default;

  virtual SImage Read(const std::string& path, const std::string& what) const = 0;
  virtual std::optional<SImageFormat> FindFormat(const std::string& fileName) const = 0;
  virtual std::string ListFormats() const = 0;
  virtual void SetQuality(SImageFormat& format, int quality) const = 0;
  virtual std::string Encode(const SPixelView& picture, const SImageFormat& format) const = 0;
};

}  // namespace argos

#endif
