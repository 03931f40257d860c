#ifndef ARGOS3_PROGRAM_SHELL_DOCUMENTS_H
#define ARGOS3_PROGRAM_SHELL_DOCUMENTS_H

#include <string>
#include <vector>

namespace argos {

// What --generate prints; made from GetCommandLineOptions().

/** The man page, argos3.1, in roff. */
std::string MakeManPage();
std::string MakeBashCompletion();
std::string MakeZshCompletion();

/** Kinds of plug-ins, and the first words of the labels of all that are registered; sorted. */
std::vector<std::string> ListPluginWords();

/**
 * Paths of all attributes of a file, for --set: arena/foot-bot[2]/body/@position; in the order of
 * the file.
 * @throws CARGoSException if the file cannot be read.
 */
std::vector<std::string> ListAttributePaths(const std::string& file);

}  // namespace argos

#endif
