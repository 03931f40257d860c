#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_NODE_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_NODE_H

#include <argos3/core/utility/configuration/configuration_attribute.h>
#include <argos3/core/utility/configuration/configuration_parsing.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * Handle of an element of an experiment file; cheap to copy, copies refer to the same element.
 *
 * References and pointers returned by GetNode(), the iterators and the navigation functions below
 * stay valid as long as the document. A copied handle keeps the document alive. An element that was
 * constructed from a tag alone is the root of its own document. Assignment makes a handle refer to
 * the other handle's element and changes no document.
 *
 * Access to an attribute marks it as read, access to an element marks it as visited: see
 * CConfigurationDocument::ForEachUnread(). A document may be used by one thread at a time.
 *
 * Every function except IsEmpty() throws CARGoSException if the handle is empty or the element was
 * removed from its document.
 */
class CConfigurationNode {
 public:
  /** Creates an empty handle. */
  CConfigurationNode() noexcept = default;

  /** Creates an element without parent. @throws CARGoSException if the tag is not an XML name. */
  CConfigurationNode(const std::string& tag);
  CConfigurationNode(const char* tag) : CConfigurationNode(std::string(tag)) {}
  template <typename T>
  CConfigurationNode(const std::string& tag, const T& text) : CConfigurationNode(tag) {
    SetText(text);
  }

  CConfigurationNode(const CConfigurationNode& other);
  CConfigurationNode& operator=(const CConfigurationNode& other);
  ~CConfigurationNode();

  bool IsEmpty() const { return m_entry == nullptr; }
  /** True if its address stays valid: see CConfigurationDocument::SetLasting(). */
  bool IsLasting() const;

  /** Returns the tag. */
  std::string Value() const;
  template <typename T>
  void GetValue(T* value) const {
    Convert(Value().c_str(), "the tag", *value);
  }
  template <typename T>
  void SetValue(const T& value) {
    SetTag(detail::FormatText(value));
  }

  /** The line of the element in its file, counted from 1; 0 if it comes from no file. */
  UInt32 GetLine() const;
  /** The name of the element's file, or "(made by the program)". */
  const std::string& GetFileName() const;
  /** Returns "file:line", or the file name if there is no line. */
  std::string GetLocation() const;

  /**
   * Navigation. Without a tag: the first element with any tag.
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

  /** The same functions under other names: a node is an element; texts and comments are skipped. */
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
  /** The child after @p previous, or the first child if that is null; null after the last. */
  CConfigurationNode* IterateChildren(CConfigurationNode* previous) const;
  CConfigurationNode* IterateChildren(const std::string& tag, CConfigurationNode* previous) const;
  /** Returns this node. */
  CConfigurationNode* ToElement() const { return const_cast<CConfigurationNode*>(this); }

  /** @return true if the element contains neither elements nor text. */
  bool NoChildren() const;

  /**
   * Insert a copy of an element and its contents as a child. The copy keeps the file and line of
   * the original.
   * @return the copy.
   */
  CConfigurationNode* InsertEndChild(const CConfigurationNode& child);
  CConfigurationNode* InsertAfterChild(const CConfigurationNode& before,
                                       const CConfigurationNode& child);
  CConfigurationNode* InsertBeforeChild(const CConfigurationNode& after,
                                        const CConfigurationNode& child);

  /** Appends a copy of the element of @p child, and makes @p child refer to the copy. */
  CConfigurationNode* LinkEndChild(CConfigurationNode* child);
  /** Replaces a child by a copy of an element. @return the copy. */
  CConfigurationNode* ReplaceChild(CConfigurationNode* child, const CConfigurationNode& with);
  /** @throws CARGoSException if @p child is not a child of this element. */
  void RemoveChild(CConfigurationNode* child);
  /** Removes all children, texts included. */
  void Clear();

  /** Returns a copy of the element and its contents, in its own document. */
  std::unique_ptr<CConfigurationNode> Clone() const;

  /** Returns the value, or an empty string if there is no such attribute. */
  std::string GetAttribute(const std::string& name) const;
  std::string GetAttributeOrDefault(const std::string& name, const std::string& dflt) const;

