#ifndef ARGOS3_CORE_UTILITY_LOGGING_ARGOS_LOG_H
#define ARGOS3_CORE_UTILITY_LOGGING_ARGOS_LOG_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/logging/argos_colored_text.h>

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

namespace argos {

/**
 * A log: messages are collected per thread and reach the stream on Flush().
 *
 * Any thread may log at any time. So that a log file does not depend on the number of threads, each
 * message carries the key its thread had set with SetSequence(), and Flush() writes the messages in
 * the order of their keys; messages of one key come in the order in which they were logged. With
 * coloured output on, every item is wrapped in the log's colour and a reset.
 *
 * A statement that logs nothing costs nothing: buffers are made when a thread logs first.
 */
class CARGoSLog {
 public:
  /**
   * @param stream   where Flush() writes; must outlive the log.
   * @param colored  wrap every item in the colour?
   */
  CARGoSLog(std::ostream& stream, const SLogColor& color, bool colored = true);
  CARGoSLog(const CARGoSLog&) = delete;
  CARGoSLog& operator=(const CARGoSLog&) = delete;

  /** Flushes, and gives a redirected stream its own buffer back. */
  ~CARGoSLog();

  void EnableColoredOutput() { m_colored = true; }
  void DisableColoredOutput() { m_colored = false; }
  bool IsColoredOutput() const { return m_colored; }

  /** The stream that Flush() writes to; its rdbuf() may be replaced. */
  std::ostream& GetStream() { return m_stream; }

  /**
   * Sends the stream, and what else is written to it, to a file, which is truncated. Colours are
   * switched off.
   * @throws CARGoSException if the file cannot be written; the text gives its name and the reason.
   */
  void RedirectToFile(const std::string& name);

  /** Writes what all threads have logged since the last call, and flushes the stream. */
  void Flush();

  /**
   * Makes the calling thread's buffer now rather than at its first message.
   * Calling it is never needed, calling it again does nothing.
   */
  void AddThreadSafeBuffer();

  /**
   * Sets the place of the calling thread's next messages in the order of Flush(), for all logs.
   *
   * A thread starts with key 0. Between two flushes, messages of the same key that come from
   * different threads must be ordered by something else (such as a barrier between two phases),
   * otherwise their order is that in which the threads happened to run.
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

 private:
  struct SThreadBuffer;
  struct SState;

  /** One item on its way into the calling thread's buffer, which it locks meanwhile. */
  class CEntry {
   public:
    CEntry(CARGoSLog& log, bool colored);
    ~CEntry();
    CEntry(const CEntry&) = delete;
    CEntry& operator=(const CEntry&) = delete;
    std::ostream& Stream();

   private:
    SThreadBuffer& m_buffer;
    std::size_t m_start = 0;
    std::size_t m_prefixLength = 0;
  };

  SThreadBuffer& GetThreadBuffer();

  std::ostream& m_stream;
  SLogColor m_color;
  bool m_colored;
  std::unique_ptr<SState> m_state;
};

/** The standard log: std::cout, bright green. */
extern CARGoSLog LOG;

/** The error log: std::cerr, bright red. */
extern CARGoSLog LOGERR;

/** Columns by which the next DEBUG() line is indented. */
extern std::size_t DEBUG_INDENTATION;

/** What DEBUG() expands to: printf to the standard error, indented by DEBUG_INDENTATION blanks. */
void DebugPrint(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace argos

/** LOG and LOGERR, prefixed with the id of the robot whose controller logs. */
#define RLOG argos::LOG << "[" << GetId() << "] "
#define RLOGERR argos::LOGERR << "[" << GetId() << "] "

/** printf to the standard error, indented. */
#define DEBUG(...) argos::DebugPrint(__VA_ARGS__)

/** Print the function's name when it is entered and left; what is between is indented. */
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
