#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_ARGOS_CONFIGURATION_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_ARGOS_CONFIGURATION_H

#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/configuration/configuration_iterator.h>
#include <argos3/core/utility/configuration/configuration_node.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <string>
#include <type_traits>

namespace argos {

typedef CConfigurationNode TConfigurationNode;
typedef CConfigurationNodeIterator TConfigurationNodeIterator;
typedef CConfigurationAttributeIterator TConfigurationAttributeIterator;

/*
 * Reading and writing elements. configuration_parsing.h describes the accepted text of each type.
 * Every error is a CARGoSException whose text begins with "file:line: <element>: " and gives the
 * value found and the values allowed.
 */

/** @return true if the element has a direct child with that tag. */
bool NodeExists(TConfigurationNode& node, const std::string& tag);

/** Returns the first direct child with that tag. @throws CARGoSException if there is none. */
TConfigurationNode& GetNode(TConfigurationNode& node, const std::string& tag);

/** Appends a copy of an element and its contents. */
void AddChildNode(TConfigurationNode& parent, TConfigurationNode& child);

/** @throws CARGoSException if the element has no text, or if the text is not a T. */
template <typename T>
void GetNodeText(TConfigurationNode& node, T& buffer) {
  node.GetText(&buffer);
}

/** @throws CARGoSException if the element has a text and the text is not a T. */
template <typename T>
void GetNodeTextOrDefault(TConfigurationNode& node, T& buffer, const std::common_type_t<T>& dflt) {
  node.GetTextOrDefault(&buffer, dflt);
}

bool NodeAttributeExists(TConfigurationNode& node, const std::string& attribute);

/**
 * @param buffer  unspecified if the function throws.
 * @throws CARGoSException if there is no such attribute, or if its text is not a T.
 */
template <typename T>
void GetNodeAttribute(TConfigurationNode& node, const std::string& attribute, T& buffer) {
  node.GetAttribute(attribute, &buffer);
}
void GetNodeAttribute(TConfigurationNode& node, const std::string& attribute, bool& buffer);
void GetNodeAttribute(TConfigurationNode& node, const std::string& attribute, UInt8& buffer);
void GetNodeAttribute(TConfigurationNode& node, const std::string& attribute, SInt8& buffer);

/**
 * @param dflt  value of buffer if there is no such attribute.
 * @throws CARGoSException if the attribute exists and its text is not a T.
 */
template <typename T>
void GetNodeAttributeOrDefault(TConfigurationNode& node, const std::string& attribute, T& buffer,
                               const std::common_type_t<T>& dflt) {
  node.GetAttributeOrDefault(attribute, &buffer, dflt);
}
void GetNodeAttributeOrDefault(TConfigurationNode& node, const std::string& attribute, bool& buffer,
                               const bool dflt);
void GetNodeAttributeOrDefault(TConfigurationNode& node, const std::string& attribute,
                               UInt8& buffer, const UInt8 dflt);
void GetNodeAttributeOrDefault(TConfigurationNode& node, const std::string& attribute,
                               SInt8& buffer, const SInt8 dflt);

/** Adds the attribute or changes its value; real numbers are written with all their digits. */
template <typename T>
void SetNodeAttribute(TConfigurationNode& node, const std::string& attribute, const T& value) {
  node.SetAttribute(attribute, value);
}
void SetNodeAttribute(TConfigurationNode& node, const std::string& attribute, const bool value);
void SetNodeAttribute(TConfigurationNode& node, const std::string& attribute, const SInt8 value);
void SetNodeAttribute(TConfigurationNode& node, const std::string& attribute, const UInt8 value);

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/configuration/tinyxml/ticpp.h>
#endif

#endif
