#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>

#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// size of texts that give none, in heights of the picture
constexpr Real kTextHeight = 0.025;
constexpr Real kMinTextSize = 12.0;  // pixels
// distance of texts from the edges of the picture and of each other's base lines, in their sizes
constexpr Real kEdge = 0.8;
constexpr Real kLineHeight = 1.35;

}  // namespace

CColor GetInk(TConfigurationNode& overlay) {
  std::string look;
  TConfigurationNode* const overlays = overlay.Parent(false);
  TConfigurationNode* const view = overlays == nullptr ? nullptr : overlays->Parent(false);
  if (view != nullptr) {
    GetNodeAttributeOrDefault(*view, "look", look, look);
  }
  return look == "dark" ? CColor::WHITE : CColor::BLACK;
}

void SOverlayText::Read(TConfigurationNode& node) {
  Color = GetInk(node);
  GetNodeAttributeOrDefault(node, "color", Color, Color);
  if (NodeAttributeExists(node, "size")) {
    ReadPositive(node, "size", "pixels", Size);
  }
}

STextStyle SOverlayText::MakeStyle(const CDrawing& drawing,
                                   STextStyle::EAlignment alignment) const {
  STextStyle style;
  style.Size = Size > 0.0 ? Size : std::max(kMinTextSize, kTextHeight * drawing.GetHeight());
  style.IsBold = IsBold;
  style.Alignment = alignment;
  return style;
}

void SPictureCorner::Read(TConfigurationNode& node) {
  if (!NodeAttributeExists(node, "corner")) {
    return;
  }
  std::string name;
  GetNodeAttribute(node, "corner", name);
  if (name != "top_left" && name != "top_right" && name != "bottom_left" &&
      name != "bottom_right") {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": unknown corner \"" << name << "\""
                                       << DidYouMean(name, {"bottom_left", "bottom_right",
                                                            "top_left", "top_right"}));
  }
  IsRight = name == "top_right" || name == "bottom_right";
  IsBottom = name == "bottom_left" || name == "bottom_right";
}

CVector3 SPictureCorner::PlaceLine(const CDrawing& drawing, Real size, UInt32 line,
                                   UInt32 lines) const {
  const Real x = IsRight ? drawing.GetWidth() - kEdge * size : kEdge * size;
  const Real y = IsBottom ? drawing.GetHeight() - kEdge * size -
                                kLineHeight * size * static_cast<Real>(lines - 1 - line)
                          : (kEdge + 1.0) * size + kLineHeight * size * static_cast<Real>(line);
  return {x, y, 0.0};
}

void ReadLineWidth(TConfigurationNode& node, Real& width) {
  if (NodeAttributeExists(node, "width")) {
    ReadPositive(node, "width", "pixels", width);
  }
}

std::string OverlayXML(const std::string& element, const std::string& more) {
  return fmt::format(R"(REQUIRED XML CONFIGURATION

  <overlays> {} </overlays>

in the element of a view that draws pictures, such as <offscreen>.{}

OPTIONAL XML CONFIGURATION

)",
                     element, more);
}

Real RoundLengthDown(Real length) {
  const Real power = std::pow(10.0, std::floor(std::log10(length)));
  // 1e-9: a length that is such a number but for rounding is kept
  const Real mantissa = length / power * (1.0 + 1e-9);
  return (mantissa >= 5.0 ? 5.0 : mantissa >= 2.0 ? 2.0 : 1.0) * power;
}

std::string FormatLength(Real length) {
  if (length < 0.1) {
    return fmt::format("{:g} cm", 100.0 * length);
  }
  return fmt::format("{:g} m", length);
}

}  // namespace argos
