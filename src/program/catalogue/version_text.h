#ifndef ARGOS3_PROGRAM_CATALOGUE_VERSION_TEXT_H
#define ARGOS3_PROGRAM_CATALOGUE_VERSION_TEXT_H

#include <string>

namespace argos {

/**
 * The text of `argos3 --version`: lines KEY=value with version, commit, compiler, options, the
 * physics engines of the loaded libraries if there are any, and the folder of the running
 * installation.
 */
std::string DescribeVersion();

}  // namespace argos

#endif
