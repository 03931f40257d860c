#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_REQUEST_RECORDER_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_REQUEST_RECORDER_H

#include <argos3/core/utility/configuration/element_name.h>
#include <argos3/core/utility/non_copyable.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace argos {

struct SConfigurationEntry;
}  // namespace argos

namespace tinyxml2 {
class XMLElement;
}

namespace argos {

/** What was requested of an attribute. */
struct SRequestedAttribute {
  /** A valid text of the type, as SampleText() gives it; "" for texts of any form. */
  std::string Sample;
  /** The form of numbers, as ExpectedText() gives it; "" if unknown. */
  std::string Expected;
  bool IsTyped = false; /**< it was read, not only looked for */
  bool IsMissed = false; /**< its absence was an error */

  /** Adds what another reading has found. A text and a number are a text. */
  void Merge(const SRequestedAttribute& other);
};

/** What was requested of an element, and of those inside it. */
struct SRequestedElement {
  std::map<std::string, SRequestedAttribute> Attributes;
  std::map<SElementName, std::unique_ptr<SRequestedElement>> Children;
  bool IsVisited = false; /**< there was such an element; otherwise it was only looked for */
  bool HasText = false;
  bool IsOpen = false; /**< any attributes and elements are read */

  SRequestedElement& Child(const SElementName& name);
  /** Null if there is none. */
  const SRequestedElement* Find(const SElementName& name) const;
  void Merge(const SRequestedElement& other);
};

/**
 * During its lifetime, records what this thread requests of the elements of documents: names that
 * are found and those that are not, with the types of the values. So what a part reads is known
 * without a list of it. At most one exists per thread.
 *
 * A number in a document gets a text behind it and is read loosely (ParseLoosely()): the value is
 * the same, and the reader states which form it expects.
 */
class CRequestRecorder : private CNonCopyable {
 public:
  CRequestRecorder();
  ~CRequestRecorder();

  /** The root: its child is the root element of the documents. */
  const SRequestedElement& GetRequests() const { return m_requests; }

  /** The one of this thread, or null. */
  static CRequestRecorder* Current();

  /** Names from the root of the document; of copies, those of the original; empty without root. */
  static std::vector<SElementName> PathOf(const tinyxml2::XMLElement& element);

  // called by the elements
  void NoteAttribute(const SConfigurationEntry& record, const std::string& name);
  /** @param sample  null for texts of any form. */
  void NoteType(const SConfigurationEntry& record, const std::string& name, const char* sample);
  /** @return the text of the attribute to read: with a text behind it if it is a number. */
  const char* TextOf(const std::string& name, const char* text);
  void NoteExpected(const SConfigurationEntry& record, const std::string& what,
                    const std::string& expected);
  void NoteMissed(const SConfigurationEntry& record, const std::string& name);
  void NoteChild(const SConfigurationEntry& record, const std::string& tag);
  void NoteVisit(const SConfigurationEntry& record);
  void NoteText(const SConfigurationEntry& record);
  void NoteOpen(const SConfigurationEntry& record);

 private:
  // null if the element is in no document, such as one that code has made
  SRequestedElement* Find(const SConfigurationEntry& record);

  SRequestedElement m_requests;
  std::string m_number;  // attribute whose type was noted last, if it is a number
  std::string m_text;  // result of TextOf()
};

}  // namespace argos

#endif
