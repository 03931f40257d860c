#ifndef ARGOS3_CAMPAIGN_STORE_STORE_LOCK_H
#define ARGOS3_CAMPAIGN_STORE_STORE_LOCK_H

#include <argos3/core/utility/non_copyable.h>

#include <string>

namespace argos {

/**
 * Keeps other programs from writing the same results: a lock of the system (fcntl) on a file that
 * contains the host and the process.
 *
 * Unlike a CLockFile, whose flock() the worker processes would inherit, the lock ends with the
 * process that has taken it, however that ends. A file system without locks gives no protection.
 */
class CStoreLock : private CNonCopyable {
 public:
  /** @throws CARGoSException if another object or process has it, with host and process. */
  explicit CStoreLock(const std::string& resultsFile);
  /** Removes the file. */
  ~CStoreLock();

 private:
  std::string m_path;
  int m_file = -1;
};

}  // namespace argos

#endif
