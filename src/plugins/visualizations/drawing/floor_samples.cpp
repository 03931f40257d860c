#include <argos3/core/simulator/visualization/floor_samples.h>

#include <argos3/core/simulator/entity/floor_entity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace argos {

namespace {

constexpr int kMaxSide = 8192;  // pixels
constexpr int kEdge = 48;  // 0 to 255; neighbours that differ by more are on two sides of an edge

int ComputeSide(UInt32 imageSide, double length, UInt32 pixelsPerMeter) {
  if (imageSide > 0) {
    return static_cast<int>(std::min<UInt32>(imageSide, kMaxSide));
  }
  const double pixels = std::ceil(length * std::max<UInt32>(pixelsPerMeter, 1) - 1e-6);
  return static_cast<int>(std::clamp<double>(pixels, 1.0, kMaxSide));
}

bool Differ(const std::uint8_t* a, const std::uint8_t* b) {
  return std::abs(a[0] - b[0]) > kEdge || std::abs(a[1] - b[1]) > kEdge ||
         std::abs(a[2] - b[2]) > kEdge;
}

// samples a floor; pixel (column, row) covers [column, column + 1) x [row, row + 1)
class CSampler {
 public:
  CSampler(CFloorEntity& floor, const CVector3& center, const CVector3& size, int width, int height)
      : m_floor(floor),
        m_corner(center - size * 0.5),
        m_step(size.GetX() / width, size.GetY() / height),
        m_width(width),
        m_height(height),
        m_pixels(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  std::vector<std::uint8_t> Sample() {
    std::uint8_t* pixel = m_pixels.data();
    for (int row = 0; row < m_height; ++row) {
      for (int column = 0; column < m_width; ++column, pixel += 4) {
        const CColor color = At(column + 0.5, row + 0.5);
        pixel[0] = color.GetRed();
        pixel[1] = color.GetGreen();
        pixel[2] = color.GetBlue();
        pixel[3] = 255;
      }
    }
    return !m_floor.IsPixelated() ? Filter() : std::move(m_pixels);
  }

 private:
  CColor At(double column, double row) {
    return m_floor.GetColorAtPoint(m_corner.GetX() + column * m_step.GetX(),
                                   m_corner.GetY() + row * m_step.GetY());
  }

  const std::uint8_t* Get(int column, int row) const {
    const int x = std::clamp(column, 0, m_width - 1);
    const int y = std::clamp(row, 0, m_height - 1);
    return m_pixels.data() + 4 * (static_cast<std::size_t>(y) * m_width + x);
  }

  std::vector<std::uint8_t> Filter() {
    std::vector<std::uint8_t> filtered = m_pixels;
    std::uint8_t* pixel = filtered.data();
    for (int row = 0; row < m_height; ++row) {
      for (int column = 0; column < m_width; ++column, pixel += 4) {
        const std::uint8_t* const here = Get(column, row);
        if (Differ(here, Get(column - 1, row)) || Differ(here, Get(column + 1, row)) ||
            Differ(here, Get(column, row - 1)) || Differ(here, Get(column, row + 1))) {
          Average(column, row, pixel);
        }
      }
    }
    return filtered;
  }

  void Average(int column, int row, std::uint8_t* pixel) {
    std::array<int, 3> sum = {2, 2, 2};  // rounds to the nearest
    for (const double y : {0.25, 0.75}) {
      for (const double x : {0.25, 0.75}) {
        const CColor color = At(column + x, row + y);
        sum[0] += color.GetRed();
        sum[1] += color.GetGreen();
        sum[2] += color.GetBlue();
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      pixel[i] = static_cast<std::uint8_t>(sum[i] / 4);
    }
  }

  CFloorEntity& m_floor;
  CVector3 m_corner;
  CVector2 m_step;
  int m_width;
  int m_height;
  std::vector<std::uint8_t> m_pixels;
};

}  // namespace

SFloorSamples SampleFloor(CFloorEntity& floor, const CVector3& center, const CVector3& size) {
  SFloorSamples samples;
  samples.Width = ComputeSide(floor.GetImageWidth(), size.GetX(), floor.GetPixelsPerMeter());
  samples.Height = ComputeSide(floor.GetImageHeight(), size.GetY(), floor.GetPixelsPerMeter());
  samples.Pixels = CSampler(floor, center, size, samples.Width, samples.Height).Sample();
  return samples;
}

}  // namespace argos
