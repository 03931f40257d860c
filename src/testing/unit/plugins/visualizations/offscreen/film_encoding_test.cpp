#include <argos3/support/numbered_file.h>
#include <argos3/plugins/simulator/visualizations/offscreen/film_encoding.h>

#include <catch2/catch.hpp>

#include <algorithm>

namespace film_encoding_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

std::string RateText(std::uint32_t ticksPerSecond, double speed, std::uint32_t ticks) {
  return ComputeFrameRate(ticksPerSecond, speed, ticks).ToText();
}

SFilmSettings Film(std::uint32_t ticksPerSecond, double speed) {
  SFilmSettings settings;
  settings.TicksPerSecond = ticksPerSecond;
  settings.Speed = speed;
  return settings;
}

std::string FileRate(EFilmFormat format, const SFrameRate& rate) {
  SFilmSettings settings;
  settings.Format = format;
  return ChooseFileRate(settings, rate).ToText();
}

}  // namespace

TEST_CASE("film encoding: the frame rate is speed * ticks per second / every, exactly",
          "[visualizations][offscreen][films]") {
  CHECK(RateText(10, 1.0, 1) == "10");
  CHECK(RateText(10, 1.0, 3) == "10/3");
  CHECK(RateText(10, 2.5, 1) == "25");
  CHECK(RateText(32, 1.0, 2) == "16");
  CHECK(RateText(10, 0.1, 1) == "1");
  CHECK(RateText(10, 0.0001, 1) == "1/1000");
  CHECK(RateText(100, 10000.0, 1) == "1000000");
  // terms above a million are rounded
  const SFrameRate rate = ComputeFrameRate(4000000000u, 9999.9999, 3);
  CHECK(rate.Numerator <= 1000000);
  CHECK(rate.Denominator >= 1);
  // a quarter of both, rounded
  CHECK(RateText(3000002u, 1.0, 2000005u) == "750001/500001");
  CHECK(RateText(4000000u, 1.0, 3000001u) == "1000000/750000");
  // 999,999.7 and 999,999.6 of sevenths
  CHECK(RateText(6999998u, 1.0, 6999997u) == "1000000/1000000");
  // 10^-4 of a tick a second, a picture in 3 * 10^9 ticks: the denominator is rounded as well
  CHECK(RateText(1, 0.0001, 3000000000u) == "1/1000000");
}

TEST_CASE("film encoding: at most 30 frames a second are drawn without a wish",
          "[visualizations][offscreen][films]") {
  CHECK(ChooseEvery(Film(10, 1.0)) == 1);
  CHECK(ChooseEvery(Film(10, 3.0)) == 1);
  CHECK(ChooseEvery(Film(10, 3.1)) == 2);
  CHECK(ChooseEvery(Film(100, 1.0)) == 4);
  CHECK(ChooseEvery(Film(10, 0.1)) == 1);
  // at least every tick, at most every 4 * 10^9
  SFilmSettings rare = Film(1000000000u, 10000.0);
  rare.FramesPerSecond = 1.0;
  CHECK(ChooseEvery(rare) == 4000000000u);
  SFilmSettings slow = Film(1, 0.1);
  slow.FramesPerSecond = 60.0;
  CHECK(ChooseEvery(slow) == 1);
  SFilmSettings settings = Film(100, 1.0);
  settings.FramesPerSecond = 25.0;
  CHECK(ChooseEvery(settings) == 4);
  settings.FramesPerSecond = 60.0;
  CHECK(ChooseEvery(settings) == 1);
}

TEST_CASE("film encoding: files have from 1 to 60 frames a second, GIFs up to 30",
          "[visualizations][offscreen][films]") {
  CHECK(FileRate(EFilmFormat::Mp4, {10, 3}) == "10/3");
  CHECK(FileRate(EFilmFormat::Mp4, {60, 1}) == "60");
  CHECK(FileRate(EFilmFormat::Mp4, {1000, 1}) == "60");
  CHECK(FileRate(EFilmFormat::Webm, {1, 5}) == "1");
  CHECK(FileRate(EFilmFormat::Gif, {60, 1}) == "30");
  SFilmSettings settings;
  settings.FramesPerSecond = 29.97;
  CHECK(ChooseFileRate(settings, {10, 1}).ToText() == "2997/100");
}

TEST_CASE("film encoding: the extension of a file is its format",
          "[visualizations][offscreen][films]") {
  CHECK(FindFilmFormatOfFile("out/a.mp4") == EFilmFormat::Mp4);
  CHECK(FindFilmFormatOfFile("a.WebM") == EFilmFormat::Webm);
  CHECK(FindFilmFormatOfFile("a.b.gif") == EFilmFormat::Gif);
  CHECK_FALSE(FindFilmFormatOfFile("a.avi"));
  CHECK_FALSE(FindFilmFormatOfFile("mp4"));
  CHECK_FALSE(FindFilmFormatOfFile("a.mp4/b"));
  CHECK_FALSE(FindFilmFormatOfFile(""));
}

TEST_CASE("film encoding: ffmpeg repeats or drops pictures only if the rates differ",
          "[visualizations][offscreen][films]") {
  const SFilmSettings settings;
  const auto filters = [&settings](const SFrameRate& rate) {
    const std::vector<std::string> words = MakeFilmArguments(settings, rate, 640, 480, "f.mp4");
    return *(std::find(words.begin(), words.end(), "-vf") + 1);
  };
  CHECK_THAT(filters({10, 1}), !Contains("fps="));
  CHECK_THAT(filters({1000, 1}), Contains("fps=60,"));
}

TEST_CASE("film encoding: films have the colours of HD video, GIFs a palette for each frame",
          "[visualizations][offscreen][films]") {
  for (const EFilmFormat format : {EFilmFormat::Mp4, EFilmFormat::Webm, EFilmFormat::Gif}) {
    SFilmSettings settings;
    settings.Format = format;
    const bool isGif = format == EFilmFormat::Gif;
    bool hasVideoColors = false;
    bool hasPalette = false;
    for (const std::string& word : MakeFilmArguments(settings, {25, 1}, 640, 480, "f")) {
      hasVideoColors = hasVideoColors || word.find("out_color_matrix=bt709") != std::string::npos;
      hasPalette = hasPalette || word.find("palettegen") != std::string::npos;
    }
    CHECK(hasVideoColors == !isGif);
    CHECK(hasPalette == isGif);
  }
}

TEST_CASE("film encoding: the command for a shell quotes what a shell would change",
          "[visualizations][offscreen][films]") {
  const std::string command =
      MakeFilmCommand(SFilmSettings(), {25, 2}, "it's [1].frames", "it's.mp4");
  CHECK_THAT(command, Contains("-framerate 25/2 -pattern_type glob "
                               "-i 'it'\\''s \\[1\\].frames/frame_*.png' ") &&
                          Catch::EndsWith(" 'it'\\''s.mp4'"));
}

TEST_CASE("film encoding: files of further runs are numbered",
          "[visualizations][offscreen][films]") {
  CHECK(NumberFile("out/film.mp4", 1) == "out/film.mp4");
  CHECK(NumberFile("out/film.mp4", 2) == "out/film.2.mp4");
  CHECK(NumberFile("film", 12) == "film.12");
}

}  // namespace film_encoding_test
