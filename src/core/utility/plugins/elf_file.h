#ifndef ARGOS3_CORE_UTILITY_PLUGINS_ELF_FILE_H
#define ARGOS3_CORE_UTILITY_PLUGINS_ELF_FILE_H

#include <string>
#include <vector>

namespace argos {

/*
 * What the file of a shared library tells without being opened as a library: nothing if it cannot
 * be read, is no library of this machine, or is damaged.
 */

/** @return the build id that the linker has written, hexadecimal. */
std::string ReadBuildId(const std::string& path);

/** @return the file names of the libraries that it is linked with. */
std::vector<std::string> ListNeeded(const std::string& path);

}  // namespace argos

#endif
