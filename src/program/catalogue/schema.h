#ifndef ARGOS3_PROGRAM_CATALOGUE_SCHEMA_H
#define ARGOS3_PROGRAM_CATALOGUE_SCHEMA_H

#include <string>

namespace argos {

/**
 * A schema of experiment files, for editors, from what the registered plug-ins read.
 * @param format  "rng": RELAX NG in XML; "rnc": its compact syntax.
 */
std::string MakeSchema(const std::string& format);

}  // namespace argos

#endif
