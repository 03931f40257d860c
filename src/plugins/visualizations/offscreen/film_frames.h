#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FILM_FRAMES_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FILM_FRAMES_H

#include <argos3/plugins/simulator/visualizations/offscreen/film_encoding.h>
#include <argos3/plugins/simulator/visualizations/offscreen/picture_sink.h>

#include <memory>
#include <optional>
#include <string>

namespace argos {

class CFrameWriter;

/**
 * Writes the frames of films as PNG files where there is no ffmpeg: into a folder `film.mp4.frames`
 * for each run, from which it removes frames of earlier runs. Prints the command that makes the
 * film of them.
 */
class CFilmFrames : public CPictureSink {
 public:
  /** @throws CARGoSException as PrepareFilmFile(). */
  explicit CFilmFrames(const SFilmSettings& settings);
  ~CFilmFrames() override;

  void Begin() override;
  void Write(const SPicture& picture, std::uint32_t tick) override;
  void Finish() override;
  std::string Describe(int width, int height, std::uint32_t every) const override;

 private:
  std::string MakeFolder() const;

  SFilmSettings m_settings;
  int m_run = 0;
  std::string m_file;  // path of the film of this run
  std::unique_ptr<CFrameWriter> m_writer;
  std::optional<std::uint32_t> m_firstTick;
  std::optional<std::uint32_t> m_ticks;  // number of ticks from frame to frame
};

}  // namespace argos

#endif
