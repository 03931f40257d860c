#include <argos3/plugins/simulator/visualizations/offscreen/film_encoding.h>

#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/support/shell_quoting.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace argos {

namespace {

constexpr std::int64_t kSpeedSteps = 10000;  // steps per unit
constexpr std::int64_t kMaxTerm = 1000000;  // ffmpeg rounds ratios of larger numbers

constexpr double kLowestRate = 1.0;  // players stumble over less
constexpr double kHighestRate = 60.0;  // most displays show no more, frames/s
constexpr double kHighestGifRate = 30.0;  // browsers slow down delays below 2/100 s
constexpr double kSmoothRate = 30.0;  // no more is drawn unless it is asked for

// constant rate factors; 0 to 51 (x264) and 63 (VP9), lower is better
constexpr double kWorstX264 = 40.0;
constexpr double kBestX264 = 10.0;
constexpr int kDefaultX264 = 20;
constexpr double kWorstVp9 = 55.0;
constexpr double kBestVp9 = 15.0;
constexpr int kDefaultVp9 = 30;
constexpr int kMinColors = 16;
constexpr int kMaxColors = 256;

int Between(double worst, double best, int quality) {
  return static_cast<int>(std::lround(worst + (best - worst) * quality / 100.0));
}

// colours of HD video; players of films without a mark guess by their size
constexpr char kToVideo[] =
    "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p";

std::string MakeFilters(const SFilmSettings& settings, const SFrameRate& rate) {
  const SFrameRate fileRate = ChooseFileRate(settings, rate);
  const bool isChanged =
      fileRate.Numerator != rate.Numerator || fileRate.Denominator != rate.Denominator;
  const std::string resampling = isChanged ? "fps=" + fileRate.ToText() + "," : "";
  if (settings.Format != EFilmFormat::Gif) {
    return resampling + kToVideo;
  }
  const int colors =
      settings.Quality < 0 ? kMaxColors : Between(kMinColors, kMaxColors, settings.Quality);
  // a palette for each frame: one for the whole film would need all frames in memory
  return resampling + fmt::format(
                          "split[a][b];[a]palettegen=max_colors={}:reserve_transparent=0:"
                          "stats_mode=single[p];[b][p]paletteuse=new=1:dither=none",
                          colors);
}

std::vector<std::string> MakeOutputArguments(const SFilmSettings& settings,
                                             const SFrameRate& rate) {
  std::vector<std::string> arguments = {"-an", "-vf", MakeFilters(settings, rate)};
  const auto add = [&arguments](std::initializer_list<std::string> more) {
    arguments.insert(arguments.end(), more);
  };
  const int quality = settings.Quality;
  switch (settings.Format) {
    case EFilmFormat::Mp4:
      add({"-c:v", "libx264", "-crf",
           std::to_string(quality < 0 ? kDefaultX264 : Between(kWorstX264, kBestX264, quality)),
           "-movflags", "+faststart"});
      break;
    case EFilmFormat::Webm:
      add({"-c:v", "libvpx-vp9", "-b:v", "0", "-crf",
           std::to_string(quality < 0 ? kDefaultVp9 : Between(kWorstVp9, kBestVp9, quality)),
           "-deadline", "good", "-cpu-used", "4", "-row-mt", "1"});
      break;
    case EFilmFormat::Gif:
      add({"-c:v", "gif", "-loop", "0", "-f", "gif"});
      return arguments;
  }
  add({"-color_primaries", "bt709", "-color_trc", "bt709", "-colorspace", "bt709", "-f",
       settings.Format == EFilmFormat::Mp4 ? "mp4" : "webm"});
  return arguments;
}

// a name may look like an option or a protocol, and patterns have no protocol
std::string ToArgument(const std::string& path) {
  const bool isPlain = path[0] == '/' || (path[0] != '-' && path.find(':') == std::string::npos);
  return isPlain ? path : "./" + path;
}

std::string EscapePattern(const std::string& path) {
  std::string escaped;
  for (const char c : path) {
    escaped += std::string_view("*?[]\\{}").find(c) != std::string_view::npos ? "\\" : "";
    escaped += c;
  }
  return escaped;
}

SFrameRate Reduce(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t divisor = std::gcd(numerator, denominator);
  numerator /= divisor;
  denominator /= divisor;
  // off by at most a millionth
  const std::int64_t excess = (std::max(numerator, denominator) - 1) / kMaxTerm + 1;
  if (excess > 1) {
    numerator = std::max<std::int64_t>((numerator + excess / 2) / excess, 1);
    denominator = std::max<std::int64_t>((denominator + excess / 2) / excess, 1);
  }
  return {numerator, denominator};
}

SFrameRate RateOf(double framesPerSecond) {
  return Reduce(std::llround(framesPerSecond * 1000.0), 1000);
}

}  // namespace

