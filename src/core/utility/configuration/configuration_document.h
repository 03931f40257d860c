#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_DOCUMENT_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_DOCUMENT_H

#include <argos3/core/utility/configuration/configuration_node.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * An experiment file in memory. References to its elements stay valid until the document is
 * destroyed or until the next LoadFile() or Parse().
 */
class CConfigurationDocument {
 public:
  CConfigurationDocument();
  CConfigurationDocument(CConfigurationDocument&&) noexcept;
  CConfigurationDocument& operator=(CConfigurationDocument&&) noexcept;
  ~CConfigurationDocument();

  /**
   * @throws CARGoSException if the file cannot be read or is not well-formed XML with one root
   *   element; the text gives file, line and reason. The document is then unchanged.
   */
  void LoadFile(const std::string& path);

  /**
   * Parses a document from a string.
   * @param name  replaces the file name in error messages.
   * @throws CARGoSException like LoadFile().
   */
  void Parse(const std::string& xml, const std::string& name = "(text)");

  /** @throws CARGoSException if the file cannot be written, or if the document is empty. */
  void SaveFile(const std::string& path) const;

  /** The document as XML, with its changes. @throws CARGoSException if the document is empty. */
  std::string ToText() const;

  /**
   * From now on, text that is no valid value is read as ARGoS 3 reads it, with a warning, instead
   * of being an error: of elements of this document, and of copies made from now on.
   */
  void SetLenient();

  /**
   * Promises that the document will outlive all that is made of its elements, so that their
   * addresses may be kept instead of copies.
   */
  void SetLasting();

  /** @throws CARGoSException if nothing was loaded. */
  CConfigurationNode& GetRoot();

  /** The file name, or the name given to Parse(). */
  const std::string& GetName() const;

  /**
   * Sets one attribute, selected by a path in XPath notation:
   *
   *   /argos-configuration/framework/experiment/@length
   *   arena/distribute[2]/entity/@quantity
   *   //foot-bot[@id='fb0']/body/@position
   *
   * A path starts at the root element, whose own name may be omitted. "//" searches at any depth,
   * "*" matches any element, [n] selects the n-th sibling of that name, counted from 1, and
   * [@name='value'] selects elements with that attribute. A missing attribute is created.
   *
   * With "//" in the path every match is changed; otherwise there must be exactly one match.
   *
   * @param mustBeRead  if nothing reads the attribute, DescribeUnreadSettings() reports it; if
   *   false, the attribute counts as one of the file.
   * @return a report for the log, 'file:12: <experiment> length="10" (was "0")', one line per
   *   element.
   * @throws CARGoSException if the path is malformed, if a step has no match (the text gives the
   *   step and the nearest existing names), or several (the text gives their lines).
   */
  std::string SetByPath(const std::string& path, const std::string& value, bool mustBeRead = true);

  /**
   * Reports unread content in the order of the file: elements that were not visited (attribute is
   * empty; their contents are not reported), and unread attributes of the visited ones.
   */
  void ForEachUnread(const std::function<void(const CConfigurationNode& node,
                                              const std::string& attribute)>& report) const;

  /**
   * Describes unread content, in the order of the file: what ForEachUnread() reports, and texts of
   * elements that were not read. A line is
   * 'file:12: <tag>: attribute "x" is not used by anything; did you mean "y"?'.
   */
  std::vector<std::string> DescribeUnread() const;
  /** The same of the contents of an element of this document. */
  std::vector<std::string> DescribeUnread(const CConfigurationNode& node) const;

  /**
   * Describes elements that are not read because one with the same tag, which is read, precedes
   * them, in the order of the file. Empty if the document is lenient; of elements that users' code
   * reads, nothing is reported.
   */
  std::vector<std::string> DescribeRepeated() const;

  /**
   * Describes the calls of SetByPath() with mustBeRead that have no effect, because the attribute
   * was read of none of the elements that were changed; with the nearest names that are read.
   * @param pending  elements of this document whose contents may still be read: left out.
   */
  std::vector<std::string> DescribeUnreadSettings(
      const std::vector<const CConfigurationNode*>& pending = {}) const;

 private:
  std::shared_ptr<CConfigurationStore> m_store;
};

}  // namespace argos

#endif
