#ifndef ARGOS3_CORE_SIMULATOR_COMMAND_LINE_H
#define ARGOS3_CORE_SIMULATOR_COMMAND_LINE_H

namespace argos {

/**
 * The program argos3: does what its command line says.
 *
 * Nothing is thrown: what goes wrong is printed on LOGERR. Runs on CSimulator::GetInstance().
 *
 * @param argc, argv  as main() got them.
 * @return the exit status: 0 after a normal end, 1 after an error; 130 or 143 if SIGINT or SIGTERM
 *         stopped the run, which then ends normally after the current tick. If that takes more than
 *         30 s, or another signal comes, the signal kills.
 */
int RunCommandLine(int argc, const char* const* argv) noexcept;

}  // namespace argos

#endif
