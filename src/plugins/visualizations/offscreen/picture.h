#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_PICTURE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_PICTURE_H

#include <cstdint>
#include <vector>

namespace argos {

/** A finished picture in memory. */
struct SPicture {
  int Width = 0;
  int Height = 0;
  std::vector<std::uint8_t>
      Pixels; /**< R, G, B, A, sRGB, rows from top to bottom (Height, Width, 4) */

  /** The four bytes of a pixel. @param x, y  from the top left corner, inside the picture. */
  const std::uint8_t* At(int x, int y) const {
    return Pixels.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(Width) +
                                static_cast<std::size_t>(x));
  }
};

}  // namespace argos

#endif
