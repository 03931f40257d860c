#ifndef ARGOS3_TESTING_SCENARIO_MUTATIONS_XML_TREE_H
#define ARGOS3_TESTING_SCENARIO_MUTATIONS_XML_TREE_H

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/** An element of a well-formed file, to be mutated; comments are dropped. */
struct SXmlElement {
  std::string Tag;
  std::vector<std::pair<std::string, std::string>> Attributes;
  std::vector<std::unique_ptr<SXmlElement>> Children;
  std::string Text;

  std::unique_ptr<SXmlElement> Clone() const;
};

/** An element and the list that contains it; Siblings is null for the root. */
struct SXmlPlace {
  SXmlElement* Element;
  std::vector<std::unique_ptr<SXmlElement>>* Siblings;
  std::size_t Number;  // among the siblings
};

/** Parses a well-formed file. */
std::unique_ptr<SXmlElement> ParseXml(const std::string& text);
/** One line per element. */
std::string ToText(const SXmlElement& element);
/** The element and everything inside it, in the order of the file. */
std::vector<SXmlPlace> ListElements(SXmlElement& root);

}  // namespace argos

#endif
