#ifndef ARGOS3_CORE_UTILITY_FILES_FILE_REPLACEMENT_H
#define ARGOS3_CORE_UTILITY_FILES_FILE_REPLACEMENT_H

#include <string>
#include <string_view>

namespace argos {

/** End of the names of files that are not complete. */
constexpr char kPartSuffix[] = ".argos3.part";

/**
 * @return where a path leads over symbolic links in its last name, also if there is no such file
 *   yet: what is renamed to that replaces the file, not the link.
 */
std::string FollowLinks(const std::string& path);

/**
 * Opens a file that is to be renamed when it is complete, and locks it: a new one, or one that a
 * killed process has left, which is not empty then.
 * @param problem  set to the reason if that fails: the system's, or the process that is writing it.
 * @return the descriptor, -1 if that fails.
 */
[[nodiscard]] int OpenPart(const std::string& part, std::string& problem);

/**
 * Writes a whole file, such as a picture.
 *
 * The file has its name only when it is complete: it is written as `path + kPartSuffix`, closed,
 * and renamed. A failure leaves an earlier file of this name as it was, and no part. Where the path
 * leads to a device or a FIFO, this is written directly. It is not forced to the disk (fsync).
 * @param problem  set to the reason if the file cannot be written: the system's, or the process
 * that is writing the same file.
 * @return true if the file is complete.
 */
[[nodiscard]] bool ReplaceFile(const std::string& path, std::string_view content,
                               std::string& problem);

/**
 * Removes the parts that killed processes have left in a folder: files whose names end in
 * kPartSuffix and that nothing is writing.
 */
void RemoveStaleParts(const std::string& folder);

}  // namespace argos

#endif
