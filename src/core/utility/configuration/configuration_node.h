#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_NODE_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_NODE_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/configuration/configuration_attribute.h>
#include <argos3/core/utility/configuration/configuration_parsing.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * An element of an experiment file: a handle, cheap to copy; copies refer to the same element.
 *
 * References and pointers that GetNode(), the iterators and the navigation functions below give
 * stay valid as long as the document. A copied handle keeps the document alive by itself. An
 * element that was made from a tag alone is the root of a document of its own. Assigning to a node
 * makes it refer to the other's element and changes no document.
 *
 * Every access to an attribute marks it as read, every way to reach an element marks the element as
 * visited: see CConfigurationDocument::ForEachUnread(). A document is for one thread at a time.
 *
 * Every function but IsEmpty() throws CARGoSException on an empty handle, and if the element was
 * removed from its document.
 */
class CConfigurationNode {
 public:
  /** An empty handle, to be assigned to. */
  CConfigurationNode() noexcept = default;

  /** A new element without parent. @throws CARGoSException if the tag is not an XML name. */
  CConfigurationNode(const std::string& tag);
  CConfigurationNode(const char* tag) : CConfigurationNode(std::string(tag)) {}
  template <typename T>
  CConfigurationNode(const std::string& tag, const T& text) : CConfigurationNode(tag) {
    SetText(text);
  }

  CConfigurationNode(const CConfigurationNode& other);
  CConfigurationNode& operator=(const CConfigurationNode& other);
  ~CConfigurationNode();

  bool IsEmpty() const { return m_record == nullptr; }

  /** The tag. */
  std::string Value() const;
  template <typename T>
  void GetValue(T* value) const {
    Convert(Value().c_str(), "the tag", *value);
  }
  template <typename T>
  void SetValue(const T& value) {
    SetTag(detail::FormatText(value));
  }

  /** Where the element stands in its file: the line, counted from 1; 0 if it comes from no file. */
  UInt32 GetLine() const;
  /** The name of the file the element was read from, or "(made by the program)". */
  const std::string& GetFileName() const;
  /** "file:line", or the file name alone without a line. */
  std::string GetLocation() const;

  /**
   * Neighbours. Without a tag: the first element of any tag.
   * @return null if there is none and throwIfMissing is false.
   * @throws CARGoSException if there is none and throwIfMissing is true.
   */
  CConfigurationNode* Parent(bool throwIfMissing = true) const;
  CConfigurationNode* FirstChildElement(bool throwIfMissing = true) const;
  CConfigurationNode* FirstChildElement(const char* tag, bool throwIfMissing = true) const;
  CConfigurationNode* FirstChildElement(const std::string& tag, bool throwIfMissing = true) const;
  CConfigurationNode* LastChildElement(bool throwIfMissing = true) const;
  CConfigurationNode* LastChildElement(const std::string& tag, bool throwIfMissing = true) const;
  CConfigurationNode* LastChildElement(const char* tag, bool throwIfMissing = true) const {
    return LastChildElement(std::string(tag), throwIfMissing);
  }
  CConfigurationNode* NextSiblingElement(bool throwIfMissing = true) const;
  CConfigurationNode* NextSiblingElement(const char* tag, bool throwIfMissing = true) const;
  CConfigurationNode* NextSiblingElement(const std::string& tag, bool throwIfMissing = true) const;
  CConfigurationNode* PreviousSiblingElement(bool throwIfMissing = true) const;
  CConfigurationNode* PreviousSiblingElement(const std::string& tag,
                                             bool throwIfMissing = true) const;
  CConfigurationNode* PreviousSiblingElement(const char* tag, bool throwIfMissing = true) const {
    return PreviousSiblingElement(std::string(tag), throwIfMissing);
  }

