#ifndef ARGOS3_CORE_UTILITY_FILES_OUTPUT_FILE_H
#define ARGOS3_CORE_UTILITY_FILES_OUTPUT_FILE_H

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace argos {

/**
 * A text file that grows during a run, such as a table of results: an output stream whose failures
 * are exceptions.
 *
 * `file << x` throws if the file cannot be written, for example because the disk is full. The
 * exception names the file and the system's reason; thrown by loop functions it ends the run.
 * Buffered text is written in whole lines, and after a failure the file is cut behind its last
 * whole line, so that it can be read at any time, also if the process is killed. std::flush writes
 * the start of a line, too.
 *
 * While a regular file is open, other COutputFiles of this and of other processes cannot open it.
 */
class COutputFile : public std::ostream {
 public:
  enum class EStart {
    Truncate, /**< an existing file becomes empty; an error if another COutputFile has it open */
    Append /**< waits until no other COutputFile has it open */
  };

  /** Closed. */
  COutputFile();
  /** Opens a file. */
  explicit COutputFile(const std::string& path, EStart start = EStart::Truncate);
  /**
   * Closes. A failure cannot be thrown, and is stored for TakeOutputFailures(): call Close()
   * before.
   */
  ~COutputFile() override;
  COutputFile(const COutputFile&) = delete;
  COutputFile& operator=(const COutputFile&) = delete;

  /**
   * Closes the file that is open, and opens another one.
   * @throws CARGoSException with the file's name and the reason.
   */
  void Open(const std::string& path, EStart start = EStart::Truncate);

  /**
   * Writes what is buffered, and then a record: text that consists of whole lines, or any bytes. If
   * that fails, nothing of the record stays in the file.
   * @throws CARGoSException with the file's name and the reason.
   */
  void WriteRecord(std::string_view record);

  /** Absolute path of the file, to which links lead; of the last one if none is open. */
  const std::string& GetTarget() const;
  /** @return true if the file is a regular one, whose content can be replaced. */
  bool CanReplace() const;
  /**
   * Replaces what was written by a text of whole lines, or any bytes: a reader finds either of
   * them. Drops what is buffered.
   * @throws CARGoSException with the file's name and the reason; the file is then as it was.
   */
  void Replace(std::string_view content);

  /**
   * Writes what is buffered, and closes the file. Does nothing if none is open.
   * @throws CARGoSException if not all could be written. Silent if that was thrown before.
   */
  void Close();

  bool IsOpen() const;
  /** In bytes, with what is buffered. 0 if no file is open. */
  std::uint64_t GetSize() const;
  /** The text of the first failure since Open(); empty if there was none. */
  const std::string& GetFailure() const;
  /** The same without the name of the file. */
  const std::string& GetReason() const;

 private:
  class CBuffer;
  std::unique_ptr<CBuffer> m_buffer;
};

/** @return what destructors of COutputFile could not throw since the last call. Thread safe. */
std::vector<std::string> TakeOutputFailures();

}  // namespace argos

#endif
