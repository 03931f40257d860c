#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_STORE_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_STORE_H

// private: the only header that includes the XML library

#include <argos3/core/utility/configuration/configuration_node.h>
#include <argos3/core/utility/configuration/element_name.h>

#include <tinyxml2.h>

#include <deque>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace argos {

/** Exists if a document is lenient. */
struct SLeniency {
  std::set<std::string> Reported;  // warnings: copies of an element repeat them
};

/** Data about an element besides its XML. */
struct SConfigurationEntry {
  tinyxml2::XMLElement* Element = nullptr;  // null once the element was removed
  CConfigurationStore* Store = nullptr;
  CConfigurationNode* Handle =
      nullptr;  // the handle that GetNode() gives; null until its first call
  // one bit per attribute, in the order of the file; attributes after the 64th count as read
  UInt64 ReadAttributes = 0;
  // the attribute that was found last, and its number: a loop over all names finds each at once
  const tinyxml2::XMLAttribute* LastFound = nullptr;
  UInt32 LastFoundIndex = 0;
  // names that were looked up in vain, without duplicates: attributes that would be used
  std::vector<std::string> MissedNames;
  bool IsVisited = false;
  bool IsTextRead = false;
  int Line = 0;
  // the entry of the element of which it is a copy, or this one
  const SConfigurationEntry* Origin = this;
  // place of the original, for CRequestRecorder; null unless it is a recorded copy
  std::shared_ptr<const std::vector<SElementName>> OriginPath;
  // shared with the document from which the element was copied, which may have been destroyed
  std::shared_ptr<const std::string> File;
  // document from which the element was copied, likewise; null unless that is lenient
  std::shared_ptr<SLeniency> Leniency;
};

/** One call of CConfigurationDocument::SetByPath(). */
struct SConfigurationSetting {
  std::string Path;
  std::string Attribute;
  std::string Value;
  std::vector<const SConfigurationEntry*> Elements;  // elements that were changed
};

/** One XML document with a entry per element; addresses of entries and handles are stable. */
class CConfigurationStore : public std::enable_shared_from_this<CConfigurationStore> {
 public:
  explicit CConfigurationStore(const std::string& name);

  tinyxml2::XMLDocument& GetXml() { return m_xml; }
  const std::shared_ptr<const std::string>& GetName() const { return m_name; }

  SConfigurationEntry& EntryOf(tinyxml2::XMLElement& element);

  /** Returns the element's handle, owned by the store; marks the element as visited. */
  CConfigurationNode* HandleOf(tinyxml2::XMLElement* element);

  void SetLasting() { m_isLasting = true; }
  bool IsLasting() const { return m_isLasting; }

  void SetLenient() { m_leniency = std::make_shared<SLeniency>(); }
  /** Null if texts that are no valid values are errors. */
  const std::shared_ptr<SLeniency>& LeniencyOf(const SConfigurationEntry& entry) const {
    return entry.Leniency != nullptr ? entry.Leniency : m_leniency;
  }

  /** See attribute_text.h. */
  static void SetText(CConfigurationNode& node, const std::string& name, const std::string& text);

  CConfigurationAttribute* KeepAttribute(const CConfigurationAttribute& attribute);

  void AddSetting(SConfigurationSetting setting) { m_settings.push_back(std::move(setting)); }
  /**
   * Describes the settings of which no element has read the attribute, but not those of the
   * contents of the elements @p pending.
   */
  std::vector<std::string> DescribeUnreadSettings(
      const std::set<const tinyxml2::XMLNode*>& pending) const;
  /**
   * Describes elements, in the element and its contents, that are unread because there is another
   * one with the same tag before them, which was read. Not of users' elements; none if the document
   * is lenient.
   */
  void DescribeRepeated(tinyxml2::XMLElement& element, std::vector<std::string>& lines);
  /** Describes what is unread in the element and its contents, in the order of the file. */
  void DescribeUnread(tinyxml2::XMLElement& element, std::vector<std::string>& lines);

  /** Copies an element of any store into this one, without parent, with file and line. */
  tinyxml2::XMLElement& CopyOf(tinyxml2::XMLElement& original);

  /** Deletes an element or text; handles of deleted elements become invalid and throw when used. */
  void Delete(tinyxml2::XMLNode& node);

 private:
  void InheritOrigin(tinyxml2::XMLElement& copy, tinyxml2::XMLElement& original);
  void Forget(tinyxml2::XMLElement& element);

  std::shared_ptr<const std::string> m_name;
  tinyxml2::XMLDocument m_xml;
  std::shared_ptr<SLeniency> m_leniency;  // null: it is strict
  bool m_isLasting = false;
  std::deque<SConfigurationEntry> m_entries;
  std::deque<CConfigurationNode> m_handles;
  std::deque<CConfigurationAttribute> m_attributes;
  std::vector<SConfigurationSetting> m_settings;
};

/** Attributes of an element of which is known whether they were read: the first ones. */
constexpr std::size_t kTrackedAttributes = 64;

/** @return true if the attribute with that number, in the order of the file, was read. */
inline bool IsAttributeRead(const SConfigurationEntry& entry, std::size_t index) {
  return index >= kTrackedAttributes || ((entry.ReadAttributes >> index) & 1) != 0;
}

/** @return true if one of the numbers in a text exceeds kMaxReal. */
bool HasHugeNumber(const char* text);

/** @return true if users' code reads the element and its contents. */
bool IsOfUser(const tinyxml2::XMLElement& element);

/** Existing names, for error messages: without duplicates, in the order of the file. */
std::vector<std::string> ChildTags(const tinyxml2::XMLElement& element);
std::vector<std::string> AttributeNames(const tinyxml2::XMLElement& element);

/** Returns "file:line", or the file name if there is no line. */
std::string LocationText(const std::string& file, int line);

/** Throws if the text is not a valid name of an element or attribute. */
void CheckXmlName(const std::string& name);

}  // namespace argos

#endif
