#include <argos3/core/utility/configuration/argos_configuration.h>

namespace argos {

bool NodeExists(TConfigurationNode& node, const std::string& tag) {
  return node.FirstChildElement(tag, false) != nullptr;
}

TConfigurationNode& GetNode(TConfigurationNode& node, const std::string& tag) {
  return *node.FirstChildElement(tag, true);
}

void AddChildNode(TConfigurationNode& parent, TConfigurationNode& child) {
  parent.InsertEndChild(child);
}

bool NodeAttributeExists(TConfigurationNode& node, const std::string& attribute) {
  return node.HasAttribute(attribute);
}

void GetNodeAttribute(TConfigurationNode& node, const std::string& attribute, bool& buffer) {
  node.GetAttribute(attribute, &buffer);
}

void GetNodeAttribute(TConfigurationNode& node, const std::string& attribute, UInt8& buffer) {
  node.GetAttribute(attribute, &buffer);
}

void GetNodeAttribute(TConfigurationNode& node, const std::string& attribute, SInt8& buffer) {
  node.GetAttribute(attribute, &buffer);
}

void GetNodeAttributeOrDefault(TConfigurationNode& node, const std::string& attribute, bool& buffer,
                               const bool dflt) {
  node.GetAttributeOrDefault(attribute, &buffer, dflt);
}

void GetNodeAttributeOrDefault(TConfigurationNode& node, const std::string& attribute,
                               UInt8& buffer, const UInt8 dflt) {
  node.GetAttributeOrDefault(attribute, &buffer, dflt);
}

void GetNodeAttributeOrDefault(TConfigurationNode& node, const std::string& attribute,
                               SInt8& buffer, const SInt8 dflt) {
  node.GetAttributeOrDefault(attribute, &buffer, dflt);
}

void SetNodeAttribute(TConfigurationNode& node, const std::string& attribute, const bool value) {
  node.SetAttribute(attribute, value);
}

void SetNodeAttribute(TConfigurationNode& node, const std::string& attribute, const SInt8 value) {
  node.SetAttribute(attribute, value);
}

void SetNodeAttribute(TConfigurationNode& node, const std::string& attribute, const UInt8 value) {
  node.SetAttribute(attribute, value);
}

}  // namespace argos