std::optional<EFilmFormat> FindFilmFormat(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, EFilmFormat>, 3> kFormats = {
      {{"mp4", EFilmFormat::Mp4}, {"webm", EFilmFormat::Webm}, {"gif", EFilmFormat::Gif}}};
  for (const auto& [known, format] : kFormats) {
    if (name == known) {
      return format;
    }
  }
  return std::nullopt;
}

std::optional<EFilmFormat> FindFilmFormatOfFile(const std::string& file) {
  const std::string extension = StringToLowerCase(std::filesystem::path(file).extension().string());
  return extension.empty() ? std::nullopt : FindFilmFormat(extension.substr(1));
}

std::string SFrameRate::ToText() const {
  return Denominator == 1 ? std::to_string(Numerator)
                          : fmt::format("{}/{}", Numerator, Denominator);
}

SFrameRate ComputeFrameRate(std::uint32_t ticksPerSecond, double speed, std::uint32_t ticks) {
  const std::int64_t steps = std::max<std::int64_t>(std::llround(speed * kSpeedSteps), 1);
  return Reduce(steps * ticksPerSecond, kSpeedSteps * ticks);
}

std::uint32_t ChooseEvery(const SFilmSettings& settings) {
  const double ticks = settings.TicksPerSecond * settings.Speed;  // ticks per second of the film
  // a rounding must not cost a tick
  constexpr double kTolerance = 1e-9;
  const double every = settings.FramesPerSecond
                           ? std::floor(ticks / *settings.FramesPerSecond + kTolerance)
                           : std::ceil(ticks / kSmoothRate - kTolerance);
  return static_cast<std::uint32_t>(std::clamp(every, 1.0, 4e9));
}

SFrameRate ChooseFileRate(const SFilmSettings& settings, const SFrameRate& pictures) {
  if (settings.FramesPerSecond) {
    return RateOf(*settings.FramesPerSecond);
  }
  const double highest = settings.Format == EFilmFormat::Gif ? kHighestGifRate : kHighestRate;
  const double rate = pictures.Get();
  return rate >= kLowestRate && rate <= highest ? pictures
                                                : RateOf(std::clamp(rate, kLowestRate, highest));
}

std::vector<std::string> MakeFilmArguments(const SFilmSettings& settings, const SFrameRate& rate,
                                           int width, int height, const std::string& file) {
  std::vector<std::string> arguments = {"-hide_banner",
                                        "-loglevel",
                                        "error",
                                        "-xerror",
                                        "-y",
                                        "-f",
                                        "rawvideo",
                                        "-pixel_format",
                                        "rgba",
                                        "-video_size",
                                        fmt::format("{}x{}", width, height),
                                        "-framerate",
                                        rate.ToText(),
                                        "-i",
                                        "pipe:0"};
  const std::vector<std::string> output = MakeOutputArguments(settings, rate);
  arguments.insert(arguments.end(), output.begin(), output.end());
  arguments.push_back("file:" + file);  // a name may look like an option or a protocol
  return arguments;
}

std::string MakeFilmCommand(const SFilmSettings& settings, const SFrameRate& rate,
                            const std::string& folder, const std::string& file) {
  std::vector<std::string> words = {
      "ffmpeg",        "-y",   "-framerate", rate.ToText(),
      "-pattern_type", "glob", "-i",         EscapePattern(ToArgument(folder)) + "/frame_*.png"};
  const std::vector<std::string> output = MakeOutputArguments(settings, rate);
  words.insert(words.end(), output.begin(), output.end());
  words.push_back(ToArgument(file));
  std::string command;
  for (const std::string& word : words) {
    command += command.empty() ? "" : " ";
    command += QuoteForShell(word);
  }
  return command;
}

std::string DescribeSpeed(double speed) {
  return speed == 1.0 ? "real time" : fmt::format("{:g}x real time", speed);
}

}  // namespace argos
