#include <argos3/plugins/simulator/visualizations/offscreen/offscreen_xml.h>

#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace argos {

namespace {

constexpr std::array<UInt32, 5> kSampleCounts = {1, 2, 4, 8, 16};

void ReadSamples(TConfigurationNode& node, SRenderSettings& render) {
  UInt32 samples = static_cast<UInt32>(render.Samples);
  GetNodeAttributeOrDefault(node, "samples", samples, samples);
  if (std::find(kSampleCounts.begin(), kSampleCounts.end(), samples) == kSampleCounts.end()) {
    THROW_ARGOSEXCEPTION(OwnerOf(node)
                         << ": attribute \"samples\": " << samples << " is not 1, 2, 4, 8 or 16");
  }
  render.Samples = static_cast<int>(samples);
}

void ReadLook(TConfigurationNode& node, SRenderSettings& render) {
  std::string look;
  GetNodeAttributeOrDefault(node, "look", look, std::string("light"));
  try {
    render.Look = SLook::FromName(look);
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(node) << ": attribute \"look\" is not valid", ex);
  }
}

void ReadFile(TConfigurationNode& node, SFrameFileSettings& file) {
  GetNodeAttributeOrDefault(node, "directory", file.Directory, file.Directory);
  GetNodeAttributeOrDefault(node, "base_name", file.BaseName, file.BaseName);
  GetNodeAttributeOrDefault(node, "format", file.Format, file.Format);
  GetNodeAttributeOrDefault(node, "quality", file.Quality, file.Quality);
}

// a real number that the text gives with at most four decimals
void ReadFilmNumber(TConfigurationNode& node, const std::string& attribute, double highest,
                    double& value) {
  GetNodeAttribute(node, attribute, value);
  constexpr double kSteps = 1e4;
  if (!(value >= 1.0 / kSteps) || !(value <= highest)) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"" << attribute << "\" is " << value
                                       << "; it must be from 0.0001 to " << highest);
  }
  value = std::round(value * kSteps) / kSteps;
}

void ReadFilmRate(TConfigurationNode& node, SFilmSettings& film) {
  constexpr double kMaxSpeed = 10000.0;
  constexpr double kMinRate = 1.0;
  if (NodeAttributeExists(node, "speed")) {
    ReadFilmNumber(node, "speed", kMaxSpeed, film.Speed);
  }
  if (NodeAttributeExists(node, "fps")) {
    const double highest = film.Format == EFilmFormat::Gif ? 50.0 : 240.0;
    double rate = 0.0;
    ReadFilmNumber(node, "fps", highest, rate);
    if (rate < kMinRate) {
      THROW_ARGOSEXCEPTION(OwnerOf(node)
                           << ": attribute \"fps\" is " << rate << "; it must be at least "
                           << kMinRate << ", frames of long duration are repeated");
    }
    film.FramesPerSecond = rate;
  }
}

void CheckFilmQuality(const TConfigurationNode& node, int quality) {
  if (quality < -1 || quality > 100) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"quality\" is " << quality
                                       << "; it must be from 0 to 100, or -1 for the format's own");
  }
}

EFilmFormat FindFormatOfFilm(const TConfigurationNode& node, const std::string& file) {
  const std::optional<EFilmFormat> format = FindFilmFormatOfFile(file);
  if (!format) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": a film cannot be written to \"" << file
                                       << "\": its name must end in " << kFilmExtensions);
  }
  return *format;
}

