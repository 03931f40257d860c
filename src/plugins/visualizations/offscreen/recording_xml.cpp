#include <argos3/plugins/simulator/visualizations/offscreen/recording_xml.h>

#include <argos3/plugins/simulator/visualizations/scene/ground_texture.h>

#include <algorithm>
#include <array>

namespace argos {

namespace {

constexpr std::array<UInt32, 5> kSampleCounts = {1, 2, 4, 8, 16};

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
    ReadSize(node, "headless_frame_size", recording.Render.Width, recording.Render.Height);
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
  ReadFrameSize(node, settings.Render.Width, settings.Render.Height);
  ReadSamples(node, settings.Render);
  ReadLook(node, settings.Render);
  ReadFrameChoice(node, settings);
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
