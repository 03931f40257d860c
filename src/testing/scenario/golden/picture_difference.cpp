#include "picture_difference.h"

#include <argos3/core/utility/configuration/argos_exception.h>

#include <FreeImage.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace argos {

namespace {

typedef std::array<double, 3> TColor;

double ToLinear(std::uint8_t value) {
  const double share = value / 255.0;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

// CIE 15:2004; sRGB's primaries and white of IEC 61966-2-1
TColor ToLab(const TColor& rgb) {
  const auto curve = [](double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  };
  const double x = curve((0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505);
  const double y = curve(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]);
  const double z = curve((0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

// in linear light, blurred; borders are repeated
TColor Blur(const SPicture& picture, int x, int y) {
  TColor sum = {};
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column) {
      const double weight = (2 - std::abs(row)) * (2 - std::abs(column)) / 16.0;
      const std::uint8_t* const pixel = picture.At(std::clamp(x + column, 0, picture.Width - 1),
                                                   std::clamp(y + row, 0, picture.Height - 1));
      for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += weight * ToLinear(pixel[i]);
      }
    }
  }
  return sum;
}

}  // namespace

SPictureDifference ComputeDifference(const SPicture& a, const SPicture& b) {
  if (a.Width != b.Width || a.Height != b.Height) {
    THROW_ARGOSEXCEPTION("a picture of " << a.Width << "x" << a.Height << " pixels and one of "
                                         << b.Width << "x" << b.Height << " cannot be compared");
  }
  SPictureDifference difference;
  for (int y = 0; y < a.Height; ++y) {
    for (int x = 0; x < a.Width; ++x) {
      const TColor here = ToLab(Blur(a, x, y));
      const TColor there = ToLab(Blur(b, x, y));
      const double distance =
          std::hypot(here[0] - there[0], here[1] - there[1], here[2] - there[2]);
      difference.Mean += distance;
      difference.Most = std::max(difference.Most, distance);
    }
  }
  difference.Mean /= std::max(1, a.Width * a.Height);
  return difference;
}

SPicture ReadPicture(const std::string& path) {
  typedef std::unique_ptr<FIBITMAP, void (*)(FIBITMAP*)> TBitmap;
  const TBitmap stored(FreeImage_Load(FreeImage_GetFileType(path.c_str()), path.c_str()),
                       &FreeImage_Unload);
  const TBitmap bitmap(stored ? FreeImage_ConvertTo24Bits(stored.get()) : nullptr,
                       &FreeImage_Unload);
  if (bitmap == nullptr) {
    THROW_ARGOSEXCEPTION("\"" << path << "\" is not a picture that can be read");
  }
  SPicture picture;
  picture.Width = static_cast<int>(FreeImage_GetWidth(bitmap.get()));
  picture.Height = static_cast<int>(FreeImage_GetHeight(bitmap.get()));
  for (int row = picture.Height - 1; row >= 0; --row) {
    const BYTE* pixel = FreeImage_GetScanLine(bitmap.get(), row);
    for (int column = 0; column < picture.Width; ++column, pixel += 3) {
      for (const int channel : {FI_RGBA_RED, FI_RGBA_GREEN, FI_RGBA_BLUE}) {
        picture.Pixels.push_back(pixel[channel]);
      }
      picture.Pixels.push_back(255);
    }
  }
  return picture;
}

}  // namespace argos
