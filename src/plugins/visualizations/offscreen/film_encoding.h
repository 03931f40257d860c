#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FILM_ENCODING_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FILM_ENCODING_H

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace argos {

enum class EFilmFormat { Mp4, Webm, Gif };

/** The formats of films, for messages. */
constexpr char kFilmExtensions[] = ".mp4, .webm or .gif";

/** @param name  "mp4", "webm" or "gif", in lower case. */
std::optional<EFilmFormat> FindFilmFormat(std::string_view name);
/** The format that the extension of a file name stands for, in any case of letters. */
std::optional<EFilmFormat> FindFilmFormatOfFile(const std::string& file);

/** Frames per second, a ratio, so that the duration of a film is exact. */
struct SFrameRate {
  std::int64_t Numerator = 1;
  std::int64_t Denominator = 1; /**< > 0 */

  double Get() const { return static_cast<double>(Numerator) / static_cast<double>(Denominator); }
  /** As ffmpeg reads it, "25" or "100/3". */
  std::string ToText() const;
};

/** File, format and speed of a film. */
struct SFilmSettings {
  std::string File = "out/film.mp4"; /**< relative to the working directory */
  EFilmFormat Format = EFilmFormat::Mp4;
  int Quality = -1; /**< 0 (smallest file) to 100 (best); -1 = the format's own */
  double Speed = 1.0; /**< simulated seconds per second of the film, a multiple of 0.0001, > 0 */
  std::optional<double> FramesPerSecond; /**< rate of the file; none: ChooseFileRate() chooses */
  std::uint32_t TicksPerSecond = 10; /**< rate of the simulation, > 0 */
  std::uint32_t Every = 1; /**< ticks from frame to frame, > 0 */
  bool IsInParts = false; /**< parts of a run are shown one after the other, without what is between
                             them */
};

/**
 * speed * ticksPerSecond / ticks, as a reduced ratio of numbers up to a million.
 * @param ticks  from frame to frame, > 0.
 */
SFrameRate ComputeFrameRate(std::uint32_t ticksPerSecond, double speed, std::uint32_t ticks);

/**
 * The number of ticks from frame to frame of a film that does not give it: the smallest one for
 * which the film has at most 30 frames a second; if FramesPerSecond is given, the largest one for
 * which it has at least as many.
 */
std::uint32_t ChooseEvery(const SFilmSettings& settings);

/**
 * The frame rate of the file: that of the pictures, unless this is outside of what players show
 * well, from 1 to 60 a second (30 in a GIF). Then the encoder repeats or leaves out pictures, and
 * the duration stays the same.
 */
SFrameRate ChooseFileRate(const SFilmSettings& settings, const SFrameRate& pictures);

/**
 * The arguments of ffmpeg for a film of pictures in memory, which it reads from its standard input.
 * @param rate  of the pictures. @param file  to be written or replaced, whatever its extension.
 */
std::vector<std::string> MakeFilmArguments(const SFilmSettings& settings, const SFrameRate& rate,
                                           int width, int height, const std::string& file);

/** A command for a shell that makes the film of the PNG files in a folder, in the order of names.
 */
std::string MakeFilmCommand(const SFilmSettings& settings, const SFrameRate& rate,
                            const std::string& folder, const std::string& file);

/** "real time", "2x real time". */
std::string DescribeSpeed(double speed);

}  // namespace argos

#endif
