#include <argos3/plugins/simulator/visualizations/scene/ground_texture.h>

#include <argos3/core/simulator/images/image_file.h>
#include <argos3/core/utility/files/nearby_file.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <cmath>
#include <memory>
#include <utility>

namespace argos {

namespace {

// adds an alpha of 255, which renderers expect
std::vector<std::uint8_t> ToRgba(const SImage& image) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(4 * image.Width * image.Height);
  for (size_t i = 0; i < image.Pixels.size(); i += 3) {
    pixels.insert(pixels.end(), {image.Pixels[i], image.Pixels[i + 1], image.Pixels[i + 2], 255});
  }
  return pixels;
}

}  // namespace

SFloorImage ReadGroundTexture(TConfigurationNode& view) {
  SFloorImage ground;
  if (!NodeAttributeExists(view, "ground_texture")) {
    if (NodeAttributeExists(view, "ground_texture_size")) {
      THROW_ARGOSEXCEPTION(OwnerOf(view)
                           << " has \"ground_texture_size\" without \"ground_texture\"");
    }
    return ground;
  }
  std::string path;
  GetNodeAttribute(view, "ground_texture", path);
  Real size = 0.0;
  if (NodeAttributeExists(view, "ground_texture_size")) {
    GetNodeAttribute(view, "ground_texture_size", size);
    if (!(size > 0.0) || !std::isfinite(size)) {
      THROW_ARGOSEXCEPTION(OwnerOf(view)
                           << ": attribute \"ground_texture_size\" must be a positive number of "
                              "metres, found "
                           << size);
    }
  }
  try {
    const SImage image = ReadImage(FindNearbyFile(path, view.GetFileName(), "texture"), "texture");
    ground.Width = static_cast<int>(image.Width);
    ground.Height = static_cast<int>(image.Height);
    ground.Pixels = std::make_shared<const std::vector<std::uint8_t>>(ToRgba(image));
    ground.TileSize = {static_cast<float>(size),
                       static_cast<float>(size * ground.Height / ground.Width)};
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(view) << ": attribute \"ground_texture\"", ex);
  }
  ground.IsSmooth = true;
  ground.Version = 1;
  return ground;
}

}  // namespace argos