  /**
   * Reads an attribute; configuration_parsing.h describes the accepted text.
   * @return true if the attribute exists.
   * @throws CARGoSException if it is missing and throwIfMissing is true, or does not parse.
   */
  template <typename T>
  bool GetAttribute(const std::string& name, T* value, bool throwIfMissing = true) const {
    NoteRequest(name, detail::SampleText(static_cast<const T*>(nullptr)));
    const char* text = FindAttribute(name);
    if (text == nullptr && throwIfMissing) {
      ThrowMissingAttribute(name);
    }
    std::string reason;
    if (text != nullptr && !detail::ParseText(text, *value, reason)) {
      ConvertLoosely("attribute \"" + name + '"', text, *value, reason);
    }
    if (text != nullptr && detail::kHasRealNumbers<T>) {
      ThrowIfHuge(name, text);
    }
    return text != nullptr;
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
  /** Adds the attribute or changes its value. */
  template <typename T>
  void SetAttribute(const std::string& name, const T& value) {
    SetAttributeText(name, detail::FormatText(value));
  }
  /** Does nothing if there is no such attribute. */
  void RemoveAttribute(const std::string& name);
  /** Owned by the document; null if there is none and throwIfMissing is false. */
  CConfigurationAttribute* FirstAttribute(bool throwIfMissing = true) const;
  std::vector<std::string> GetAttributeNames() const;
  /** Returns names and values, in the order of the file, and marks no attribute as read. */
  std::vector<std::pair<std::string, std::string>> CopyAttributes() const;

  /** Returns the first text inside the element, trimmed. */
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
  std::string GetTextOrDefault(const std::string& dflt) const;
  template <typename T>
  void SetText(const T& value) {
    SetTextContent(detail::FormatText(value));
  }

  /** Returns the attribute's text, owned by the document, and marks it as read; null if missing. */
  const char* FindAttribute(const std::string& name) const;

  /** Throws the error of a missing attribute; the text gives the nearest existing names. */
  [[noreturn]] void ThrowMissingAttribute(const std::string& name) const;

  /** Throws the error of a missing child element; the text gives the nearest existing tags. */
  [[noreturn]] void ThrowMissingChild(const std::string& tag) const;

  /** @return true if the document accepts malformed values as ARGoS 3 does, with a warning each. */
  bool IsLenient() const;

 private:
  friend class CConfigurationAttribute;
  friend class CConfigurationAttributeIterator;
  friend class CConfigurationDocument;
  friend class CConfigurationStore;
  friend void MarkSubtreeRead(CConfigurationNode& node);
  friend std::ostream& operator<<(std::ostream& stream, const CConfigurationNode& node);
  friend std::istream& operator>>(std::istream& stream, CConfigurationNode& node);

  template <typename T>
  void Convert(const char* text, const char* what, T& value) const {
    std::string reason;
    if (!detail::ParseText(text, value, reason)) {
      ConvertLoosely(what, text, value, reason);
    }
  }
  template <typename T>
  void ConvertLoosely(const std::string& what, const char* text, T& value,
                      const std::string& reason) const {
    const std::string expected = detail::ExpectedText(static_cast<const T*>(nullptr));
    const bool isLoose = detail::ParseLoosely(text, value);
    if (!IsLenient() || !isLoose) {
      ThrowUnparsable(what, text, expected, reason, isLoose);
    }
    WarnOfLooseText(what, text, expected);
  }
  // not called for users' <params>, <loop_functions> and <user_functions>
  void ThrowIfHuge(const std::string& name, const char* text) const;
  void NoteRequest(const std::string& name, const char* sample) const;
  void WarnOfLooseText(const std::string& what, const char* text,
                       const std::string& expected) const;
  [[noreturn]] void ThrowUnparsable(const std::string& what, const char* text,
                                    const std::string& expected, const std::string& reason,
                                    bool isLoose) const;

  SConfigurationEntry& Entry() const;
  void SetTag(const std::string& tag);
  void SetAttributeText(const std::string& name, const std::string& text);
  void SetTextContent(const std::string& text);
  const char* FindText(bool throwIfMissing) const;

  SConfigurationEntry* m_entry = nullptr;
  // a user's handle may outlive the document object; empty in handles that the document itself
  // holds
  std::shared_ptr<CConfigurationStore> m_owner;
  bool m_heldByDocument = false;
};

/** Prints the element and its contents as XML. */
std::ostream& operator<<(std::ostream& stream, const CConfigurationNode& node);

/** Reads the rest of the stream as one element. @throws CARGoSException if it is malformed. */
std::istream& operator>>(std::istream& stream, CConfigurationNode& node);

/** Marks the element, its attributes and its contents as read. */
void MarkSubtreeRead(CConfigurationNode& node);

}  // namespace argos

#endif
