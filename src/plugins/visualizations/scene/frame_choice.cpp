#include <argos3/plugins/simulator/visualizations/scene/frame_choice.h>

#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/visualizations/scene/ground_texture.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace argos {

namespace {

constexpr UInt32 kMinSide = 16;  // pixels
constexpr UInt32 kMaxSide = 16384;  // pixels; the limit of current drivers

int CheckSide(const TConfigurationNode& node, const std::string& attribute, UInt32 pixels) {
  if (pixels < kMinSide || pixels > kMaxSide) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"" << attribute << "\": " << pixels
                                       << " pixels are out of range; a side must have from "
                                       << kMinSide << " to " << kMaxSide << " pixels");
  }
  return static_cast<int>(pixels);
}

// "a-b,c,d-e", each part after the one before
void ReadTicks(TConfigurationNode& node, SFrameChoice& choice) {
  std::string text;
  GetNodeAttributeOrDefault(node, "ticks", text, text);
  std::vector<std::string> parts;
  if (NodeAttributeExists(node, "ticks")) {
    Tokenize(text, parts, ",");
  }
  for (const std::string& part : parts) {
    const size_t dash = part.find('-');
    const std::string_view view(part);
    UInt32 first = 0;
    UInt32 last = 0;
    const bool isValid = ParseNumber(view.substr(0, dash), first) == ENumberParsing::Ok &&
                         ParseNumber(dash == std::string::npos ? view : view.substr(dash + 1),
                                     last) == ENumberParsing::Ok &&
                         last >= first &&
                         (choice.Ticks.empty() || first > choice.Ticks.back().second);
    if (!isValid) {
      THROW_ARGOSEXCEPTION(OwnerOf(node)
                           << ": attribute \"ticks\": \"" << part << "\" in \"" << text
                           << "\" is not valid; write ticks, or first and "
                           << "last ticks, in increasing order, such as \"0-50,100,550-600\"");
    }
    choice.Ticks.emplace_back(first, last);
  }
  if (parts.empty() && NodeAttributeExists(node, "ticks")) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"ticks\" is empty");
  }
}

}  // namespace

bool SFrameChoice::IsWanted(std::uint32_t tick, bool isFirst) const {
  if (Ticks.empty()) {
    return isFirst || tick % Every == 0;
  }
  return tick % Every == 0 && std::any_of(Ticks.begin(), Ticks.end(), [tick](const auto& part) {
           return tick >= part.first && tick <= part.second;
         });
}

void ReadFrameChoice(TConfigurationNode& node, SFrameChoice& choice) {
  ReadPositive(node, "every", choice.Every);
  ReadTicks(node, choice);
}

void ReadFrameContents(TConfigurationNode& node, SFrameContents& contents) {
  contents.Ground = ReadGroundTexture(node);
  GetNodeAttributeOrDefault(node, "show_grid", contents.ShowGrid, true);
  GetNodeAttributeOrDefault(node, "show_boundary", contents.ShowBoundary, true);
  GetNodeAttributeOrDefault(node, "show_rays", contents.ShowRays, true);
}

void ReadPositive(TConfigurationNode& node, const std::string& attribute, UInt32& value) {
  GetNodeAttributeOrDefault(node, attribute, value, value);
  if (value == 0) {
    THROW_ARGOSEXCEPTION(OwnerOf(node)
                         << ": attribute \"" << attribute << "\" is 0; it must be at least 1");
  }
}

void ReadSize(TConfigurationNode& node, const std::string& attribute, int& frameWidth,
              int& frameHeight) {
  std::string text;
  GetNodeAttribute(node, attribute, text);
  const size_t cross = text.find('x');
  UInt32 width = 0;
  UInt32 height = 0;
  if (cross == std::string::npos ||
      ParseNumber(std::string_view(text).substr(0, cross), width) != ENumberParsing::Ok ||
      ParseNumber(std::string_view(text).substr(cross + 1), height) != ENumberParsing::Ok) {
    THROW_ARGOSEXCEPTION(OwnerOf(node)
                         << ": attribute \"" << attribute << "\": \"" << text
                         << "\" is not a size; write width and height in pixels, such as "
                         << "\"1280x960\"");
  }
  frameWidth = CheckSide(node, attribute, width);
  frameHeight = CheckSide(node, attribute, height);
}

void ReadFrameSize(TConfigurationNode& node, int& frameWidth, int& frameHeight) {
  const bool hasSides = NodeAttributeExists(node, "width") || NodeAttributeExists(node, "height");
  if (NodeAttributeExists(node, "size")) {
    if (hasSides) {
      THROW_ARGOSEXCEPTION(OwnerOf(node) << " has both \"size\" and \"width\" or "
                                         << "\"height\"; give the frame's size once");
    }
    ReadSize(node, "size", frameWidth, frameHeight);
    return;
  }
  UInt32 width = static_cast<UInt32>(frameWidth);
  UInt32 height = static_cast<UInt32>(frameHeight);
  GetNodeAttributeOrDefault(node, "width", width, width);
  GetNodeAttributeOrDefault(node, "height", height, height);
  frameWidth = CheckSide(node, "width", width);
  frameHeight = CheckSide(node, "height", height);
}

}  // namespace argos
