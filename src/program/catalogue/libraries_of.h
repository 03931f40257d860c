#ifndef ARGOS3_PROGRAM_CATALOGUE_LIBRARIES_OF_H
#define ARGOS3_PROGRAM_CATALOGUE_LIBRARIES_OF_H

#include <string>

namespace argos {

/**
 * Loads the libraries that the elements of an experiment file name.
 * @throws CARGoSException if the file is not well-formed, or if a library does not load.
 */
void LoadLibrariesOf(const std::string& experimentFile);

}  // namespace argos

#endif
