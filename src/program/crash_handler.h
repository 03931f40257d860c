#ifndef ARGOS3_PROGRAM_CRASH_HANDLER_H
#define ARGOS3_PROGRAM_CRASH_HANDLER_H

#include <string>

namespace argos {

/**
 * Reports a crash: on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT it prints, on the standard error
 * and in the error log's file, which robot, controller, call and tick were running and the stack,
 * writes what the logs and the C streams have not written yet, and lets the process die of the same
 * signal: the shell and core files see no difference.
 *
 * Runs on a stack of its own in each thread of the simulator, so that it also reports a stack that
 * has overflowed. A step that hangs, because the crash has left a lock locked, is given up after
 * some seconds. The program argos3 installs it unless `--no-crash-handler` is given; other programs
 * may.
 */
class CCrashHandler {
 public:
  /**
   * Installs the handler for those of the signals that have their default action: a handler of the
   * user or of a sanitizer is kept. Call it once, before an experiment is loaded.
   */
  static void Install();
  /**
   * Names the files to which the logs have been redirected; empty: the standard output and error.
   */
  static void SetLogFiles(const std::string& log, const std::string& logErr);
};

}  // namespace argos

#endif