  /** The same under other names: a node is an element; texts and comments are passed over. */
  CConfigurationNode* FirstChild(bool throwIfMissing = true) const {
    return FirstChildElement(throwIfMissing);
  }
  template <typename TAG>
  CConfigurationNode* FirstChild(const TAG& tag, bool throwIfMissing = true) const {
    return FirstChildElement(tag, throwIfMissing);
  }
  CConfigurationNode* LastChild(bool throwIfMissing = true) const {
    return LastChildElement(throwIfMissing);
  }
  template <typename TAG>
  CConfigurationNode* LastChild(const TAG& tag, bool throwIfMissing = true) const {
    return LastChildElement(tag, throwIfMissing);
  }
  CConfigurationNode* NextSibling(bool throwIfMissing = true) const {
    return NextSiblingElement(throwIfMissing);
  }
  template <typename TAG>
  CConfigurationNode* NextSibling(const TAG& tag, bool throwIfMissing = true) const {
    return NextSiblingElement(tag, throwIfMissing);
  }
  CConfigurationNode* PreviousSibling(bool throwIfMissing = true) const {
    return PreviousSiblingElement(throwIfMissing);
  }
  template <typename TAG>
  CConfigurationNode* PreviousSibling(const TAG& tag, bool throwIfMissing = true) const {
    return PreviousSiblingElement(tag, throwIfMissing);
  }
  /** The child after @p previous, or the first one if that is null; null after the last. */
  CConfigurationNode* IterateChildren(CConfigurationNode* previous) const;
  CConfigurationNode* IterateChildren(const std::string& tag, CConfigurationNode* previous) const;
  /** Itself. */
  CConfigurationNode* ToElement() const { return const_cast<CConfigurationNode*>(this); }

  /** Has the element no child elements and no text? */
  bool NoChildren() const;

  /**
   * Insert a copy of an element, with all it contains, as a child. The copy remembers the file and
   * line of the original.
   * @return the copy.
   */
  CConfigurationNode* InsertEndChild(const CConfigurationNode& child);
  CConfigurationNode* InsertAfterChild(const CConfigurationNode& before,
                                       const CConfigurationNode& child);
  CConfigurationNode* InsertBeforeChild(const CConfigurationNode& after,
                                        const CConfigurationNode& child);

  /** Appends a copy of what @p child refers to, which from then on refers to the copy. */
  CConfigurationNode* LinkEndChild(CConfigurationNode* child);
  /** Puts a copy of an element in the place of a child, which is removed. @return the copy. */
  CConfigurationNode* ReplaceChild(CConfigurationNode* child, const CConfigurationNode& with);
  /** @throws CARGoSException if it is not a child of this element. */
  void RemoveChild(CConfigurationNode* child);
  /** Removes all children, texts included. */
  void Clear();

  /** A copy, with all it contains, in a document of its own. */
  std::unique_ptr<CConfigurationNode> Clone() const;

  /** The value, or an empty text if there is no such attribute. */
  std::string GetAttribute(const std::string& name) const;
  std::string GetAttributeOrDefault(const std::string& name, const std::string& dflt) const {
    const char* text = FindAttribute(name);
    return text != nullptr ? text : dflt;
  }

  /**
   * Reads an attribute; see configuration_parsing.h for what is accepted.
   * @return was there such an attribute?
   * @throws CARGoSException if it is missing and throwIfMissing is true, or does not parse.
   */
  template <typename T>
  bool GetAttribute(const std::string& name, T* value, bool throwIfMissing = true) const {
    const char* text = FindAttribute(name);
    if (text == nullptr) {
      if (throwIfMissing) {
        ThrowMissingAttribute(name);
      }
      return false;
    }
    ConvertAttribute(name, text, *value);
    return true;
  }
  template <typename T>
  T GetAttribute(const std::string& name, bool throwIfMissing = true) const {
    T value = T();
    GetAttribute(name, &value, throwIfMissing);
    return value;
  }
  template <typename T, typename DEFAULT>
  void GetAttributeOrDefault(const std::string& name, T* value, const DEFAULT& dflt) const {
    if (!GetAttribute(name, value, false)) {
      *value = dflt;
    }
  }

