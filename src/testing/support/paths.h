#ifndef ARGOS3_TESTING_SUPPORT_PATHS_H
#define ARGOS3_TESTING_SUPPORT_PATHS_H

#include <string>

namespace argos {

/** A file or folder of the source tree. @param path relative to its root. */
std::string InSourceTree(const std::string& path);
/** A file or folder of the build tree. @param path relative to its root. */
std::string InBuildTree(const std::string& path);

}  // namespace argos

#endif
