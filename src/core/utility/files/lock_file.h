#ifndef ARGOS3_CORE_UTILITY_FILES_LOCK_FILE_H
#define ARGOS3_CORE_UTILITY_FILES_LOCK_FILE_H

#include <argos3/core/utility/non_copyable.h>

#include <sys/types.h>

#include <string>

namespace argos {

/**
 * Keeps other simulations, of this process and of others, from using a place during its lifetime:
 * an empty file with a lock of the system (flock).
 *
 * The system releases the lock when the process ends, however it ends. So a file that a killed
 * process has left locks nothing. The destructor removes the file. A file system without locks
 * gives no protection.
 */
class CLockFile : private CNonCopyable {
 public:
  /**
   * @param path  created if it does not exist.
   * @throws CARGoSException if the file cannot be created, or is locked; the text names the
   *   process that has locked it.
   */
  explicit CLockFile(const std::string& path);
  ~CLockFile();

 private:
  void WriteProcess() const;

  std::string m_path;
  int m_file = -1;
  pid_t m_owner;  // a forked process has a copy of this object, but not the lock's ownership
};

/**
 * Locks an open file against other openings of it, of this process and of others, until it is
 * closed.
 * @param wait  true: wait until it is unlocked.
 * @return false if it is locked, and @p wait is false. True also on file systems without locks.
 */
bool TryToLock(int file, bool wait = false);

/** @return true if @p path leads to the open file: not if it was removed or renamed. */
bool LeadsTo(const std::string& path, int file);

/** Names the process that has locked a file: "process 123", "this process", "another process". */
std::string DescribeLockHolder(int file);

}  // namespace argos

#endif
