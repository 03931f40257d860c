#ifndef ARGOS3_CORE_UTILITY_FILES_NEARBY_FILE_H
#define ARGOS3_CORE_UTILITY_FILES_NEARBY_FILE_H

#include <string>

namespace argos {

/**
 * Finds a file that an experiment names: a relative path is searched in the working folder, then
 * beside the file that names it.
 * @param name  may contain environment variables, as "$HOME/map.png".
 * @param besideFile  path of that file; empty: there is none.
 * @param what  for errors, such as "floor image".
 * @throws CARGoSException if there is no such file, with the places where it was searched.
 */
std::string FindNearbyFile(const std::string& name, const std::string& besideFile,
                           const std::string& what);

}  // namespace argos

#endif
