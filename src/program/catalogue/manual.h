#ifndef ARGOS3_PROGRAM_CATALOGUE_MANUAL_H
#define ARGOS3_PROGRAM_CATALOGUE_MANUAL_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/program/catalogue/elements.h>

#include <map>
#include <memory>
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

  /** What tables say of the attribute of elements with that tag, or of any tag. */
  SAttributeText TextOf(const std::string& tag, const std::string& attribute) const;

 private:
  void ReadExamples(const std::string& text);
  void ReadTables(const std::string& text);
  void NoteRow(const std::string& names, const std::string& text);

  std::vector<std::unique_ptr<CConfigurationDocument>> m_documents;
  std::vector<TConfigurationNode> m_examples;
  std::map<std::pair<std::string, std::string>, std::string>
      m_texts;  // by tag or "", and attribute
};

}  // namespace argos

#endif