// "file", or "format" with the format of a film
std::optional<SFilmSettings> ReadFilm(TConfigurationNode& node) {
  SFilmSettings film;
  std::string format;
  GetNodeAttributeOrDefault(node, "format", format, format);
  if (NodeAttributeExists(node, "file")) {
    for (const char* other : {"directory", "base_name", "format"}) {
      if (NodeAttributeExists(node, other)) {
        THROW_ARGOSEXCEPTION(OwnerOf(node) << " has both \"file\" and \"" << other
                                           << "\"; \"file\" is the path of a film");
      }
    }
    GetNodeAttribute(node, "file", film.File);
  } else if (FindFilmFormat(format)) {
    SFrameFileSettings file;
    file.Directory = "out";
    file.BaseName = "film";
    ReadFile(node, file);
    film.File = file.Directory + '/' + file.BaseName + '.' + format;
  } else {
    for (const char* attribute : {"speed", "fps"}) {
      if (NodeAttributeExists(node, attribute)) {
        THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"" << attribute
                                           << "\" is of films only; add file=\"film.mp4\"");
      }
    }
    return std::nullopt;
  }
  film.Format = FindFormatOfFilm(node, film.File);
  GetNodeAttributeOrDefault(node, "quality", film.Quality, film.Quality);
  CheckFilmQuality(node, film.Quality);
  ReadFilmRate(node, film);
  return film;
}

void ReadOutput(TConfigurationNode& node, SFrameSeriesSettings& settings) {
  settings.Film = ReadFilm(node);
  if (!settings.Film) {
    settings.File.Directory = "out";
    ReadFile(node, settings.File);
    return;
  }
  settings.KeepLastFrame = false;
  settings.ChoosesEvery = !NodeAttributeExists(node, "every");
}

// the usual coding of colours in films has one sample for each square of four pixels
void MakeSidesEven(SFrameSeriesSettings& settings) {
  if (settings.Film && settings.Film->Format != EFilmFormat::Gif) {
    settings.Render.Width += settings.Render.Width % 2;
    settings.Render.Height += settings.Render.Height % 2;
  }
}

void ReadFrameGrabbing(TConfigurationNode& node, SQtOpenGlRequest& request) {
  SFrameSeriesSettings& frames = request.Frames;
  frames.File.CreateDirectory = false;
  ReadFile(node, frames.File);
  // an explicit "false" restricts frames to runs with a window
  GetNodeAttributeOrDefault(node, "headless_grabbing", request.WantsFrames, true);
  frames.Render.Width = 1600;
  frames.Render.Height = 1200;
  if (NodeAttributeExists(node, "headless_frame_size")) {
    ReadSize(node, "headless_frame_size", frames.Render.Width, frames.Render.Height);
  }
  ReadPositive(node, "headless_frame_rate", frames.Every);
  frames.KeepLastFrame = false;
  frames.Announcement = "<qt-opengl> has no window here but asks for frames: ";
}

}  // namespace

SFrameSeriesSettings ReadOffscreenSettings(TConfigurationNode& node) {
  SFrameSeriesSettings settings;
  ReadOutput(node, settings);
  ReadFrameSize(node, settings.Render.Width, settings.Render.Height);
  MakeSidesEven(settings);
  ReadSamples(node, settings.Render);
  ReadLook(node, settings.Render);
  ReadFrameChoice(node, settings);
  ReadFrameContents(node, settings);
  return settings;
}

void CompleteFilmSettings(SFrameSeriesSettings& settings, UInt32 ticksPerSecond) {
  if (!settings.Film) {
    return;
  }
  SFilmSettings& film = *settings.Film;
  film.TicksPerSecond = ticksPerSecond;
  film.IsInParts = !settings.Ticks.empty();
  if (settings.ChoosesEvery) {
    settings.Every = ChooseEvery(film);
  }
  film.Every = settings.Every;
}

SQtOpenGlRequest ReadQtOpenGlRequest(TConfigurationNode& node) {
  SQtOpenGlRequest request;
  std::string title;
  bool ofTheWindow = false;
  GetNodeAttributeOrDefault(node, "title", title, title);
  GetNodeAttributeOrDefault(node, "autoplay", ofTheWindow, false);
  GetNodeAttributeOrDefault(node, "lua_editor", ofTheWindow, false);
  GetNodeAttributeOrDefault(node, "invert_mouse", ofTheWindow, false);
  GetNodeAttributeOrDefault(node, "show_boundary", request.Frames.ShowBoundary, true);
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
