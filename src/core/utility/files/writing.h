#ifndef ARGOS3_CORE_UTILITY_FILES_WRITING_H
#define ARGOS3_CORE_UTILITY_FILES_WRITING_H

#include <cstddef>
#include <string>
#include <string_view>

namespace argos {

/** What becomes of the missing folder of a file. */
enum class EMissingFolder { IsAProblem, IsCreated, WillBeCreated };

/**
 * Checks whether a file can be written, without changing it.
 * @return empty if it can; else the reason.
 */
std::string FindOutputProblem(const std::string& path, EMissingFolder missingFolder);

/** The same for a file in a folder, whose name is not known yet. */
std::string FindFolderProblem(const std::string& folder, EMissingFolder missingFolder);

/**
 * Opens a file for writing. Waits for the reader of a FIFO as long as GetOutputTimeout() says.
 * @param flags    of open(2), besides O_WRONLY and O_CLOEXEC.
 * @param problem  set to the reason if that fails.
 * @return the descriptor, -1 if that fails.
 */
[[nodiscard]] int OpenForWriting(const std::string& path, int flags, std::string& problem);

/**
 * Writes bytes. A FIFO, a socket or a terminal may take nothing for as long as GetOutputTimeout()
 * says.
 * @param problem  set to the reason if not all were written.
 * @return how many were written.
 */
[[nodiscard]] std::size_t WriteBytes(int file, std::string_view bytes, std::string& problem);

}  // namespace argos

#endif
