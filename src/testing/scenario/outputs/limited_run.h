#ifndef ARGOS3_TESTING_SCENARIO_OUTPUTS_LIMITED_RUN_H
#define ARGOS3_TESTING_SCENARIO_OUTPUTS_LIMITED_RUN_H

#include "../command_line/program_run.h"

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace argos {

/** The circumstances of a run of argos3. */
struct SCircumstances {
  std::vector<std::string> Environment; /**< NAME=VALUE, added */
  std::string Out = "stdout.txt"; /**< in the folder of the test, or an absolute path */
  std::string Err = "stderr.txt";
  std::vector<int> Closed; /**< standard streams that are closed */
  std::optional<unsigned long> FileSize; /**< RLIMIT_FSIZE, bytes */
  int PipeAsOut = -1; /**< a file descriptor that replaces the standard output */
};

/** Starts argos3 in a folder. @return its process. */
pid_t StartProgram(const CTestFolder& folder, const std::vector<std::string>& arguments,
                   const SCircumstances& circumstances = {});

/** Waits for its end, at most two minutes. @return exit status; 128 + number of a signal. */
int WaitFor(pid_t process);

/** The two together, and what it has printed. */
SProgramRun RunProgramUnder(const CTestFolder& folder, const std::vector<std::string>& arguments,
                            const SCircumstances& circumstances);

/** Waits until a file exists and is not empty, at most a minute. @return false after that time. */
bool WaitForFile(const CTestFolder& folder, const std::string& name);

}  // namespace argos

#endif
