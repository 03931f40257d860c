#include <argos3/plugins/simulator/visualizations/offscreen/recording_xml.h>

#include <argos3/plugins/simulator/visualizations/scene/ground_texture.h>

#include <algorithm>
#include <array>

namespace argos {

namespace {

constexpr UInt32 kSmallestSide = 16;  // pixels
constexpr UInt32 kLargestSide = 16384;  // pixels; the limit of current drivers
constexpr std::array<UInt32, 5> kSampleCounts = {1, 2, 4, 8, 16};

int CheckSide(const TConfigurationNode& node, const std::string& attribute, UInt32 pixels) {
  if (pixels < kSmallestSide || pixels > kLargestSide) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": <" << node.Value() << ">: attribute \"" << attribute
                         << "\": " << pixels << " pixels are out of range; a side must have from "
                         << kSmallestSide << " to " << kLargestSide << " pixels");
  }
  return static_cast<int>(pixels);
}

// "WxH"
void ReadSize(TConfigurationNode& node, const std::string& attribute, SRenderSettings& render) {
  std::string text;
  GetNodeAttribute(node, attribute, text);
  const size_t cross = text.find('x');
  UInt32 width = 0;
  UInt32 height = 0;
  if (cross == std::string::npos ||
      ParseNumber(std::string_view(text).substr(0, cross), width) != ENumberParsing::Ok ||
      ParseNumber(std::string_view(text).substr(cross + 1), height) != ENumberParsing::Ok) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": <" << node.Value() << ">: attribute \"" << attribute << "\": \""
                         << text << "\" is not a size; write width and height in pixels, such as "
                         << "\"1280x960\"");
  }
  render.Width = CheckSide(node, attribute, width);
  render.Height = CheckSide(node, attribute, height);
}

void ReadPositive(TConfigurationNode& node, const std::string& attribute, UInt32& value) {
  GetNodeAttributeOrDefault(node, attribute, value, value);
  if (value == 0) {
    THROW_ARGOSEXCEPTION(node.GetLocation() << ": <" << node.Value() << ">: attribute \""
                                            << attribute << "\" is 0; it must be at least 1");
  }
}

void ReadFrameSize(TConfigurationNode& node, SRenderSettings& render) {
  const bool hasSides = NodeAttributeExists(node, "width") || NodeAttributeExists(node, "height");
  if (NodeAttributeExists(node, "size")) {
    if (hasSides) {
      THROW_ARGOSEXCEPTION(node.GetLocation()
                           << ": <" << node.Value() << "> has both \"size\" and \"width\" or "
                           << "\"height\"; give the frame's size once");
    }
    ReadSize(node, "size", render);
    return;
  }
  UInt32 width = static_cast<UInt32>(render.Width);
  UInt32 height = static_cast<UInt32>(render.Height);
  GetNodeAttributeOrDefault(node, "width", width, width);
  GetNodeAttributeOrDefault(node, "height", height, height);
  render.Width = CheckSide(node, "width", width);
  render.Height = CheckSide(node, "height", height);
}

void ReadSamples(TConfigurationNode& node, SRenderSettings& render) {
  UInt32 samples = static_cast<UInt32>(render.Samples);
  GetNodeAttributeOrDefault(node, "samples", samples, samples);
  if (std::find(kSampleCounts.begin(), kSampleCounts.end(), samples) == kSampleCounts.end()) {
    THROW_ARGOSEXCEPTION(node.GetLocation() << ": <" << node.Value() << ">: attribute \"samples\": "
                                            << samples << " is not 1, 2, 4, 8 or 16");
  }
  render.Samples = static_cast<int>(samples);
}

void ReadLook(TConfigurationNode& node, SRenderSettings& render) {
  std::string look;
  GetNodeAttributeOrDefault(node, "look", look, std::string("light"));
  try {
    render.Look = SLook::FromName(look);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(
        node.GetLocation() << ": <" << node.Value() << ">: attribute \"look\" is not valid", ex);
  }
}

