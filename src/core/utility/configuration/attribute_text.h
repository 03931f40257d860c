#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_ATTRIBUTE_TEXT_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_ATTRIBUTE_TEXT_H

#include <string>

namespace argos {

class CConfigurationNode;

/**
 * Adds the attribute or changes its text: CConfigurationNode::SetAttribute() without the stream
 * that formats values of any type, for attributes that are written for each of many entities.
 */
void SetAttributeText(CConfigurationNode& node, const std::string& name, const std::string& text);

}  // namespace argos

#endif
