#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FILM_WRITER_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FILM_WRITER_H

#include <argos3/plugins/simulator/visualizations/offscreen/film_encoding.h>
#include <argos3/plugins/simulator/visualizations/offscreen/picture_sink.h>

#include <memory>
#include <optional>
#include <string>

namespace argos {

class CChildProcess;
class CPartFile;

/** The path of ffmpeg: of the environment variable ARGOS_FFMPEG, or in PATH; empty: not found. */
std::string FindFfmpeg();

/**
 * Checks the path of a film, and creates its folder, but not in a CLoadingCheck.
 * @throws CARGoSException if the folder cannot be created or written, or if the path leads to
 * something that is no file.
 */
void PrepareFilmFile(const std::string& file);

/**
 * Writes films with ffmpeg, to which pictures go through a pipe: one film for each run, `film.mp4`,
 * `film.2.mp4`, ...
 *
 * A film appears under its name only when it is complete: it is written under a temporary name in
 * the same folder, which kPartSuffix ends, and renamed. If this process is killed, ffmpeg completes
 * the film under the temporary name.
 *
 * Pictures have the same distance in ticks, which the first two of a run tell.
 */
class CFilmWriter : public CPictureSink {
 public:
  /** @param ffmpeg  path of the program. @throws CARGoSException as PrepareFilmFile(). */
  CFilmWriter(const SFilmSettings& settings, const std::string& ffmpeg);
  ~CFilmWriter() override;

  void Begin() override;
  void Write(const SPicture& picture, std::uint32_t tick) override;
  void Finish() override;
  std::string Describe(int width, int height, std::uint32_t every) const override;

 private:
  void StartEncoder(std::uint32_t ticks);
  void Encode(const SPicture& picture);
  [[noreturn]] void ThrowFailure();
  void DropFilm();

  SFilmSettings m_settings;
  std::string m_ffmpeg;
  int m_run = 0;
  std::string m_file;  // path of the film of this run
  std::unique_ptr<CPartFile> m_part;  // null: no run has begun, or it has failed
  SPicture m_first;  // kept until the second one tells the frame rate
  std::optional<std::uint32_t> m_firstTick;
  SFrameRate m_rate;
  std::uint64_t m_numPictures = 0;
  std::unique_ptr<CChildProcess> m_encoder;
};

}  // namespace argos

#endif
