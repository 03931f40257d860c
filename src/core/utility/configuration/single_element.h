#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_SINGLE_ELEMENT_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_SINGLE_ELEMENT_H

#include <string>

namespace argos {

class CConfigurationNode;

/**
 * For elements that may be there only once, where children are visited in a loop.
 * @throws CARGoSException if an element with the same tag is before it in the same parent.
 */
void CheckIsSingle(const CConfigurationNode& node);

/** The message about a repeated element. @param location  of the other one, "file:line". */
std::string DescribeRepeat(const std::string& location);

}  // namespace argos

#endif
