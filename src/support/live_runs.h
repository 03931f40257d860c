#ifndef ARGOS3_SUPPORT_LIVE_RUNS_H
#define ARGOS3_SUPPORT_LIVE_RUNS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <string>
#include <vector>

namespace argos {

/** A run that can be watched in a browser. */
struct SLiveRunEntry {
  std::string URL; /**< with its secret */
  std::string Experiment; /**< path of its file; may be empty */
  UInt32 Seed = 0;
  UInt64 Process = 0;
  std::string File; /**< that says so */
};

/**
 * A file with the URL of a run, which only the user can read, during the lifetime of this object.
 * It is locked, so a file whose run was killed is recognized.
 */
class CLiveRunFile : private CNonCopyable {
 public:
  /**
   * @param path   "auto": a new file in the folder that ListLiveRuns() searches.
   * @param entry  without its file.
   * @throws CARGoSException if it cannot be written, or exists.
   */
  CLiveRunFile(const std::string& path, const SLiveRunEntry& entry);
  /** Removes it. */
  ~CLiveRunFile();

  const std::string& GetPath() const { return m_path; }

 private:
  std::string m_path;
  int m_file = -1;
};

/**
 * Runs of this user, on this computer, whose files are in the common folder: `argos3-live` in
 * $XDG_RUNTIME_DIR, or `argos3-live-UID` in the folder for temporary files. Removes files of runs
 * that were killed. In the order of experiments, seeds and processes.
 */
std::vector<SLiveRunEntry> ListLiveRuns();

/** Shows a URL in the user's browser, if there is a display. @return false if there is none. */
bool OpenInBrowser(const std::string& url);

}  // namespace argos

#endif