// "a-b,c,d-e", each part after the one before
void ReadTicks(TConfigurationNode& node, SRecordingSettings& settings) {
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
                         (settings.Ticks.empty() || first > settings.Ticks.back().second);
    if (!isValid) {
      THROW_ARGOSEXCEPTION(node.GetLocation()
                           << ": <" << node.Value() << ">: attribute \"ticks\": \"" << part
                           << "\" in \"" << text << "\" is not valid; write ticks, or first and "
                           << "last ticks, in increasing order, such as \"0-50,100,550-600\"");
    }
    settings.Ticks.emplace_back(first, last);
  }
  if (parts.empty() && NodeAttributeExists(node, "ticks")) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": <" << node.Value() << ">: attribute \"ticks\" is empty");
  }
}

void ReadFile(TConfigurationNode& node, SFrameFileSettings& file) {
  GetNodeAttributeOrDefault(node, "directory", file.Directory, file.Directory);
  GetNodeAttributeOrDefault(node, "base_name", file.BaseName, file.BaseName);
  GetNodeAttributeOrDefault(node, "format", file.Format, file.Format);
  GetNodeAttributeOrDefault(node, "quality", file.Quality, file.Quality);
}

void ReadFrameGrabbing(TConfigurationNode& node, SQtOpenGlRequest& request) {
  SRecordingSettings& recording = request.Recording;
  recording.File.CreateDirectory = false;
  ReadFile(node, recording.File);
  // only an explicit "false" restricts frames to runs with a window
  GetNodeAttributeOrDefault(node, "headless_grabbing", request.WantsFrames, true);
  recording.Render.Width = 1600;
  recording.Render.Height = 1200;
  if (NodeAttributeExists(node, "headless_frame_size")) {
    ReadSize(node, "headless_frame_size", recording.Render);
  }
  ReadPositive(node, "headless_frame_rate", recording.Every);
  recording.KeepLastFrame = false;
  recording.Announcement = "<qt-opengl> has no window here but asks for frames: ";
}

}  // namespace

SRecordingSettings ReadOffscreenSettings(TConfigurationNode& node) {
  SRecordingSettings settings;
  settings.File.Directory = "out";
  ReadFile(node, settings.File);
  ReadFrameSize(node, settings.Render);
  ReadSamples(node, settings.Render);
  ReadLook(node, settings.Render);
  ReadPositive(node, "every", settings.Every);
  ReadTicks(node, settings);
  settings.Ground = ReadGroundTexture(node);
  GetNodeAttributeOrDefault(node, "show_grid", settings.ShowGrid, true);
  GetNodeAttributeOrDefault(node, "show_boundary", settings.ShowBoundary, true);
  GetNodeAttributeOrDefault(node, "show_rays", settings.ShowRays, true);
  return settings;
}

SQtOpenGlRequest ReadQtOpenGlRequest(TConfigurationNode& node) {
  SQtOpenGlRequest request;
  std::string title;
  bool ofTheWindow = false;
  GetNodeAttributeOrDefault(node, "title", title, title);
  GetNodeAttributeOrDefault(node, "autoplay", ofTheWindow, false);
  GetNodeAttributeOrDefault(node, "lua_editor", ofTheWindow, false);
  GetNodeAttributeOrDefault(node, "invert_mouse", ofTheWindow, false);
  GetNodeAttributeOrDefault(node, "show_boundary", request.Recording.ShowBoundary, true);
  if (NodeExists(node, "frame_grabbing")) {
    ReadFrameGrabbing(GetNode(node, "frame_grabbing"), request);
  }
  // checked also if no frames are requested, so that nothing draws
  TConfigurationNodeIterator it("user_functions");
  for (it = it.begin(&node); it != it.end(); ++it) {
    std::string text;
    request.HasUserFunctions = true;
    GetNodeAttribute(*it, "label", text);
    GetNodeAttributeOrDefault(*it, "library", text, text);
  }
  return request;
}

}  // namespace argos
