#ifndef ARGOS3_TESTING_SCENARIO_COMMAND_LINE_PROGRAM_RUN_H
#define ARGOS3_TESTING_SCENARIO_COMMAND_LINE_PROGRAM_RUN_H

#include <argos3/testing/support/temporary_folder.h>

#include <string>
#include <vector>

namespace argos {

/** The result of running a program. */
struct SProgramRun {
  int Status = -1; /**< exit status; 128 + number if a signal killed it */
  std::string Out; /**< standard output */
  std::string Err; /**< standard error, without the lines of Notices */
  std::string Notices; /**< lines of the standard error about the run: "[INFO] ..." */
};

/** Sets Err and Notices. */
void SplitStandardError(const std::string& text, SProgramRun& run);

/** A temporary folder in which programs run. */
class CTestFolder : public CTemporaryFolder {
 public:
  /**
   * Runs argos3 in this folder and waits for its end.
   * @param signal  if not 0, sent once as soon as @p trigger was printed.
   */
  SProgramRun Run(const std::vector<std::string>& arguments, int signal = 0,
                  const std::string& trigger = "") const;
  /** Runs another program of this build. @param name  such as "argos3_benchmark". */
  SProgramRun RunProgram(const std::string& name, const std::vector<std::string>& arguments,
                         int signal = 0, const std::string& trigger = "") const;
  /**
   * Runs argos3 in this folder with a terminal of so many columns as output and standard error,
   * and interrupts it (SIGINT) as soon as @p trigger was printed.
   * @param kind  for TERM.
   * @return what was printed.
   */
  std::string RunOnTerminal(const std::vector<std::string>& arguments, unsigned short columns,
                            const std::string& trigger, const std::string& kind = "xterm") const;
};

}  // namespace argos

#endif
