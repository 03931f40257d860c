#ifndef ARGOS3_COMPAT_CORE_UTILITY_CONFIGURATION_TINYXML_TICPP_H
#define ARGOS3_COMPAT_CORE_UTILITY_CONFIGURATION_TINYXML_TICPP_H

#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/configuration/configuration_error.h>
#include <argos3/core/utility/configuration/configuration_iterator.h>
#include <argos3/core/utility/configuration/configuration_node.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <sstream>
#include <string>

/*
 * The names of the XML library of ARGoS 3, TinyXML++, that users' code calls directly, for our
 * nodes. A node is an element; texts and comments are skipped.
 */
namespace ticpp {

using Attribute = argos::CConfigurationAttribute;
using Element = argos::CConfigurationNode;
using Exception = argos::CConfigurationError;
using Node = argos::CConfigurationNode;

namespace detail {

template <typename T>
struct SIteratorOf;
template <>
struct SIteratorOf<Element> {
  typedef argos::CConfigurationNodeIterator TType;
};
template <>
struct SIteratorOf<Attribute> {
  typedef argos::CConfigurationAttributeIterator TType;
};

}  // namespace detail

/** Of the child elements or of the attributes of an element. */
template <typename T>
using Iterator = typename detail::SIteratorOf<T>::TType;

/** An XML file with a name. Its one child is the root element. Every function throws Exception. */
class Document : public argos::CConfigurationDocument {
 public:
  Document() = default;
  explicit Document(const std::string& name) : m_name(name) {}
  explicit Document(const char* name) : m_name(name) {}

  using argos::CConfigurationDocument::LoadFile;
  using argos::CConfigurationDocument::SaveFile;
  void LoadFile() { LoadFile(m_name); }
  void SaveFile() const { SaveFile(m_name); }
  /** @param throwIfError  false: a text that is not well-formed leaves the document as it was. */
  void Parse(const std::string& xml, bool throwIfError = true) {
    try {
      argos::CConfigurationDocument::Parse(xml, m_name.empty() ? "(text)" : m_name);
    } catch (Exception&) {
      if (throwIfError) {
        throw;
      }
    }
  }

  Element* FirstChildElement(bool throwIfMissing = true) {
    return throwIfMissing || !IsEmpty() ? &GetRoot() : nullptr;
  }
  Element* FirstChildElement(const std::string& tag, bool throwIfMissing = true) {
    Element* const root = FirstChildElement(throwIfMissing);
    if (root == nullptr || root->Value() == tag) {
      return root;
    }
    if (throwIfMissing) {
      throw Exception(GetName() + ": the root element is <" + root->Value() + ">, not <" + tag +
                      ">");
    }
    return nullptr;
  }
  Element* FirstChildElement(const char* tag, bool throwIfMissing = true) {
    return FirstChildElement(std::string(tag), throwIfMissing);
  }
  /** The same: the only child is an element. */
  Node* FirstChild(bool throwIfMissing = true) { return FirstChildElement(throwIfMissing); }
  template <typename TAG>
  Node* FirstChild(const TAG& tag, bool throwIfMissing = true) {
    return FirstChildElement(tag, throwIfMissing);
  }

  /** Makes a copy of an element the root of an empty document. @return the copy. */
  Node* InsertEndChild(const Node& root) {
    if (!IsEmpty()) {
      throw Exception(GetName() + ": the document already has the root element <" +
                      GetRoot().Value() + ">");
    }
    argos::CTextOutput text;
    text << root;
    Parse(text.str());
    return &GetRoot();
  }
  /** The same; @p root then refers to the copy. */
  Node* LinkEndChild(Node* root) {
    Node* const copy = InsertEndChild(*root);
    *root = *copy;
    return copy;
  }

 private:
  bool IsEmpty() {
    try {
      GetRoot();
      return false;
    } catch (Exception&) {
      return true;
    }
  }

  std::string m_name;
};

}  // namespace ticpp

#endif
