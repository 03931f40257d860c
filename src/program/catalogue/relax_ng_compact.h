#ifndef ARGOS3_PROGRAM_CATALOGUE_RELAX_NG_COMPACT_H
#define ARGOS3_PROGRAM_CATALOGUE_RELAX_NG_COMPACT_H

#include <argos3/core/utility/configuration/argos_configuration.h>

#include <string>

namespace argos {

/** A grammar of RELAX NG in the compact syntax. @param grammar  its root, <grammar>. */
std::string WriteCompactSyntax(TConfigurationNode& grammar);

}  // namespace argos

#endif
