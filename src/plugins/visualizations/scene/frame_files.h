#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_FRAME_FILES_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_FRAME_FILES_H

#include <cstdint>
#include <memory>
#include <string>

namespace argos {

class CLockFile;

/** Folder and names of files that are numbered by tick. */
class CFrameFiles {
 public:
  /**
   * @param directory  relative to the working directory; a trailing slash is dropped; "" is ".".
   * @param baseName   begins the names; without a slash.
   * @param create     create the directory (not in a CLoadingCheck); otherwise one that does not
   *                   exist is an error.
   * @throws CARGoSException if the directory does not exist and is not to be created, or cannot be
   *         created; if the base name contains a slash.
   */
  CFrameFiles(const std::string& directory, const std::string& baseName, bool create);

  /** Without a trailing slash. */
  const std::string& GetDirectory() const { return m_directory; }
  const std::string& GetBaseName() const { return m_baseName; }

  /** Directory, base name, tick padded with zeros to 10 digits, a dot, extension. */
  std::string MakeFileName(std::uint32_t tick, const std::string& extension) const;

  /**
   * Keeps other runs from writing frames of the same names, by a hidden file in the directory, and
   * removes partial files of killed runs from it.
   * @return to be kept during the run.
   * @throws CARGoSException if another run writes such frames, naming directory and process.
   */
  std::unique_ptr<CLockFile> Lock() const;

 private:
  void CheckBaseName() const;
  void CheckDirectory(bool create);

  std::string m_directory;
  std::string m_baseName;
};

}  // namespace argos

#endif
