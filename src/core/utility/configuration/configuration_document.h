#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_DOCUMENT_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_DOCUMENT_H

#include <argos3/core/utility/configuration/configuration_node.h>

#include <functional>
#include <memory>
#include <string>

namespace argos {

/**
 * An experiment file in memory. References to its elements stay valid while it lives and until the
 * next LoadFile() or Parse().
 */
class CConfigurationDocument {
 public:
  CConfigurationDocument();
  CConfigurationDocument(CConfigurationDocument&&) noexcept;
  CConfigurationDocument& operator=(CConfigurationDocument&&) noexcept;
  ~CConfigurationDocument();

  /**
   * @throws CARGoSException if the file cannot be read or is not well-formed XML with one root
   * element; the text gives the file, the line and what is wrong. The document is then as before.
   */
  void LoadFile(const std::string& path);

  /**
   * Reads a document from a text.
   * @param name  what error messages call it, in place of a file name.
   * @throws CARGoSException as LoadFile() does.
   */
  void Parse(const std::string& xml, const std::string& name = "(text)");

  /** @throws CARGoSException if the file cannot be written, or if there is no document. */
  void SaveFile(const std::string& path) const;

  /** @throws CARGoSException if nothing was loaded. */
  CConfigurationNode& GetRoot();

  /** The file name, or the name given to Parse(). */
  const std::string& GetName() const;

  /**
   * Sets one attribute, found by a path like those of XPath:
   *
   *   /argos-configuration/framework/experiment/@length
   *   arena/distribute[2]/entity/@quantity
   *   //foot-bot[@id='fb0']/body/@position
   *
   * A path goes from the root element, whose own name may be left out. "//" looks at any depth, "*"
   * is any element, [n] the n-th among its like-named siblings, counted from 1, [@name='value']
   * those with that attribute. The attribute is created if the element has none of that name.
   *
   * With "//" in the path every element found is changed; otherwise there must be exactly one.
   *
   * @return what was done, for a log: 'file:12: <experiment> length="10" (was "0")', one line per
   *         element.
   * @throws CARGoSException if the path is malformed, if a step finds nothing (the text gives the
   * step and the nearest existing names), or if it finds several (the text gives their lines).
   */
  std::string SetByPath(const std::string& path, const std::string& value);

  /**
   * Reports what nobody has read, in the order of the file: elements that were not visited
   * (attribute is empty; what they contain is not reported), and attributes of the others.
   */
  void ForEachUnread(const std::function<void(const CConfigurationNode& node,
                                              const std::string& attribute)>& report) const;

 private:
  std::shared_ptr<CConfigurationStore> m_store;
};

}  // namespace argos

#endif
