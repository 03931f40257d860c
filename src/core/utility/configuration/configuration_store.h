#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_STORE_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_STORE_H

// private: the only header that knows the XML library

#include <argos3/core/utility/configuration/configuration_node.h>

#include <tinyxml2.h>

#include <deque>
#include <functional>
#include <memory>
#include <string>

namespace argos {

/** What is kept about an element besides its XML. */
struct SConfigurationRecord {
  tinyxml2::XMLElement* Element = nullptr;  // null once the element was removed
  CConfigurationStore* Store = nullptr;
  CConfigurationNode* Handle =
      nullptr;  // the handle that GetNode() gives; null until it is asked for
  // one bit per attribute, in the order of the file; those after the 64th count as read
  UInt64 ReadAttributes = 0;
  bool IsVisited = false;
  int Line = 0;
  // shared with the document the element was copied from, which may be gone
  std::shared_ptr<const std::string> File;
};

/** One XML document with a record per element; addresses of records and handles never change. */
class CConfigurationStore : public std::enable_shared_from_this<CConfigurationStore> {
 public:
  explicit CConfigurationStore(const std::string& name);

  tinyxml2::XMLDocument& GetXml() { return m_xml; }
  const std::shared_ptr<const std::string>& GetName() const { return m_name; }

  SConfigurationRecord& RecordOf(tinyxml2::XMLElement& element);

  /** The element's handle, which the store holds; the element counts as visited. */
  CConfigurationNode* HandleOf(tinyxml2::XMLElement* element);

  CConfigurationAttribute* KeepAttribute(const CConfigurationAttribute& attribute);

  /** Copies an element of any store into this one, without parent, remembering files and lines. */
  tinyxml2::XMLElement& CopyOf(tinyxml2::XMLElement& original);

  /** Deletes an element or text; handles to what was in it notice. */
  void Delete(tinyxml2::XMLNode& node);

 private:
  void InheritOrigin(tinyxml2::XMLElement& copy, tinyxml2::XMLElement& original);
  void Forget(tinyxml2::XMLElement& element);

  std::shared_ptr<const std::string> m_name;
  tinyxml2::XMLDocument m_xml;
  std::deque<SConfigurationRecord> m_records;
  std::deque<CConfigurationNode> m_handles;
  std::deque<CConfigurationAttribute> m_attributes;
};

/** Names that are in use, for error messages: without repetition, in the order of the file. */
std::vector<std::string> ChildTags(const tinyxml2::XMLElement& element);
std::vector<std::string> AttributeNames(const tinyxml2::XMLElement& element);

/** "file:line", or the file alone without a line. */
std::string LocationText(const std::string& file, int line);

/** Throws if the text cannot be the name of an element or attribute. */
void CheckXmlName(const std::string& name);

}  // namespace argos

#endif
