#ifndef ARGOS3_TESTING_SUPPORT_PLOT_PICTURE_H
#define ARGOS3_TESTING_SUPPORT_PLOT_PICTURE_H

// where the axes and the lines of a figure are in its picture

#include <argos3/core/simulator/images/image_file.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace argos {

/** Pixels from the left and from the top, both ends included. */
struct SPixelBox {
  double Left, Top, Right, Bottom;
  double GetWidth() const { return Right - Left; }
  double GetHeight() const { return Bottom - Top; }
};

/** The picture of a figure, such as a PNG file. */
class CPlotPicture {
 public:
  static constexpr UInt32 kAxisColor = 0x555555;
  static constexpr UInt32 kFirstColor = 0x332288; /**< of the first series, box or robot */

  explicit CPlotPicture(const std::string& file) : m_image(ReadImage(file, "figure")) {}

  double GetWidth() const { return static_cast<double>(m_image.Width); }
  double GetHeight() const { return static_cast<double>(m_image.Height); }
  SPixelBox GetWhole() const { return {0.0, 0.0, GetWidth() - 1.0, GetHeight() - 1.0}; }

  /** The box around all pixels of a colour. */
  SPixelBox FindBox(UInt32 color, const SPixelBox& area) const {
    SPixelBox box{area.Right, area.Bottom, area.Left, area.Top};
    for (double y = area.Top; y <= area.Bottom; ++y) {
      for (double x = area.Left; x <= area.Right; ++x) {
        if (HasColor(x, y, color)) {
          box = {std::min(box.Left, x), std::min(box.Top, y), std::max(box.Right, x),
                 std::max(box.Bottom, y)};
        }
      }
    }
    REQUIRE(box.Left <= box.Right);
    return box;
  }

  /**
   * From the left axis to the end of the lower one: the first column, and the last row, of pixels
   * with the colour of axes that are nearly as many as in any other.
   */
  SPixelBox FindAxes() const {
    const SPixelBox whole = GetWhole();
    std::vector<double> columns(m_image.Width);
    std::vector<double> rows(m_image.Height);
    for (size_t y = 0; y < rows.size(); ++y) {
      for (size_t x = 0; x < columns.size(); ++x) {
        const bool isAxis = HasColor(static_cast<double>(x), static_cast<double>(y), kAxisColor);
        columns[x] += isAxis ? 1.0 : 0.0;
        rows[y] += isAxis ? 1.0 : 0.0;
      }
    }
    const auto isLong = [](const std::vector<double>& counts) {
      return [most = *std::max_element(counts.begin(), counts.end())](double count) {
        return count > 0.9 * most;
      };
    };
    const double left = static_cast<double>(
        std::find_if(columns.begin(), columns.end(), isLong(columns)) - columns.begin());
    const double bottom =
        whole.Bottom -
        static_cast<double>(std::find_if(rows.rbegin(), rows.rend(), isLong(rows)) - rows.rbegin());
    return {left, FindBox(kAxisColor, {left, 0.0, left, bottom}).Top,
            FindBox(kAxisColor, {left, bottom, whole.Right, bottom}).Right, bottom};
  }

 private:
  bool HasColor(double x, double y, UInt32 color) const {
    // the lowest row is the first
    const size_t row = m_image.Height - 1 - static_cast<size_t>(y);
    const UInt8* pixel = &m_image.Pixels[3 * (row * m_image.Width + static_cast<size_t>(x))];
    return (UInt32(pixel[0]) << 16 | UInt32(pixel[1]) << 8 | pixel[2]) == color;
  }

  SImage m_image;
};

}  // namespace argos

#endif
