#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_ITERATOR_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_ITERATOR_H

#include <argos3/core/utility/configuration/configuration_node.h>

#include <cstddef>
#include <string>

namespace argos {

/**
 * Iterates over the child elements of a node, all of them or those with one tag:
 *
 *   CConfigurationNodeIterator it("tag");
 *   for (it = it.begin(&node); it != it.end(); ++it) { ... }
 */
class CConfigurationNodeIterator {
 public:
  CConfigurationNodeIterator(const std::string& tag = "") : m_tag(tag) {}
  CConfigurationNodeIterator(CConfigurationNode* node, const std::string& tag = "")
      : m_node(node), m_tag(tag) {}

  /** Returns the first child with the iterator's tag; null if there is none. */
  CConfigurationNode* begin(const CConfigurationNode* parent) const {
    return m_tag.empty() ? parent->FirstChildElement(false)
                         : parent->FirstChildElement(m_tag, false);
  }
  CConfigurationNode* end() const { return nullptr; }

  /** Moves the iterator to an element; the tag stays the same. */
  CConfigurationNodeIterator& operator=(CConfigurationNode* node) {
    m_node = node;
    return *this;
  }

  CConfigurationNode* Get() const { return m_node; }
  CConfigurationNode* operator->() const { return m_node; }
  CConfigurationNode& operator*() const { return *m_node; }

  CConfigurationNodeIterator& operator++() {
    m_node = m_tag.empty() ? m_node->NextSiblingElement(false)
                           : m_node->NextSiblingElement(m_tag, false);
    return *this;
  }
  CConfigurationNodeIterator operator++(int) {
    CConfigurationNodeIterator before(*this);
    ++*this;
    return before;
  }
  CConfigurationNodeIterator& operator--() {
    do {
      m_node = m_node->PreviousSiblingElement(false);
    } while (m_node != nullptr && !m_tag.empty() && m_node->Value() != m_tag);
    return *this;
  }
  CConfigurationNodeIterator operator--(int) {
    CConfigurationNodeIterator before(*this);
    --*this;
    return before;
  }

  bool operator==(const CConfigurationNode* node) const { return m_node == node; }
  bool operator!=(const CConfigurationNode* node) const { return m_node != node; }
  bool operator==(const CConfigurationNodeIterator& other) const { return m_node == other.m_node; }
  bool operator!=(const CConfigurationNodeIterator& other) const { return m_node != other.m_node; }

 private:
  CConfigurationNode* m_node = nullptr;
  std::string m_tag;
};

/**
 * Iterates over the attributes of a node, in the order of the file:
 *
 *   CConfigurationAttributeIterator it;
 *   for (it = it.begin(&node); it != it.end(); ++it) { it->Name(); it->Value(); }
 */
class CConfigurationAttributeIterator {
 public:
  CConfigurationAttributeIterator() = default;

  CConfigurationAttributeIterator begin(const CConfigurationNode* node) const;
  CConfigurationAttributeIterator end() const { return CConfigurationAttributeIterator(); }

  const CConfigurationAttribute* Get() const { return &m_attribute; }
  CConfigurationAttribute* operator->() { return &m_attribute; }
  CConfigurationAttribute& operator*() { return m_attribute; }

  CConfigurationAttributeIterator& operator++();
  CConfigurationAttributeIterator operator++(int) {
    CConfigurationAttributeIterator before(*this);
    ++*this;
    return before;
  }

  bool operator==(const CConfigurationAttributeIterator& other) const {
    return m_attribute.m_attribute == other.m_attribute.m_attribute;
  }
  bool operator!=(const CConfigurationAttributeIterator& other) const { return !(*this == other); }

 private:
  explicit CConfigurationAttributeIterator(const CConfigurationAttribute& attribute)
      : m_attribute(attribute) {}

  CConfigurationAttribute m_attribute;
};

}  // namespace argos

#endif
