#ifndef ARGOS3_PROGRAM_SHIELDED_CHECK_H
#define ARGOS3_PROGRAM_SHIELDED_CHECK_H

namespace argos {

/**
 * A check runs users' code, which may open its files of results in Init(). So it runs in a child
 * process in which a preloaded library (write_shield.cpp) takes the place of the C library's
 * functions that change files: changes go to a temporary folder, which is removed afterwards, and
 * the code sees them as if they had been made. Programs that the code starts have it, too.
 *
 * No feature of the kernel and no privileges are needed. System calls that code makes without the C
 * library are not covered.
 */

/** @return true in the child process. */
bool IsInShieldedCheck();

/** In the child process: from now on nothing is written. Files that are open stay as they are. */
void RaiseWriteShield();

/**
 * Runs a program in such a process, with the arguments of this one, and waits for its end.
 * @param program  its executable file. @param argv  its arguments, which a null pointer ends.
 * @return its exit status; 128 + the number of the signal that has ended it.
 * @throws CARGoSException if the temporary folder or the process cannot be made.
 */
int RunShieldedCheck(const char* program, const char* const* argv);

}  // namespace argos

#endif
