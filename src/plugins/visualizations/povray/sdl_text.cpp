#include <argos3/plugins/simulator/visualizations/povray/sdl_text.h>

#include <argos3/core/utility/text/utf8.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr double kMaxByte = 255.0;

// four digits tell apart all 256 levels
std::string ToLevel(double value) {
  return fmt::format("{:.4g}", value / kMaxByte);
}

}  // namespace

std::string ToSdl(double value) {
  return fmt::format("{}", value);
}

std::string ToSdl(float value) {
  return fmt::format("{}", value);
}

std::string ToSdl(const Eigen::Vector3d& vector) {
  return fmt::format("<{},{},{}>", vector.x(), vector.y(), vector.z());
}

std::string ToSdl(const std::array<float, 3>& vector) {
  return fmt::format("<{},{},{}>", vector[0], vector[1], vector[2]);
}

std::string ToSdl(const SRgba& color) {
  const std::string rgb =
      fmt::format("{},{},{}", ToLevel(color.R), ToLevel(color.G), ToLevel(color.B));
  return color.A == 255 ? fmt::format("srgb <{}>", rgb)
                        : fmt::format("srgbt <{},{}>", rgb, ToLevel(kMaxByte - color.A));
}

std::string ToSdlFilter(const SRgba& color, double share) {
  return fmt::format("srgbf <{},{},{},{:.4g}>", ToLevel(color.R), ToLevel(color.G),
                     ToLevel(color.B), share);
}

std::string ToSdl(const std::array<std::array<float, 4>, 3>& rows) {
  std::string text = "matrix <";
  for (std::size_t column = 0; column < 4; ++column) {
    for (const std::array<float, 4>& row : rows) {
      text += text.back() == '<' ? "" : ",";
      text += ToSdl(row[column]);
    }
  }
  return text + ">";
}

std::string ToSdlString(std::string_view text) {
  std::string literal = "\"";
  while (!text.empty()) {
    const std::size_t size = CountUtf8Bytes(text);
    const char first = text.front();
    if (size == 0) {
      literal += '?';
    } else if (size == 1 && (static_cast<unsigned char>(first) < 0x20 || first == 0x7F)) {
      literal += ' ';
    } else if (first == '"' || first == '\\') {
      literal += '\\';
      literal += first;
    } else {
      literal += text.substr(0, size);
    }
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return literal + '"';
}

bool IsFinite(const std::array<float, 3>& vector) {
  return std::all_of(vector.begin(), vector.end(), [](float x) { return std::isfinite(x); });
}

bool IsFinite(const std::array<std::array<float, 4>, 3>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const std::array<float, 4>& row) {
    return std::all_of(row.begin(), row.end(), [](float x) { return std::isfinite(x); });
  });
}

}  // namespace argos
