#ifndef ARGOS3_CORE_UTILITY_PLUGINS_UNKNOWN_LABEL_H
#define ARGOS3_CORE_UTILITY_PLUGINS_UNKNOWN_LABEL_H

#include <string>
#include <vector>

namespace argos {

/**
 * Keeps for this thread which library the element names that is being read; empty: none.
 * @param path  of the library, which is loaded.
 */
void NoteNamedLibrary(const std::string& path);

/**
 * The end of a message about a label that no loaded library registers: the nearest labels, or all;
 * in a second line what the library registers that the element names, or else how to name a library
 * and which folders are searched.
 */
std::string DescribeUnknownLabel(const std::string& label,
                                 const std::vector<std::string>& registered);

}  // namespace argos

#endif
