#ifndef ARGOS3_CORE_UTILITY_LOGGING_ARGOS_LOG_H
#define ARGOS3_CORE_UTILITY_LOGGING_ARGOS_LOG_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_colored_text.h>
#include <argos3/core/utility/non_copyable.h>

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * A log: messages are collected per thread and reach the stream on Flush().
 *
 * Any thread may log at any time. To make a log file independent of the number of threads, each
 * message carries the key that its thread set with SetSequence(), and Flush() writes messages in
 * the order of their keys; messages with the same key keep the order in which they were logged.
 * With coloured output, each item is wrapped in the log's colour and a reset.
 *
 * Logging nothing costs nothing: a thread's buffer is created by its first message.
 */
class CARGoSLog {
 public:
  /**
   * @param stream   target of Flush(); must outlive the log.
   * @param colored  true: wrap each item in the colour.
   */
  CARGoSLog(std::ostream& stream, const SLogColor& color, bool colored = true);
  CARGoSLog(const CARGoSLog&) = delete;
  CARGoSLog& operator=(const CARGoSLog&) = delete;

  /** Flushes, and restores the buffer of a redirected stream. */
  ~CARGoSLog();

  void EnableColoredOutput() { m_colored = true; }
  void DisableColoredOutput() { m_colored = false; }
  bool IsColoredOutput() const { return m_colored; }

  /** The target of Flush(); its rdbuf() may be replaced. */
  std::ostream& GetStream() { return m_stream; }

  /**
   * Redirects the stream, including other writers, to a file, which is truncated. Switches colours
   * off.
   * @throws CARGoSException if the file cannot be written; the text gives its name and the reason.
   */
  void RedirectToFile(const std::string& name);

  /** Flushes, closes the file of RedirectToFile() and restores the stream. */
  void EndRedirection();
  bool IsRedirected() const;

  /**
   * Writes the messages of all threads since the last call, and flushes the stream.
   *
   * Throws nothing if the stream cannot be written, for example because a disk is full: see
   * HasFailed().
   */
  void Flush();

  /** @return true if output was lost. */
  bool HasFailed() const;

  /** @return which output could not be written and why, once; empty if none, or none since. */
  std::string TakeFailure();

  /**
   * Writes what has not been flushed to a file descriptor, for the report of a crash: in no order,
   * and without the messages of threads that are logging. May be called in a signal handler.
   */
  void WriteAfterCrash(int file) noexcept;

  /**
   * Creates the calling thread's buffer now instead of at its first message. Optional.
   */
  void AddThreadSafeBuffer();

  /**
   * Sets the sort key of the calling thread's next messages, for all logs.
   *
   * A thread starts with key 0. Between two flushes, messages with the same key from different
   * threads must be ordered by other means (such as a barrier between two phases); otherwise their
   * order depends on the scheduling of the threads.
   */
  static void SetSequence(UInt64 key);
  static UInt64 GetSequence();

  /** std::endl and other manipulators, red and reset among them. */
  CARGoSLog& operator<<(std::ostream& (*manipulator)(std::ostream&));

  /** Anything that can be printed to a std::ostream. */
  template <typename T>
  CARGoSLog& operator<<(const T msg) {
    CEntry entry(*this, m_colored);
    entry.Stream() << msg;
    return *this;
  }

  /** Readings of sensors that are numbers: `{ 0.5 } { 0 }` and an end of line. */
  CARGoSLog& operator<<(const std::vector<Real>& readings);

 private:
  struct SThreadBuffer;
  struct SState;

  /** One item that is being written to the calling thread's buffer, which is locked meanwhile. */
  class CEntry : private CNonCopyable {
   public:
    CEntry(CARGoSLog& log, bool colored);
    ~CEntry();
    std::ostream& Stream();

   private:
    SThreadBuffer& m_buffer;
    std::size_t m_start = 0;
    std::size_t m_prefixLength = 0;
  };

  SThreadBuffer& GetThreadBuffer();
  void NoteFailure(int error);

  std::ostream& m_stream;
  SLogColor m_color;
  bool m_colored;
  std::unique_ptr<SState> m_state;
};

/** The standard log: std::cout, bright green. */
extern CARGoSLog LOG;

/** The error log: std::cerr, bright red. */
extern CARGoSLog LOGERR;

/** Indentation of the next DEBUG() line, in columns. */
extern std::size_t DEBUG_INDENTATION;

/** Implements DEBUG(): printf to the standard error, indented by DEBUG_INDENTATION blanks. */
void DebugPrint(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace argos

/** LOG and LOGERR, prefixed with the id of the robot whose controller logs. */
#define RLOG argos::LOG << "[" << GetId() << "] "
#define RLOGERR argos::LOGERR << "[" << GetId() << "] "

/** printf to the standard error, indented. */
#define DEBUG(...) argos::DebugPrint(__VA_ARGS__)

/** Prints the function's name when it is entered and left; the output in between is indented. */
#define DEBUG_FUNCTION_ENTER                  \
  DEBUG("%s - START\n", __PRETTY_FUNCTION__); \
  ++argos::DEBUG_INDENTATION
#define DEBUG_FUNCTION_EXIT   \
  --argos::DEBUG_INDENTATION; \
  DEBUG("%s - END\n", __PRETTY_FUNCTION__)

/** Prints a line of code, then executes it. */
#define TRACE(line)     \
  DEBUG("%s\n", #line); \
  line

#endif
