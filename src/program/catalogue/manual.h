#ifndef ARGOS3_PROGRAM_CATALOGUE_MANUAL_H
#define ARGOS3_PROGRAM_CATALOGUE_MANUAL_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/program/catalogue/elements.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace argos {

class CConfigurationDocument;

/** The long description of a plug-in, for programs. */
class CManual {
 public:
  /** The XML examples: runs of indented lines that begin with a tag and are well-formed. */
  explicit CManual(const std::string& text);
  CManual(CManual&&) noexcept;
  ~CManual();

  /** The outermost elements of the examples, in their order. */
  const std::vector<TConfigurationNode>& GetExamples() const { return m_examples; }

  /** @return true if an example contains such an element. */
  bool HasExampleOf(const std::string& tag) const { return m_tags.count(tag) > 0; }

  /** What tables say of the attribute of elements with that tag, or of any tag. */
  SAttributeText TextOf(const std::string& tag, const std::string& attribute) const;

  /** What a row "tag@attribute" says, or a row of the tag that mentions the attribute. */
  SAttributeText TextOfTag(const std::string& tag, const std::string& attribute) const;

 private:
  /* A line of a table. */
  struct SRow {
    std::string Tag;  // "": of any
    std::string Name;  // name of an attribute, or of an element
    std::string Text;
  };

  // null if there is none
  const SRow* FindRow(const std::string& tag, const std::string& name) const;
  void ReadExamples(const std::string& text);
  void ReadTables(const std::string& text);
  void NoteRow(const std::string& names, const std::string& text);

  std::vector<std::unique_ptr<CConfigurationDocument>> m_documents;
  std::vector<TConfigurationNode> m_examples;
  std::set<std::string> m_tags;  // tags of all elements in examples
  std::vector<SRow> m_rows;
};

}  // namespace argos

#endif
