#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_WRITER_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_WRITER_H

#include <argos3/core/simulator/images/image_file.h>
#include <argos3/plugins/simulator/visualizations/offscreen/picture_sink.h>
#include <argos3/plugins/simulator/visualizations/scene/frame_files.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace argos {

class CLockFile;

/** Folder, names and format of the files of frames. */
struct SFrameFileSettings {
  std::string Directory =
      "."; /**< relative to the working directory; a trailing slash is dropped */
  std::string BaseName = "frame_"; /**< has no slash */
  std::string Format =
      "png"; /**< any that FreeImage writes 24-bit pictures in: png, jpg, bmp, ... */
  int Quality = -1; /**< 0 (smallest file) to 100 (best, or least packed); -1 = the format's own */
  bool CreateDirectory = true; /**< if false, a directory that does not exist is an error */
};

/**
 * Writes pictures to files that are numbered by tick.
 *
 * A file appears under its name only when it is complete: it is written under a temporary name in
 * the same directory, and renamed.
 */
class CFrameWriter : public CPictureSink {
 public:
  /**
   * Checks the settings and creates the directory if asked to.
   * @throws CARGoSException if the directory does not exist and is not to be created, or cannot be
   *         created; if the format is unknown (listing those there are); if the quality is out of
   *         range; if the base name contains a slash.
   */
  explicit CFrameWriter(const SFrameFileSettings& settings);
  ~CFrameWriter() override;

  /** Locks the frames until Finish(). @throws CARGoSException as LockFrames(). */
  void Begin() override;

  /** Directory, base name, tick padded with zeros to 10 digits, a dot, format. */
  std::string MakeFileName(std::uint32_t tick) const;

  /**
   * Writes one frame; replaces one of the same tick.
   * @throws CARGoSException naming the file, if it cannot be written; no part of it stays behind.
   */
  void Write(const SPicture& picture, std::uint32_t tick) override;
  void Finish() override;
  std::string Describe(int width, int height, std::uint32_t every) const override;

  /**
   * Keeps other runs from writing frames of the same names, by a hidden file in the directory, and
   * removes partial files of killed runs from it.
   * @return to be kept during the run.
   * @throws CARGoSException if another run writes such frames, naming directory and process.
   */
  std::unique_ptr<CLockFile> LockFrames() const;

 private:
  void CheckFormat();
  void CheckQuality();

  SFrameFileSettings m_settings;
  std::optional<CFrameFiles> m_files;  // set by the constructor
  SImageFormat m_format;
  std::unique_ptr<CLockFile> m_lock;  // held during a run
};

}  // namespace argos

#endif
