#ifndef ARGOS3_SUPPORT_SCRATCH_FOLDER_H
#define ARGOS3_SUPPORT_SCRATCH_FOLDER_H

#include <argos3/core/utility/non_copyable.h>

#include <filesystem>
#include <string>

namespace argos {

/** A new folder in that of the system for temporary files; removed with all that is in it. */
class CScratchFolder : private CNonCopyable {
 public:
  /**
   * @param prefix  of its name.
   * @throws CARGoSException if it cannot be created.
   */
  explicit CScratchFolder(const std::string& prefix);
  ~CScratchFolder();

  const std::filesystem::path& GetPath() const { return m_path; }

 private:
  std::filesystem::path m_path;
};

}  // namespace argos

#endif
