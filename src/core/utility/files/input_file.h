#ifndef ARGOS3_CORE_UTILITY_FILES_INPUT_FILE_H
#define ARGOS3_CORE_UTILITY_FILES_INPUT_FILE_H

#include <string>

namespace argos {

/**
 * Checks that a path leads to a regular file, without opening it: to open a FIFO would wait for its
 * writer.
 * @return empty if it does; else the reason: the system's, or what the path leads to.
 */
std::string FindInputProblem(const std::string& path);

/**
 * Reads a whole file.
 * @param problem  set to the reason if the file cannot be read, as by FindInputProblem().
 * @return true if @p content has the whole file.
 */
[[nodiscard]] bool ReadInputFile(const std::string& path, std::string& content,
                                 std::string& problem);

}  // namespace argos

#endif