  bool HasAttribute(const std::string& name) const { return FindAttribute(name) != nullptr; }
  /** Adds the attribute, or changes its value. */
  template <typename T>
  void SetAttribute(const std::string& name, const T& value) {
    SetAttributeText(name, detail::FormatText(value));
  }
  /** Does nothing if there is no such attribute. */
  void RemoveAttribute(const std::string& name);
  /** Owned by the document. @return null if there are no attributes and throwIfMissing is false. */
  CConfigurationAttribute* FirstAttribute(bool throwIfMissing = true) const;
  std::vector<std::string> GetAttributeNames() const;

  /** The first text inside the element, blanks around it removed. */
  std::string GetText(bool throwIfMissing = true) const;
  template <typename T>
  bool GetText(T* value, bool throwIfMissing = true) const {
    const char* text = FindText(throwIfMissing);
    if (text == nullptr) {
      return false;
    }
    Convert(text, "the text", *value);
    return true;
  }
  template <typename T, typename DEFAULT>
  void GetTextOrDefault(T* value, const DEFAULT& dflt) const {
    if (!GetText(value, false)) {
      *value = dflt;
    }
  }
  std::string GetTextOrDefault(const std::string& dflt) const {
    const char* text = FindText(false);
    return text != nullptr ? text : dflt;
  }
  template <typename T>
  void SetText(const T& value) {
    SetTextContent(detail::FormatText(value));
  }

  /** The attribute's text, owned by the document, marked as read; null if there is none. */
  const char* FindAttribute(const std::string& name) const;

  /** Throws the error of an attribute that must be there: names the nearest that is. */
  [[noreturn]] void ThrowMissingAttribute(const std::string& name) const;

  /** Throws the error of a child element that must be there: names the nearest that is. */
  [[noreturn]] void ThrowMissingChild(const std::string& tag) const;

 private:
  friend class CConfigurationAttribute;
  friend class CConfigurationAttributeIterator;
  friend class CConfigurationDocument;
  friend class CConfigurationStore;
  friend void MarkSubtreeRead(CConfigurationNode& node);
  friend std::ostream& operator<<(std::ostream& stream, const CConfigurationNode& node);
  friend std::istream& operator>>(std::istream& stream, CConfigurationNode& node);

  template <typename T>
  void ConvertAttribute(const std::string& name, const char* text, T& value) const {
    std::string reason;
    if (!detail::ParseText(text, value, reason)) {
      ThrowUnparsable("attribute \"" + name + '"', text,
                      detail::ExpectedText(static_cast<const T*>(nullptr)), reason);
    }
  }
  template <typename T>
  void Convert(const char* text, const char* what, T& value) const {
    std::string reason;
    if (!detail::ParseText(text, value, reason)) {
      ThrowUnparsable(what, text, detail::ExpectedText(static_cast<const T*>(nullptr)), reason);
    }
  }
  [[noreturn]] void ThrowUnparsable(const std::string& what, const char* text,
                                    const std::string& expected, const std::string& reason) const;

  SConfigurationRecord& Record() const;
  void SetTag(const std::string& tag);
  void SetAttributeText(const std::string& name, const std::string& text);
  void SetTextContent(const std::string& text);
  const char* FindText(bool throwIfMissing) const;

  SConfigurationRecord* m_record = nullptr;
  // shared, because a user may keep a handle to an element whose document object is gone; empty in
  // handles that the document itself holds
  std::shared_ptr<CConfigurationStore> m_owner;
  bool m_heldByDocument = false;
};

/** Prints the element and all it contains as XML. */
std::ostream& operator<<(std::ostream& stream, const CConfigurationNode& node);

/** Reads the rest of the stream as one XML element. @throws CARGoSException if it is not well
 * formed. */
std::istream& operator>>(std::istream& stream, CConfigurationNode& node);

/** Marks the element, its attributes and everything in it as read. */
void MarkSubtreeRead(CConfigurationNode& node);

}  // namespace argos

#endif
