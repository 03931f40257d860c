#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_GLYPH_ATLAS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_GLYPH_ATLAS_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <vector>

namespace argos {

/** One letter on the picture, or its contour, in the layout of the vertex buffer. */
struct SGlyphInstance {
  std::array<float, 4> Area; /**< x, y of the upper left corner, width, height, pixels, y down */
  std::array<float, 2> Texel; /**< upper left corner in the atlas */
  SRgba Color;
};

/**
 * Sets text: an image of all letters in use, and the places of letters on a picture.
 *
 * Letters are rasterised by FreeType at the size at which they are drawn, so that they stay sharp;
 * they begin at whole pixels. The fonts are those of the DejaVu family, found when the simulator is
 * configured. Nothing is loaded before the first text.
 */
class CGlyphAtlas : private CNonCopyable {
 public:
  CGlyphAtlas();
  ~CGlyphAtlas();

  /** Starts a picture: forgets the letters of earlier ones if they fill much of the image. */
  void BeginPicture();

  /**
   * Appends the letters of a text: all contours, then all letters.
   * @param x, y   place of the text's position, pixels, y down.
   * @param scale  drawn pixels per pixel of the text's size.
   * @throws CARGoSException if a font cannot be loaded, or if the letters do not fit the image.
   */
  void Append(const SLabel& label, double x, double y, double scale,
              std::vector<SGlyphInstance>& instances);

  /** Coverage, one byte per pixel, rows from top to bottom (GetHeight(), GetWidth()). */
  const std::vector<std::uint8_t>& GetPixels() const { return m_pixels; }
  int GetWidth() const { return kWidth; }
  int GetHeight() const { return static_cast<int>(m_pixels.size()) / kWidth; }
  /** Changes when the pixels change. */
  std::uint64_t GetVersion() const { return m_version; }

 private:
  static constexpr int kWidth = 1024;  // pixels
  static constexpr int kMaxHeight = 8192;  // pixels

  struct SFonts;  // FreeType's objects
  // a rectangle of the image, and where its upper left corner lies from the pen, y down
  struct SBitmap {
    int X = 0;
    int Y = 0;
    int Width = 0;
    int Height = 0;
    int Left = 0;
    int Top = 0;
  };
  struct SGlyph {
    SBitmap Letter;
    SBitmap Contour;
    double Advance = 0.0;  // pixels
  };
  typedef std::tuple<std::size_t, int, bool, char32_t> TKey;  // font, size, italic, character

  const SGlyph& Get(const TKey& key);
  SBitmap Store(const std::vector<std::uint8_t>& pixels, int width, int height);
  double MeasureLine(std::u32string_view line, const STextStyle& style, std::size_t font, int size);

  std::unique_ptr<SFonts> m_fonts;
  std::map<TKey, SGlyph> m_glyphs;
  std::vector<std::uint8_t> m_pixels;
  std::uint64_t m_version = 0;
  // the place of the next bitmap: letters stand in rows
  int m_nextX = 0;
  int m_nextY = 0;
  int m_rowHeight = 0;
};

}  // namespace argos

#endif
