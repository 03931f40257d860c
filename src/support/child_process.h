#ifndef ARGOS3_SUPPORT_CHILD_PROCESS_H
#define ARGOS3_SUPPORT_CHILD_PROCESS_H

#include <argos3/core/utility/non_copyable.h>

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace argos {

/**
 * Finds a program as execvp() does: a name with a slash is a path, others are searched in PATH.
 * @return the path of an executable file; empty if there is none.
 */
std::string FindProgram(const std::string& name);

/** How a child process ended. */
struct SProcessEnd {
  bool IsSuccess = false; /**< exit status 0 */
  std::string Description; /**< "exit status 1", "signal 9 (Killed)" */
};

/** Waits for the end of a child of this process. @return the status of waitpid(). */
int AwaitEnd(pid_t process);
/** What a status of waitpid() says. */
SProcessEnd DescribeEnd(int status);

/** What a program has printed, without line breaks at the end. */
struct SProgramOutput {
  bool IsSuccess = false; /**< exit status 0 */
  std::string Out, Err;
};

/**
 * Runs a program to its end, however long that takes, and captures what it prints. No shell is
 * involved; signals of the terminal reach it.
 * @param arguments  the program, searched as by FindProgram(), and its arguments.
 * @throws CARGoSException naming the program and the system's reason, if it cannot be started.
 */
SProgramOutput RunProgram(const std::vector<std::string>& arguments);

/**
 * Runs another program, and feeds its standard input. No shell is involved.
 *
 * The child has a process group of its own, so that Ctrl-C in a terminal does not reach it; no
 * signal is blocked or ignored in it; no other open file of this process is inherited; its standard
 * output is discarded. If this process ends, however it ends, the child reads the end of its input.
 *
 * A child that ends early is an error of Write(), never a SIGPIPE, and signal handling of this
 * process is not changed. Not thread safe; different objects may be used on different threads.
 */
class CChildProcess : private CNonCopyable {
 public:
  /** Bytes of the standard error that are kept: the last ones. */
  static constexpr std::size_t kErrorTextSize = 2048;

  /**
   * Starts the program.
   * @param arguments  the program, searched as by FindProgram(), and its arguments.
   * @param directory  its working directory; empty: that of this process.
   * @throws CARGoSException naming the program and the system's reason, if it cannot be started.
   */
  explicit CChildProcess(const std::vector<std::string>& arguments,
                         const std::string& directory = std::string());
  /** Kills a child that Finish() was not called for, and waits for its end. */
  ~CChildProcess();

  /**
   * Writes to the standard input of the child. Waits until the child has read most of it: the
   * system buffers some 100 kB. A child that neither reads nor computes for as long as
   * GetOutputTimeout() says is killed.
   * @return false if the child does not read any more; Finish() tells why.
   */
  [[nodiscard]] bool Write(const void* data, std::size_t size);

  /**
   * Closes the standard input, and waits for the end of the child, which is killed if it does
   * nothing for as long as GetOutputTimeout() says. Repeated: the same result.
   */
  SProcessEnd Finish();

  /** Ends the child and the processes that it has started at once (SIGKILL); Finish() describes it.
   */
  void Kill();

  /**
   * The last lines that the child has written to its standard error, complete after Finish(); at
   * most kErrorTextSize bytes, without blanks at the end.
   */
  std::string GetErrorText() const;

  pid_t GetId() const { return m_id; }

 private:
  void Start(const std::vector<std::string>& arguments, const std::string& directory, int input,
             int errors);
  // reads what is there. @return false at the end
  bool ReadErrors();
  void ReadErrorsUntilEnd();
  bool HasEnded() const;
  // kills the child if it has done nothing for too long
  void CheckProgress();
  void NoteProgress();

  pid_t m_id = -1;
  bool m_isRunning = false;  // it was not waited for
  int m_input = -1;  // our end of a socket pair
  int m_errors = -1;  // our end of a pipe
  std::string m_errorText;  // is at most twice as long as what is kept
  bool m_isErrorTextCut = false;
  SProcessEnd m_end;

  // time since the last progress that was noticed
  std::chrono::steady_clock::time_point m_idleStart;
  std::chrono::steady_clock::time_point m_lastCheck;
  std::chrono::milliseconds m_idleStartCPU{0};  // time used by the child until then
  bool m_hasHung = false;  // the child was hung and killed
};

}  // namespace argos

#endif
