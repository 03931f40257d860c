#ifndef ARGOS3_PROGRAM_COMMAND_LINE_H
#define ARGOS3_PROGRAM_COMMAND_LINE_H

namespace argos {

/**
 * The program argos3.
 *
 * Never throws: errors are printed on LOGERR. Runs on CSimulator::GetInstance().
 *
 * @param argc, argv  arguments of main(); a null pointer follows the last one.
 * @param program  executable file of the program, which runs a check in a process of its own
 *   (RunShieldedCheck()); null: in this process, so users' code may write files.
 * @return the exit status: 0 after a normal end; 1 after an error, also if a log or another output
 *   could not be written; 3 after a normal end of a run in which errors stopped robots (EOnError);
 *   128 + its number if a signal stopped the run (CStopSignals), such as 130 for SIGINT and 143 for
 *   SIGTERM. A stopped run ends normally after the current tick; if this takes longer than 30 s, or
 *   on a second signal, the process is killed.
 */
int RunCommandLine(int argc, const char* const* argv, const char* program = nullptr) noexcept;

}  // namespace argos

#endif
