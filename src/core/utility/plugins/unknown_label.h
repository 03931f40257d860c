#ifndef ARGOS3_CORE_UTILITY_PLUGINS_UNKNOWN_LABEL_H
#define ARGOS3_CORE_UTILITY_PLUGINS_UNKNOWN_LABEL_H

#include <string>
#include <vector>

namespace argos {

/**
 * The end of a message about a label that no loaded library registers: the nearest labels, or all;
 * in a second line, how to name a library and which folders are searched.
 */
std::string DescribeUnknownLabel(const std::string& label,
                                 const std::vector<std::string>& registered);

}  // namespace argos

#endif
